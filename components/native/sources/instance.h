/* One instance of the component, whatever the FMI version: life cycle, values, state. */
#ifndef INSTANCE_H
#define INSTANCE_H

#include <stddef.h>

#include "component.h"

typedef enum { STATUS_OK, STATUS_WARNING, STATUS_DISCARD, STATUS_ERROR, STATUS_FATAL } Status;
typedef enum { INSTANTIATED = 1, INITIALIZING = 2, STEPPING = 4, TERMINATED = 8 } Stage;

typedef struct Instance Instance;
typedef void (*AnyFunction)(void);
typedef void (*Report)(const Instance *instance, Status status, const char *text);

struct Instance {
    char *name;
    void *environment; /* of the host, handed back with every message */
    AnyFunction logger;
    Report report; /* puts a message into the form of the FMI version */
    Stage stage;
    bool ready; /* the arrays hold a state that belongs to the parameters */
    bool stale; /* an input has changed since the outputs were computed */
    bool tuned; /* so has a tunable parameter, which is not yet known to be in its range */
    double *v;
    double **arrays;
    Shape *shapes;
};

Instance *instance_new(const char *name, const char *token, void *environment, AnyFunction logger, Report report);
void instance_free(Instance *instance);
void instance_reset(Instance *instance);

/* Send a message to the host; returns the status. */
Status instance_report(const Instance *instance, Status status, const char *format, ...);

/* STATUS_ERROR with a message unless the instance is in one of the stages. */
Status instance_require(const Instance *instance, int stages, const char *function);

/* Places of `count` values from value reference `reference` on; NULL with a message if there is no such variable. */
double *instance_readable(Instance *instance, unsigned reference, size_t count, Kind kind);
double *instance_writable(Instance *instance, unsigned reference, size_t count, Kind kind);

/* The same, at once where the outputs are those of the inputs, as they are behind every step. */
static inline const double *instance_read(Instance *instance, unsigned reference, size_t count, Kind kind) {
    if (instance->ready && !instance->stale && reference < (unsigned)component.value_count) {
        const Variable *found = &component.variables[component.owners[reference]];
        if (found->kind == kind && (size_t)(found->first + found->size) - reference >= count)
            return instance->v + reference;
    }
    return instance_readable(instance, reference, count, kind);
}

Status instance_initialize(Instance *instance); /* parameters checked, state and outputs at the start */
Status instance_step(Instance *instance, double time, double step);

#define VECTOR_SIZE ((size_t)component.value_count + 2)
static inline size_t instance_array_size(Shape shape) { return (size_t)(shape.rows * shape.columns); }
Status instance_check(const Instance *instance, const double *v);       /* are the parameters in range? */
Status instance_allocate(Instance *instance, const double *v);          /* arrays for these parameters, zeroed */

/* The complete state, behind an opaque pointer that the host keeps (state.c). */
Status state_save(const Instance *instance, void **state);
Status state_restore(Instance *instance, const void *state);
void state_free(void **state);
Status state_serialized_size(const Instance *instance, const void *state, size_t *size);
Status state_serialize(const Instance *instance, const void *state, void *bytes, size_t size);
Status state_deserialize(const Instance *instance, const void *bytes, size_t size, void **state);

#endif
