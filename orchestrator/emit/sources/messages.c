/* What goes wrong in a system, and what is told of it: each function tells `message` and returns 1. */
#include "inside.h"

#include <stdarg.h>
#include <stdio.h>

int SYSTEM_say(SYSTEM *s, const char *who, int status, const char *format, ...) {
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (s->message) s->message(s->user, who, status, text);
    return 1;
}

int SYSTEM_fail(SYSTEM *s, const char *who, int status, const char *text) {
    s->now.stage = SYSTEM_FAILED;
    return SYSTEM_say(s, who, status, "%s", text);
}

int SYSTEM_refused(SYSTEM *s, int part, const char *what, int status) {
    char text[200];
    snprintf(text, sizeof text, "t = %.9g s: %s cannot %s (status %d)", s->now.time, SYSTEM_parts[part].name, what, status);
    for (int k = 0; status == FATAL && k < SYSTEM_PARTS; k++) /* nobody may call its library again, not even to free it */
        if (SYSTEM_parts[k].functions == SYSTEM_parts[part].functions) s->part[k] = NULL;
    return SYSTEM_fail(s, SYSTEM_parts[part].name, status, text);
}

int SYSTEM_not_finite(SYSTEM *s, int cell, double value) {
    char text[300];
    snprintf(text, sizeof text, "behind t = %.9g s: %s is %g", s->now.time, SYSTEM_cells[cell], value);
    return SYSTEM_fail(s, s->name, 3, text);
}

int SYSTEM_unfit(SYSTEM *s, int cell) {
    char text[300];
    snprintf(text, sizeof text, "behind t = %.9g s: what %s is sent does not fit its type", s->now.time, SYSTEM_cells[cell]);
    return SYSTEM_fail(s, s->name, 3, text);
}

int SYSTEM_asks(SYSTEM *s, int part, int end, int early) {
    char text[200];
    snprintf(text, sizeof text, "behind t = %.9g s: %s %s", s->now.time, SYSTEM_parts[part].name,
             end ? "asks to end" : early ? "returned early from a step" : "has an event, which nobody handles");
    return SYSTEM_fail(s, SYSTEM_parts[part].name, 3, text);
}

int SYSTEM_not_converged(SYSTEM *s, int cell) {
    char text[300];
    snprintf(text, sizeof text, "behind t = %.9g s: the loop of %s does not converge", s->now.time, SYSTEM_cells[cell]);
    return SYSTEM_fail(s, s->name, 3, text);
}

int SYSTEM_required(SYSTEM *s, int status, const char *words, double value, double low, double high) {
    char text[900];
    snprintf(text, sizeof text, words, value, low, high);
    if (status > 1) return SYSTEM_fail(s, s->name, status, text);
    SYSTEM_say(s, s->name, status, "%s", text);
    return 0;
}
