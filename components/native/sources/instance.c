#include "instance.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int time_place(void) { return component.value_count; }

/* --- life --- */

Instance *instance_new(const char *name, const char *token, void *environment, AnyFunction logger, Report report) {
    Instance unborn = {.name = (char *)(name ? name : ""), .environment = environment, .logger = logger, .report = report};
    if (!token || strcmp(token, component.token) != 0) {
        instance_report(&unborn, STATUS_ERROR, "the host asked for %s, this binary is %s; the FMU was changed by hand",
                        token ? token : "nothing", component.token);
        return NULL;
    }
    Instance *instance = calloc(1, sizeof *instance);
    if (!instance) return NULL;
    *instance = unborn;
    instance->name = malloc(strlen(unborn.name) + 1);
    instance->v = calloc(VECTOR_SIZE, sizeof(double));
    instance->arrays = calloc((size_t)component.array_count + 1, sizeof(double *)); /* none may give NULL */
    instance->shapes = calloc((size_t)component.array_count + 1, sizeof(Shape));
    if (!instance->name || !instance->v || !instance->arrays || !instance->shapes) {
        instance_free(instance);
        return NULL;
    }
    strcpy(instance->name, unborn.name);
    instance_reset(instance);
    return instance;
}

void instance_free(Instance *instance) {
    if (!instance) return;
    for (int k = 0; instance->arrays && k < component.array_count; k++) free(instance->arrays[k]);
    free(instance->arrays);
    free(instance->shapes);
    free(instance->v);
    free(instance->name);
    free(instance);
}

void instance_reset(Instance *instance) {
    memcpy(instance->v, component.starts, sizeof(double) * (size_t)component.value_count);
    instance->v[time_place()] = instance->v[time_place() + 1] = 0.0;
    instance->stage = INSTANTIATED;
    instance->ready = instance->stale = instance->tuned = false;
}

Status instance_report(const Instance *instance, Status status, const char *format, ...) {
    char text[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (instance->logger) instance->report(instance, status, text);
    return status;
}

Status instance_require(const Instance *instance, int stages, const char *function) {
    if (instance->stage & stages) return STATUS_OK;
    const char *stage = instance->stage == INSTANTIATED   ? "before initialization"
                        : instance->stage == INITIALIZING ? "during initialization"
                        : instance->stage == STEPPING     ? "after initialization"
                                                          : "after termination";
    return instance_report(instance, STATUS_ERROR, "%s: %s is not allowed %s", instance->name, function, stage);
}

/* --- values --- */

static double *place(Instance *instance, unsigned reference, size_t count, Kind kind, const Variable **variable) {
    static const char *const KINDS[] = {"a Real (Float64)", "an Integer (Int32)", "a Boolean"};
    *variable = NULL;
    if (reference < (unsigned)component.value_count) {
        const Variable *found = &component.variables[component.owners[reference]];
        if (found->kind != kind) {
            instance_report(instance, STATUS_ERROR, "%s: %s is %s", instance->name, found->name, KINDS[found->kind]);
        } else if ((size_t)(found->first + found->size) - reference < count) {
            instance_report(instance, STATUS_ERROR, "%s: %s has %d elements", instance->name, found->name, found->size);
        } else {
            *variable = found;
            return instance->v + reference;
        }
    } else {
        instance_report(instance, STATUS_ERROR, "%s: there is no variable of value reference %u", instance->name, reference);
    }
    return NULL;
}

double *instance_readable(Instance *instance, unsigned reference, size_t count, Kind kind) {
    const Variable *variable;
    double *found = place(instance, reference, count, kind, &variable);
    if (found && variable->causality == OUTPUT) {
        if (!instance->ready && instance_initialize(instance) != STATUS_OK) return NULL;
        if (instance->stale) {
            component.outputs(instance->v, instance->arrays, instance->shapes);
            instance->stale = false;
        }
    }
    return found;
}

double *instance_writable(Instance *instance, unsigned reference, size_t count, Kind kind) {
    const Variable *variable;
    double *found = place(instance, reference, count, kind, &variable);
    if (!found) return NULL;
    if (variable->causality == OUTPUT) {
        instance_report(instance, STATUS_ERROR, "%s: %s is an output and cannot be set", instance->name, variable->name);
        return NULL;
    }
    if (variable->causality == PARAMETER && !(instance->stage & (INSTANTIATED | INITIALIZING))) {
        instance_report(instance, STATUS_ERROR, "%s: parameter %s is fixed; set it before initialization ends",
                        instance->name, variable->name);
        return NULL;
    }
    if (variable->causality == TUNABLE) instance->tuned = true;
    if (instance->stage == STEPPING) instance->stale = true;
    else instance->ready = false;
    return found;
}

static Status check_finite(const Instance *instance, int begin, int end, const char *what) {
    for (int k = begin; k < end; k++)
        if (!isfinite(instance->v[k]))
            return instance_report(instance, STATUS_ERROR, "%s: %s %s is %g at t = %.9g s", instance->name, what,
                                   component.variables[component.owners[k]].name, instance->v[k],
                                   instance->v[time_place()]);
    return STATUS_OK;
}

static Status check_inputs(const Instance *instance) {
    return check_finite(instance, component.first_input, component.first_output, "input");
}

static Status check_outputs(const Instance *instance) {
    return check_finite(instance, component.first_output, component.value_count, "output");
}

/* --- start and step --- */

Status instance_check(const Instance *instance, const double *v) {
    for (int k = 0; k < component.first_input; k++) {
        const Variable *variable = &component.variables[component.owners[k]];
        if (!(v[k] >= variable->minimum && v[k] <= variable->maximum)) {
            const char *unit = strcmp(variable->unit, "1") == 0 ? "" : variable->unit;
            return instance_report(instance, STATUS_ERROR, "%s.%s = %.9g %s is out of range: %g to %g %s are allowed",
                                   instance->name, variable->name, v[k], unit, variable->minimum, variable->maximum, unit);
        }
    }
    return STATUS_OK;
}

Status instance_allocate(Instance *instance, const double *v) {
    instance->ready = false; /* what it has no arrays for it cannot do */
    component.shapes(v, instance->shapes);
    for (int k = 0; k < component.array_count; k++) {
        free(instance->arrays[k]);
        instance->arrays[k] = calloc(instance_array_size(instance->shapes[k]) + 1, sizeof(double));
        if (!instance->arrays[k])
            return instance_report(instance, STATUS_ERROR, "%s: not enough memory", instance->name);
    }
    return STATUS_OK;
}

Status instance_initialize(Instance *instance) {
    if (instance->ready) return STATUS_OK;
    if (check_inputs(instance) || instance_check(instance, instance->v)) return STATUS_ERROR;
    if (instance_allocate(instance, instance->v)) return STATUS_ERROR;
    component.start(instance->v, instance->arrays, instance->shapes);
    instance->stale = false;
    instance->ready = check_outputs(instance) == STATUS_OK; /* else the next call says it again */
    return instance->ready ? STATUS_OK : STATUS_ERROR;
}

Status instance_step(Instance *instance, double time, double step) {
    if (!(step > 0.0) || !isfinite(step) || !isfinite(time))
        return instance_report(instance, STATUS_ERROR, "%s: a step of %g s from t = %g s is not possible",
                               instance->name, step, time);
    instance->v[time_place()] = time;
    instance->v[time_place() + 1] = step;
    if (instance->tuned && instance_check(instance, instance->v)) return STATUS_ERROR;
    instance->tuned = false;
    if (check_inputs(instance)) return STATUS_ERROR;
    component.step(instance->v, instance->arrays, instance->shapes);
    instance->v[time_place()] = time + step; /* outputs that are asked for between two steps belong to its end */
    instance->stale = false;
    return check_outputs(instance);
}
