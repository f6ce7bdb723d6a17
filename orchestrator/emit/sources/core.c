/* The life of a system: its components made and freed, and from instant to instant. */
#include "inside.h"

#include <stdlib.h>

double SYSTEM_time(int64_t tick) { return seconds(tick); }

int SYSTEM_find(const char *name) {
    for (int k = 0; k < SYSTEM_VARIABLES; k++)
        if (strcmp(SYSTEM_variables[k].name, name) == 0) return k;
    return -1;
}

/* --- from new to running --- */

int SYSTEM_open(SYSTEM *s, const char *name, const char *resources, SYSTEM_Message message, void *user) {
    memset(s, 0, sizeof *s);
    s->name = name, s->resources = resources, s->message = message, s->user = user, s->final = 1;
    for (int k = 0; k < SYSTEM_VARIABLES; k++) {
        s->now.values[k] = SYSTEM_variables[k].start;
        s->now.given[k] = SYSTEM_variables[k].given;
    }
    for (int k = 0; k < SYSTEM_SOLVER; k++) s->now.solver[k] = 0.0;
    for (int k = 0; k < SYSTEM_PARTS; k++) {
        const bool loaded = !SYSTEM_parts[k].load || SYSTEM_parts[k].load(s) == 0;
        if (loaded && SYSTEM_part_make(s, k) == 0) continue;
        s->now.stage = SYSTEM_FAILED;
        return SYSTEM_say(s, SYSTEM_parts[k].name, 3, "%s cannot be instantiated", SYSTEM_parts[k].name);
    }
    return 0;
}

void SYSTEM_log(SYSTEM *s, bool on) {
    for (int part = 0; part < SYSTEM_PARTS; part++) SYSTEM_part_log(s, part, on);
}

static bool leads(int k) { return SYSTEM_variables[k].index == 0 && SYSTEM_variables[k].part >= 0; }

/* Whether anything of the array of a variable was given a value. */
static bool array_given(const SYSTEM *s, int k) {
    for (int j = 0; j < SYSTEM_variables[k].count; j++)
        if (s->now.given[k + j]) return true;
    return false;
}

/* Every component in its initialization, with all that was given to it before. */
static int enter(SYSTEM *s, double start, int with_stop, double stop) {
    for (int part = 0; part < SYSTEM_PARTS; part++) {
        if (SYSTEM_part_set_up(s, part, start, with_stop, stop)) return 1;
        for (int k = 0; k < SYSTEM_VARIABLES; k++)
            if (SYSTEM_variables[k].part == part && leads(k) && array_given(s, k) && SYSTEM_part_give(s, k)) return 1;
        if (SYSTEM_part_enter(s, part, start, with_stop, stop)) return 1;
    }
    return SYSTEM_first_cells(s);
}

/* Whether an instant can be: its ticks, and what they are multiplied with, are whole numbers of 63 bits and exact doubles. */
static bool countable(double time) {
    return fabs(time) < 0x1p61 / (double)SYSTEM_DENOMINATOR && fabs(time / SYSTEM_TICK) < 0x1p53;
}

int SYSTEM_enter(SYSTEM *s, double start, int with_stop, double stop) {
    if (s->now.stage != SYSTEM_NEW)
        return SYSTEM_say(s, s->name, 3, s->now.stage == SYSTEM_FAILED ? "%s has failed before" : "%s is initialized already", s->name);
    if (with_stop && !(stop > start))
        return SYSTEM_say(s, s->name, 3, "%s cannot stop at %.9g s: it starts at %.9g s", s->name, stop, start);
    const int64_t first = countable(start) ? (int64_t)llround(start / SYSTEM_TICK) : 0;
    if (!(fabs(seconds(first) - start) <= 1e-9 * SYSTEM_TICK + 1e-15 * fabs(start)))
        return SYSTEM_say(s, s->name, 3, "%s cannot start at %.17g s; a multiple of %.9g s is wanted", s->name, start, SYSTEM_TICK);
#if SYSTEM_EVENTS
    if (first != SYSTEM_START)
        return SYSTEM_say(s, s->name, 3, "%s has events, whose times count from its own start, %.9g s", s->name, seconds(SYSTEM_START));
#endif
    s->now.first = s->now.begin = first;
    s->now.time = seconds(first);
    s->now.stop = with_stop ? stop : 1e300;
    if (enter(s, start, with_stop, stop)) {
        s->now.stage = SYSTEM_FAILED; /* some of its components are further than others */
        return 1;
    }
#if SYSTEM_EVENTS
    SYSTEM_first_events(s);
#endif
    s->now.stage = SYSTEM_INITIALIZING, s->now.stale = true;
    return 0;
}

int SYSTEM_settle(SYSTEM *s) {
    if (s->now.stage == SYSTEM_FAILED) return SYSTEM_say(s, s->name, 3, "%s has failed before", s->name);
    if (s->now.stage != SYSTEM_INITIALIZING || !s->now.stale) return 0;
    for (int sweep = 1; sweep <= SYSTEM_PARTS + 2; sweep++) {
        memcpy(s->before, s->now.z, sizeof s->before);
        if (SYSTEM_propagate(s)) return 1;
        if ((sweep > 1 && memcmp(s->before, s->now.z, sizeof s->before) == 0) || !SYSTEM_BLOCKS) {
            s->now.stale = false;
            return 0;
        }
    }
    return SYSTEM_fail(s, s->name, 3, "the inputs keep changing in the initialization");
}

/* All components behind their initialization, and what is known from the start on. */
static int start(SYSTEM *s) {
    for (int part = 0; part < SYSTEM_PARTS; part++)
        if (SYSTEM_part_leave(s, part)) return 1;
    s->now.stale = false;
    if (SYSTEM_read_outputs(s) || SYSTEM_settle_instant(s) || SYSTEM_requirements(s) || SYSTEM_first_history(s)) return 1;
    for (int k = 0; k < SYSTEM_LOOPS; k++) s->now.solver[SYSTEM_loop_places[k]] = -1.0;
    s->now.stage = SYSTEM_RUNNING;
#if SYSTEM_REPEATS || SYSTEM_VARIES
    memcpy(s->now.work, SYSTEM_first_work, sizeof s->now.work);
#endif
#if SYSTEM_VARIES
    memcpy(s->now.clock, SYSTEM_first_clock, sizeof s->now.clock);
    s->now.wanted = s->now.clock[STEP_TICKS];
#endif
#if SYSTEM_EVENTS
    if (SYSTEM_begin_events(s)) return 1;
#endif
    return 0;
}

int SYSTEM_start(SYSTEM *s) {
    if (s->now.stage != SYSTEM_INITIALIZING) return SYSTEM_say(s, s->name, 3, "%s is not in its initialization", s->name);
    if (SYSTEM_settle(s)) return 1;
    if (start(s) == 0) return 0;
    s->now.stage = SYSTEM_FAILED; /* some of its components are further than others */
    return 1;
}

#if SYSTEM_VARIES
int64_t SYSTEM_next(const SYSTEM *s) { return s->now.first + s->now.clock[NOW] + SYSTEM_EVEN; }

int SYSTEM_step(SYSTEM *s) {
    if (s->now.stage != SYSTEM_RUNNING) return SYSTEM_say(s, s->name, 3, "%s cannot make a step now", s->name);
    if (s->now.clock[STEP_TICKS] <= 0) return SYSTEM_say(s, s->name, 3, "%s is at its stop; SYSTEM_go_to leads further", s->name);
    if (SYSTEM_macro_step(s)) return 1;
    s->now.time = seconds(s->now.first + s->now.clock[NOW]);
    return 0;
}

/* Steps of its own length, of which one ends there. */
static int go_on(SYSTEM *s, int64_t end) {
    int64_t *clock = s->now.clock;
    clock[STOP] = end - s->now.first;
    clock[STEP_TICKS] = clock[NOW] ? SYSTEM_fitted(s, s->now.wanted) : s->now.wanted < clock[STOP] ? s->now.wanted : clock[STOP];
    while (clock[NOW] < clock[STOP])
        if (SYSTEM_step(s)) return 1;
    return 0;
}

static bool is_instant(const SYSTEM *s, int64_t tick) {
    return tick > s->now.first + s->now.clock[NOW] && (tick - s->now.first) % SYSTEM_EVEN == 0;
}
#else
static int next_instant(const SYSTEM *s) { return s->now.instant + 1 < SYSTEM_INSTANTS ? s->now.instant + 1 : 1; }

int64_t SYSTEM_next(const SYSTEM *s) {
    const bool round = s->now.instant + 1 == SYSTEM_INSTANTS;
    return s->now.begin + (round ? SYSTEM_HYPERPERIOD : 0) + SYSTEM_cycle[next_instant(s)].tick;
}

static int go(SYSTEM *s, const Instant *here, const Instant *there) {
    if (here->begin && here->begin(s, s->now.begin + here->tick)) return 1;
#if SYSTEM_EVENTS
    if (SYSTEM_between(s, s->now.begin + there->tick, there->starts)) return 1;
#endif
    if (there->end && there->end(s, s->now.begin + there->tick)) return 1;
    s->now.time = seconds(s->now.begin + there->tick);
    return 0;
}

int SYSTEM_step(SYSTEM *s) {
    if (s->now.stage != SYSTEM_RUNNING) return SYSTEM_say(s, s->name, 3, "%s cannot make a step now", s->name);
    if (s->now.instant + 1 == SYSTEM_INSTANTS) s->now.begin += SYSTEM_HYPERPERIOD, s->now.instant = 0;
    const int here = s->now.instant;
    if (go(s, &SYSTEM_cycle[here], &SYSTEM_cycle[here + 1])) return 1;
    s->now.instant = here + 1;
    return 0;
}

static bool is_instant(const SYSTEM *s, int64_t tick) {
    int64_t within = (tick - s->now.first) % SYSTEM_HYPERPERIOD;
    within += within <= 0 ? SYSTEM_HYPERPERIOD : 0;
    for (int k = 1; k < SYSTEM_INSTANTS; k++)
        if (SYSTEM_cycle[k].tick == within) return true;
    return false;
}

static int go_on(SYSTEM *s, int64_t end) {
    while (SYSTEM_next(s) <= end)
        if (SYSTEM_step(s)) return 1;
    return 0;
}
#endif

/* Where a step ends [ticks from time 0], or -1: that is no instant. Hosts that add step to step drift away from an instant
   by rounding: a hundredth of a tick is no other instant. How long a step is must be right to rounding, or where it ends. */
static int64_t end_of_step(const SYSTEM *s, double time, double step) {
    const double near = 1e-6 * SYSTEM_TICK + 1e-12 * fabs(time);
    if (!(step > 0.0 && countable(step))) return -1;
    const int64_t length = (int64_t)llround(step / SYSTEM_TICK), end = (int64_t)llround(s->now.time / SYSTEM_TICK) + length;
    const bool exact = fabs(seconds(length) - step) <= near || fabs(seconds(end) - (time + step)) <= near;
    return exact && (end == SYSTEM_next(s) || is_instant(s, end)) ? end : -1;
}

int SYSTEM_go_to(SYSTEM *s, double time, double step) {
    if (s->now.stage != SYSTEM_RUNNING) return SYSTEM_say(s, s->name, 3, "%s cannot make a step now", s->name);
    if (!(fabs(time - s->now.time) <= fmax(0.01 * SYSTEM_TICK, 1e-12 * fabs(time))))
        return SYSTEM_say(s, s->name, 3, "a step from t = %.17g s is not possible: %s is at %.17g s", time, s->name, s->now.time);
    const int64_t end = end_of_step(s, time, step);
    if (end < 0)
        return SYSTEM_say(s, s->name, 3, "a step of %.9g s from t = %.9g s is not possible: %s goes on by instants, the next one at %.9g s",
                    step, time, s->name, seconds(SYSTEM_next(s)));
    if (seconds(end) > s->now.stop + 1e-6 * SYSTEM_TICK + 1e-12 * fabs(s->now.stop))
        return SYSTEM_say(s, s->name, 3, "a step to t = %.9g s is not possible: %s was told to stop at %.9g s", seconds(end), s->name, s->now.stop);
    return go_on(s, end);
}

int SYSTEM_rest(SYSTEM *s) {
#if SYSTEM_VARIES
    return SYSTEM_say(s, s->name, 3, "%s has no cycles; SYSTEM_go_to leads to its stop", s->name);
#else
    if (s->now.stage != SYSTEM_RUNNING || (s->now.instant && s->now.instant + 1 != SYSTEM_INSTANTS))
        return SYSTEM_say(s, s->name, 3, "%s is not behind a whole cycle", s->name);
    if (s->now.instant) s->now.begin += SYSTEM_HYPERPERIOD, s->now.instant = 0;
#if SYSTEM_EVENTS
    s->now.in_last = true;
#endif
    for (int k = 0; k + 1 < SYSTEM_LAST_INSTANTS; k++)
        if (go(s, &SYSTEM_last[k], &SYSTEM_last[k + 1])) return 1;
    s->now.stage = SYSTEM_ENDED;
    return 0;
#endif
}

int SYSTEM_terminate(SYSTEM *s) {
    if (s->now.stage != SYSTEM_RUNNING && s->now.stage != SYSTEM_ENDED)
        return SYSTEM_say(s, s->name, 3, s->now.stage == SYSTEM_FAILED ? "%s has failed before" : "%s does not run", s->name);
    int failed = 0;
    for (int part = 0; part < SYSTEM_PARTS; part++)
        if (s->part[part]) failed |= SYSTEM_part_terminate(s, part);
    if (!failed) s->now.stage = SYSTEM_TERMINATED;
    return failed;
}

void SYSTEM_close(SYSTEM *s) {
#if SYSTEM_REPEATS
    for (int part = 0; part < SYSTEM_PARTS; part++)
        if (s->part[part]) SYSTEM_part_forget(s, part, &s->kept[part]);
#endif
    for (int part = 0; part < SYSTEM_PARTS; part++) SYSTEM_part_free(s, part);
    for (int k = 0; k < SYSTEM_VARIABLES; k++) free(s->texts[k]);
    memset(s, 0, sizeof *s);
}
