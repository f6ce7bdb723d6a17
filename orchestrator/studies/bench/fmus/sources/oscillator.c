/* The oscillator of van der Pol: x'' = mu (1 - x^2) x' - x + u. */
#define NR 8
#define NI 0
#define NX 2
#define NZ 0
#include "exchange.h"

enum { X, V, DX, DV, MU, U, Y, TAU };
static int states(size_t k) { return k == 0 ? X : V; }
static int derivatives(size_t k) { return k == 0 ? DX : DV; }
static void init(Model *m) {
    m->r[X] = 2.0;
    m->r[MU] = 1.0;
}
static int calculate(Model *m) {
    double *r = m->r;
    r[DX] = r[V];
    r[DV] = r[MU] * (1.0 - r[X] * r[X]) * r[V] - r[X] + r[U];
    r[Y] = r[X];
    return 0;
}
static void indicate(Model *m, double *z) {}
static int event(Model *m, double *next) { return 0; }
static int completed(Model *m) { return 0; }
static double nominal(Model *m, int state) { return 1.0; }
