"""A filament near the hull: classical Runge-Kutta in error-controlled micro-steps of its own."""

from math import sqrt

from ..library.integration import runge_kutta_sum
from .filament import free_acceleration, tip_force
from .modes import deflection_ratio
from .parameters import Parameters
from .records import Constants, Inputs, Modes, Placement, Reach, Scratch, Stage, State, Touched, Trial
from .standing import turn_by, turned
from .water import add_drag, book_drag


def evaluate(limited: bool, f: Stage, at: Placement, u: Inputs, p: Parameters, s: Scratch) -> Reach:
    """The right-hand side: accelerations, forces and powers from deflection and rates. `limited`: as in `tip_force`."""
    free_acceleration(f, p, s.modes, s.k)
    reach = tip_force(limited, f, at, u, p, s.c, s.modes, s.G)
    return reach


def predict(f: Stage, begin: Stage, before: Stage, h: float, p: Parameters) -> None:
    """A stage of Runge-Kutta: from the begin over h at the rates of the stage before."""
    for r in range(p.N_m):
        f.eta[r] = begin.eta[r] + h * before.eta_dot[r]
        f.eta_dot[r] = begin.eta_dot[r] + h * before.a[r]
    if p.friction_law == 2:
        f.z = begin.z + h * before.z_dot


def finish(
    end: Stage, now: Stage, second: Stage, third: Stage, fourth: Stage, h_s: float, p: Parameters, m: Modes,
) -> float:
    """The end of the micro-step; returns the squared error of the deflections as velocities."""
    w = h_s / 6.0
    error = 0.0
    for r in range(p.N_m):
        end.eta[r] = now.eta[r] + h_s * (now.eta_dot[r] + w * (now.a[r] + second.a[r] + third.a[r]))
        end.eta_dot[r] = now.eta_dot[r] + w * (now.a[r] + 2.0 * (second.a[r] + third.a[r]) + fourth.a[r])
        e = m.omega_r[r] * w * (end.eta_dot[r] - fourth.eta_dot[r])
        error = error + e * e
    if p.friction_law == 2:
        end.z = now.z + w * (now.z_dot + 2.0 * (second.z_dot + third.z_dot) + fourth.z_dot)
    return error


def with_velocities(error: float, end: Stage, fourth: Stage, h_s: float, p: Parameters, c: Constants) -> float:
    """The squared error of the velocities on top, and of z as a velocity."""
    total = error
    for r in range(p.N_m):
        e = h_s / 6.0 * (end.a[r] - fourth.a[r])
        total = total + e * e
    if p.friction_law == 2:
        e = c.omega_max * h_s / 6.0 * (end.z_dot - fourth.z_dot)
        total = total + e * e
    return total


def runge_kutta(at: Placement, h_s: float, u: Inputs, p: Parameters, s: Scratch) -> Trial:
    """Micro-step h_s from `now`, which stands at `at` and where stage 1 is known, to `end`.

    The error estimate is the difference to the third-order companion that takes k5, the rate at the end of the step,
    for k4.
    """
    turn = turn_by(0.5 * h_s * u.omega_b)
    half = turned(at, turn, 0.5 * h_s, u)
    whole = turned(half, turn, 0.5 * h_s, u)
    predict(s.second, s.now, s.now, 0.5 * h_s, p)
    reach = evaluate(False, s.second, half, u, p, s)
    if p.C_d > 0.0:
        add_drag(0.0, s.second, half, u, p, s.c, s.modes, s.shapes)
    predict(s.third, s.now, s.second, 0.5 * h_s, p)
    reach = evaluate(False, s.third, half, u, p, s)
    if p.C_d > 0.0:
        add_drag(0.0, s.third, half, u, p, s.c, s.modes, s.shapes)
    predict(s.fourth, s.now, s.third, h_s, p)
    reach = evaluate(False, s.fourth, whole, u, p, s)
    if p.C_d > 0.0:
        add_drag(0.0, s.fourth, whole, u, p, s.c, s.modes, s.shapes)
    error = finish(s.end, s.now, s.second, s.third, s.fourth, h_s, p, s.modes)
    reach = evaluate(True, s.end, whole, u, p, s)
    rate = reach.rate
    if p.C_d > 0.0:
        rate = rate + add_drag(0.0, s.end, whole, u, p, s.c, s.modes, s.shapes)
    error = with_velocities(error, s.end, s.fourth, h_s, p, s.c)
    return Trial(sqrt(error), reach.Delta, rate, whole.sin_psi, whole.cos_psi, whole.h_plane)


def book(
    h_s: float, now: Stage, second: Stage, third: Stage, fourth: Stage, c: Constants, x: State,
) -> None:
    """Impulses and losses of a micro-step, of a rod's share."""
    w = h_s * c.share
    x.J_x = x.J_x - runge_kutta_sum(w, now.F_f, second.F_f, third.F_f, fourth.F_f)
    x.J_z = x.J_z - runge_kutta_sum(w, now.F_n, second.F_n, third.F_n, fourth.F_n)
    x.J_T = x.J_T + runge_kutta_sum(w, now.moment, second.moment, third.moment, fourth.moment)
    x.sliding_distance = x.sliding_distance + runge_kutta_sum(
        w, now.v_slip, second.v_slip, third.v_slip, fourth.v_slip)
    x.W_damping = x.W_damping + runge_kutta_sum(
        w, now.P_damping, second.P_damping, third.P_damping, fourth.P_damping)
    x.W_friction = x.W_friction + runge_kutta_sum(
        w, now.P_friction, second.P_friction, third.P_friction, fourth.P_friction)
    x.W_contact = x.W_contact + runge_kutta_sum(
        w, now.P_contact, second.P_contact, third.P_contact, fourth.P_contact)
    x.micro_steps = x.micro_steps + 1.0


def adopt(now: Stage, end: Stage, p: Parameters) -> None:
    """The end of a micro-step is the begin of the next."""
    for r in range(p.N_m):
        now.eta[r] = end.eta[r]
        now.eta_dot[r] = end.eta_dot[r]
        now.a[r] = end.a[r]
        now.g[r] = end.g[r]
    if p.friction_law == 2:
        now.z = end.z
        now.z_dot = end.z_dot
        if end.F_n == 0.0:  # off the hull nothing bends them
            now.z = 0.0
    now.F_f = end.F_f
    now.F_n = end.F_n
    now.moment = end.moment
    now.x = end.x
    now.v_slip = end.v_slip
    now.P_friction = end.P_friction
    now.P_contact = end.P_contact
    now.P_damping = end.P_damping
    if p.C_d > 0.0:
        now.F_w = end.F_w
        now.M_w = end.M_w
        now.P_water = end.P_water


def book_water(at: Placement, h_s: float, u: Inputs, x: State, s: Scratch) -> None:
    """Impulses of the drag in a micro-step that begins at `at`, and its loss."""
    turn = turn_by(0.5 * h_s * u.omega_b)
    half = turned(at, turn, 0.5 * h_s, u)
    whole = turned(half, turn, 0.5 * h_s, u)
    book_stage(h_s / 6.0, s.now, at, s.c, x)
    book_stage(h_s / 3.0, s.second, half, s.c, x)
    book_stage(h_s / 3.0, s.third, half, s.c, x)
    book_stage(h_s / 6.0, s.fourth, whole, s.c, x)


def book_stage(h: float, f: Stage, at: Placement, c: Constants, x: State) -> None:
    """Impulses of the drag at a stage that stands for the time h, and its loss."""
    book_drag(h * f.F_w, h * f.M_w, at, c, x)
    x.W_water = x.W_water + h * c.share * f.P_water


def touches(f: Stage) -> float:
    """1 for a tip that the hull presses, else 0."""
    touching = 0.0
    if f.F_n > 0.0:
        touching = 1.0
    return touching


def count_strike(before: float, f: Stage, c: Constants, x: State) -> None:
    """Count a touch-down, of a rod's share, where a tip is pressed that was not before."""
    if before == 0.0 and f.F_n > 0.0:
        x.strikes = x.strikes + c.share


def accept(h_s: float, p: Parameters, x: State, s: Scratch) -> None:
    """Book a micro-step and make its end the start of the next."""
    book(h_s, s.now, s.second, s.third, s.fourth, s.c, x)
    count_strike(touches(s.now), s.end, s.c, x)
    adopt(s.now, s.end, p)
    x.deflection_ratio = max(x.deflection_ratio, deflection_ratio(s.now, p, s.c, s.modes))


def advance_touching(
    begin: Placement, h: float, h_first: float, rate_first: float, u: Inputs, p: Parameters, x: State, s: Scratch,
) -> Touched:
    """Advance `now` over h from how it stands; h_first: first micro-step to try.

    At the start the rate and, in `now`, accelerations and forces are known.
    """
    v_tolerance = p.tolerance * omega_1(s.modes) * p.L
    h_goal = h_first
    rate = rate_first
    Delta = 0.0
    tau = 0.0
    at = Placement(begin.sin_psi, begin.cos_psi, begin.h_plane)
    running = True
    while running:
        left = h - tau
        h_s = max(min(h_goal, 2.7 / rate), 1e-9)  # Runge-Kutta is stable up to 2.78 / rate
        if h_s >= left * (1.0 - 1e-9):
            h_s = left
        elif 2.0 * h_s > left:  # two equal steps rather than a last tiny one
            h_s = 0.5 * left
        trial = runge_kutta(at, h_s, u, p, s)
        Delta = trial.Delta
        error = trial.error / v_tolerance
        h_new = 2.0 * h_s
        if error > 0.04:
            h_new = h_s * max(0.9 / sqrt(sqrt(error)), 0.2)
        if h_new < p.h_min:
            h_new = min(p.h_min, 1.7 * h_new)  # below h_min for ten times the tolerance
        if h_s * trial.rate > 4.0 and h_s > 1e-9:  # contact or sticking began: the step is outside the stability limit
            h_goal = max(2.0 / trial.rate, 0.25 * h_s)
        elif (error > 1.0 and h_s > 1.000001 * p.h_min) or (error > 10.0 and h_s > 1e-9):
            h_goal = h_new
        else:
            if h_s < left:
                x.h_micro_min = min(x.h_micro_min, h_s)
            if h_new < h_s or h_new > h_goal:
                h_goal = h_new
            h_goal = min(h_goal, p.h_max)
            if p.C_d > 0.0:
                book_water(at, h_s, u, x, s)
            accept(h_s, p, x, s)
            rate = trial.rate
            at = Placement(trial.sin_psi, trial.cos_psi, trial.h_plane)
            running = h_s < left
            tau = tau + h_s
    return Touched(h_goal, Delta)


def omega_1(m: Modes) -> float:
    """The lowest frequency at rest."""
    return m.omega_r[0]
