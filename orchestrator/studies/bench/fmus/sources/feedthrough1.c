/* An FMI 1.0 co-simulation FMU that does as little as possible: y = u after every step. Its functions begin with MODEL.
   Value references: 0 the input, 1 the output. */
#include <stdlib.h>
#include "fmi1Functions.h"

#define JOINED(a, b) a##_fmi##b
#define NAMED(a, b) JOINED(a, b)
#define F(name) NAMED(MODEL, name)

const char *F(GetTypesPlatform)(void) { return "standard32"; }
const char *F(GetVersion)(void) { return "1.0"; }
fmi1Component F(InstantiateSlave)(fmi1String name, fmi1String guid, fmi1String location, fmi1String mime, fmi1Real timeout,
                                  fmi1Boolean visible, fmi1Boolean interactive, fmi1CallbackFunctions f, fmi1Boolean on)
{
    return calloc(2, sizeof(double));
}
void F(FreeSlaveInstance)(fmi1Component c) { free(c); }
static fmi1Status copy(double v[]) { v[1] = v[0]; return fmi1OK; }
fmi1Status F(InitializeSlave)(fmi1Component c, fmi1Real start, fmi1Boolean defined, fmi1Real stop) { return copy(c); }
fmi1Status F(DoStep)(fmi1Component c, fmi1Real t, fmi1Real h, fmi1Boolean fresh) { return copy(c); }
fmi1Status F(TerminateSlave)(fmi1Component c) { return fmi1OK; }
fmi1Status F(ResetSlave)(fmi1Component c) { ((double *)c)[0] = ((double *)c)[1] = 0; return fmi1OK; }
fmi1Status F(SetDebugLogging)(fmi1Component c, fmi1Boolean on) { return fmi1OK; }
fmi1Status F(GetReal)(fmi1Component c, const fmi1ValueReference r[], size_t n, fmi1Real value[])
{
    for (size_t k = 0; k < n; k++) value[k] = ((double *)c)[r[k]];
    return fmi1OK;
}
fmi1Status F(SetReal)(fmi1Component c, const fmi1ValueReference r[], size_t n, const fmi1Real value[])
{
    for (size_t k = 0; k < n; k++) ((double *)c)[r[k]] = value[k];
    return fmi1OK;
}
#define NO_SUCH(name) fmi1Status F(name)(fmi1Component c) { return fmi1Error; }
NO_SUCH(GetInteger) NO_SUCH(GetBoolean) NO_SUCH(GetString) NO_SUCH(SetInteger) NO_SUCH(SetBoolean) NO_SUCH(SetString)
NO_SUCH(SetRealInputDerivatives) NO_SUCH(GetRealOutputDerivatives) NO_SUCH(CancelStep) NO_SUCH(GetStatus)
NO_SUCH(GetRealStatus) NO_SUCH(GetIntegerStatus) NO_SUCH(GetBooleanStatus) NO_SUCH(GetStringStatus)
