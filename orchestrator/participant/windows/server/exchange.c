/* Model Exchange: states, derivatives, indicators and events of an FMU whose solver is the master's. */
#include "protocol.h"

#include <stdbool.h>
#include <string.h>

void *instantiate_model(Function f)
{
    size_t at = 0;
    const char *name = next_text(&at), *token = next_text(&at), *place = next_text(&at);
    return ((void *(*)(const char *, const char *, const char *, bool, bool, void *, void *))f)(
        name, token, place, false, shared->words[0], NULL, (void *)logger3);
}

int exchange_call(Function f, enum Shape shape)
{
    const uint32_t *references = (const uint32_t *)shared->references;
    const uint64_t *w = shared->words;
    size_t unknowns = (size_t)w[0], knowns = (size_t)w[1], count = 0;
    unsigned char *v = shared->values;
    double *seeds = (double *)v, *answers = seeds + w[2];
    int status;
    switch (shape) {
    case TIME:
        return ((int (*)(void *, double))f)(instance, real(w[0]));
    case VECTOR:
        return ((int (*)(void *, double *, size_t))f)(instance, (double *)v, (size_t)w[0]);
    case COMPLETED2:
        return ((int (*)(void *, int, int *, int *))f)(instance, (int)w[0], (int *)v, (int *)(v + 8));
    case COMPLETED3:
        return ((int (*)(void *, bool, bool *, bool *))f)(instance, w[0], (bool *)v, (bool *)(v + 8));
    case EVENT_INFO:
        return ((int (*)(void *, void *))f)(instance, v);
    case COUNT:
        status = ((int (*)(void *, size_t *))f)(instance, &count);
        *(uint64_t *)v = count;
        return status;
    case DIRECTIONAL2:
        return ((int (*)(void *, const uint32_t *, size_t, const uint32_t *, size_t, const double *, double *))f)(
            instance, references, unknowns, references + unknowns, knowns, seeds, answers);
    default: /* DIRECTIONAL3 */
        return ((int (*)(void *, const uint32_t *, size_t, const uint32_t *, size_t, const double *, size_t, double *,
                         size_t))f)(
            instance, references, unknowns, references + unknowns, knowns, seeds, (size_t)w[2], answers,
            (size_t)w[3]);
    }
}
