/* FMI 3.0: event mode, clocks, partitions, and bytes. */
#include "protocol.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static void clocks_changed(void *environment)
{
    (void)environment;
    let_master_call();
}

static void nothing(void) {} /* partitions are never preempted */

void *instantiate_scheduled(Function f)
{
    size_t at = 0;
    const char *name = next_text(&at), *token = next_text(&at), *place = next_text(&at);
    return ((void *(*)(const char *, const char *, const char *, bool, bool, void *, void *, void *, void *, void *))f)(
        name, token, place, false, shared->words[0], NULL, (void *)logger3, (void *)clocks_changed, (void *)nothing,
        (void *)nothing);
}

/* Sizes are in the values, all bytes where texts are, one behind the other. */
static int exchange_bytes(Function f, enum Shape shape, size_t count, size_t values)
{
    uint64_t *sizes = (uint64_t *)shared->values;
    size_t *own = calloc(values ? values : 1, sizeof(size_t)), at = 0;
    const unsigned char **bytes = calloc(values ? values : 1, sizeof(unsigned char *));
    int status = 3;
    if (own && bytes) {
        for (size_t k = 0; shape == SET_BINARY && k < values; at += own[k], k++)
            own[k] = (size_t)sizes[k], bytes[k] = (unsigned char *)shared->texts + at;
        status = ((int (*)(void *, const uint32_t *, size_t, size_t *, const unsigned char **, size_t))f)(
            instance, (const uint32_t *)shared->references, count, own, bytes, values);
        for (size_t k = 0; shape == GET_BINARY && k < values && (status == 0 || status == 1); k++) {
            size_t size = bytes[k] ? own[k] : 0;
            if (size > AREA - at) {
                say(3, "", "its bytes are more than the memory shared with it can hold");
                status = 3;
                break;
            }
            memcpy(shared->texts + at, bytes[k], size);
            sizes[k] = size, at += size;
        }
    }
    free(own);
    free(bytes);
    return status;
}

int event_call(Function f, enum Shape shape)
{
    const uint32_t *references = (const uint32_t *)shared->references;
    size_t count = (size_t)shared->call.references;
    unsigned char *v = shared->values;
    switch (shape) {
    case SET_BINARY: case GET_BINARY:
        return exchange_bytes(f, shape, count, (size_t)shared->call.values);
    case PAIRS:
        return ((int (*)(void *, const uint32_t *, size_t, void *, void *))f)(
            instance, references, count, v, v + 8 * count);
    case TRIPLES:
        return ((int (*)(void *, const uint32_t *, size_t, void *, void *, void *))f)(
            instance, references, count, v, v + 8 * count, v + 16 * count);
    case UPDATE:
        return ((int (*)(void *, bool *, bool *, bool *, bool *, bool *, double *))f)(
            instance, (bool *)v, (bool *)(v + 8), (bool *)(v + 16), (bool *)(v + 24), (bool *)(v + 32),
            (double *)(v + 40));
    default: /* ACTIVATE */
        return ((int (*)(void *, uint32_t, double))f)(instance, (uint32_t)shared->words[0], real(shared->words[1]));
    }
}
