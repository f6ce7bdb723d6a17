/* Components of FMI 2.0: made, given values, asked. */
#include "inside.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

static void logged2(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status, fmi2String category,
                    fmi2String format, ...) {
    SYSTEM *s = environment;
    char text[1000];
    va_list arguments;
    (void)category;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format ? format : "", arguments);
    va_end(arguments);
    if (s && s->message) s->message(s->user, instance ? instance : "", (int)status, text);
}

int SYSTEM_make2(SYSTEM *s, int part, const Functions2 *f) {
    fmi2CallbackFunctions *callbacks = (fmi2CallbackFunctions *)(void *)s->callbacks;
    char folder[9000];
    const fmi2CallbackFunctions own = {logged2, calloc, free, NULL, s};
    memcpy(callbacks, &own, sizeof own);
    SYSTEM_folder(s, part, true, folder, sizeof folder);
    s->part[part] = f->Instantiate(SYSTEM_parts[part].name, fmi2CoSimulation, SYSTEM_parts[part].token, folder, callbacks,
                                   fmi2False, fmi2False);
    return s->part[part] == NULL;
}

int SYSTEM_give2(SYSTEM *s, int part, int k, const Functions2 *f) {
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    const fmi2Integer whole = (fmi2Integer)s->now.values[k].whole;
    switch (v->type) {
    case T_FLOAT64: return (int)f->SetReal(s->part[part], &v->reference, 1, &s->now.values[k].real);
    case T_BOOLEAN: return (int)f->SetBoolean(s->part[part], &v->reference, 1, &whole);
    case T_STRING: {
        const char *text = SYSTEM_text_of(s, k);
        return (int)f->SetString(s->part[part], &v->reference, 1, &text);
    }
    default: return (int)f->SetInteger(s->part[part], &v->reference, 1, &whole);
    }
}

int SYSTEM_ask2(SYSTEM *s, int part, int k, const Functions2 *f, SYSTEM_Value *value) {
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    fmi2Integer whole = 0;
    int status;
    switch (v->type) {
    case T_FLOAT64: return (int)f->GetReal(s->part[part], &v->reference, 1, &value->real);
    case T_BOOLEAN: status = (int)f->GetBoolean(s->part[part], &v->reference, 1, &whole), whole = whole != 0; break;
    default: status = (int)f->GetInteger(s->part[part], &v->reference, 1, &whole);
    }
    value->whole = whole;
    return status;
}
