/* Components of FMI 3.0: made, given values, asked. */
#include "inside.h"

#define MOST SYSTEM_LARGEST_ARRAY

static void logged3(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message) {
    SYSTEM *s = environment;
    (void)category;
    if (s && s->message) s->message(s->user, s->name, (int)status, message ? message : "");
}

int SYSTEM_make3(SYSTEM *s, int part, const Functions3 *f) {
    char folder[3100];
    SYSTEM_folder(s, part, false, folder, sizeof folder);
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

int SYSTEM_give3(SYSTEM *s, int part, int k, const Functions3 *f) {
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
        for (int j = 0; j < v->count; j++) text[j] = SYSTEM_text_of(s, k + j);
        return (int)f->SetString(s->part[part], &v->reference, 1, text, (size_t)v->count);
    }
    }
}

int SYSTEM_ask3(SYSTEM *s, int part, int k, const Functions3 *f, SYSTEM_Value *found) {
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
