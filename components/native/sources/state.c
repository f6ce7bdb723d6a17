#include <stdlib.h>
#include <string.h>

#include "instance.h"

/* A saved state: token, flags, all values, all arrays that are not scratch. */
typedef struct {
    size_t size;
    char bytes[];
} State;

typedef struct {
    int32_t stage, ready, stale, reserved;
} Flags;

static size_t doubles_of(const Shape *shapes, bool ready) {
    size_t count = VECTOR_SIZE;
    for (int k = 0; ready && k < component.array_count; k++)
        if (!component.scratch[k]) count += instance_array_size(shapes[k]);
    return count;
}

static size_t state_size(const Instance *instance) {
    return strlen(component.token) + sizeof(Flags) + sizeof(double) * doubles_of(instance->shapes, instance->ready);
}

static void copy(char **bytes, const void *data, size_t size) {
    memcpy(*bytes, data, size);
    *bytes += size;
}

static void save(const Instance *instance, char *bytes) {
    const Flags flags = {(int32_t)instance->stage, instance->ready, instance->stale, 0};
    copy(&bytes, component.token, strlen(component.token));
    copy(&bytes, &flags, sizeof flags);
    copy(&bytes, instance->v, sizeof(double) * VECTOR_SIZE);
    for (int k = 0; instance->ready && k < component.array_count; k++)
        if (!component.scratch[k]) copy(&bytes, instance->arrays[k], sizeof(double) * instance_array_size(instance->shapes[k]));
}

static Status restore(Instance *instance, const char *bytes, size_t size) {
    const size_t token = strlen(component.token), head = token + sizeof(Flags) + sizeof(double) * VECTOR_SIZE;
    Status status = STATUS_ERROR;
    Flags flags;
    double *v = malloc(sizeof(double) * VECTOR_SIZE);
    Shape *shapes = malloc(sizeof(Shape) * ((size_t)component.array_count + 1));
    if (v && shapes && size >= head && memcmp(bytes, component.token, token) == 0) {
        memcpy(&flags, bytes + token, sizeof flags);
        memcpy(v, bytes + token + sizeof flags, sizeof(double) * VECTOR_SIZE);
        memset(shapes, 0, sizeof(Shape) * (size_t)component.array_count); /* none where there is no state yet */
        const bool known = flags.stage == INSTANTIATED || flags.stage == INITIALIZING || flags.stage == STEPPING
                           || flags.stage == TERMINATED;
        if (known && (!flags.ready || instance_check(instance, v) == STATUS_OK)) {
            if (flags.ready) component.shapes(v, shapes);
            if (size == token + sizeof flags + sizeof(double) * doubles_of(shapes, flags.ready != 0)) status = STATUS_OK;
        }
    }
    if (status == STATUS_OK && flags.ready) {
        status = instance_allocate(instance, v);
        if (status != STATUS_OK) instance->stage = TERMINATED; /* what it was is gone too */
    }
    if (status == STATUS_OK) {
        memcpy(instance->v, v, sizeof(double) * VECTOR_SIZE);
        instance->stage = (Stage)flags.stage;
        instance->ready = flags.ready != 0;
        instance->stale = flags.stale != 0;
        instance->tuned = false; /* its parameters are in range */
        const char *rest = bytes + head;
        for (int k = 0; instance->ready && k < component.array_count; k++) {
            if (component.scratch[k]) continue;
            memcpy(instance->arrays[k], rest, sizeof(double) * instance_array_size(shapes[k]));
            rest += sizeof(double) * instance_array_size(shapes[k]);
        }
    } else {
        instance_report(instance, STATUS_ERROR, "%s: the state was not saved by this FMU", instance->name);
    }
    free(v);
    free(shapes);
    return status;
}

static State *resized(const Instance *instance, State *state, size_t size) {
    State *block = state && state->size == size ? state : realloc(state, sizeof(State) + size);
    if (block) block->size = size;
    else instance_report(instance, STATUS_ERROR, "%s: not enough memory for the state", instance->name);
    return block;
}

Status state_save(const Instance *instance, void **state) {
    State *block = resized(instance, *state, state_size(instance));
    if (!block) return STATUS_ERROR;
    save(instance, block->bytes);
    *state = block;
    return STATUS_OK;
}

Status state_restore(Instance *instance, const void *state) {
    if (!state) return instance_report(instance, STATUS_ERROR, "%s: there is no state to restore", instance->name);
    return restore(instance, ((const State *)state)->bytes, ((const State *)state)->size);
}

void state_free(void **state) {
    if (state) free(*state);
    if (state) *state = NULL;
}

Status state_serialized_size(const Instance *instance, const void *state, size_t *size) {
    if (!state) return instance_report(instance, STATUS_ERROR, "%s: there is no state to serialize", instance->name);
    *size = ((const State *)state)->size;
    return STATUS_OK;
}

Status state_serialize(const Instance *instance, const void *state, void *bytes, size_t size) {
    const State *block = state;
    if (!block || size < block->size)
        return instance_report(instance, STATUS_ERROR, "%s: the state does not fit into %zu bytes", instance->name, size);
    memcpy(bytes, block->bytes, block->size);
    return STATUS_OK;
}

Status state_deserialize(const Instance *instance, const void *bytes, size_t size, void **state) {
    State *block = resized(instance, *state, size);
    if (!block) return STATUS_ERROR;
    memcpy(block->bytes, bytes, size);
    *state = block;
    return STATUS_OK;
}
