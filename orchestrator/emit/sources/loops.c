/* Loops of direct dependence: Newton's method at an instant, as the loop of rovbrush does it bit by bit, and at the start;
   and tables that inputs follow. */
#include "inside.h"

#include <float.h>

enum { COUNT, COLUMN, RESIDUAL, WORST, FACTOR, STEP, HEAD };
enum { TOLERANCE, LIMIT, METHOD, SETTINGS };

static void perturb(double *z, int u, int column, const double *settings, double *work) {
    work[COLUMN] = column;
    work[STEP] = 0x1p-26 * fmax(settings[SETTINGS + column], fabs(z[u + column]));
    z[u + column] += work[STEP];
}

static int newton_step(double *z, int u, int n, double *work) {
    double *last = work + HEAD, *base = last + n, *jacobian = base + n, *a = jacobian + n * n;
    for (int i = 0; i < n * n; i++) a[i] = jacobian[i];
    for (int i = 0; i < n; i++) z[u + i] = -last[i];
    for (int j = 0; j < n; j++) {
        int pivot = j;
        for (int i = j + 1; i < n; i++)
            if (fabs(a[i * n + j]) > fabs(a[pivot * n + j])) pivot = i;
        if (a[pivot * n + j] == 0.0) return -1;
        for (int m = 0; m < n; m++) {
            const double kept = a[j * n + m];
            a[j * n + m] = a[pivot * n + m], a[pivot * n + m] = kept;
        }
        const double kept = z[u + j];
        z[u + j] = z[u + pivot], z[u + pivot] = kept;
        for (int i = j + 1; i < n; i++) {
            const double ratio = a[i * n + j] / a[j * n + j];
            for (int m = j; m < n; m++) a[i * n + m] -= ratio * a[j * n + m];
            z[u + i] -= ratio * z[u + j];
        }
    }
    for (int j = n - 1; j >= 0; j--) {
        for (int m = j + 1; m < n; m++) z[u + j] -= a[j * n + m] * z[u + m];
        z[u + j] /= a[j * n + j];
    }
    for (int i = 0; i < n; i++) z[u + i] += base[i];
    return 1;
}

static int next_column(double *z, int u, int g, int n, const double *settings, double *work) {
    double *last = work + HEAD, *base = last + n, *jacobian = base + n;
    const int column = (int)work[COLUMN];
    for (int i = 0; i < n; i++) jacobian[i * n + column] = ((z[g + i] - z[u + i]) - last[i]) / work[STEP];
    z[u + column] = base[column];
    if (column + 1 < n) {
        perturb(z, u, column + 1, settings, work);
        return 1;
    }
    work[COLUMN] = -1.0;
    return newton_step(z, u, n, work);
}

int SYSTEM_iterate(double *z, int u, int g, int n, const double *settings, double *work) {
    if (work[COLUMN] >= 0.0) return next_column(z, u, g, n, settings, work);
    double *last = work + HEAD, *base = last + n, before = work[RESIDUAL], residual = 0.0, above = 0.0, below = 0.0;
    for (int i = 0; i < n; i++) {
        const double r = z[g + i] - z[u + i], scale = fmax(settings[SETTINGS + i], fabs(z[g + i]));
        if (fabs(r) / scale > residual) residual = fabs(r) / scale, work[WORST] = i;
        const double change = (r - last[i]) / scale;
        above += last[i] / scale * change;
        below += change * change;
        last[i] = r;
    }
    work[COUNT] += 1.0;
    work[RESIDUAL] = residual;
    if (residual <= settings[TOLERANCE]) {
        z[u - 2] = work[COUNT], z[u - 1] = residual;
        work[COUNT] = 0.0;
        return 0;
    }
    if (work[COUNT] >= settings[LIMIT]) return -1;
    if (settings[METHOD] == 0.0) { /* fixed point with Aitken's relaxation */
        work[FACTOR] = work[COUNT] == 1.0 || below == 0.0 ? 1.0 : -work[FACTOR] * above / below;
        for (int i = 0; i < n; i++) z[u + i] += work[FACTOR] * last[i];
        return 1;
    }
    for (int i = 0; i < n; i++) base[i] = z[u + i];
    if (work[COUNT] == 1.0 || residual > 0.1 * before) {
        perturb(z, u, 0, settings, work);
        return 1;
    }
    return newton_step(z, u, n, work);
}

/* --- at the start --- */

#define MOST SYSTEM_LARGEST_LOOP

static int sizes(SYSTEM *s, SYSTEM_Loop loop, int n, const double *x, double *r, double *size) {
    double sent[MOST];
    if (loop(s, x, sent)) return 1;
    *size = 0.0;
    for (int i = 0; i < n; i++) {
        r[i] = sent[i] - x[i];
        *size = fmax(*size, fabs(r[i]) / fmax(fabs(x[i]), 1.0));
    }
    return 0;
}

int SYSTEM_solve_start(SYSTEM *s, SYSTEM_Loop loop, const int *cells, int n, double tolerance) {
    static const int PASSES = 50;
    double x[MOST], r[MOST], size, work[HEAD + 2 * MOST + 2 * MOST * MOST];
    for (int i = 0; i < n; i++) x[i] = s->now.z[cells[i]];
    if (sizes(s, loop, n, x, r, &size)) return 1;
    for (int pass = 0; size > tolerance && pass < PASSES; pass++) {
        double moved[MOST], there[MOST], unused, *jacobian = work + HEAD + 2 * n;
        for (int i = 0; i < n; i++) work[HEAD + i] = r[i], work[HEAD + n + i] = x[i];
        for (int j = 0; j < n; j++) {
            memcpy(moved, x, sizeof moved);
            const double nudge = 1e-7 * fmax(fabs(x[j]), 1.0);
            moved[j] += nudge;
            if (sizes(s, loop, n, moved, there, &unused)) return 1;
            for (int i = 0; i < n; i++) jacobian[i * n + j] = (there[i] - r[i]) / nudge;
        }
        if (newton_step(x, 0, n, work) < 0) break;
        if (sizes(s, loop, n, x, r, &size)) return 1;
    }
    if (size <= fmax(tolerance, 1e-9)) return 0;
    return SYSTEM_not_converged(s, cells[0]);
}

/* --- tables: the number of rows n, n times that never fall, n values --- */

int SYSTEM_row_at(const double *table, double time) {
    int low = 0, high = (int)table[0] - 1;
    while (low < high) {
        const int middle = (low + high + 1) / 2;
        if (table[1 + middle] <= time) low = middle;
        else high = middle - 1;
    }
    return low;
}

double SYSTEM_held_at(const double *table, double time) { return table[1 + (int)table[0] + SYSTEM_row_at(table, time)]; }

static double on_line(const double *table, int row, double time) {
    const int n = (int)table[0], t = 1 + row, v = 1 + n + row;
    if (row + 1 == n) return table[v];
    return table[v] + (table[v + 1] - table[v]) * ((time - table[t]) / (table[t + 1] - table[t]));
}

double SYSTEM_mean_over(const double *table, double begin, double end) {
    const int n = (int)table[0];
    int row = SYSTEM_row_at(table, begin);
    if (row + 1 == n || table[2 + row] >= end) return on_line(table, row, 0.5 * (begin + end));
    double total = 0.0, x = begin, left = on_line(table, row, begin);
    while (row + 1 < n && table[2 + row] < end) {
        row++;
        const double value = table[1 + n + row];
        total += 0.5 * (left + value) * (table[1 + row] - x);
        x = table[1 + row], left = value;
    }
    total += 0.5 * (left + on_line(table, row, end)) * (end - x);
    return total / (end - begin);
}
