/* The values of a system's variables: set, passed on to its components, and got. */
#include "inside.h"

#include <stdlib.h>

static int checked(SYSTEM *s, int k, SYSTEM_Kind a, SYSTEM_Kind b) {
    static const char *const KINDS[] = {"a real number", "a whole number", "a Boolean", "a text"};
    if (k < 0 || k >= SYSTEM_VARIABLES) return SYSTEM_say(s, s->name, 3, "there is no variable of number %d", k);
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    if (v->kind != a && v->kind != b) return SYSTEM_say(s, s->name, 3, "%s is %s", v->name, KINDS[v->kind]);
    return 0;
}

/* A value that was set goes on to its component at once, where that is there to hear it. */
static int set(SYSTEM *s, int k) {
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    if (v->causality != SYSTEM_PARAMETER && v->causality != SYSTEM_TUNABLE && v->causality != SYSTEM_INPUT)
        return SYSTEM_say(s, s->name, 3, "%s cannot be set", v->name);
    if (s->now.stage > SYSTEM_RUNNING) return SYSTEM_say(s, s->name, 3, "%s: %s can be set no more", s->name, v->name);
    if (s->now.stage == SYSTEM_RUNNING && v->causality == SYSTEM_PARAMETER)
        return SYSTEM_say(s, s->name, 3, "%s is a parameter; it is set before the run", v->name);
    return 0;
}

static int passed_on(SYSTEM *s, int k) {
    const SYSTEM_Variable *v = &SYSTEM_variables[k];
    s->now.given[k] = true;
    if (s->now.stage == SYSTEM_NEW) return 0;
    s->now.stale = s->now.stage == SYSTEM_INITIALIZING;
    if (v->cell >= 0 && v->kind == SYSTEM_REAL) s->now.z[v->cell] = s->now.values[k].real;
    else if (v->cell >= 0 && v->kind != SYSTEM_TEXT) s->now.whole[v->cell] = s->now.values[k].whole;
    return SYSTEM_part_give(s, k - v->index);
}

int SYSTEM_set_real(SYSTEM *s, int k, double value) {
    if (checked(s, k, SYSTEM_REAL, SYSTEM_REAL) || set(s, k)) return 1;
    s->now.values[k].real = value;
    return passed_on(s, k);
}

int SYSTEM_set_whole(SYSTEM *s, int k, int64_t value) {
    if (checked(s, k, SYSTEM_WHOLE, SYSTEM_BOOLEAN) || set(s, k)) return 1;
    s->now.values[k].whole = SYSTEM_variables[k].kind == SYSTEM_BOOLEAN ? value != 0 : value;
    return passed_on(s, k);
}

int SYSTEM_set_text(SYSTEM *s, int k, const char *value) {
    if (checked(s, k, SYSTEM_TEXT, SYSTEM_TEXT) || set(s, k)) return 1;
    char *copy = value ? malloc(strlen(value) + 1) : NULL;
    if (!copy) return SYSTEM_say(s, s->name, 3, value ? "not enough memory" : "a text is wanted");
    free(s->texts[k]);
    s->texts[k] = strcpy(copy, value);
    return passed_on(s, k);
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
    const bool there = s->now.stage == SYSTEM_RUNNING || s->now.stage == SYSTEM_TERMINATED;
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
