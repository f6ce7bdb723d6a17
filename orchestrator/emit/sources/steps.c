/* Macro steps that are repeated or vary in length, as the loop of rovbrush does them bit by bit: their states kept, and how
   long the next one is. */
#include "inside.h"

#if SYSTEM_REPEATS
int SYSTEM_keep(SYSTEM *s, int part) {
    if (!SYSTEM_part_save(s, part, &s->kept[part])) return 0;
    s->now.stage = SYSTEM_FAILED;
    return SYSTEM_say(s, SYSTEM_parts[part].name, 3, "t = %.9g s: %s cannot save its state", s->now.time, SYSTEM_parts[part].name);
}

int SYSTEM_go_back(SYSTEM *s, int part) {
    if (!SYSTEM_part_restore(s, part, s->kept[part])) return 0;
    s->now.stage = SYSTEM_FAILED;
    return SYSTEM_say(s, SYSTEM_parts[part].name, 3, "t = %.9g s: %s cannot restore its state", s->now.time, SYSTEM_parts[part].name);
}
#endif

#if SYSTEM_VARIES
enum { SUM, BONDS, BEFORE };                                    /* of `work`: steps by the energy of bonds */
enum { INDICATOR, WORST, REPEATED };                            /* and by step doubling */
enum { TOLERANCE, SAFETY, SHRINK, GROW, ORDER, NOMINALS };      /* of its settings */

int64_t SYSTEM_fitted(const SYSTEM *s, int64_t length) {
    const int64_t *clock = s->now.clock, even = SYSTEM_EVEN;
    length = length / even * even;
    if (length < clock[MINIMUM]) length = clock[MINIMUM];
    if (length > clock[MAXIMUM]) length = clock[MAXIMUM];
    const int64_t left = clock[STOP] - clock[NOW];
    if (left >= length + clock[MINIMUM]) return length;
    return left <= clock[MAXIMUM] ? left : left / (2 * even) * even;
}

/* Energy-conservation-based steps: Sadjina, Kyllingstad, Skjong, Pedersen, Engineering with Computers 33 (2017) 607-620. */
void SYSTEM_gauge(SYSTEM *s, int effort, int held_effort, int flow, int held_flow, const double *settings) {
    const double *z = s->now.z, h = seconds(s->now.clock[STEP_TICKS]);
    const double at_flow = z[held_effort] * z[flow] * h, at_effort = z[held_flow] * z[effort] * h;
    const double a = fabs(at_flow), b = fabs(at_effort), carried = b > a ? b : a;
    const double indicator = (at_flow - at_effort) / (settings[0] + settings[1] * carried);
    s->now.work[SUM] += indicator * indicator;
    s->now.work[BONDS] += 1.0;
}

double SYSTEM_choose_step(SYSTEM *s, const double *settings) {
    double *work = s->now.work, eps = sqrt(work[SUM] / work[BONDS]);
    if (!(eps > 1e-10)) eps = 1e-10;
    const double before = work[BEFORE] > 0.0 ? work[BEFORE] : eps;
    double factor = settings[0] * pow(eps, -(settings[1] + settings[2])) * pow(before, settings[2]);
    if (factor < settings[3]) factor = settings[3];
    if (factor > settings[4]) factor = settings[4];
    work[SUM] = 0.0, work[BONDS] = 0.0, work[BEFORE] = eps;
    s->now.clock[NOW] += s->now.clock[STEP_TICKS];
    s->now.wanted = (int64_t)((double)s->now.clock[STEP_TICKS] * factor);
    s->now.clock[STEP_TICKS] = SYSTEM_fitted(s, s->now.wanted);
    return eps;
}

/* Step doubling with held inputs: Hairer, Norsett, Wanner, Solving ordinary differential equations I, section II.4. */
int SYSTEM_estimate(SYSTEM *s, int p, int n, const double *settings) {
    const double *z = s->now.z;
    double *work = s->now.work, eps = 0.0, factor = settings[GROW];
    int64_t *clock = s->now.clock;
    for (int i = 0; i < n; i++) {
        const double nominal = settings[NOMINALS + i], found = fabs(z[p + n + i]);
        const double error = fabs(z[p + n + i] - z[p + i]) / (settings[TOLERANCE] * (found > nominal ? found : nominal));
        if (error > eps) eps = error, work[WORST] = i;
    }
    work[INDICATOR] = eps;
    if (eps > 0.0) {
        factor = settings[SAFETY] * pow(eps, -1.0 / settings[ORDER]);
        if (factor < settings[SHRINK]) factor = settings[SHRINK];
        if (factor > settings[GROW]) factor = settings[GROW];
    }
    const int64_t whole = 2 * clock[STEP_TICKS];
    clock[OFFSET] = 0, clock[STEP_TICKS] = whole;
    if (eps <= 1.0) {
        clock[NOW] += whole;
        s->now.wanted = (int64_t)((double)whole * factor);
        clock[STEP_TICKS] = SYSTEM_fitted(s, s->now.wanted);
        return 0;
    }
    if (whole <= clock[MINIMUM]) {
        s->now.stage = SYSTEM_FAILED;
        SYSTEM_say(s, s->name, 3, "the error of the step from t = %.9g s is %.3g times its tolerance, and it is as short as allowed",
                   s->now.time, eps);
        return -1;
    }
    work[REPEATED] += 1.0;
    clock[STEP_TICKS] = (int64_t)((double)whole * factor) / SYSTEM_EVEN * SYSTEM_EVEN;
    if (clock[STEP_TICKS] < clock[MINIMUM]) clock[STEP_TICKS] = clock[MINIMUM];
    return 1;
}
#endif
