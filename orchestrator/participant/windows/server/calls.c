/* The calls of FMI functions, one kind of arguments after the other; references, values and texts are shared memory. */
#include "protocol.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static HMODULE library;
static Function functions[FUNCTIONS];
static unsigned char shapes[FUNCTIONS];
static unsigned char *state; /* serialized, between this process and the master */
static size_t state_size;

typedef struct { /* FMI 2.0: the environment comes last; FMI 1.0 has none */
    void (*logger)(void *, const char *, int, const char *, const char *, ...);
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void *finished;
    void *environment;
} Callbacks;

static const Callbacks callbacks = {logger, calloc, free, NULL, NULL};

const char *next_text(size_t *at)
{
    const char *found = shared->texts + *at;
    *at += strlen(found) + 1;
    return found;
}

void load(void)
{
    size_t at = 0;
    const char *path = next_text(&at);
    library = LoadLibraryExA(path, NULL, LOAD_WITH_ALTERED_SEARCH_PATH);
    shared->refused = library ? 0 : GetLastError();
    if (!library)
        return;
    memcpy(shapes, shared->values, FUNCTIONS); /* by the number of a function */
    memset(shared->values, 0, FUNCTIONS);
    for (uint64_t k = 0; k < shared->words[0] && k < FUNCTIONS; k++) {
        functions[k] = (Function)GetProcAddress(library, next_text(&at));
        shared->values[k] = functions[k] != NULL;
    }
}

void chunk(enum Operation operation)
{
    size_t at = (size_t)shared->words[0], size = (size_t)shared->words[1], all = (size_t)shared->words[2];
    shared->status = 0;
    if (operation == CHUNK_TO_SERVER && all > state_size) {
        unsigned char *more = realloc(state, all);
        if (!more) {
            shared->status = 3;
            return;
        }
        state = more, state_size = all;
    }
    if (size > AREA || at > state_size || size > state_size - at)
        shared->status = 3;
    else if (operation == CHUNK_TO_SERVER)
        memcpy(state + at, shared->values, size);
    else
        memcpy(shared->values, state + at, size);
}

/* Pointers to texts of the master, in memory that is given back behind the call; NULL where there is no memory. */
static const char **pointers_to(uint64_t count)
{
    const char **found = malloc(sizeof(char *) * (size_t)(count ? count : 1));
    size_t at = 0;
    for (uint64_t k = 0; found && k < count; k++)
        found[k] = next_text(&at);
    return found;
}

/* Texts of the FMU, laid where the master reads them. */
static int pass_on(const char **texts, uint64_t count, int status)
{
    size_t at = 0;
    for (uint64_t k = 0; k < count && (status == 0 || status == 1); k++) {
        const char *text = texts[k] ? texts[k] : "";
        size_t size = strlen(text) + 1;
        if (at + size > AREA) {
            say(3, "", "its texts are longer than the memory shared with it");
            return 3;
        }
        memcpy(shared->texts + at, text, size);
        at += size;
    }
    return status;
}

static int exchange_texts(Function f, enum Shape shape, const uint32_t *references, size_t count, size_t values)
{
    bool sets = shape == SET_TEXT || shape == SET_TEXT_SIZED, sized = shape == SET_TEXT_SIZED || shape == GET_TEXT_SIZED;
    const char **texts = sets ? pointers_to(values) : calloc(values ? values : 1, sizeof(char *));
    int status = 3;
    if (!texts)
        return status;
    status = sized ? ((int (*)(void *, const uint32_t *, size_t, const char **, size_t))f)(
                         instance, references, count, texts, values)
                   : ((int (*)(void *, const uint32_t *, size_t, const char **))f)(instance, references, count, texts);
    if (!sets)
        status = pass_on(texts, values, status);
    free(texts);
    return status;
}

double real(uint64_t word)
{
    double found;
    memcpy(&found, &word, 8);
    return found;
}

static void *instantiate(Function f, enum Shape shape)
{
    size_t at = 0;
    const char *name = next_text(&at), *token = next_text(&at), *place = next_text(&at), *kind = next_text(&at);
    int logs = (int)shared->words[0];
    if (shape == INSTANTIATE3)
        return ((void *(*)(const char *, const char *, const char *, bool, bool, bool, bool, const uint32_t *, size_t,
                           void *, void *, void *))f)(
            name, token, place, false, logs, shared->words[1], shared->words[1], NULL, 0, NULL, (void *)logger3, NULL);
    if (shape == INSTANTIATE_SCHEDULED)
        return instantiate_scheduled(f);
    if (shape == INSTANTIATE_MODEL)
        return instantiate_model(f);
    if (shape == INSTANTIATE2)
        return ((void *(*)(const char *, int, const char *, const char *, const Callbacks *, int, int))f)(
            name, (int)shared->words[1], token, place, &callbacks, 0, logs);
    /* FMI 1.0 takes its callbacks by value, without the environment. */
    struct { void *logger, *allocate, *release, *finished; } by_value = {
        (void *)logger, (void *)calloc, (void *)free, NULL};
    typedef void *(*Instantiate)(const char *, const char *, const char *, const char *, double, char, char,
                                 __typeof__(by_value), char);
    return ((Instantiate)f)(name, token, place, kind, 0.0, 0, 0, by_value, (char)logs);
}

static int number_of(Function f, enum Shape shape)
{
    const uint64_t *w = shared->words;
    const char *text = NULL, **categories;
    int status;
    switch (shape) {
    case PLAIN:
        return ((int (*)(void *))f)(instance);
    case FREE:
        ((void (*)(void *))f)(instance);
        return 0;
    case EXPERIMENT:
        return ((int (*)(void *, int, double, double, int, double))f)(
            instance, (int)w[0], real(w[1]), real(w[2]), (int)w[3], real(w[4]));
    case INITIALIZE1:
        return ((int (*)(void *, double, int, double))f)(instance, real(w[0]), (int)w[1], real(w[2]));
    case LOGGING1:
        return ((int (*)(void *, int))f)(instance, (int)w[0]);
    case LOGGING:
        categories = pointers_to(w[1]);
        status = ((int (*)(void *, int, size_t, const char **))f)(instance, (int)w[0], (size_t)w[1], categories);
        free(categories);
        return status;
    case STATUS_NUMBER:
        memset(shared->values, 0, 8);
        return ((int (*)(void *, int, void *))f)(instance, (int)w[0], shared->values);
    case STATUS_TEXT:
        status = ((int (*)(void *, int, const char **))f)(instance, (int)w[0], &text);
        return pass_on(&text, 1, status);
    case TEXT:
        text = ((const char *(*)(void))f)();
        return pass_on(&text, 1, 0);
    default:
        return 3;
    }
}

static int state_call(Function f, enum Shape shape)
{
    uint64_t *cell = (uint64_t *)shared->values; /* a state of 32 bits leaves the upper half as it is */
    void *handle = (void *)(uintptr_t)*cell;
    size_t size = 0;
    int status;
    switch (shape) {
    case STATE_OUT:
        status = ((int (*)(void *, void **))f)(instance, &handle);
        *cell = (uintptr_t)handle;
        return status;
    case STATE_IN:
        return ((int (*)(void *, void *))f)(instance, handle);
    case STATE_SIZE:
        status = ((int (*)(void *, void *, size_t *))f)(instance, handle, &size);
        shared->result = size;
        return status;
    case SERIALIZE:
        size = (size_t)shared->words[0];
        if (size > state_size) {
            unsigned char *more = realloc(state, size);
            if (!more)
                return 3;
            state = more, state_size = size;
        }
        return ((int (*)(void *, void *, unsigned char *, size_t))f)(instance, handle, state, size);
    default: /* DESERIALIZE */
        size = (size_t)shared->words[0];
        if (size > state_size)
            return 3;
        handle = NULL;
        status = ((int (*)(void *, const unsigned char *, size_t, void **))f)(instance, state, size, &handle);
        *cell = (uintptr_t)handle;
        return status;
    }
}

void call(void)
{
    const struct Call *c = &shared->call;
    const uint32_t *references = (const uint32_t *)shared->references;
    enum Shape shape = c->function < FUNCTIONS ? shapes[c->function] : PLAIN;
    Function f = c->function < FUNCTIONS ? functions[c->function] : NULL;
    unsigned char *v = shared->values;
    if (!f) {
        shared->status = 3;
        return;
    }
    switch (shape) {
    case SET_GET:
        shared->status = ((int (*)(void *, const uint32_t *, size_t, void *))f)(
            instance, references, (size_t)c->references, v);
        break;
    case SET_GET_SIZED:
        shared->status = ((int (*)(void *, const uint32_t *, size_t, void *, size_t))f)(
            instance, references, (size_t)c->references, v, (size_t)c->values);
        break;
    case SET_TEXT: case SET_TEXT_SIZED: case GET_TEXT: case GET_TEXT_SIZED:
        shared->status = exchange_texts(f, shape, references, (size_t)c->references, (size_t)c->values);
        break;
    case STEP:
        shared->status = ((int (*)(void *, double, double, int))f)(instance, c->time, c->length, c->final);
        break;
    case STEP3:
        memset(v, 0, 16);
        shared->status = ((int (*)(void *, double, double, bool, bool *, bool *, bool *, double *))f)(
            instance, c->time, c->length, c->final, (bool *)v, (bool *)(v + 1), (bool *)(v + 2), (double *)(v + 8));
        break;
    case STATE_OUT: case STATE_IN: case STATE_SIZE: case SERIALIZE: case DESERIALIZE:
        shared->status = state_call(f, shape);
        break;
    case INSTANTIATE1: case INSTANTIATE2: case INSTANTIATE3: case INSTANTIATE_SCHEDULED: case INSTANTIATE_MODEL:
        instance = instantiate(f, shape);
        shared->result = (uintptr_t)instance;
        break;
    case SET_BINARY: case GET_BINARY: case PAIRS: case TRIPLES: case UPDATE: case ACTIVATE:
        shared->status = event_call(f, shape);
        break;
    case TIME: case VECTOR: case COMPLETED2: case COMPLETED3: case EVENT_INFO: case COUNT: case DIRECTIONAL2:
    case DIRECTIONAL3:
        shared->status = exchange_call(f, shape);
        break;
    default:
        shared->status = number_of(f, shape);
    }
}
