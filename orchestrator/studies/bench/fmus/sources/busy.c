/* The FMU of feedthrough.c with a step that takes its time: WORK multiplications one after the other, and a state that
   remembers them. From FAILS_AT [s] on its step is answered with FAILS. */
#include "fmi2Functions.h"
#undef fmi2DoStep
#define fmi2DoStep pass_on
#include "feedthrough.c"
#undef fmi2DoStep

#ifndef WORK
#define WORK 1000
#endif
#ifndef FAILS_AT
#define FAILS_AT 1e300
#endif
#ifndef FAILS
#define FAILS fmi2Error
#endif

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean final)
{
    double *v = ((Model *)c)->v, x = 0.9 * v[SIGNALS] + 0.1 * v[0] + step;
    for (long k = 0; k < WORK; k++) x = x * 0.99999 + 1e-7 * time;
    v[SIGNALS] = x;
    return time >= FAILS_AT ? FAILS : fmi2OK;
}
