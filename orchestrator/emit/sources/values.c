/* The values of a system's variables: set, passed on to its components, and got. */
#include "inside.h"

#include <float.h>
#include <stdlib.h>

static int checked(SYSTEM *s, int k, SYSTEM_Kind a, SYSTEM_Kind b) {
    static const char *const KINDS[] = {"a real number", "a whole number", "a Boolean", "a text"};
    if (k < 0 || k >= SYSTEM_VARIABLES) return SYSTEM_say(s, s->name, 3, "there is no variable of number %d", k);
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    if (v->kind != a && v->kind != b) return SYSTEM_say(s, s->name, 3, "%s is %s", v->name, KINDS[v->kind]);
    return 0;
}

/* 0 where a variable may be set now. */
static int settable(SYSTEM *s, int k) {
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    if (v->causality != SYSTEM_PARAMETER && v->causality != SYSTEM_TUNABLE && v->causality != SYSTEM_INPUT)
        return SYSTEM_say(s, s->name, 3, "%s cannot be set", v->name);
    if (s->now.stage > SYSTEM_RUNNING) return SYSTEM_say(s, s->name, 3, "%s: %s can be set no more", s->name, v->name);
    if (s->now.stage == SYSTEM_RUNNING && v->causality == SYSTEM_PARAMETER)
        return SYSTEM_say(s, s->name, 3, "%s is a parameter; it is set before the run", v->name);
    return 0;
}

/* A value in its cell, and with its component where that is there to hear it. */
static int pass_on(SYSTEM *s, int k) {
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    s->now.given[k] = true;
    if (s->now.stage == SYSTEM_NEW) return 0;
    s->now.stale = s->now.stage == SYSTEM_INITIALIZING;
    if (v->cell >= 0 && v->kind == SYSTEM_REAL) s->now.z[v->cell] = s->now.values[k].real;
    else if (v->cell >= 0 && v->kind != SYSTEM_TEXT) s->now.whole[v->cell] = s->now.values[k].whole;
    return SYSTEM_part_give(s, k - v->index);
}

/* A number takes the place of the one before, which is back where the component refuses it. */
static int put(SYSTEM *s, int k, SYSTEM_Value value) {
    const SYSTEM_Value before = s->now.values[k];
    const bool given = s->now.given[k];
    s->now.values[k] = value;
    if (pass_on(s, k) == 0) return 0;
    s->now.values[k] = before, s->now.given[k] = given;
    if (SYSTEM_variables[k].cell >= 0 && SYSTEM_variables[k].kind == SYSTEM_REAL) s->now.z[SYSTEM_variables[k].cell] = before.real;
    else if (SYSTEM_variables[k].cell >= 0) s->now.whole[SYSTEM_variables[k].cell] = before.whole;
    return 1;
}

/* Of a host that knows one type of whole numbers only: whether the component's own holds it. */
static bool fits(Type type, int64_t value) {
    switch (type) {
    case T_INT8: return value >= INT8_MIN && value <= INT8_MAX;
    case T_UINT8: return value >= 0 && value <= UINT8_MAX;
    case T_INT16: return value >= INT16_MIN && value <= INT16_MAX;
    case T_UINT16: return value >= 0 && value <= UINT16_MAX;
    case T_INT32: return value >= INT32_MIN && value <= INT32_MAX;
    case T_UINT32: return value >= 0 && value <= UINT32_MAX;
    default: return true;
    }
}

int SYSTEM_set_real(SYSTEM *s, int k, double value) {
    if (checked(s, k, SYSTEM_REAL, SYSTEM_REAL) || settable(s, k)) return 1;
    if (SYSTEM_variables[k].type == T_FLOAT32 && fabs(value) > FLT_MAX)
        return SYSTEM_say(s, s->name, 3, "%s cannot be %.9g: it is a Float32", SYSTEM_variables[k].name, value);
    return put(s, k, (SYSTEM_Value){.real = value});
}

int SYSTEM_set_whole(SYSTEM *s, int k, int64_t value) {
    if (checked(s, k, SYSTEM_WHOLE, SYSTEM_BOOLEAN) || settable(s, k)) return 1;
    if (SYSTEM_variables[k].kind == SYSTEM_BOOLEAN) value = value != 0;
    if (!fits((Type)SYSTEM_variables[k].type, value))
        return SYSTEM_say(s, s->name, 3, "%s cannot be %lld: its type does not hold that", SYSTEM_variables[k].name, (long long)value);
    return put(s, k, (SYSTEM_Value){.whole = value});
}

int SYSTEM_set_text(SYSTEM *s, int k, const char *value) {
    if (checked(s, k, SYSTEM_TEXT, SYSTEM_TEXT) || settable(s, k)) return 1;
    char *copy = value ? malloc(strlen(value) + 1) : NULL;
    if (!copy) return SYSTEM_say(s, s->name, 3, value ? "not enough memory" : "a text is wanted");
    char *const before = s->texts[k];
    const bool given = s->now.given[k];
    s->texts[k] = strcpy(copy, value);
    const int failed = pass_on(s, k);
    if (failed) s->texts[k] = before, s->now.given[k] = given;
    free(failed ? copy : before);
    return failed;
}

/* Where a number is to be found: in its cell, among what was set, or with its component. */
static int number(SYSTEM *s, int k, SYSTEM_Value *value) {
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    *value = s->now.values[k];
    if (v->causality == SYSTEM_CALCULATED || v->causality == SYSTEM_OUTPUT) {
        if (s->now.stage == SYSTEM_NEW) return 0;
        if (SYSTEM_settle(s)) return 1;
        if (v->part >= 0 && v->cell < 0) return SYSTEM_part_ask(s, k, value);
        if (v->kind == SYSTEM_REAL) value->real = s->now.z[v->cell];
        else value->whole = s->now.whole[v->cell];
    }
    return 0;
}

int SYSTEM_get_real(SYSTEM *s, int k, double *value) {
    SYSTEM_Value found;
    if (checked(s, k, SYSTEM_REAL, SYSTEM_REAL) || number(s, k, &found)) return 1;
    *value = found.real;
    return 0;
}

/* Outputs lie in their cells while it runs: a host that records hundreds of them at each step has them at once. */
int SYSTEM_get_reals(SYSTEM *s, const unsigned *variables, size_t n, double *values) {
    const bool there = s->now.stage >= SYSTEM_RUNNING && s->now.stage <= SYSTEM_TERMINATED;
    for (size_t k = 0; k < n; k++) {
        for (int cell; there && k < n && variables[k] < SYSTEM_VARIABLES && (cell = SYSTEM_in_cells[variables[k]]) >= 0; k++)
            values[k] = s->now.z[cell];
        if (k < n && SYSTEM_get_real(s, variables[k] < SYSTEM_VARIABLES ? (int)variables[k] : -1, &values[k])) return 1;
    }
    return 0;
}

int SYSTEM_get_whole(SYSTEM *s, int k, int64_t *value) {
    SYSTEM_Value found;
    if (checked(s, k, SYSTEM_WHOLE, SYSTEM_BOOLEAN) || number(s, k, &found)) return 1;
    *value = found.whole;
    return 0;
}

int SYSTEM_get_text(SYSTEM *s, int k, const char **value) {
    if (checked(s, k, SYSTEM_TEXT, SYSTEM_TEXT)) return 1;
    *value = s->texts[k] ? s->texts[k] : SYSTEM_variables[k].text;
    return 0;
}

int SYSTEM_number(SYSTEM *s, int k, double *value) {
    SYSTEM_Value found;
    if (number(s, k, &found)) return 1;
    *value = SYSTEM_variables[k].kind == SYSTEM_REAL ? found.real : (double)found.whole;
    return 0;
}
