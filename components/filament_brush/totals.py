"""What the whole brush does: sums over the rods that are awake one by one, over the sleepers by their sums (Eq. 14)."""

from math import floor, pi

from ..declare.record import Matrix
from .calendar import catch_up
from .contact import contact_energy
from .filament import free_acceleration, share_of
from .micro_steps import evaluate
from .parameters import Parameters
from .reach import filament_at, is_far, known_swing, span_within, within_step
from .reactions import (
    add_base,
    add_energies,
    add_tip,
    base_reactions,
    clear_sums,
    filament_inertia,
    take,
)
from .records import Constants, Inputs, Load, Modes, Outputs, Placement, Reach, Scratch, Stage, State, Stiffness
from .rods import at_strip, place, take_group
from .sleepers import are_asleep, count_in, filament_of, strip_of
from .standing import at_begin, stand
from .water import add_drag, add_water


def begin_sums(p: Parameters, y: Outputs, s: Scratch) -> None:
    """Nothing is summed yet."""
    clear_sums(y)
    s.x_front = -p.R_brush
    s.x_rear = p.R_brush


def end_sums(y: Outputs, s: Scratch) -> None:
    """What is known when all rods are summed."""
    y.contact_length = max(0.0, s.x_front - s.x_rear)
    y.v_sliding = y.v_sliding / max(y.contact_count, 1e-30)


def brush_sums(delta: float, u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Forces, torques, powers and energies of the whole brush between two steps, whatever the inputs are now."""
    begin_sums(p, y, s)
    stand(0.0, x, s)
    for g in range(p.n_groups):
        take_group(g, u, p, x, s)
        begin_left(g, p, x, s)
        for a in range(look_at(g, delta, u, p, x, s)):
            k = int(s.looked_at[a])
            w = place(strip_of(k, g, p), p)
            there = at_strip(w, delta, u, p)
            if x.clock[k] >= 0.0:
                catch_up(k, g, s.now, p, x, s)
                count_in(0, -1.0, filament_of(k, p), s.now, p, s.left, s.left_around)
            else:
                take(k, s.now, p, x)
            at = at_begin(filament_of(k, p), there.delta, p, x, s)
            reach = evaluate_at(x.linear[k], at, there, p, s)
            add_rod(w, contact_energy(reach.Delta, p), at, p, y, s)
        group_sums(g, p, x, y, s)
    end_sums(y, s)


def group_sums(g: int, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Add the sleepers of group g, which are in `left`, and what holds for all its rods."""
    if are_asleep(g, p, x):
        add_left(p, s.c, s.modes, s.k, y, s)
    y.J_filaments = y.J_filaments + filament_inertia(s.c, p)


def begin_left(g: int, p: Parameters, x: State, s: Scratch) -> None:
    """The sums of all sleepers of group g."""
    size = 2 * p.N_m + 1
    for i in range(size):
        s.left_around[0, i] = x.around[2 * g, i]
        s.left_around[1, i] = x.around[2 * g + 1, i]
        for j in range(size):
            s.left[i, j] = x.sums[size * g + i, j]


def look_at(g: int, delta: float, u: Inputs, p: Parameters, x: State, s: Scratch) -> int:
    """Write down who is looked at by itself: the awake, and sleepers that a hull which has jumped may touch."""
    count = int(x.awake_count[g])
    for a in range(count):
        s.looked_at[a] = x.awake[g * p.n * p.n_strips + a]
    if are_asleep(g, p, x):
        for j in range(p.n_strips):
            there = at_strip(place(j, p), delta, u, p)
            way = within_step(0.0, there, p)
            within = span_within(g, way, p, s.c, x)
            for m in range(within.count):
                k = (g * p.n_strips + j) * p.n + filament_at(within.first, m, p)
                if x.clock[k] >= 0.0:
                    at = at_begin(filament_of(k, p), there.delta, p, x, s)
                    if not is_far(g, at, known_swing(g, x.swing[k], x), way, s.c, x):
                        s.looked_at[count] = 1.0 * k
                        count = count + 1
    return count


def evaluate_at(linear: float, at: Placement, u: Inputs, p: Parameters, s: Scratch) -> Reach:
    """What the hull and the water do to the rod in `now`, which stands so."""
    reach = evaluate(False, s.now, at, u, p, s)
    if p.C_d > 0.0:
        add_drag(linear, s.now, at, u, p, s.c, s.modes, s.shapes)
    return reach


def add_rod(w: float, E_contact: float, at: Placement, p: Parameters, y: Outputs, s: Scratch) -> float:
    """Add the rod in `now`, of a strip at y_t = w, that stands so, as it has been evaluated; returns its tip
    deflection."""
    add_tip(w, s.now, s.c, y)
    extend(s.now, s)
    if p.C_d > 0.0:
        add_water(w, s.now, at, s.c, y)
    shortening = add_energies(s.now, p, s.c, s.modes, y)
    y.E_contact = y.E_contact + share_of(s.c) * E_contact
    return add_base(s.now, at, shortening, p, s.c, s.modes, y)


def extend(f: Stage, s: Scratch) -> None:
    """Take a tip into the length of contact."""
    if f.F_n > 0.0:
        s.x_front = max(s.x_front, f.x)
        s.x_rear = min(s.x_rear, f.x)


def add_left(p: Parameters, c: Constants, m: Modes, k: Stiffness, y: Outputs, s: Scratch) -> None:
    """Energies, losses and base reactions of rods that feel no hull where a step ends, from their sums in `left`."""
    N_m = p.N_m
    for r in range(N_m):
        kinetic = c.share * (0.5 * c.M * s.left[N_m + r, N_m + r])
        y.kinetic_fraction[r] = y.kinetic_fraction[r] + kinetic
        y.E_kinetic = y.E_kinetic + kinetic
        y.E_strain = y.E_strain + c.share * (0.5 * c.M * m.omega_r[r] * m.omega_r[r] * s.left[r, r])
        y.P_damping = y.P_damping + 2.0 * m.damping[r] * kinetic
    cosine = s.cos_end
    sine = s.sin_end
    cosines = cosine * s.left_around[0, 2 * N_m] - sine * s.left_around[1, 2 * N_m]
    # A base reaction is a constant and a linear part: of the sum of w, and of that with cosines, it holds the constant
    # once; of a rod at rest, the first, it is the constant.
    for part in range(3):
        once = 0.0
        in_turn = 0.0
        times = 1.0
        times_cosine = 0.0
        if part == 0:
            times = s.left[2 * N_m, 2 * N_m] - 1.0
            times_cosine = cosines - 1.0
        elif part == 1:
            once = 1.0
        else:
            in_turn = 1.0
            times = 0.0
            times_cosine = 1.0
        free_rod(once, in_turn * cosine, -in_turn * sine, s.now, p, s.left, s.left_around)
        free_acceleration(s.now, p, m, k)
        load = Load(0.0, 0.0, shortening=0.0)
        base = base_reactions(s.now, load, p, c, m)
        y.F_y_eq11 = y.F_y_eq11 + c.share * times * base.shear
        y.M_b_eq12 = y.M_b_eq12 + c.share * times * base.moment
        y.T_brush_eq15 = y.T_brush_eq15 + p.R_brush * c.share * times_cosine * base.shear  # Eq. 15


def free_rod(once: float, a: float, b: float, f: Stage, p: Parameters, sums: Matrix, around: Matrix) -> None:
    """A rod whose deflections and rates are those of sums: of the plain one, of those with cosines and with sines."""
    for r in range(p.N_m):
        q = p.N_m + r
        f.eta[r] = once * sums[2 * p.N_m, r] + a * around[0, r] + b * around[1, r]
        f.eta_dot[r] = once * sums[2 * p.N_m, q] + a * around[0, q] + b * around[1, q]


def fill_table(delta: float, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """Fill the table `filament`."""
    stand(0.0, x, s)
    for i in range(p.n):
        phi = x.theta_b + 2.0 * pi * i / p.n
        s.filament_phi[i] = phi - 2.0 * pi * floor((phi + pi) / (2.0 * pi))
        s.filament_F_n[i] = 0.0
        s.filament_F_f[i] = 0.0
        s.filament_y[i] = 0.0
    for g in range(p.n_groups):
        take_group(g, u, p, x, s)
        first = g * p.n * p.n_strips
        for k in range(first, first + p.n * p.n_strips):
            there = at_strip(place(strip_of(k, g, p), p), delta, u, p)
            if x.clock[k] >= 0.0:
                catch_up(k, g, s.now, p, x, s)
            else:
                take(k, s.now, p, x)
            tell(filament_of(k, p), k, there, p, x, s)


def tell(i: int, k: int, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """What rod k of filament i, which is in `now`, adds to the table."""
    at = at_begin(i, u.delta, p, x, s)
    evaluate_at(x.linear[k], at, u, p, s)
    add_row(i, s.now, at, p, s.c, s.modes, s)


def add_row(i: int, f: Stage, at: Placement, p: Parameters, c: Constants, m: Modes, s: Scratch) -> None:
    """Add a rod to row i of the table."""
    shortening = 0.0
    for r in range(p.N_m):
        shortening = shortening + 0.5 * f.g[r] * f.eta[r]
    load = Load(
        F_a=-f.F_f * at.sin_psi - f.F_n * at.cos_psi,
        F_t=f.F_f * at.cos_psi - f.F_n * at.sin_psi,
        shortening=shortening,
    )
    base = base_reactions(f, load, p, c, m)
    s.filament_F_n[i] = s.filament_F_n[i] + c.share * f.F_n
    s.filament_F_f[i] = s.filament_F_f[i] + c.share * f.F_f
    s.filament_y[i] = s.filament_y[i] + c.share * base.y
