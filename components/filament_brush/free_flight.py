"""Free flight: filaments that cannot reach the hull within a step share one linear map over it (Eq. 4)."""

from math import sqrt

from ..declare.record import Matrix
from ..library.matrices import multiply
from .filament import modal_mass, share_of
from .parameters import Parameters
from .records import Constants, Drag, Inputs, Losses, Modes, Placement, Scratch, Stage, State, Stiffness
from .water import book_drag, torque_of_drag


def free_flight(
    h: float, omega_max: float, u: Inputs, p: Parameters, c: Constants, m: Modes, k: Stiffness, s: Scratch,
) -> None:
    """Fill P with the map of (eta, eta_dot, 1) over h without contact: Runge-Kutta in 2^k equal micro-steps.

    With drag, of (eta, eta_dot, 1, 1 m/s of water that passes the bristle along -e_t).

    For linear equations the classical Runge-Kutta step is the polynomial 1 + hA + .. + (hA)^4/24; k squarings of it
    give the whole step. The fastest rate times the micro-step is at most 0.2.
    """
    size = 2 * p.N_m + 1
    fastest = omega_max
    if p.C_d > 0.0:
        size = size + 1
        fastest = fastest + 2.0 * c.drag * c.slip * abs(u.omega_b) * c.x_a * c.L / c.M
    h_s = h
    squarings = 0
    while h_s * fastest > 0.2 and squarings < 60:
        h_s = 0.5 * h_s
        squarings = squarings + 1
    linear_equations(h_s, p, m, k, s)
    if p.C_d > 0.0:
        linear_drag(h_s, u, p, c, m, k, s)
    for order in range(4):
        if p.C_d > 0.0:
            multiply(size, s.A, s.P, s.Q)
        else:
            rates_of(p.N_m, s.A, s.P, s.Q)
        for i in range(size):
            for j in range(size):
                s.P[i, j] = s.Q[i, j] / (4.0 - order)
            s.P[i, i] = s.P[i, i] + 1.0
    for _ in range(squarings):
        if p.C_d > 0.0:
            multiply(size, s.P, s.P, s.Q)
        else:
            twice(2 * p.N_m, s.P, s.Q)
        for i in range(size):
            for j in range(size):
                s.P[i, j] = s.Q[i, j]


def rates_of(N_m: int, A: Matrix, P: Matrix, Q: Matrix) -> None:
    """Q = A P without drag, with what of A is not zero."""
    for j in range(2 * N_m + 1):
        for r in range(N_m):
            Q[r, j] = A[r, N_m + r] * P[N_m + r, j]
            total = 0.0
            for q in range(N_m):
                total = total + A[N_m + r, q] * P[q, j]
            Q[N_m + r, j] = total + A[N_m + r, N_m + r] * P[N_m + r, j] + A[N_m + r, 2 * N_m] * P[2 * N_m, j]
        Q[2 * N_m, j] = 0.0


def twice(size: int, P: Matrix, Q: Matrix) -> None:
    """Q = P P, whose last row is that of 1."""
    for i in range(size):
        for j in range(size + 1):
            total = 0.0
            for k in range(size):
                total = total + P[i, k] * P[k, j]
            Q[i, j] = total
        Q[i, size] = Q[i, size] + P[i, size]
        Q[size, i] = 0.0
    Q[size, size] = 1.0


def linear_equations(h_s: float, p: Parameters, m: Modes, k: Stiffness, s: Scratch) -> None:
    """A h_s of the rates of (eta, eta_dot, 1), and P = 1."""
    N_m = p.N_m
    for i in range(2 * N_m + 1):
        for j in range(2 * N_m + 1):
            s.A[i, j] = 0.0
            s.P[i, j] = 0.0
        s.P[i, i] = 1.0
    for r in range(N_m):
        s.A[r, N_m + r] = h_s
        s.A[N_m + r, N_m + r] = -h_s * m.damping[r]  # Eq. 4
        s.A[N_m + r, 2 * N_m] = h_s * k.load[r]
        for q in range(N_m):
            s.A[N_m + r, q] = -h_s * k.K[r, q]


def linear_drag(h_s: float, u: Inputs, p: Parameters, c: Constants, m: Modes, k: Stiffness, s: Scratch) -> None:
    """Add h_s times what drag, linear about omega_b r, does to the rates."""
    N_m = p.N_m
    one = 2 * N_m
    s.P[one + 1, one + 1] = 1.0
    for j in range(one + 2):
        s.A[one + 1, j] = 0.0
        s.A[j, one + 1] = 0.0
        s.P[one + 1, j] = 0.0
        s.P[j, one + 1] = 0.0
    s.P[one + 1, one + 1] = 1.0
    for r in range(N_m):
        s.rest[r] = k.load[r] / k.K[r, r]
    for i in range(6):
        sweep = c.slip * u.omega_b * (c.x_a - c.L + m.x[i])
        b = h_s * c.drag * m.weight[i] * abs(sweep) / c.M
        for r in range(N_m):
            b_r = b * s.shapes[i, r]
            s.A[N_m + r, one] = s.A[N_m + r, one] + b_r * sweep
            s.rest[r] = s.rest[r] + b_r * sweep / (h_s * k.K[r, r])
            s.A[N_m + r, one + 1] = s.A[N_m + r, one + 1] - 2.0 * b_r
            for q in range(N_m):
                s.A[N_m + r, N_m + q] = s.A[N_m + r, N_m + q] - 2.0 * b_r * s.shapes[i, q]


def relative_energy(f: Stage, p: Parameters, k: Stiffness) -> float:
    """Kinetic, strain and centrifugal energy per modal mass."""
    energy = 0.0
    for r in range(p.N_m):
        pull = -k.load[r]
        for s in range(p.N_m):
            pull = pull + 0.5 * k.K[r, s] * f.eta[s]
        energy = energy + 0.5 * f.eta_dot[r] * f.eta_dot[r] + pull * f.eta[r]
    return energy


def advance_free(now: Stage, after: Stage, p: Parameters, k: Stiffness, s: Scratch) -> float:
    """Map a filament over the communication step; returns the energy lost per modal mass, all of it to damping."""
    N_m = p.N_m
    before = relative_energy(now, p, k)
    for r in range(N_m):
        after.eta[r] = s.P[r, 2 * N_m]
        after.eta_dot[r] = s.P[N_m + r, 2 * N_m]
        for q in range(N_m):
            after.eta[r] = after.eta[r] + s.P[r, q] * now.eta[q] + s.P[r, N_m + q] * now.eta_dot[q]
            after.eta_dot[r] = after.eta_dot[r] + s.P[N_m + r, q] * now.eta[q] + s.P[N_m + r, N_m + q] * now.eta_dot[q]
    for r in range(N_m):
        now.eta[r] = after.eta[r]
        now.eta_dot[r] = after.eta_dot[r]
    now.z = 0.0
    return before - relative_energy(now, p, k)


def losses(f: Stage, u: Inputs, p: Parameters, c: Constants, m: Modes, shapes: Matrix) -> Losses:
    """Powers of modal damping and of linear drag on the bristle's own motion."""
    damping = 0.0
    drag = 0.0
    for r in range(p.N_m):
        damping = damping + c.M * m.damping[r] * f.eta_dot[r] * f.eta_dot[r]
    for i in range(6):
        y_dot = 0.0
        for r in range(p.N_m):
            y_dot = y_dot + shapes[i, r] * f.eta_dot[r]
        sweep = c.slip * abs(u.omega_b) * (c.x_a - c.L + m.x[i])
        drag = drag + 2.0 * c.drag * m.weight[i] * sweep * y_dot * y_dot
    return Losses(damping, drag)


def map_in_water(
    now: Stage, after: Stage, way: Stage, passing: float, p: Parameters, c: Constants, k: Stiffness, s: Scratch,
) -> float:
    """As `advance_free`, with water that passes at this speed; the way of eta goes into `way`."""
    N_m = p.N_m
    before = relative_energy(now, p, k)
    for r in range(N_m):
        way.eta[r] = now.eta[r]
    advance_free(now, after, p, k, s)
    for r in range(N_m):
        now.eta[r] = now.eta[r] + s.P[r, 2 * N_m + 1] * c.slip * passing
        now.eta_dot[r] = now.eta_dot[r] + s.P[N_m + r, 2 * N_m + 1] * c.slip * passing
        way.eta[r] = now.eta[r] - way.eta[r]
    return before - relative_energy(now, p, k)


def drag_on_way(
    way: Stage, h: float, passing: float, u: Inputs, p: Parameters, c: Constants, m: Modes, shapes: Matrix,
) -> Drag:
    """Impulse of linear drag over the time h in which the deflections went this way."""
    F_w = 0.0
    M_w = 0.0
    work = 0.0
    for i in range(6):
        y = 0.0
        for r in range(p.N_m):
            y = y + shapes[i, r] * way.eta[r]
        sweep = c.slip * u.omega_b * (c.x_a - c.L + m.x[i])
        b = c.drag * m.weight[i] * abs(sweep)
        load = b * (sweep - 2.0 * c.slip * passing)
        F_i = h * load - 2.0 * b * y
        F_w = F_w + F_i
        M_w = M_w + F_i * m.x[i]
        work = work + load * y
    return Drag(F_w, M_w, work)


def advance_free_in_water(at: Placement, h: float, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """Map a filament over the communication step, in whose middle it stands so, and book what damping and drag take.

    Forces are linear in the rates, so that their impulses follow from the deflections exactly; its angle counts as in
    the middle. What both losses are together follows from the energy; they share it as their powers do at the two ends.
    """
    passing = u.v_rov * at.cos_psi + u.delta_dot * at.sin_psi
    begin = losses(s.now, u, p, s.c, s.modes, s.shapes)
    lost = modal_mass(s.c) * map_in_water(s.now, s.end, s.second, passing, p, s.c, s.k, s)
    end = losses(s.now, u, p, s.c, s.modes, s.shapes)
    drag = drag_on_way(s.second, h, passing, u, p, s.c, s.modes, s.shapes)
    damping = begin.damping + end.damping
    W_damping = (lost + drag.work) * damping / max(damping + begin.drag + end.drag, 1e-300)
    share = share_of(s.c)
    x.W_damping = x.W_damping + share * W_damping
    torque = torque_of_drag(drag.F_w, drag.M_w, s.c)
    x.W_water = x.W_water + share * (lost - W_damping - u.omega_b * torque - passing * drag.F_w)
    book_drag(drag.F_w, drag.M_w, at, s.c, x)


def is_near_the_flow(f: Stage, u: Inputs, p: Parameters, c: Constants, k: Stiffness, s: Scratch) -> bool:
    """Is the tip's own speed, all energy kinetic and modes in phase, so far below the flow's that drag is linear?"""
    speed = 0.0
    for r in range(p.N_m):
        away = f.eta[r] - s.rest[r]
        speed = speed + 2.0 * sqrt(f.eta_dot[r] * f.eta_dot[r] + k.K[r, r] * away * away)
    return speed < p.linear_below * c.slip * abs(u.omega_b) * p.R_brush


def tip_speed_bound(f: Stage, p: Parameters, k: Stiffness) -> float:
    """Bound on the tip speed of free vibration: all energy kinetic, modes in phase, times 1.5."""
    speed = 0.0
    for r in range(p.N_m):
        speed = speed + 3.0 * sqrt(f.eta_dot[r] * f.eta_dot[r] + k.K[r, r] * f.eta[r] * f.eta[r])
    return speed
