/* What the FMI layer knows of a component: its variables, its arrays and its entry points.

   All numbers of an instance live in one vector of doubles, `v`: parameters, inputs, outputs in the order of the
   declaration (an array variable takes consecutive places), then time and step size. The declaration's tables and the
   entry points are written by the build into <component>.c, behind the equations. */
#ifndef COMPONENT_H
#define COMPONENT_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#ifndef M_PI
#define M_PI 3.14159265358979323846
#endif

/* Contraction of a*b + c would round once where the equations round twice. GCC (12) does it for several at once even
   where -ffp-contract=off forbids it. */
#if !defined(__GNUC__) || defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__FP_FAST_FMA)
#pragma GCC optimize("fp-contract=off", "no-tree-slp-vectorize")
#endif

/* Of a function that takes in all that it calls: there numbers decide that it gives to them. */
#ifdef __GNUC__
#define FLAT __attribute__((flatten))
#else
#define FLAT
#endif

typedef struct {
    double *data;
    int64_t columns;
} Matrix;

#define AT(matrix, row, column) ((matrix).data[(row) * (matrix).columns + (column)])

static inline double min_double(double a, double b) { return b < a ? b : a; }
static inline double max_double(double a, double b) { return b > a ? b : a; }
static inline int64_t min_int64_t(int64_t a, int64_t b) { return b < a ? b : a; }
static inline int64_t max_int64_t(int64_t a, int64_t b) { return b > a ? b : a; }

typedef enum { REAL, INTEGER, BOOLEAN } Kind;
typedef enum { PARAMETER, TUNABLE, INPUT, OUTPUT } Causality; /* a calculated parameter is an output here */

typedef struct {
    const char *name, *unit;
    Kind kind;
    Causality causality;
    int first, size; /* places in `v` */
    double minimum, maximum;
} Variable;

typedef struct {
    int64_t rows, columns;
} Shape;

typedef struct {
    const char *name, *token;
    int value_count, first_input, first_output; /* parameters come before the inputs, outputs last */
    int array_count;
    const Variable *variables;
    const short *owners;   /* the variable that each place of `v` belongs to */
    const double *starts;  /* start values of all places */
    const bool *scratch;   /* arrays that carry nothing from one call to the next */
    void (*shapes)(const double *v, Shape *shape);
    void (*start)(double *v, double *const *a, const Shape *shape);   /* initial state and outputs */
    void (*outputs)(double *v, double *const *a, const Shape *shape); /* outputs from state and inputs */
    void (*step)(double *v, double *const *a, const Shape *shape);    /* from v[time] over v[step size] */
} Component;

extern const Component component;

#endif
