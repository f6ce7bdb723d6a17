/* CVODE driven from C: what the integration of an FMU for Model Exchange costs at least. All functions are addresses. */
#include <stddef.h>

typedef struct {
    int (*set_time)(void *, double);
    int (*set_states)(void *, const double *, size_t);
    int (*get_derivatives)(void *, double *, size_t);
    int (*set_real)(void *, const unsigned *, size_t, const double *);
    double *(*data)(void *);                                      /* N_VGetArrayPointer */
    int (*step)(void *, double, void *, double *, int);           /* CVode */
    int (*stop)(void *, double);                                  /* CVodeSetStopTime */
    int (*anew)(void *, double, void *);                          /* CVodeReInit */
    void *instance, *cvode, *states;
    long n, calls;
} Driver;

int right_hand_side(double t, void *y, void *dy, void *user) {
    Driver *d = user;
    d->calls++;
    return d->set_time(d->instance, t) | d->set_states(d->instance, d->data(y), d->n) |
           d->get_derivatives(d->instance, d->data(dy), d->n);
}

/* `count` communication steps of `h` from number `first` on; `inputs`: what the input is set to at each, or none. */
int drive(Driver *d, long first, long count, double h, const double *inputs, unsigned input, int restart) {
    int worst = 0;
    double t;
    for (long k = first; k < first + count; k++) {
        double begin = k * h, end = begin + h;
        if (inputs) worst |= d->set_real(d->instance, &input, 1, &inputs[k]);
        if (restart) worst |= d->anew(d->cvode, begin, d->states);
        worst |= d->stop(d->cvode, end);
        int flag = d->step(d->cvode, end, d->states, &t, 1);
        if (flag < 0) return flag;
        worst |= d->set_time(d->instance, t) | d->set_states(d->instance, d->data(d->states), d->n);
    }
    return worst;
}
