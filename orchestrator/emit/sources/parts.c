/* The components of a system, whatever their version of FMI: made, initialized, asked, saved. */
#include "inside.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#define MOST SYSTEM_LARGEST_ARRAY

static const char *text_of(const SYSTEM *s, int k) { return s->texts[k] ? s->texts[k] : SYSTEM_variables[k].text; }

/* The folder of a component's own resources: a path, or a URI of it. */
static void folder_of(const SYSTEM *s, int part, int uri, char *to, size_t size) {
    const char *folder = SYSTEM_parts[part].folder, *given = s->resources ? s->resources : "";
    const int is_uri = strncmp(given, "file:", 5) == 0;
    if (!is_uri && uri && given[0] == '/') snprintf(to, size, "file://%s%s%s", given, folder ? "/" : "", folder ? folder : "");
    else snprintf(to, size, "%s%s%s", given, folder && given[0] ? "/" : "", folder ? folder : "");
}

#if SYSTEM_FMI2
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

static int make2(SYSTEM *s, int part, const Functions2 *f) {
    fmi2CallbackFunctions *callbacks = (fmi2CallbackFunctions *)(void *)s->callbacks;
    char folder[2000];
    const fmi2CallbackFunctions own = {logged2, calloc, free, NULL, s};
    memcpy(callbacks, &own, sizeof own);
    folder_of(s, part, 1, folder, sizeof folder);
    s->part[part] = f->Instantiate(SYSTEM_parts[part].name, fmi2CoSimulation, SYSTEM_parts[part].token, folder, callbacks,
                                   fmi2False, fmi2False);
    return s->part[part] == NULL;
}

static int give2(SYSTEM *s, int part, int k, const Functions2 *f) {
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    const fmi2Integer whole = (fmi2Integer)s->now.values[k].whole;
    switch (v->type) {
    case T_FLOAT64: return (int)f->SetReal(s->part[part], &v->reference, 1, &s->now.values[k].real);
    case T_BOOLEAN: return (int)f->SetBoolean(s->part[part], &v->reference, 1, &whole);
    case T_STRING: {
        const char *text = text_of(s, k);
        return (int)f->SetString(s->part[part], &v->reference, 1, &text);
    }
    default: return (int)f->SetInteger(s->part[part], &v->reference, 1, &whole);
    }
}

static int ask2(SYSTEM *s, int part, int k, const Functions2 *f, SYSTEM_Value *value) {
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
#endif

#if SYSTEM_FMI3
static void logged3(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message) {
    SYSTEM *s = environment;
    (void)category;
    if (s && s->message) s->message(s->user, s->name, (int)status, message ? message : "");
}

static int make3(SYSTEM *s, int part, const Functions3 *f) {
    char folder[2000];
    folder_of(s, part, 0, folder, sizeof folder);
    s->part[part] = f->InstantiateCoSimulation(SYSTEM_parts[part].name, SYSTEM_parts[part].token, folder[0] ? folder : NULL,
                                               0, 0, 0, 0, NULL, 0, s, logged3, NULL);
    return s->part[part] == NULL;
}

#define GIVE(TYPE, Name, field)                                                                              \
    case TYPE: {                                                                                             \
        fmi3##Name value[MOST];                                                                              \
        for (int j = 0; j < v->count; j++) value[j] = (fmi3##Name)s->now.values[k + j].field;                \
        return (int)f->Set##Name(s->part[part], &v->reference, 1, value, (size_t)v->count);                  \
    }
#define ASK(TYPE, Name, field, ctype)                                                                        \
    case TYPE: {                                                                                             \
        fmi3##Name value[MOST];                                                                              \
        const int status = (int)f->Get##Name(s->part[part], &v->reference, 1, value, (size_t)v->count);      \
        found->field = (ctype)value[v->index];                                                               \
        return status;                                                                                       \
    }

static int give3(SYSTEM *s, int part, int k, const Functions3 *f) {
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    switch (v->type) {
    GIVE(T_FLOAT64, Float64, real)
    GIVE(T_FLOAT32, Float32, real)
    GIVE(T_INT8, Int8, whole)
    GIVE(T_UINT8, UInt8, whole)
    GIVE(T_INT16, Int16, whole)
    GIVE(T_UINT16, UInt16, whole)
    GIVE(T_INT32, Int32, whole)
    GIVE(T_UINT32, UInt32, whole)
    GIVE(T_INT64, Int64, whole)
    GIVE(T_UINT64, UInt64, whole)
    GIVE(T_BOOLEAN, Boolean, whole)
    default: {
        const char *text[MOST];
        for (int j = 0; j < v->count; j++) text[j] = text_of(s, k + j);
        return (int)f->SetString(s->part[part], &v->reference, 1, text, (size_t)v->count);
    }
    }
}

static int ask3(SYSTEM *s, int part, int k, const Functions3 *f, SYSTEM_Value *found) {
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    switch (v->type) {
    ASK(T_FLOAT64, Float64, real, double)
    ASK(T_FLOAT32, Float32, real, double)
    ASK(T_INT8, Int8, whole, int64_t)
    ASK(T_UINT8, UInt8, whole, int64_t)
    ASK(T_INT16, Int16, whole, int64_t)
    ASK(T_UINT16, UInt16, whole, int64_t)
    ASK(T_INT32, Int32, whole, int64_t)
    ASK(T_UINT32, UInt32, whole, int64_t)
    ASK(T_INT64, Int64, whole, int64_t)
    ASK(T_UINT64, UInt64, whole, int64_t)
    ASK(T_BOOLEAN, Boolean, whole, int64_t)
    default: return 3;
    }
}
#endif

/* The same for both; F stands for the functions of a part. */
#if SYSTEM_FMI2 && SYSTEM_FMI3
#define EITHER(two, three)                                       \
    if (SYSTEM_parts[part].version == 2) {                       \
        const Functions2 *f = SYSTEM_parts[part].functions;      \
        two;                                                     \
    } else {                                                     \
        const Functions3 *f = SYSTEM_parts[part].functions;      \
        three;                                                   \
    }
#elif SYSTEM_FMI2
#define EITHER(two, three)                                  \
    const Functions2 *f = SYSTEM_parts[part].functions;     \
    two;
#else
#define EITHER(two, three)                                  \
    const Functions3 *f = SYSTEM_parts[part].functions;     \
    three;
#endif

static int good(int status) { return (status & ~1) == 0; }

int SYSTEM_part_make(SYSTEM *s, int part) {
    EITHER(return make2(s, part, f), return make3(s, part, f))
}

int SYSTEM_part_set_up(SYSTEM *s, int part, double start, int with_stop, double stop) {
    const double tolerance = SYSTEM_parts[part].tolerance;
    int status = 0;
    (void)tolerance, (void)start, (void)with_stop, (void)stop;
    EITHER(status = (int)f->SetupExperiment(s->part[part], tolerance > 0.0, tolerance, start, with_stop, with_stop ? stop : 0.0),
           (void)f)
    return good(status) ? 0 : SYSTEM_refused(s, part, "be set up", status);
}

int SYSTEM_part_enter(SYSTEM *s, int part, double start, int with_stop, double stop) {
    const double tolerance = SYSTEM_parts[part].tolerance;
    int status = 0;
    (void)tolerance, (void)start, (void)with_stop, (void)stop;
    EITHER(status = (int)f->EnterInitializationMode(s->part[part]),
           status = (int)f->EnterInitializationMode(s->part[part], tolerance > 0.0, tolerance, start, with_stop != 0,
                                                    with_stop ? stop : 0.0))
    return good(status) ? 0 : SYSTEM_refused(s, part, "enter initialization", status);
}

int SYSTEM_part_leave(SYSTEM *s, int part) {
    int status = 0;
    EITHER(status = (int)f->ExitInitializationMode(s->part[part]), status = (int)f->ExitInitializationMode(s->part[part]))
    return good(status) ? 0 : SYSTEM_refused(s, part, "leave initialization", status);
}

int SYSTEM_part_terminate(SYSTEM *s, int part) {
    int status = 0;
    EITHER(status = (int)f->Terminate(s->part[part]), status = (int)f->Terminate(s->part[part]))
    return good(status) ? 0 : 1;
}

void SYSTEM_part_free(SYSTEM *s, int part) {
    if (!s->part[part]) return;
    EITHER(f->FreeInstance(s->part[part]), f->FreeInstance(s->part[part]))
    s->part[part] = NULL;
}

int SYSTEM_part_give(SYSTEM *s, int k) {
    const int part = SYSTEM_variables[k].part;
    int status = 3;
    if (part < 0) return 0;
    EITHER(status = give2(s, part, k, f), status = give3(s, part, k, f))
    if (good(status)) return 0;
    return SYSTEM_say(s, SYSTEM_parts[part].name, status, "%s cannot be set (status %d)", SYSTEM_variables[k].name, status);
}

int SYSTEM_part_ask(SYSTEM *s, int k, SYSTEM_Value *value) {
    const int part = SYSTEM_variables[k].part;
    int status = 3;
    EITHER(status = ask2(s, part, k, f, value), status = ask3(s, part, k, f, value))
    if (good(status)) return 0;
    return SYSTEM_say(s, SYSTEM_parts[part].name, status, "%s cannot be got (status %d)", SYSTEM_variables[k].name, status);
}

int SYSTEM_part_save(SYSTEM *s, int part, void **state) {
    if (!SYSTEM_parts[part].saves) return 1;
    EITHER(return !good((int)f->GetFMUstate(s->part[part], state)), return !good((int)f->GetFMUState(s->part[part], state)))
}

int SYSTEM_part_restore(SYSTEM *s, int part, void *state) {
    EITHER(return !good((int)f->SetFMUstate(s->part[part], state)), return !good((int)f->SetFMUState(s->part[part], state)))
}

void SYSTEM_part_forget(SYSTEM *s, int part, void **state) {
    if (!*state) return;
    EITHER(f->FreeFMUstate(s->part[part], state), f->FreeFMUState(s->part[part], state))
    *state = NULL;
}

int SYSTEM_part_state_size(SYSTEM *s, int part, void *state, size_t *size) {
    if (!SYSTEM_parts[part].serializes) return 1;
    EITHER(return !good((int)f->SerializedFMUstateSize(s->part[part], state, size)),
           return !good((int)f->SerializedFMUStateSize(s->part[part], state, size)))
}

int SYSTEM_part_write(SYSTEM *s, int part, void *state, char *bytes, size_t size) {
    EITHER(return !good((int)f->SerializeFMUstate(s->part[part], state, bytes, size)),
           return !good((int)f->SerializeFMUState(s->part[part], state, (fmi3Byte *)bytes, size)))
}

int SYSTEM_part_read(SYSTEM *s, int part, const char *bytes, size_t size, void **state) {
    EITHER(return !good((int)f->DeSerializeFMUstate(s->part[part], bytes, size, state)),
           return !good((int)f->DeserializeFMUState(s->part[part], (const fmi3Byte *)bytes, size, state)))
}
