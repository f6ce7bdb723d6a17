/* FMI 2.0 for co-simulation, on top of instance.c (FMI 2.0.4, sections 2.1 and 4.2). */
#include "fmi2Functions.h"
#include "instance.h"

static void report(const Instance *instance, Status status, const char *text) {
    char words[2100];
    size_t n = 0;
    for (; *text && n + 2 < sizeof words; text++) {
        if (*text == '%') words[n++] = '%'; /* a format without arguments: hosts not in C cannot read those */
        words[n++] = *text;
    }
    words[n] = '\0';
    ((fmi2CallbackLogger)instance->logger)(instance->environment, instance->name, (fmi2Status)status,
                                           status == STATUS_OK ? "logAll" : "logStatusError", words);
}

static fmi2Status unsupported(fmi2Component c, const char *function) {
    return (fmi2Status)instance_report(c, STATUS_ERROR, "%s: %s is not supported", ((Instance *)c)->name, function);
}

/* --- life cycle --- */

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t count, const fmi2String categories[]) {
    (void)c, (void)on, (void)count, (void)categories; /* only errors are reported, and always */
    return fmi2OK;
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String token, fmi2String resources,
                              const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging) {
    (void)resources, (void)visible, (void)logging;
    if (type != fmi2CoSimulation || !callbacks) return NULL;
    return instance_new(name, token, callbacks->componentEnvironment, (AnyFunction)callbacks->logger, report);
}

void fmi2FreeInstance(fmi2Component c) { instance_free(c); }

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean with_tolerance, fmi2Real tolerance, fmi2Real start,
                               fmi2Boolean with_stop, fmi2Real stop) {
    (void)with_tolerance, (void)tolerance, (void)with_stop, (void)stop;
    Instance *instance = c;
    if (instance_require(instance, INSTANTIATED, "fmi2SetupExperiment")) return fmi2Error;
    instance->v[component.value_count] = start;
    return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
    Instance *instance = c;
    if (instance_require(instance, INSTANTIATED, "fmi2EnterInitializationMode")) return fmi2Error;
    instance->stage = INITIALIZING;
    return fmi2OK;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
    Instance *instance = c;
    if (instance_require(instance, INITIALIZING, "fmi2ExitInitializationMode")) return fmi2Error;
    if (instance_initialize(instance)) return fmi2Error;
    instance->stage = STEPPING;
    return fmi2OK;
}

fmi2Status fmi2Terminate(fmi2Component c) {
    Instance *instance = c;
    if (instance_require(instance, STEPPING, "fmi2Terminate")) return fmi2Error;
    instance->stage = TERMINATED;
    return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component c) {
    instance_reset(c);
    return fmi2OK;
}

/* --- values: a value reference is a place in the vector of values --- */

#define GET(Name, Type, KIND, CONVERT)                                                                             \
    fmi2Status fmi2Get##Name(fmi2Component c, const fmi2ValueReference vr[], size_t count, Type values[]) {        \
        for (size_t k = 0; k < count; k++) {                                                                       \
            const double *place = instance_read(c, vr[k], 1, KIND);                                                \
            if (!place) return fmi2Error;                                                                          \
            values[k] = CONVERT(*place);                                                                           \
        }                                                                                                          \
        return fmi2OK;                                                                                             \
    }
#define SET(Name, Type, KIND, CONVERT)                                                                             \
    fmi2Status fmi2Set##Name(fmi2Component c, const fmi2ValueReference vr[], size_t count, const Type values[]) {  \
        if (instance_require(c, INSTANTIATED | INITIALIZING | STEPPING, "fmi2Set" #Name)) return fmi2Error;        \
        for (size_t k = 0; k < count; k++) {                                                                       \
            double *place = instance_writable(c, vr[k], 1, KIND);                                                  \
            if (!place) return fmi2Error;                                                                          \
            *place = CONVERT(values[k]);                                                                           \
        }                                                                                                          \
        return fmi2OK;                                                                                             \
    }
#define TRUTH(x) ((x) != 0)

GET(Real, fmi2Real, REAL, )
GET(Integer, fmi2Integer, INTEGER, (fmi2Integer))
GET(Boolean, fmi2Boolean, BOOLEAN, TRUTH)
SET(Real, fmi2Real, REAL, )
SET(Integer, fmi2Integer, INTEGER, )
SET(Boolean, fmi2Boolean, BOOLEAN, TRUTH)

fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2String values[]) {
    (void)vr, (void)values;
    return count ? unsupported(c, "fmi2GetString") : fmi2OK;
}

fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2String values[]) {
    (void)vr, (void)values;
    return count ? unsupported(c, "fmi2SetString") : fmi2OK;
}

/* --- step --- */

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_rollback) {
    (void)no_rollback;
    if (instance_require(c, STEPPING, "fmi2DoStep")) return fmi2Error;
    return (fmi2Status)instance_step(c, time, step);
}

fmi2Status fmi2CancelStep(fmi2Component c) { return unsupported(c, "fmi2CancelStep"); }

#define GET_STATUS(Name, Type)                                                                 \
    fmi2Status fmi2Get##Name##Status(fmi2Component c, const fmi2StatusKind kind, Type *value) { \
        (void)c, (void)kind, (void)value;                                                      \
        return fmi2Discard; /* every step ends before fmi2DoStep returns */                    \
    }
GET_STATUS(, fmi2Status)
GET_STATUS(Integer, fmi2Integer)
GET_STATUS(Boolean, fmi2Boolean)
GET_STATUS(String, fmi2String)

fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real *value) {
    if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
    *value = ((Instance *)c)->v[component.value_count];
    return fmi2OK;
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t count,
                                       const fmi2Integer order[], const fmi2Real value[]) {
    (void)vr, (void)order, (void)value;
    return count ? unsupported(c, "fmi2SetRealInputDerivatives") : fmi2OK;
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t count,
                                        const fmi2Integer order[], fmi2Real value[]) {
    (void)vr, (void)order, (void)value;
    return count ? unsupported(c, "fmi2GetRealOutputDerivatives") : fmi2OK;
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknowns[], size_t n_unknowns,
                                        const fmi2ValueReference knowns[], size_t n_knowns, const fmi2Real seed[],
                                        fmi2Real sensitivity[]) {
    (void)unknowns, (void)n_unknowns, (void)knowns, (void)n_knowns, (void)seed, (void)sensitivity;
    return unsupported(c, "fmi2GetDirectionalDerivative");
}

/* --- state --- */

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state) { return (fmi2Status)state_save(c, state); }

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) { return (fmi2Status)state_restore(c, state); }

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state) {
    (void)c;
    state_free(state);
    return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size) {
    return (fmi2Status)state_serialized_size(c, state, size);
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    return (fmi2Status)state_serialize(c, state, bytes, size);
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state) {
    return (fmi2Status)state_deserialize(c, bytes, size, state);
}
