/* An FMU for Model Exchange around a model: FMI 2.0 (-DFMI=2) or FMI 3.0 (-DFMI=3).
 *
 * A model defines NR, NI, NX, NZ (numbers of reals, of Integers and Booleans, states, event indicators), includes this,
 * and defines `states` and `derivatives` (value references by number) and the functions
 *
 *   init       start values of parameters and states
 *   calculate  derivatives and outputs from time, states, inputs and parameters; 0, or a status of FMI
 *   indicate   event indicators
 *   event      one round of event mode: what it changed, as bits of Answer, and *next, the next time event
 *   completed  after a step of the solver: EVENT, END or 0
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#if FMI == 2
#include "fmi2Functions.h"
#else
#include "fmi3Functions.h"
#endif

enum Answer { AGAIN = 1, END = 2, NOMINALS = 4, STATES = 8, TIMED = 16, EVENT = 32 };

typedef struct {
    double time, r[NR];
    int i[NI + 1];
} Model;

static void init(Model *m);
static int calculate(Model *m);
static void indicate(Model *m, double *z);
static int event(Model *m, double *next);
static int completed(Model *m);
static double nominal(Model *m, int state);
static int states(size_t k);
static int derivatives(size_t k);

#if FMI == 2
#define F(name) fmi2##name
typedef fmi2Component Instance;
typedef fmi2ValueReference Ref;
#else
#define F(name) fmi3##name
#define WHOLE 1000000 /* where value references of Integers and Booleans begin */
typedef fmi3Instance Instance;
typedef fmi3ValueReference Ref;
#endif
#define STATUS(code) return (code) == 0 ? F(OK) : (F(Status))(code)

static Instance made(void) {
    Model *m = calloc(1, sizeof(Model));
    init(m);
    return m;
}

F(Status) F(SetTime)(Instance c, double time) {
    ((Model *)c)->time = time;
    return F(OK);
}

F(Status) F(SetContinuousStates)(Instance c, const double x[], size_t n) {
    for (size_t k = 0; k < n; k++) ((Model *)c)->r[states(k)] = x[k];
    return F(OK);
}

F(Status) F(GetContinuousStates)(Instance c, double x[], size_t n) {
    for (size_t k = 0; k < n; k++) x[k] = ((Model *)c)->r[states(k)];
    return F(OK);
}

F(Status) F(GetNominalsOfContinuousStates)(Instance c, double x[], size_t n) {
    for (size_t k = 0; k < n; k++) x[k] = nominal(c, (int)k);
    return F(OK);
}

F(Status) F(GetEventIndicators)(Instance c, double z[], size_t n) {
    int status = calculate(c);
    if (n > 0) indicate(c, z);
    STATUS(status);
}

static F(Status) rates(Instance c, double dx[], size_t n) {
    int status = calculate(c);
    for (size_t k = 0; k < n; k++) dx[k] = ((Model *)c)->r[derivatives(k)];
    STATUS(status);
}

F(Status) F(EnterEventMode)(Instance c) { return F(OK); }
F(Status) F(EnterContinuousTimeMode)(Instance c) { return F(OK); }
F(Status) F(ExitInitializationMode)(Instance c) { return F(OK); }
F(Status) F(Terminate)(Instance c) { return F(OK); }
F(Status) F(Reset)(Instance c) {
    memset(c, 0, sizeof(Model));
    init(c);
    return F(OK);
}
void F(FreeInstance)(Instance c) { free(c); }

static F(Status) put_reals(Instance c, const Ref at[], size_t n, const double v[]) {
    for (size_t k = 0; k < n; k++) ((Model *)c)->r[at[k]] = v[k];
    return F(OK);
}

static F(Status) take_reals(Instance c, const Ref at[], size_t n, double v[]) {
    int status = calculate(c);
    for (size_t k = 0; k < n; k++) v[k] = ((Model *)c)->r[at[k]];
    STATUS(status);
}

/* By differences: exact to rounding for what is linear, and close to it otherwise. */
static F(Status) directional(Instance c, const Ref z[], size_t nz, const Ref v[], size_t nv, const double dv[], double dz[]) {
    Model ahead = *(Model *)c, behind = ahead;
    double size = 1e-6;
    for (size_t k = 0; k < nv; k++) size = fmax(size, fabs(ahead.r[v[k]]));
    double h = 6e-6 * size;
    for (size_t k = 0; k < nv; k++) {
        ahead.r[v[k]] += h * dv[k];
        behind.r[v[k]] -= h * dv[k];
    }
    calculate(&ahead);
    calculate(&behind);
    for (size_t k = 0; k < nz; k++) dz[k] = (ahead.r[z[k]] - behind.r[z[k]]) / (2 * h);
    return F(OK);
}

static int kept(Instance c, void **state) {
    if (!*state) *state = malloc(sizeof(Model));
    memcpy(*state, c, sizeof(Model));
    return 0;
}

#if FMI == 2
const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return "2.0"; }
fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String place,
                              const fmi2CallbackFunctions *f, fmi2Boolean visible, fmi2Boolean logging) {
    return type == fmi2ModelExchange ? made() : NULL;
}
fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String categories[]) { return fmi2OK; }
fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean t, fmi2Real tolerance, fmi2Real start, fmi2Boolean s, fmi2Real stop) {
    ((Model *)c)->time = start;
    return fmi2OK;
}
fmi2Status fmi2EnterInitializationMode(fmi2Component c) { return fmi2OK; }
fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real dx[], size_t n) { return rates(c, dx, n); }
fmi2Status fmi2SetReal(fmi2Component c, const Ref at[], size_t n, const double v[]) { return put_reals(c, at, n, v); }
fmi2Status fmi2GetReal(fmi2Component c, const Ref at[], size_t n, double v[]) { return take_reals(c, at, n, v); }
fmi2Status fmi2SetInteger(fmi2Component c, const Ref at[], size_t n, const int v[]) {
    for (size_t k = 0; k < n; k++) ((Model *)c)->i[at[k]] = v[k];
    return fmi2OK;
}
fmi2Status fmi2GetInteger(fmi2Component c, const Ref at[], size_t n, int v[]) {
    for (size_t k = 0; k < n; k++) v[k] = ((Model *)c)->i[at[k]];
    return fmi2OK;
}
fmi2Status fmi2SetBoolean(fmi2Component c, const Ref at[], size_t n, const int v[]) { return fmi2SetInteger(c, at, n, v); }
fmi2Status fmi2GetBoolean(fmi2Component c, const Ref at[], size_t n, int v[]) { return fmi2GetInteger(c, at, n, v); }
fmi2Status fmi2SetString(fmi2Component c, const Ref at[], size_t n, const fmi2String v[]) { return fmi2Error; }
fmi2Status fmi2GetString(fmi2Component c, const Ref at[], size_t n, fmi2String v[]) { return fmi2Error; }
fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *info) {
    double next = 0.0;
    int said = event(c, &next);
    info->newDiscreteStatesNeeded = (said & AGAIN) != 0;
    info->terminateSimulation = (said & END) != 0;
    info->nominalsOfContinuousStatesChanged = (said & NOMINALS) != 0;
    info->valuesOfContinuousStatesChanged = (said & STATES) != 0;
    info->nextEventTimeDefined = (said & TIMED) != 0;
    info->nextEventTime = next;
    return fmi2OK;
}
fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean final, fmi2Boolean *enter, fmi2Boolean *end) {
    int said = completed(c);
    *enter = (said & EVENT) != 0;
    *end = (said & END) != 0;
    return fmi2OK;
}
fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const Ref z[], size_t nz, const Ref v[], size_t nv, const double dv[], double dz[]) {
    return directional(c, z, nz, v, nv, dv, dz);
}
fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state) { return kept(c, state); }
fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
    memcpy(c, state, sizeof(Model));
    return fmi2OK;
}
fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state) {
    free(*state);
    *state = NULL;
    return fmi2OK;
}
fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size) {
    *size = sizeof(Model);
    return fmi2OK;
}
fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    memcpy(bytes, state, sizeof(Model));
    return fmi2OK;
}
fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state) {
    *state = malloc(sizeof(Model));
    memcpy(*state, bytes, sizeof(Model));
    return fmi2OK;
}
#else
const char *fmi3GetVersion(void) { return "3.0"; }
fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String place, fmi3Boolean visible,
                                          fmi3Boolean logging, fmi3InstanceEnvironment e, fmi3LogMessageCallback log) {
    return made();
}
fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean on, size_t n, const fmi3String categories[]) { return fmi3OK; }
fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean t, fmi3Float64 tolerance, fmi3Float64 start, fmi3Boolean s, fmi3Float64 stop) {
    ((Model *)c)->time = start;
    return fmi3OK;
}
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance c, double dx[], size_t n) { return rates(c, dx, n); }
fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance c, size_t *n) {
    *n = NX;
    return fmi3OK;
}
fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance c, size_t *n) {
    *n = NZ;
    return fmi3OK;
}
fmi3Status fmi3SetFloat64(fmi3Instance c, const Ref at[], size_t n, const double v[], size_t nv) { return put_reals(c, at, n, v); }
fmi3Status fmi3GetFloat64(fmi3Instance c, const Ref at[], size_t n, double v[], size_t nv) { return take_reals(c, at, n, v); }
fmi3Status fmi3SetInt32(fmi3Instance c, const Ref at[], size_t n, const int v[], size_t nv) {
    for (size_t k = 0; k < n; k++) ((Model *)c)->i[at[k] - WHOLE] = v[k];
    return fmi3OK;
}
fmi3Status fmi3GetInt32(fmi3Instance c, const Ref at[], size_t n, int v[], size_t nv) {
    for (size_t k = 0; k < n; k++) v[k] = ((Model *)c)->i[at[k] - WHOLE];
    return fmi3OK;
}
fmi3Status fmi3SetBoolean(fmi3Instance c, const Ref at[], size_t n, const bool v[], size_t nv) {
    for (size_t k = 0; k < n; k++) ((Model *)c)->i[at[k] - WHOLE] = v[k];
    return fmi3OK;
}
fmi3Status fmi3GetBoolean(fmi3Instance c, const Ref at[], size_t n, bool v[], size_t nv) {
    for (size_t k = 0; k < n; k++) v[k] = ((Model *)c)->i[at[k] - WHOLE] != 0;
    return fmi3OK;
}
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, bool *again, bool *end, bool *nominals, bool *moved, bool *timed, double *next) {
    int said = event(c, next);
    *again = (said & AGAIN) != 0;
    *end = (said & END) != 0;
    *nominals = (said & NOMINALS) != 0;
    *moved = (said & STATES) != 0;
    *timed = (said & TIMED) != 0;
    return fmi3OK;
}
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance c, bool final, bool *enter, bool *end) {
    int said = completed(c);
    *enter = (said & EVENT) != 0;
    *end = (said & END) != 0;
    return fmi3OK;
}
fmi3Status fmi3GetDirectionalDerivative(fmi3Instance c, const Ref z[], size_t nz, const Ref v[], size_t nv,
                                        const double dv[], size_t ndv, double dz[], size_t ndz) {
    return directional(c, z, nz, v, nv, dv, dz);
}
fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState *state) { return kept(c, state); }
fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state) {
    memcpy(c, state, sizeof(Model));
    return fmi3OK;
}
fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState *state) {
    free(*state);
    *state = NULL;
    return fmi3OK;
}
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, size_t *size) {
    *size = sizeof(Model);
    return fmi3OK;
}
fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
    memcpy(bytes, state, sizeof(Model));
    return fmi3OK;
}
fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState *state) {
    *state = malloc(sizeof(Model));
    memcpy(*state, bytes, sizeof(Model));
    return fmi3OK;
}
#endif
