/* What the files of a system share and no caller needs. */
#ifndef SYSTEM_INSIDE_H
#define SYSTEM_INSIDE_H

#include <math.h>
#include <string.h>

#include "SYSTEM.h"
@HEADERS@

@EXACT@

/* The FMI functions of one FMU; NULL where its sources do not define one. */
@FUNCTIONS@

typedef enum {
    T_FLOAT64, T_FLOAT32, T_INT8, T_UINT8, T_INT16, T_UINT16, T_INT32, T_UINT32, T_INT64, T_UINT64, T_BOOLEAN, T_STRING
} Type;

/* A component: its FMU's functions, and what it is told when it is made. */
typedef struct {
    const char *name, *token, *folder; /* its own below `resources`, or NULL */
    int version;
    const void *functions;
    double tolerance; /* 0: not stated */
    bool saves, serializes;
    int (*load)(SYSTEM *s); /* of one that is carried as a library, or NULL */
} Part;

typedef struct {
    int64_t tick;
    int (*begin)(SYSTEM *s, int64_t at); /* steps that begin there */
    int (*end)(SYSTEM *s, int64_t at);   /* steps that end there */
    const int64_t *starts;               /* of events before it: where each component's step begins, from it on; or NULL */
} Instant;

extern const Part SYSTEM_parts[SYSTEM_PARTS];
extern const int SYSTEM_in_cells[SYSTEM_VARIABLES]; /* the cell of a double that can be read there at any step, or -1 */
extern const Instant SYSTEM_cycle[SYSTEM_INSTANTS], SYSTEM_last[SYSTEM_LAST_INSTANTS];

int SYSTEM_first_cells(SYSTEM *s);
int SYSTEM_propagate(SYSTEM *s);
int SYSTEM_read_outputs(SYSTEM *s);
int SYSTEM_settle_instant(SYSTEM *s);
int SYSTEM_first_history(SYSTEM *s);
int SYSTEM_requirements(SYSTEM *s);
int SYSTEM_number(SYSTEM *s, int variable, double *value); /* whatever its type */
int SYSTEM_required(SYSTEM *s, int status, const char *words, double value, double low, double high);

enum { FATAL = 4 }; /* a status of FMI */

/* Errors: each tells `message` and returns 1. */
int SYSTEM_fail(SYSTEM *s, const char *who, int status, const char *text);
int SYSTEM_say(SYSTEM *s, const char *who, int status, const char *format, ...);
int SYSTEM_refused(SYSTEM *s, int part, const char *what, int status);
int SYSTEM_not_finite(SYSTEM *s, int cell, double value);
int SYSTEM_unfit(SYSTEM *s, int cell);
int SYSTEM_asks(SYSTEM *s, int part, int end, int early);
int SYSTEM_not_converged(SYSTEM *s, int cell);

/* Components: see parts.c; what depends on the version of FMI, parts2.c and parts3.c. */
const char *SYSTEM_text_of(const SYSTEM *s, int variable);
/* The path of a file in the folder of resources, which may have come as a URI. */
void SYSTEM_resource(const SYSTEM *s, const char *file, char *to, size_t size);
/* The folder of a component's own resources as FMI 2.0 wants it, a URI, or 3.0, a path that ends in a separator; or "". */
void SYSTEM_folder(const SYSTEM *s, int part, bool uri, char *to, size_t size);
#if SYSTEM_FMI2
int SYSTEM_make2(SYSTEM *s, int part, const Functions2 *f);
int SYSTEM_give2(SYSTEM *s, int part, int variable, const Functions2 *f);
int SYSTEM_ask2(SYSTEM *s, int part, int variable, const Functions2 *f, SYSTEM_Value *value);
#endif
#if SYSTEM_FMI3
int SYSTEM_make3(SYSTEM *s, int part, const Functions3 *f);
int SYSTEM_give3(SYSTEM *s, int part, int variable, const Functions3 *f);
int SYSTEM_ask3(SYSTEM *s, int part, int variable, const Functions3 *f, SYSTEM_Value *value);
#endif
int SYSTEM_part_make(SYSTEM *s, int part);
int SYSTEM_part_set_up(SYSTEM *s, int part, double start, int with_stop, double stop);
int SYSTEM_part_enter(SYSTEM *s, int part, double start, int with_stop, double stop);
int SYSTEM_part_leave(SYSTEM *s, int part);
int SYSTEM_part_terminate(SYSTEM *s, int part);
void SYSTEM_part_free(SYSTEM *s, int part);
void SYSTEM_part_log(SYSTEM *s, int part, bool on);
int SYSTEM_part_give(SYSTEM *s, int variable); /* it, or the array that it begins */
int SYSTEM_part_ask(SYSTEM *s, int variable, SYSTEM_Value *value);
int SYSTEM_part_save(SYSTEM *s, int part, void **state);
int SYSTEM_part_restore(SYSTEM *s, int part, void *state);
void SYSTEM_part_forget(SYSTEM *s, int part, void **state);
int SYSTEM_part_state_size(SYSTEM *s, int part, void *state, size_t *size);
int SYSTEM_part_write(SYSTEM *s, int part, void *state, char *bytes, size_t size);
int SYSTEM_part_read(SYSTEM *s, int part, const char *bytes, size_t size, void **state);
extern const int SYSTEM_loop_places[SYSTEM_LOOPS + 1]; /* cells of `solver` that begin with -1 */

/* Loops. */
typedef int (*SYSTEM_Loop)(SYSTEM *s, const double *given, double *sent);
int SYSTEM_solve_start(SYSTEM *s, SYSTEM_Loop loop, const int *cells, int n, double tolerance);
int SYSTEM_iterate(double *z, int u, int g, int n, const double *settings, double *work); /* 1: again, -1: failed */

#if SYSTEM_EVENTS
/* Events: see events.c. Times are whole numbers of fine ticks, SYSTEM_FINE of them to one of the clock. */
#define NEVER (INT64_C(1) << 62)
typedef struct {
    const char *name;
    int64_t at, after, lasting, until; /* NEVER: not stated */
    bool early, repeat;                /* there from the start; each time that it crosses */
    int watch, signal, part;           /* cells of what is looked at, and whose it is; watch = -1: nothing */
    bool whole, rising;
    int parts;
    const int *touched; /* components */
} Event;
/* What is done for events: a component brought to an instant from where its step began, by components; and values among
   those that are at one instant. */
typedef struct {
    uint64_t parts;
    int (*pass_on)(SYSTEM *s, const int64_t *starts);
} Together;
typedef struct {
    int (*const *bring)(SYSTEM *s, int64_t at);
    const Together *together;
    int number;
} EventRows;
extern const Event SYSTEM_events[SYSTEM_EVENTS];
extern const EventRows SYSTEM_at_events, SYSTEM_at_last_events;
extern const int SYSTEM_order[SYSTEM_PARTS], SYSTEM_rank[SYSTEM_PARTS], SYSTEM_breakable[SYSTEM_BREAKABLE];
extern const int64_t SYSTEM_spacing[SYSTEM_PARTS], SYSTEM_periods[SYSTEM_PARTS]; /* spacing 0: brought to an event */
extern const uint64_t SYSTEM_stopped, SYSTEM_early;
void SYSTEM_first_events(SYSTEM *s);                          /* thresholds, and faults that are there from the start */
void SYSTEM_act(SYSTEM *s, int event, int part, int ends);    /* what an event does to a component */
int SYSTEM_begin_events(SYSTEM *s);                           /* behind the initialization */
int SYSTEM_paused(SYSTEM *s, int64_t at, const int64_t *starts); /* do what is due at an instant of the plan */
int SYSTEM_between(SYSTEM *s, int64_t at, const int64_t *starts); /* and what is due before it */
double SYSTEM_faulted(const SYSTEM *s, int fault, int64_t stream, int64_t counter, double value);
#endif

/* Macro steps that are repeated or vary: see steps.c. */
#if SYSTEM_REPEATS || SYSTEM_VARIES
extern const double SYSTEM_first_work[SYSTEM_WORK];
#endif
#if SYSTEM_REPEATS
int SYSTEM_keep(SYSTEM *s, int part);
int SYSTEM_go_back(SYSTEM *s, int part);
#endif
#if SYSTEM_VARIES
/* `clock`: the instant from the start on, the step that is done now, its limits, the stop, nothing, and where in the macro
   step its second half begins. */
enum { NOW, STEP_TICKS, MINIMUM, MAXIMUM, STOP, UNTIL, OFFSET };
extern const int64_t SYSTEM_first_clock[7];
int64_t SYSTEM_fitted(const SYSTEM *s, int64_t length); /* the next step, between its limits and to the stop */
void SYSTEM_gauge(SYSTEM *s, int effort, int held_effort, int flow, int held_flow, const double *settings);
double SYSTEM_choose_step(SYSTEM *s, const double *settings);
int SYSTEM_estimate(SYSTEM *s, int p, int n, const double *settings); /* 0: good, 1: again, shorter, -1: failed */
int SYSTEM_macro_step(SYSTEM *s);
#endif

/* Tables: the number of rows n, n times that never fall, n values. */
int SYSTEM_row_at(const double *table, double time); /* the last row that is not behind a time, or the first */
double SYSTEM_held_at(const double *table, double time);
double SYSTEM_mean_over(const double *table, double begin, double end);

#define CALL(part, what, call)                                                   \
    do {                                                                         \
        const int status_ = (int)(call);                                         \
        if (status_ & ~1) return SYSTEM_refused(s, part, what, status_);         \
    } while (0)
#define FINITE(first, size)                                                      \
    do {                                                                         \
        for (int k_ = (first); k_ < (first) + (size); k_++)                      \
            if (!isfinite(z[k_])) return SYSTEM_not_finite(s, k_, z[k_]);        \
    } while (0)

static inline double seconds(int64_t ticks) { return (double)(ticks * SYSTEM_NUMERATOR) / (double)SYSTEM_DENOMINATOR; }

/* How long a step from `time` is that ends at `end` in doubles. */
static inline double length_to(double time, double end) {
    double length = end - time;
    while (time + length > end) length *= 1.0 - 0x1p-52;
    return length;
}

/* How long a step is that would take `length` and is not to end behind the stop, by rounding. */
static inline double length_of(const SYSTEM *s, double time, double length) {
    return time + length > s->now.stop ? length_to(time, s->now.stop) : length;
}

#if SYSTEM_EVENTS
/* The part of a step from `time` to `end` [s] that is still to be done, and to be done now; whether there is one. */
static inline bool part_of_step(SYSTEM *s, int part, double *time, double *length, double *end) {
    if (*end > s->now.latest) *end = s->now.latest, *length = length_to(*time, *end);
    if (s->now.reached[part] > *time) *time = s->now.reached[part], *length = length_to(*time, *end);
    *length = length_of(s, *time, *length);
    s->now.began[part] = *time;
    return *time < *end;
}

/* What a fault makes of an input that was formed: see `loop/run` of rovbrush. */
static inline void fault(SYSTEM *s, int first, int cell, int64_t stream, int64_t counter) {
    if (s->now.z[first] == 2.0) s->now.whole[cell] = s->now.whole[first + 2];
    else if (s->now.z[first] == 1.0) s->now.z[cell] = SYSTEM_faulted(s, first, stream, counter, s->now.z[cell]);
}

/* Whether a signal crosses what is waited for: then the next pause is one. */
static inline void watch(SYSTEM *s, double value, int cell, bool rising) {
    double *const w = s->now.z + cell;
    const double side = (rising ? value > w[1] : value < w[1]) ? 1.0 : -1.0;
    if (w[0] * side < 0.0 && 0.0 < side) w[2] += 1.0, s->now.event_at = -NEVER;
    w[0] = side;
}
#endif

static inline bool among(int64_t value, const int64_t *items, int n) {
    for (int k = 0; k < n; k++)
        if (items[k] == value) return true;
    return false;
}

#endif
