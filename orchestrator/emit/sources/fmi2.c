/* FMI 2.0 for co-simulation around a system (FMI 2.0.4, sections 2.1 and 4.2). A value reference is the number of a
   variable. */
#include "fmi2Functions.h"

#include "inside.h"

#include <stdlib.h>

typedef struct {
    SYSTEM s;
    fmi2CallbackLogger logger;
    fmi2ComponentEnvironment environment;
    char *name, *resources;
    double start, stop;
    int with_stop;
    bool logging; /* what components say is told, and not only what goes wrong */
} Instance;

static void message(void *user, const char *component, int status, const char *text) {
    static const char *const CATEGORIES[] = {"logAll", "logStatusWarning", "logStatusError"};
    const Instance *instance = user;
    char words[2300];
    size_t n = 0;
    if (!instance->logger || (status == 0 && !instance->logging)) return;
    const char *const parts[] = {component, ": ", text};
    for (int k = 0; k < 3; k++)
        for (const char *c = parts[k]; *c && n + 3 < sizeof words; c++) {
            if (*c == '%') words[n++] = '%'; /* a format without arguments: hosts not in C cannot read those */
            words[n++] = *c;
        }
    words[n] = '\0';
    instance->logger(instance->environment, instance->name, (fmi2Status)(status & 7), CATEGORIES[status > 1 ? 2 : status == 1], words);
}

static char *copied(const char *text) {
    char *copy = text ? malloc(strlen(text) + 1) : NULL;
    return copy ? strcpy(copy, text) : NULL;
}

static fmi2Status status_of(int failed) { return failed ? fmi2Error : fmi2OK; }

static fmi2Status unsupported(fmi2Component c, const char *function) {
    Instance *instance = c;
    SYSTEM_say(&instance->s, instance->name, fmi2Error, "%s is not supported", function);
    return fmi2Error;
}

/* --- life cycle --- */

FMI2_Export const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
FMI2_Export const char *fmi2GetVersion(void) { return fmi2Version; }

FMI2_Export fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t count, const fmi2String categories[]) {
    Instance *instance = c; /* what goes wrong is told always */
    bool all = count == 0;
    for (size_t k = 0; categories && k < count; k++) all = all || (categories[k] && strcmp(categories[k], "logAll") == 0);
    instance->logging = on && all;
    SYSTEM_log(&instance->s, instance->logging);
    return fmi2OK;
}

FMI2_Export fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String token, fmi2String resources,
                                          const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging) {
    (void)visible;
    const fmi2CallbackLogger logger = callbacks ? callbacks->logger : NULL;
    const bool known = token && strcmp(token, "@GUID@") == 0;
    if (type != fmi2CoSimulation || !name || !known) {
        if (logger)
            logger(callbacks->componentEnvironment, name ? name : "", fmi2Error, "logStatusError",
                   !known ? "the GUID is not that of this library" : name ? "it is for co-simulation" : "an instance needs a name");
        return NULL;
    }
    Instance *instance = calloc(1, sizeof *instance);
    if (!instance) return NULL;
    instance->name = copied(name), instance->resources = copied(resources), instance->logging = logging != 0;
    if (callbacks) instance->logger = logger, instance->environment = callbacks->componentEnvironment;
    if (!instance->name || SYSTEM_open(&instance->s, instance->name, instance->resources, message, instance)) {
        fmi2FreeInstance(instance);
        return NULL;
    }
    if (instance->logging) SYSTEM_log(&instance->s, true);
    return instance;
}

FMI2_Export void fmi2FreeInstance(fmi2Component c) {
    Instance *instance = c;
    if (!instance) return;
    SYSTEM_close(&instance->s);
    free(instance->name), free(instance->resources), free(instance);
}

FMI2_Export fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean with_tolerance, fmi2Real tolerance, fmi2Real start,
                                           fmi2Boolean with_stop, fmi2Real stop) {
    Instance *instance = c;
    (void)with_tolerance, (void)tolerance; /* each component has its own */
    if (instance->s.now.stage != SYSTEM_NEW)
        return status_of(SYSTEM_say(&instance->s, instance->name, fmi2Error, "an experiment is set up before the initialization"));
    instance->start = start, instance->with_stop = with_stop != 0, instance->stop = stop;
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
    Instance *instance = c;
    return status_of(SYSTEM_enter(&instance->s, instance->start, instance->with_stop, instance->stop));
}

FMI2_Export fmi2Status fmi2ExitInitializationMode(fmi2Component c) { return status_of(SYSTEM_start(&((Instance *)c)->s)); }

FMI2_Export fmi2Status fmi2Terminate(fmi2Component c) { return status_of(SYSTEM_terminate(&((Instance *)c)->s)); }

FMI2_Export fmi2Status fmi2Reset(fmi2Component c) {
    Instance *instance = c;
    SYSTEM_close(&instance->s);
    instance->start = instance->stop = 0.0, instance->with_stop = 0;
    if (SYSTEM_open(&instance->s, instance->name, instance->resources, message, instance)) return fmi2Error;
    if (instance->logging) SYSTEM_log(&instance->s, true);
    return fmi2OK;
}

/* --- values --- */

/* Whether a function is that of a variable's type. */
static bool of_kind(Instance *instance, fmi2ValueReference vr, SYSTEM_Kind kind) {
    if (vr < SYSTEM_VARIABLES && SYSTEM_variables[vr].kind == kind) return true;
    SYSTEM_say(&instance->s, instance->name, fmi2Error, "value reference %u is not of the type of that function", vr);
    return false;
}

#define GET(Name, Type, KIND, function, ctype)                                                                     \
    FMI2_Export fmi2Status fmi2Get##Name(fmi2Component c, const fmi2ValueReference vr[], size_t n, Type v[]) {       \
        for (size_t k = 0; k < n; k++) {                                                                           \
            ctype found;                                                                                           \
            if (!of_kind(c, vr[k], KIND) || SYSTEM_get_##function(&((Instance *)c)->s, (int)vr[k], &found))        \
                return fmi2Error;                                                                                  \
            v[k] = (Type)found;                                                                                    \
        }                                                                                                          \
        return fmi2OK;                                                                                             \
    }
#define SET(Name, Type, KIND, function)                                                                            \
    FMI2_Export fmi2Status fmi2Set##Name(fmi2Component c, const fmi2ValueReference vr[], size_t n, const Type v[]) { \
        for (size_t k = 0; k < n; k++)                                                                             \
            if (!of_kind(c, vr[k], KIND) || SYSTEM_set_##function(&((Instance *)c)->s, (int)vr[k], v[k]))          \
                return fmi2Error;                                                                                  \
        return fmi2OK;                                                                                             \
    }

FMI2_Export fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real v[]) {
    return status_of(SYSTEM_get_reals(&((Instance *)c)->s, vr, n, v));
}

GET(Integer, fmi2Integer, SYSTEM_WHOLE, whole, int64_t)
GET(Boolean, fmi2Boolean, SYSTEM_BOOLEAN, whole, int64_t)
GET(String, fmi2String, SYSTEM_TEXT, text, const char *)
SET(Real, fmi2Real, SYSTEM_REAL, real)
SET(Integer, fmi2Integer, SYSTEM_WHOLE, whole)
SET(Boolean, fmi2Boolean, SYSTEM_BOOLEAN, whole)
SET(String, fmi2String, SYSTEM_TEXT, text)

/* --- step --- */

FMI2_Export fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_rollback) {
    Instance *instance = c;
    instance->s.final = no_rollback != 0;
    return status_of(SYSTEM_go_to(&instance->s, time, step));
}

FMI2_Export fmi2Status fmi2CancelStep(fmi2Component c) { return unsupported(c, "fmi2CancelStep"); }

#define GET_STATUS(Name, Type)                                                                              \
    FMI2_Export fmi2Status fmi2Get##Name##Status(fmi2Component c, const fmi2StatusKind kind, Type *value) { \
        (void)c, (void)kind, (void)value;                                                                   \
        return fmi2Discard; /* every step ends before fmi2DoStep returns */                                 \
    }
GET_STATUS(, fmi2Status)
GET_STATUS(Integer, fmi2Integer)
GET_STATUS(Boolean, fmi2Boolean)
GET_STATUS(String, fmi2String)

FMI2_Export fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real *value) {
    if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
    *value = ((Instance *)c)->s.now.time;
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                                   const fmi2Integer order[], const fmi2Real value[]) {
    (void)vr, (void)order, (void)value;
    return n ? unsupported(c, "fmi2SetRealInputDerivatives") : fmi2OK;
}

FMI2_Export fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                                    const fmi2Integer order[], fmi2Real value[]) {
    (void)vr, (void)order, (void)value;
    return n ? unsupported(c, "fmi2GetRealOutputDerivatives") : fmi2OK;
}

FMI2_Export fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknowns[], size_t n_unknowns,
                                                    const fmi2ValueReference knowns[], size_t n_knowns,
                                                    const fmi2Real seed[], fmi2Real sensitivity[]) {
    (void)unknowns, (void)n_unknowns, (void)knowns, (void)n_knowns, (void)seed, (void)sensitivity;
    return unsupported(c, "fmi2GetDirectionalDerivative");
}

/* --- state --- */

FMI2_Export fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state) {
    return status_of(SYSTEM_save(&((Instance *)c)->s, (SYSTEM_State **)state));
}

FMI2_Export fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
    return status_of(SYSTEM_restore(&((Instance *)c)->s, state));
}

FMI2_Export fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state) {
    SYSTEM_forget(&((Instance *)c)->s, (SYSTEM_State **)state);
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size) {
    return status_of(SYSTEM_state_size(&((Instance *)c)->s, state, size));
}

FMI2_Export fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    return status_of(SYSTEM_write_state(&((Instance *)c)->s, state, bytes, size));
}

FMI2_Export fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state) {
    return status_of(SYSTEM_read_state(&((Instance *)c)->s, bytes, size, (SYSTEM_State **)state));
}
