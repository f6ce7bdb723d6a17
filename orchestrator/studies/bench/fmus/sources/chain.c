/* A rod of N cells between two walls at 0: x_k' = a (x_(k-1) - 2 x_k + x_(k+1)), x_k(0) = sin(pi (k + 1) / (N + 1)). */
#ifndef N
#define N 1000
#endif
#define NR (2 * N + 2)
#define NI 0
#define NX N
#define NZ 0
#include "exchange.h"

enum { A = 2 * N, Y };
static int states(size_t k) { return (int)k; }
static int derivatives(size_t k) { return N + (int)k; }
static void init(Model *m) {
    m->r[A] = 100.0;
    for (int k = 0; k < N; k++) m->r[k] = sin(acos(-1.0) * (k + 1) / (N + 1));
}
static int calculate(Model *m) {
    double *x = m->r, *dx = m->r + N, a = m->r[A];
    dx[0] = a * (x[1] - 2.0 * x[0]);
    for (int k = 1; k < N - 1; k++) dx[k] = a * (x[k - 1] - 2.0 * x[k] + x[k + 1]);
    dx[N - 1] = a * (x[N - 2] - 2.0 * x[N - 1]);
    m->r[Y] = x[N / 2];
    return 0;
}
static void indicate(Model *m, double *z) {}
static int event(Model *m, double *next) { return 0; }
static int completed(Model *m) { return 0; }
static double nominal(Model *m, int state) { return 1.0; }
