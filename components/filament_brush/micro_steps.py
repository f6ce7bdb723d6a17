"""A filament near the hull: classical Runge-Kutta in error-controlled micro-steps of its own."""

from math import cos, sin, sqrt

from .filament import free_acceleration, tip_force


def runge_kutta(
    psi: float, tau: float, h_s: float, h_plane: float, N_m: int, foreshortening: bool, omega_r: "float[:]",
    modes: "float[:,:]", G: "float[:,:]", K: "float[:,:]", c: "float[:]", work: "float[:,:]",
) -> tuple[float, float, float]:
    """Micro-step h_s from rows 0, 1 of work to rows 2, 3; returns the velocity error, and Delta and rate at the end.

    psi, h_plane: as at tau = 0. Stage 1 is known. The error estimate is the difference to the third-order companion
    that takes k5, the rate at the end of the step, for k4.
    """
    sin_psi = 0.0
    cos_psi = 0.0
    for r in range(N_m):
        work[3, r] = work[1, r]
    for k in range(5, 8):
        c_h = 0.5 * h_s
        if k == 7:
            c_h = h_s
        if k != 6:
            sin_psi = sin(psi + c[6] * (tau + c_h))
            cos_psi = cos(psi + c[6] * (tau + c_h))
        for r in range(N_m):
            work[2, r] = work[0, r] + c_h * work[3, r]
            work[3, r] = work[1, r] + c_h * work[k - 1, r]
        free_acceleration(2, 3, k, N_m, modes, K, work)
        tip_force(2, 3, k, N_m, sin_psi, cos_psi, h_plane - c[7] * (tau + c_h), foreshortening, modes, G, c, work)
    w = h_s / 6.0
    error = 0.0
    for r in range(N_m):
        v_4 = work[3, r]
        work[2, r] = work[0, r] + h_s * (work[1, r] + w * (work[4, r] + work[5, r] + work[6, r]))
        work[3, r] = work[1, r] + w * (work[4, r] + 2.0 * (work[5, r] + work[6, r]) + work[7, r])
        e = omega_r[r] * w * (work[3, r] - v_4)
        error = error + e * e
    free_acceleration(2, 3, 8, N_m, modes, K, work)
    Delta, rate = tip_force(
        2, 3, 8, N_m, sin_psi, cos_psi, h_plane - c[7] * (tau + h_s), foreshortening, modes, G, c, work)
    for r in range(N_m):
        e = w * (work[8, r] - work[7, r])
        error = error + e * e
    return sqrt(error), Delta, rate


def integral(q: int, h_s: float, work: "float[:,:]") -> float:
    """Integral over a micro-step of what column q of the stages' rows 10..13 of work holds."""
    return h_s / 6.0 * (work[10, q] + 2.0 * (work[11, q] + work[12, q]) + work[13, q])


def accept(h_s: float, N_m: int, L: float, modes: "float[:,:]", work: "float[:,:]", total: "float[:]") -> None:
    """Book impulses and losses of a micro-step and make its end the start of the next."""
    total[1] = total[1] - integral(0, h_s, work)
    total[2] = total[2] - integral(1, h_s, work)
    total[3] = total[3] + integral(2, h_s, work)
    total[6] = total[6] + integral(5, h_s, work)
    total[7] = total[7] + integral(3, h_s, work)
    total[8] = total[8] + integral(4, h_s, work)
    total[14] = total[14] + 1.0
    y = 0.0
    for r in range(N_m):
        work[0, r] = work[2, r]
        work[1, r] = work[3, r]
        work[4, r] = work[8, r]
        y = y + modes[1, r] * work[0, r]
    for q in range(6):
        work[10, q] = work[14, q]
    total[12] = max(total[12], abs(y) / L)


def advance_touching(
    psi: float, h: float, h_goal: float, rate: float, Delta: float, h_plane: float, N_m: int, L: float,
    foreshortening: bool, h_min: float, h_max: float, tolerance: float, omega_r: "float[:]", modes: "float[:,:]",
    G: "float[:,:]", K: "float[:,:]", c: "float[:]", work: "float[:,:]", total: "float[:]",
) -> tuple[float, float]:
    """Advance rows 0, 1 of work over h; h_goal: first micro-step to try; returns the next one and Delta at the end.

    psi, h_plane: axis angle and hull distance at the start, where rate, Delta and rows 4, 10 of work are known.
    """
    v_tolerance = tolerance * omega_r[0] * L
    tau = 0.0
    running = True
    while running:
        left = h - tau
        h_s = max(min(h_goal, 2.7 / rate), 1e-9)  # Runge-Kutta is stable up to 2.78 / rate
        if h_s >= left * (1.0 - 1e-9):
            h_s = left
        elif 2.0 * h_s > left:  # two equal steps rather than a last tiny one
            h_s = 0.5 * left
        error, Delta, rate_end = runge_kutta(psi, tau, h_s, h_plane, N_m, foreshortening, omega_r, modes, G, K, c, work)
        error = error / v_tolerance
        h_new = 2.0 * h_s
        if error > 0.04:
            h_new = h_s * max(0.9 / sqrt(sqrt(error)), 0.2)
        if h_new < h_min:
            h_new = min(h_min, 1.7 * h_new)  # below h_min for ten times the tolerance
        if h_s * rate_end > 4.0 and h_s > 1e-9:  # contact or sticking began: the step is outside the stability limit
            h_goal = max(2.0 / rate_end, 0.25 * h_s)
        elif (error > 1.0 and h_s > 1.000001 * h_min) or (error > 10.0 and h_s > 1e-9):
            h_goal = h_new
        else:
            if h_s < left:
                total[15] = min(total[15], h_s)
            if h_new < h_s or h_new > h_goal:
                h_goal = h_new
            h_goal = min(h_goal, h_max)
            accept(h_s, N_m, L, modes, work, total)
            rate = rate_end
            running = h_s < left
            tau = tau + h_s
    return h_goal, Delta
