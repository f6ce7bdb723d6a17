/* A motor as tools export models (FMI 2.0, co-simulation): the equations of tests/fixtures/modelica/DcMotor.mo, integrated
   by RK4 inside; outputs that follow inputs at once, computed when they are asked for; INNER local variables more, which
   every step computes; with LOG a message after every step, whether anybody wants it or not.
   Value references: 0 v, 1 tau_load, 2.. the outputs current, speed, heat, v_left, 6.. the states, then the locals. */
#include <stdlib.h>
#include <string.h>
#include "fmi2Functions.h"

#ifndef INNER
#define INNER 300
#endif

enum { V, TAU, CURRENT, SPEED, HEAT, LEFT, I, W, LOCALS, ALL = LOCALS + INNER };
static const double R = 0.1, L = 0.05, K = 0.016, D = 0.001, J_ROTOR = 5e-5, J_LOAD = 0.6, RATIO = 27.2484;

typedef struct {
    double v[ALL];
    int stale;
    const fmi2CallbackFunctions *callbacks;
} Model;

static void rates(const double *v, double i, double w, double *di, double *dw)
{
    *di = (v[V] - R * i - K * RATIO * w) / (L / 1000.0);
    *dw = (RATIO * (K * i - D * RATIO * w) - v[TAU]) / (J_ROTOR * RATIO * RATIO + J_LOAD);
}

static void copy(Model *m) /* to the outputs */
{
    double *v = m->v;
    v[CURRENT] = v[I];
    v[SPEED] = v[W] * 30.0 / 3.141592653589793;
    v[HEAT] = R * v[I] * v[I];
    v[LEFT] = v[V] - R * v[I];
    m->stale = 0;
}

static void step(Model *m, double h)
{
    double *v = m->v, *i = &v[I], *w = &v[W], a, b, c, d, e, f, g, k;
    int n = (int)(h / 1e-4 + 0.5);
    if (n < 1) n = 1;
    h /= n;
    for (int s = 0; s < n; s++) {
        rates(v, *i, *w, &a, &b);
        rates(v, *i + h / 2 * a, *w + h / 2 * b, &c, &d);
        rates(v, *i + h / 2 * c, *w + h / 2 * d, &e, &f);
        rates(v, *i + h * e, *w + h * f, &g, &k);
        *i += h / 6 * (a + 2 * (c + e) + g);
        *w += h / 6 * (b + 2 * (d + f) + k);
    }
    for (int j = 0; j < INNER; j++) v[LOCALS + j] = *i * j + *w;
    copy(m);
}

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return "2.0"; }
fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String categories[]) { return fmi2OK; }
fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *f, fmi2Boolean visible, fmi2Boolean logging)
{
    Model *m = calloc(1, sizeof(Model));
    if (m) m->callbacks = f;
    return m;
}
void fmi2FreeInstance(fmi2Component c) { free(c); }
fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean t, fmi2Real tolerance, fmi2Real start, fmi2Boolean s,
                               fmi2Real stop) { return fmi2OK; }
fmi2Status fmi2EnterInitializationMode(fmi2Component c) { return fmi2OK; }
fmi2Status fmi2ExitInitializationMode(fmi2Component c) { copy(c); return fmi2OK; }
fmi2Status fmi2Terminate(fmi2Component c) { return fmi2OK; }
fmi2Status fmi2Reset(fmi2Component c) { memset(((Model *)c)->v, 0, sizeof(double) * ALL); return fmi2OK; }

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference r[], size_t n, fmi2Real value[])
{
    if (((Model *)c)->stale) copy(c);
    for (size_t k = 0; k < n; k++) value[k] = ((Model *)c)->v[r[k]];
    return fmi2OK;
}
fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2Real value[])
{
    for (size_t k = 0; k < n; k++) ((Model *)c)->v[r[k]] = value[k];
    ((Model *)c)->stale = 1;
    return fmi2OK;
}
#define NO_SUCH(type) \
    fmi2Status fmi2Get##type(fmi2Component c, const fmi2ValueReference r[], size_t n, fmi2##type v[]) { return fmi2Error; } \
    fmi2Status fmi2Set##type(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2##type v[]) { return fmi2Error; }
NO_SUCH(Integer)
NO_SUCH(Boolean)
NO_SUCH(String)

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state)
{
    if (!*state) *state = malloc(sizeof(Model));
    memcpy(*state, c, sizeof(Model));
    return fmi2OK;
}
fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) { memcpy(c, state, sizeof(Model)); return fmi2OK; }
fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state) { free(*state); *state = NULL; return fmi2OK; }
fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate s, size_t *size) { *size = sizeof(Model); return fmi2OK; }
fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate s, fmi2Byte b[], size_t n) { memcpy(b, s, n); return fmi2OK; }
fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte b[], size_t n, fmi2FMUstate *s)
{
    if (!*s) *s = malloc(sizeof(Model));
    memcpy(*s, b, n);
    return fmi2OK;
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real t, fmi2Real h, fmi2Boolean noSet)
{
    Model *m = c;
    step(m, h);
#ifdef LOG
    m->callbacks->logger(m->callbacks->componentEnvironment, "motor", fmi2OK, "logAll",
                         "t = %.17g s: %g s further, current %g A, speed %g rad/s", t, h, m->v[I], m->v[W]);
#endif
    return fmi2OK;
}
fmi2Status fmi2CancelStep(fmi2Component c) { return fmi2Error; }
fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2Integer o[],
                                       const fmi2Real v[]) { return fmi2Error; }
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2Integer o[],
                                        fmi2Real v[]) { return fmi2Error; }
fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference u[], size_t nu,
                                        const fmi2ValueReference k[], size_t nk, const fmi2Real dk[], fmi2Real du[])
{
    return fmi2Error;
}
fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind k, fmi2Status *v) { return fmi2Discard; }
fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind k, fmi2Real *v) { return fmi2Discard; }
fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind k, fmi2Integer *v) { return fmi2Discard; }
fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind k, fmi2Boolean *v) { return fmi2Discard; }
fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind k, fmi2String *v) { return fmi2Discard; }
