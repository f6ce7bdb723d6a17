/* FMI 3.0 for co-simulation, on top of instance.c (FMI 3.0.1, sections 2.2 and 4.2). */
#include "fmi3Functions.h"
#include "instance.h"

static void report(const Instance *instance, Status status, const char *text) {
    ((fmi3LogMessageCallback)instance->logger)(instance->environment, (fmi3Status)status,
                                               status == STATUS_OK ? "logAll" : "logStatusError", text);
}

static fmi3Status unsupported(fmi3Instance c, const char *function) {
    return (fmi3Status)instance_report(c, STATUS_ERROR, "%s: %s is not supported", ((Instance *)c)->name, function);
}

/* --- life cycle --- */

const char *fmi3GetVersion(void) { return fmi3Version; }

fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean on, size_t count, const fmi3String categories[]) {
    (void)c, (void)on, (void)count, (void)categories; /* only errors are reported, and always */
    return fmi3OK;
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                         fmi3Boolean logging, fmi3Boolean event_mode, fmi3Boolean early_return,
                                         const fmi3ValueReference intermediate[], size_t n_intermediate,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                         fmi3IntermediateUpdateCallback update) {
    (void)resources, (void)visible, (void)logging, (void)early_return, (void)intermediate, (void)update;
    if (event_mode || n_intermediate) return NULL; /* neither is offered in the model description */
    return instance_new(name, token, environment, (AnyFunction)log, report);
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                          fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback log) {
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)environment, (void)log;
    return NULL;
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean logging,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                               fmi3ClockUpdateCallback clock, fmi3LockPreemptionCallback lock,
                                               fmi3UnlockPreemptionCallback unlock) {
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)environment, (void)log;
    (void)clock, (void)lock, (void)unlock;
    return NULL;
}

void fmi3FreeInstance(fmi3Instance c) { instance_free(c); }

fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean with_tolerance, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean with_stop, fmi3Float64 stop) {
    (void)with_tolerance, (void)tolerance, (void)with_stop, (void)stop;
    Instance *instance = c;
    if (instance_require(instance, INSTANTIATED, "fmi3EnterInitializationMode")) return fmi3Error;
    instance->v[component.value_count] = start;
    instance->stage = INITIALIZING;
    return fmi3OK;
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance c) {
    Instance *instance = c;
    if (instance_require(instance, INITIALIZING, "fmi3ExitInitializationMode")) return fmi3Error;
    if (instance_initialize(instance)) return fmi3Error;
    instance->stage = STEPPING;
    return fmi3OK;
}

fmi3Status fmi3Terminate(fmi3Instance c) {
    Instance *instance = c;
    if (instance_require(instance, STEPPING, "fmi3Terminate")) return fmi3Error;
    instance->stage = TERMINATED;
    return fmi3OK;
}

fmi3Status fmi3Reset(fmi3Instance c) {
    instance_reset(c);
    return fmi3OK;
}

/* --- values: a value reference is the first place of a variable in the vector of values --- */

static size_t size_of(fmi3ValueReference vr) {
    return vr < (unsigned)component.value_count ? (size_t)component.variables[component.owners[vr]].size : 1;
}

/* The place behind all variables: the independent one, which FMI 3.0 declares as a variable. */
static bool is_time(fmi3ValueReference vr) { return vr == (unsigned)component.value_count; }

static const double *readable(Instance *instance, fmi3ValueReference vr, size_t size, Kind kind) {
    if (!is_time(vr)) return instance_read(instance, vr, size, kind);
    if (kind == REAL) return instance->v + vr;
    instance_report(instance, STATUS_ERROR, "%s: time is a Real (Float64)", instance->name);
    return NULL;
}

static double *writable(Instance *instance, fmi3ValueReference vr, size_t size, Kind kind) {
    if (!is_time(vr)) return instance_writable(instance, vr, size, kind);
    instance_report(instance, STATUS_ERROR, "%s: time is the independent variable and cannot be set", instance->name);
    return NULL;
}

#define GET(Name, Type, KIND, CONVERT)                                                                              \
    fmi3Status fmi3Get##Name(fmi3Instance c, const fmi3ValueReference vr[], size_t count, Type values[],            \
                             size_t n_values) {                                                                     \
        size_t at = 0;                                                                                              \
        for (size_t k = 0; k < count; k++) {                                                                        \
            const size_t size = size_of(vr[k]);                                                                     \
            const double *place = readable(c, vr[k], size, KIND);                                                   \
            if (!place) return fmi3Error;                                                                           \
            if (at + size > n_values) return wrong_size(c, "fmi3Get" #Name, n_values);                              \
            for (size_t j = 0; j < size; j++) values[at++] = CONVERT(place[j]);                                     \
        }                                                                                                           \
        return at == n_values ? fmi3OK : wrong_size(c, "fmi3Get" #Name, n_values);                                  \
    }
#define SET(Name, Type, KIND, CONVERT)                                                                              \
    fmi3Status fmi3Set##Name(fmi3Instance c, const fmi3ValueReference vr[], size_t count, const Type values[],      \
                             size_t n_values) {                                                                     \
        size_t at = 0;                                                                                              \
        if (instance_require(c, INSTANTIATED | INITIALIZING | STEPPING, "fmi3Set" #Name)) return fmi3Error;         \
        for (size_t k = 0; k < count; k++) at += size_of(vr[k]);                                                    \
        if (at != n_values) return wrong_size(c, "fmi3Set" #Name, n_values);                                        \
        at = 0;                                                                                                     \
        for (size_t k = 0; k < count; k++) {                                                                        \
            const size_t size = size_of(vr[k]);                                                                     \
            double *place = writable(c, vr[k], size, KIND);                                                         \
            if (!place) return fmi3Error;                                                                           \
            for (size_t j = 0; j < size; j++) place[j] = CONVERT(values[at++]);                                     \
        }                                                                                                           \
        return fmi3OK;                                                                                              \
    }
#define TRUTH(x) ((x) != 0)

static fmi3Status wrong_size(fmi3Instance c, const char *function, size_t n_values) {
    return (fmi3Status)instance_report(c, STATUS_ERROR, "%s: %s with %zu values, which is not the size of the variables",
                                       ((Instance *)c)->name, function, n_values);
}

GET(Float64, fmi3Float64, REAL, )
GET(Int32, fmi3Int32, INTEGER, (fmi3Int32))
GET(Boolean, fmi3Boolean, BOOLEAN, TRUTH)
SET(Float64, fmi3Float64, REAL, )
SET(Int32, fmi3Int32, INTEGER, )
SET(Boolean, fmi3Boolean, BOOLEAN, TRUTH)

/* Types that no variable has: an empty request is fine. */
#define NO_TYPE(Name)                                                                                               \
    fmi3Status fmi3Get##Name(fmi3Instance c, const fmi3ValueReference vr[], size_t count, fmi3##Name values[],      \
                             size_t n_values) {                                                                     \
        (void)vr, (void)values, (void)n_values;                                                                     \
        return count ? unsupported(c, "fmi3Get" #Name) : fmi3OK;                                                    \
    }                                                                                                               \
    fmi3Status fmi3Set##Name(fmi3Instance c, const fmi3ValueReference vr[], size_t count, const fmi3##Name values[], \
                             size_t n_values) {                                                                     \
        (void)vr, (void)values, (void)n_values;                                                                     \
        return count ? unsupported(c, "fmi3Set" #Name) : fmi3OK;                                                    \
    }
NO_TYPE(Float32)
NO_TYPE(Int8)
NO_TYPE(UInt8)
NO_TYPE(Int16)
NO_TYPE(UInt16)
NO_TYPE(UInt32)
NO_TYPE(Int64)
NO_TYPE(UInt64)
NO_TYPE(String)

/* --- step --- */

fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64 time, fmi3Float64 step, fmi3Boolean no_rollback,
                      fmi3Boolean *event_needed, fmi3Boolean *terminate, fmi3Boolean *early_return,
                      fmi3Float64 *last_time) {
    (void)no_rollback;
    if (event_needed) *event_needed = fmi3False;
    if (terminate) *terminate = fmi3False;
    if (early_return) *early_return = fmi3False;
    if (instance_require(c, STEPPING, "fmi3DoStep")) return fmi3Error;
    const Status status = instance_step(c, time, step);
    if (last_time) *last_time = status == STATUS_OK ? time + step : time;
    return (fmi3Status)status;
}

/* --- state --- */

fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState *state) { return (fmi3Status)state_save(c, state); }

fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state) { return (fmi3Status)state_restore(c, state); }

fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState *state) {
    (void)c;
    state_free(state);
    return fmi3OK;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, size_t *size) {
    return (fmi3Status)state_serialized_size(c, state, size);
}

fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
    return (fmi3Status)state_serialize(c, state, bytes, size);
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState *state) {
    return (fmi3Status)state_deserialize(c, bytes, size, state);
}
