/* Events: what happens beside the steps, and when, as rovbrush runs it. An event acts on components that can be brought to
   its instant there, and on others at their next instant; values go round among those at one instant until none changes. */
#include "inside.h"

enum { SIDE, THRESHOLD, CROSSED };                 /* cells of what is looked at */

static const int MOST_ROUNDS = 1000; /* of one instant */

static double fine(int64_t time) { return (double)(time * SYSTEM_FINE_NUMERATOR) / (double)SYSTEM_FINE_DENOMINATOR; }

static int64_t ceiling(int64_t a, int64_t b) { return a / b + (a % b > 0); }

/* --- what is to come --- */

/* When something that happens at a time acts on a component. */
static int64_t acts_at(int part, int64_t time) {
    const int64_t start = (int64_t)SYSTEM_FINE * SYSTEM_START, between = SYSTEM_spacing[part];
    if (between == 0) return time > start ? time : start;
    const int64_t instant = ceiling(ceiling(time, SYSTEM_FINE) - SYSTEM_START, between) * between;
    return (int64_t)SYSTEM_FINE * (SYSTEM_START + (instant > 0 ? instant : 0));
}

static bool in_run(const SYSTEM *s, int64_t time) { return fine(time) < s->now.stop; }

static int waits(SYSTEM *s, int64_t time, int event, int part, int ends) {
    if (s->now.dues == SYSTEM_MOST_DUE)
        return SYSTEM_say(s, s->name, 3, "more than %d events wait to act, the next of %s", SYSTEM_MOST_DUE, SYSTEM_events[event].name);
    s->now.due[s->now.dues++] = (SYSTEM_Due){time, event, part, ends};
    return 0;
}

static int64_t end_of(const Event *e, int64_t time) { return e->lasting != NEVER ? time + e->lasting : e->until; }

/* The fault of an event that happens at a time ends where it does, and not where it did before. */
static int will_end(SYSTEM *s, int event, int64_t time) {
    const Event *e = &SYSTEM_events[event];
    const int64_t ends = end_of(e, time);
    if (ends == NEVER) return 0;
    int kept = 0;
    for (int k = 0; k < s->now.dues; k++)
        if (s->now.due[k].event != event || !s->now.due[k].ends) s->now.due[kept++] = s->now.due[k];
    s->now.dues = kept;
    for (int k = 0; k < e->parts; k++) {
        const int64_t at = acts_at(e->touched[k], ends);
        if (acts_at(e->touched[k], time) < at && in_run(s, at) && waits(s, at, event, e->touched[k], 1)) return 1;
    }
    return 0;
}

static int will_happen(SYSTEM *s, int event, int64_t time) {
    const Event *e = &SYSTEM_events[event];
    const int64_t ends = end_of(e, time);
    for (int k = 0; k < e->parts; k++) {
        const int64_t at = acts_at(e->touched[k], time);
        if (in_run(s, at) && (ends == NEVER || acts_at(e->touched[k], ends) > at) && waits(s, at, event, e->touched[k], 0)) return 1;
    }
    return will_end(s, event, time);
}

static int64_t next_due(const SYSTEM *s) {
    int64_t found = NEVER;
    for (int k = 0; k < s->now.dues; k++)
        if (s->now.due[k].time < found) found = s->now.due[k].time;
    return found;
}

/* Where the plan is to be left next. */
static void look_ahead(SYSTEM *s) {
    const int64_t due = next_due(s);
    s->now.event_at = s->now.ends_at = NEVER;
    if (due == NEVER) return;
    const int64_t tick = ceiling(due, SYSTEM_FINE);
    for (int k = 0; k < SYSTEM_PARTS; k++)
        if (due % SYSTEM_FINE == 0 && (tick - SYSTEM_START) % SYSTEM_periods[k] == 0) s->now.event_at = tick;
    if (s->now.event_at == NEVER) s->now.ends_at = tick - 1;
}

/* --- what happens at an instant --- */

static double at_time(const SYSTEM *s, int part, const int64_t *starts) {
    return fmax(seconds(starts[part]), s->now.reached[part]);
}

/* As the plan looks at signals, at those of all components that are not behind the instant. */
static void look(SYSTEM *s, const int64_t *starts, double time) {
    for (int k = 0; k < SYSTEM_EVENTS; k++) {
        const Event *e = &SYSTEM_events[k];
        if (e->watch < 0 || (starts && at_time(s, e->part, starts) > time)) continue;
        double *w = s->now.z + e->watch;
        const double value = e->whole ? (double)s->now.whole[e->signal] : s->now.z[e->signal];
        const double side = (e->rising ? value > w[THRESHOLD] : value < w[THRESHOLD]) ? 1.0 : -1.0;
        if (w[SIDE] < 0.0 && 0.0 < side) w[CROSSED] += 1.0;
        w[SIDE] = side;
    }
}

static bool before(const SYSTEM_Due *a, const SYSTEM_Due *b) {
    if (a->time != b->time) return a->time < b->time;
    if (a->event != b->event) return a->event < b->event;
    if (a->part != b->part) return SYSTEM_rank[a->part] < SYSTEM_rank[b->part];
    return a->ends < b->ends;
}

static int happen(SYSTEM *s, int64_t now, const int64_t *starts) {
    if (!in_run(s, now)) return 0; /* no step is behind it */
    look(s, starts, fine(now));
    if (s->now.held_at != now) {
        s->now.held_at = now;
        for (int k = 0; k < SYSTEM_BREAKABLE; k++) s->now.held[k] = s->now.whole[SYSTEM_breakable[k]];
    }
    for (int k = 0; k < SYSTEM_EVENTS; k++) {
        const Event *e = &SYSTEM_events[k];
        if (e->watch < 0 || !(s->now.z[e->watch + CROSSED] > 0.0)) continue;
        s->now.z[e->watch + CROSSED] = 0.0;
        if (!e->repeat) s->now.z[e->watch + THRESHOLD] = e->rising ? INFINITY : -INFINITY;
        if (will_happen(s, k, now + e->after)) return 1;
    }
    for (;;) {
        int next = -1;
        for (int k = 0; k < s->now.dues; k++)
            if (s->now.due[k].time <= now && (next < 0 || before(&s->now.due[k], &s->now.due[next]))) next = k;
        if (next < 0) return 0;
        const SYSTEM_Due due = s->now.due[next];
        memmove(s->now.due + next, s->now.due + next + 1, (size_t)(--s->now.dues - next) * sizeof due);
        SYSTEM_act(s, due.event, due.part, due.ends);
    }
}

static int values(SYSTEM *s, uint64_t known, const int64_t *starts, bool *changed) {
    const EventRows *rows = s->now.in_last ? &SYSTEM_at_last_events : &SYSTEM_at_events;
    memcpy(s->before, s->now.z, sizeof s->before);
    for (int k = 0; k < rows->number; k++)
        if (rows->together[k].parts == known) {
            if (rows->together[k].pass_on(s, starts)) return 1;
            *changed = memcmp(s->before, s->now.z, sizeof s->before) != 0;
            return 0;
        }
    return SYSTEM_say(s, s->name, 3, "an event at t = %.9g s is at no instant of the plan", s->now.time);
}

/* All that can be are brought to an instant; then values go round. `first`: they are passed on before it. */
static int go_round(SYSTEM *s, int64_t now, const int64_t *starts, bool first) {
    const EventRows *rows = s->now.in_last ? &SYSTEM_at_last_events : &SYSTEM_at_events;
    const double time = fine(now);
    uint64_t known = SYSTEM_stopped;
    bool changed = true;
    for (int k = 0; k < SYSTEM_PARTS; k++)
        if (seconds(starts[k]) >= time && !(SYSTEM_early >> k & 1)) known |= UINT64_C(1) << k;
    for (int k = 0; k < SYSTEM_PARTS; k++) {
        const int part = SYSTEM_order[k];
        if (!(SYSTEM_stopped >> part & 1) || at_time(s, part, starts) >= time) continue;
        s->now.latest = time;
        const int failed = rows->bring[part](s, starts[part]);
        s->now.latest = 1e300;
        if (failed) return 1;
    }
    s->now.time = time;
    if (first && values(s, known, starts, &changed)) return 1;
    if (happen(s, now, starts)) return 1;
    for (int round = 0; round < MOST_ROUNDS; round++) {
        if (values(s, known, starts, &changed) || values(s, known, starts, &changed)) return 1;
        if (!changed) {
            look_ahead(s);
            return 0;
        }
    }
    return SYSTEM_say(s, s->name, 3, "the events at t = %.9g s do not settle: after %d rounds values still change", time, MOST_ROUNDS);
}

static int round_from(SYSTEM *s, int64_t now, int64_t at, const int64_t *from, bool first) {
    int64_t starts[SYSTEM_PARTS];
    for (int k = 0; k < SYSTEM_PARTS; k++) starts[k] = at + from[k];
    if (!go_round(s, now, starts, first)) return 0;
    s->now.stage = SYSTEM_FAILED;
    return 1;
}

int SYSTEM_begin_events(SYSTEM *s) {
    s->now.latest = 1e300, s->now.held_at = -NEVER, s->now.dues = 0;
    for (int k = 0; k < SYSTEM_PARTS; k++) s->now.reached[k] = s->now.began[k] = seconds(SYSTEM_START);
    for (int k = 0; k < SYSTEM_EVENTS; k++) {
        const Event *e = &SYSTEM_events[k];
        if (e->at == NEVER) continue;
        if (e->early ? will_end(s, k, e->at) : will_happen(s, k, e->at)) return 1;
    }
    look(s, NULL, 0.0);
    return round_from(s, (int64_t)SYSTEM_FINE * SYSTEM_START, SYSTEM_START, SYSTEM_cycle[0].starts, true);
}

int SYSTEM_paused(SYSTEM *s, int64_t at, const int64_t *starts) { return round_from(s, at * SYSTEM_FINE, at, starts, false); }

int SYSTEM_between(SYSTEM *s, int64_t at, const int64_t *starts) {
    while (at > s->now.ends_at)
        if (round_from(s, next_due(s), at, starts, false)) return 1;
    return 0;
}
