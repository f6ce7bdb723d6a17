/* FMI 3.0 for co-simulation around a system (FMI 3.0.1, sections 2.2, 2.3 and 4.2). A value reference is the number of a
   variable; the one behind them all is the time. */
#include "fmi3Functions.h"

#include "inside.h"

#include <stdlib.h>

typedef struct {
    SYSTEM s;
    fmi3LogMessageCallback logger;
    fmi3InstanceEnvironment environment;
    char *name, *resources;
    bool logging; /* what components say is told, and not only what goes wrong */
} Instance;

static void message(void *user, const char *component, int status, const char *text) {
    static const char *const CATEGORIES[] = {"logAll", "logStatusWarning", "logStatusError"};
    const Instance *instance = user;
    char words[1100];
    if (!instance->logger || (status == 0 && !instance->logging)) return;
    words[0] = '\0';
    strncat(words, component, 90), strncat(words, ": ", 3), strncat(words, text, 990);
    instance->logger(instance->environment, (fmi3Status)(status > 4 ? 3 : status), CATEGORIES[status > 1 ? 2 : status == 1], words);
}

static char *copied(const char *text) {
    char *copy = text ? malloc(strlen(text) + 1) : NULL;
    return copy ? strcpy(copy, text) : NULL;
}

static fmi3Status status_of(int failed) { return failed ? fmi3Error : fmi3OK; }

static fmi3Status unsupported(fmi3Instance c, const char *function) {
    Instance *instance = c;
    SYSTEM_say(&instance->s, instance->name, fmi3Error, "%s is not supported", function);
    return fmi3Error;
}

/* --- life cycle --- */

FMI3_Export const char *fmi3GetVersion(void) { return fmi3Version; }

FMI3_Export fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean on, size_t count, const fmi3String categories[]) {
    Instance *instance = c; /* what goes wrong is told always */
    bool all = count == 0;
    for (size_t k = 0; categories && k < count; k++) all = all || (categories[k] && strcmp(categories[k], "logAll") == 0);
    instance->logging = on && all;
    SYSTEM_log(&instance->s, instance->logging);
    return fmi3OK;
}

FMI3_Export void fmi3FreeInstance(fmi3Instance c) {
    Instance *instance = c;
    if (!instance) return;
    SYSTEM_close(&instance->s);
    free(instance->name), free(instance->resources), free(instance);
}

FMI3_Export fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources,
    fmi3Boolean visible, fmi3Boolean logging, fmi3Boolean event_mode, fmi3Boolean early_return,
    const fmi3ValueReference required[], size_t n_required, fmi3InstanceEnvironment environment,
    fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update) {
    (void)visible, (void)early_return, (void)required, (void)update;
    const char *wrong = !token || strcmp(token, "@GUID@") != 0 ? "the instantiation token is not that of this library"
                        : !name                                ? "an instance needs a name"
                        : event_mode                           ? "it has no event mode"
                        : n_required                           ? "it has no intermediate variables"
                                                               : NULL;
    if (wrong && log) log(environment, fmi3Error, "logStatusError", wrong);
    Instance *instance = wrong ? NULL : calloc(1, sizeof *instance);
    if (!instance) return NULL;
    instance->logging = logging;
    instance->name = copied(name), instance->resources = copied(resources);
    instance->logger = log, instance->environment = environment;
    if (!instance->name || SYSTEM_open(&instance->s, instance->name, instance->resources, message, instance)) {
        fmi3FreeInstance(instance);
        return NULL;
    }
    if (instance->logging) SYSTEM_log(&instance->s, true);
    return instance;
}

FMI3_Export fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources,
    fmi3Boolean visible, fmi3Boolean logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)environment, (void)log;
    return NULL;
}

FMI3_Export fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
    fmi3Boolean visible, fmi3Boolean logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
    fmi3ClockUpdateCallback clock, fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock) {
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)environment, (void)log;
    (void)clock, (void)lock, (void)unlock;
    return NULL;
}

FMI3_Export fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean with_tolerance, fmi3Float64 tolerance,
                                                   fmi3Float64 start, fmi3Boolean with_stop, fmi3Float64 stop) {
    (void)with_tolerance, (void)tolerance; /* each component has its own */
    return status_of(SYSTEM_enter(&((Instance *)c)->s, start, with_stop, stop));
}

FMI3_Export fmi3Status fmi3ExitInitializationMode(fmi3Instance c) { return status_of(SYSTEM_start(&((Instance *)c)->s)); }

FMI3_Export fmi3Status fmi3Terminate(fmi3Instance c) { return status_of(SYSTEM_terminate(&((Instance *)c)->s)); }

FMI3_Export fmi3Status fmi3Reset(fmi3Instance c) {
    Instance *instance = c;
    SYSTEM_close(&instance->s);
    if (SYSTEM_open(&instance->s, instance->name, instance->resources, message, instance)) return fmi3Error;
    if (instance->logging) SYSTEM_log(&instance->s, true);
    return fmi3OK;
}

/* --- values --- */

static bool of_type(Instance *instance, fmi3ValueReference vr, Type type) {
    if (vr < SYSTEM_VARIABLES && SYSTEM_variables[vr].type == (int)type) return true;
    SYSTEM_say(&instance->s, instance->name, fmi3Error, "value reference %u is not of the type of that function", vr);
    return false;
}

static fmi3Status wrong_size(Instance *instance, const char *function, size_t n, size_t n_values) {
    SYSTEM_say(&instance->s, instance->name, fmi3Error, "%s: %lu values for %lu variables, all of them scalars", function,
               (unsigned long)n_values, (unsigned long)n);
    return fmi3Error;
}

#define GET(Name, TYPE, function, ctype)                                                                           \
    FMI3_Export fmi3Status fmi3Get##Name(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3##Name v[],  \
                                         size_t n_values) {                                                        \
        if (n != n_values) return wrong_size(c, "fmi3Get" #Name, n, n_values);                                     \
        for (size_t k = 0; k < n; k++) {                                                                           \
            ctype found;                                                                                           \
            if (in_cell(c, vr[k], TYPE)) {                                                                         \
                v[k] = (fmi3##Name)((Instance *)c)->s.now.z[SYSTEM_in_cells[vr[k]]];                               \
                continue;                                                                                          \
            }                                                                                                      \
            if (is_time(vr[k], TYPE)) found = (ctype)((Instance *)c)->s.now.time;                                  \
            else if (!of_type(c, vr[k], TYPE) || SYSTEM_get_##function(&((Instance *)c)->s, (int)vr[k], &found))   \
                return fmi3Error;                                                                                  \
            v[k] = (fmi3##Name)found;                                                                              \
        }                                                                                                          \
        return fmi3OK;                                                                                             \
    }
#define SET(Name, TYPE, function)                                                                                  \
    FMI3_Export fmi3Status fmi3Set##Name(fmi3Instance c, const fmi3ValueReference vr[], size_t n,                  \
                                         const fmi3##Name v[], size_t n_values) {                                  \
        if (n != n_values) return wrong_size(c, "fmi3Set" #Name, n, n_values);                                     \
        for (size_t k = 0; k < n; k++)                                                                             \
            if (!of_type(c, vr[k], TYPE) || SYSTEM_set_##function(&((Instance *)c)->s, (int)vr[k], v[k]))          \
                return fmi3Error;                                                                                  \
        return fmi3OK;                                                                                             \
    }
#define BOTH(Name, TYPE, function, ctype) GET(Name, TYPE, function, ctype) SET(Name, TYPE, function)

static bool is_time(fmi3ValueReference vr, Type type) { return vr == SYSTEM_VARIABLES && type == T_FLOAT64; }

/* Whether a double can be read from its cell as it is: most are, at every step. */
static inline bool in_cell(const Instance *instance, fmi3ValueReference vr, Type type) {
    const SYSTEM_Stage stage = instance->s.now.stage;
    return type == T_FLOAT64 && vr < SYSTEM_VARIABLES && SYSTEM_in_cells[vr] >= 0 &&
           stage >= SYSTEM_RUNNING && stage <= SYSTEM_TERMINATED;
}

BOTH(Float64, T_FLOAT64, real, double)
BOTH(Float32, T_FLOAT32, real, double)
BOTH(Int8, T_INT8, whole, int64_t)
BOTH(UInt8, T_UINT8, whole, int64_t)
BOTH(Int16, T_INT16, whole, int64_t)
BOTH(UInt16, T_UINT16, whole, int64_t)
BOTH(Int32, T_INT32, whole, int64_t)
BOTH(UInt32, T_UINT32, whole, int64_t)
BOTH(Int64, T_INT64, whole, int64_t)
SET(UInt64, T_UINT64, whole)
GET(UInt64, T_UINT64, whole, int64_t)
BOTH(Boolean, T_BOOLEAN, whole, int64_t)

FMI3_Export fmi3Status fmi3GetString(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3String v[], size_t n_values) {
    if (n != n_values) return wrong_size(c, "fmi3GetString", n, n_values);
    for (size_t k = 0; k < n; k++)
        if (SYSTEM_get_text(&((Instance *)c)->s, (int)vr[k], &v[k])) return fmi3Error;
    return fmi3OK;
}

FMI3_Export fmi3Status fmi3SetString(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3String v[], size_t n_values) {
    if (n != n_values) return wrong_size(c, "fmi3SetString", n, n_values);
    for (size_t k = 0; k < n; k++)
        if (SYSTEM_set_text(&((Instance *)c)->s, (int)vr[k], v[k])) return fmi3Error;
    return fmi3OK;
}

/* --- step --- */

FMI3_Export fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64 time, fmi3Float64 step, fmi3Boolean no_rollback,
                                  fmi3Boolean *event, fmi3Boolean *end, fmi3Boolean *early, fmi3Float64 *last) {
    Instance *instance = c;
    instance->s.final = no_rollback;
    const int failed = SYSTEM_go_to(&instance->s, time, step);
    if (event) *event = fmi3False;
    if (end) *end = fmi3False;
    if (early) *early = fmi3False;
    if (last) *last = instance->s.now.time;
    return status_of(failed);
}

/* --- state --- */

FMI3_Export fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState *state) {
    return status_of(SYSTEM_save(&((Instance *)c)->s, (SYSTEM_State **)state));
}

FMI3_Export fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state) {
    return status_of(SYSTEM_restore(&((Instance *)c)->s, state));
}

FMI3_Export fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState *state) {
    SYSTEM_forget(&((Instance *)c)->s, (SYSTEM_State **)state);
    return fmi3OK;
}

FMI3_Export fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, size_t *size) {
    return status_of(SYSTEM_state_size(&((Instance *)c)->s, state, size));
}

FMI3_Export fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
    return status_of(SYSTEM_write_state(&((Instance *)c)->s, state, (char *)bytes, size));
}

FMI3_Export fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState *state) {
    return status_of(SYSTEM_read_state(&((Instance *)c)->s, (const char *)bytes, size, (SYSTEM_State **)state));
}

/* --- what a co-simulation without event mode does not have --- */

@UNSUPPORTED@
