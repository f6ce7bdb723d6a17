"""Filament brush: modal filaments with contact and friction (Eqs. 1-13) and their sum over the brush (Eqs. 14-15).

Frames and symbols are those of README.md, names and units those of records.py.
"""

from math import cos, pi

from .calendar import keep_map, turn_page
from .contact import contact_energy
from .filament import hub_radius, modal_mass, share_of, tip_radius
from .free_flight import advance_free, advance_free_in_water, is_near_the_flow, tip_speed_bound
from .largest import largest_asleep
from .micro_steps import advance_touching, count_strike, evaluate, touches
from .modes import centrifugal_energy, deflection_ratio, mode_table, slope_integrals
from .nearby_maps import map_of_step
from .parameters import Parameters
from .reach import follow_speed, is_far, start_bounds, swing_of, within_step
from .reactions import give, take
from .records import Advanced, Constants, Inputs, Modes, Outputs, Scratch, State
from .rods import at_strip, place, take_group
from .sleepers import (
    are_asleep,
    carry,
    centrifugal_energy_of_sum,
    filament_of,
    may_sleep,
    settle,
    strip_of,
    wake_all,
    wake_near,
)
from .standing import at_begin, at_end, spread, stand, turn_by, turned
from .totals import add_rod, begin_left, begin_sums, brush_sums, end_sums, evaluate_at, fill_table, group_sums
from .water import add_drag, drag_points, has_pack_torque, pack_torque, pushed_by_water


def setup(p: Parameters, x: State, s: Scratch) -> None:
    """The numbers of six modes at the length L."""
    A = 0.25 * pi * p.d * p.d
    EI_zz = p.E * pi * p.d * p.d * p.d * p.d / 64.0
    mass = (p.rho + p.C_a * p.rho_w) * A
    r_A = hub_radius(p) * cos(p.alpha)
    mode_table(EI_zz, mass, p, x.nominal)
    slope_integrals(r_A, A, mass, p, x, s)
    drag_points(p, x.nominal, x.Y, s)


def initialize(p: Parameters, x: State) -> None:
    """Straight filaments at rest in the turning brush. Energy counts from here; what is pressed in is hull work."""
    x.theta_b = p.theta_b_0
    x.J_x = 0.0
    x.J_z = 0.0
    x.J_T = 0.0
    x.J_Mx = 0.0
    x.J_Mz = 0.0
    x.sliding_distance = 0.0
    x.strikes = 0.0
    x.W_hub = 0.0
    x.W_hull = 0.0
    x.W_damping = 0.0
    x.W_friction = 0.0
    x.W_contact = 0.0
    x.W_water = 0.0
    x.E_contact = 0.0
    x.E_per_speed_2 = 0.0
    x.speed_2 = 0.0
    x.deflection_ratio = 0.0
    x.deflection_ratio_max = 0.0
    x.micro_steps = 0.0
    x.h_micro_min = p.h_max
    for i in range(p.n * p.n_strips * p.n_groups):
        x.h_next[i] = p.h_min
        x.z[i] = 0.0
        x.linear[i] = 0.0
        x.touches[i] = 0.0
        for r in range(p.N_m):
            x.eta[i, r] = 0.0
            x.eta_dot[i, r] = 0.0
    spread(p, x)
    wake_all(p, x)
    start_bounds(p, x)


def outputs(u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Write the outputs from the state and the inputs."""
    write_outputs(u.delta, u, p, x, y, s)


def table(u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """Fill the table `filament`, for those who look at single ones: where the last step ended, or at another delta."""
    delta = u.delta
    if delta == x.delta:
        delta = x.delta_end
    fill_table(delta, u, p, x, s)


def write_outputs(delta: float, u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """The outputs at a penetration."""
    brush_sums(delta, u, p, x, y, s)
    write_others(u, p, x, y, s)


def write_others(u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """The outputs that are no sums over the rods, and those that follow from them."""
    if has_pack_torque(p):
        T_pack = pack_torque(u, p, s.c)
        y.T_water = y.T_water + T_pack
        y.P_water = y.P_water - u.omega_b * T_pack
    y.T_brush = y.T_brush + y.T_water
    for r in range(6):
        y.kinetic_fraction[r] = y.kinetic_fraction[r] / max(y.E_kinetic, 1e-30)
    y.theta_b = x.theta_b
    y.J_x = x.J_x
    y.J_z = x.J_z
    y.J_T = x.J_T
    y.J_Mx = x.J_Mx
    y.J_Mz = x.J_Mz
    y.sliding_distance = x.sliding_distance
    y.strikes = x.strikes
    y.W_hub = x.W_hub
    y.W_hull = x.W_hull
    y.W_damping = x.W_damping
    y.W_friction = x.W_friction
    y.W_contact = x.W_contact
    y.W_water = x.W_water
    y.P_hub = -u.omega_b * y.T_brush
    y.P_hull = y.F_x * u.v_rov - y.F_z * u.delta_dot
    accounts(s.c, x, y)
    y.deflection_ratio = x.deflection_ratio
    y.deflection_ratio_max = x.deflection_ratio_max
    y.micro_steps = x.micro_steps
    y.h_micro_min = x.h_micro_min
    write_modes(x.nominal, y)
    write_sizes(p, s.c, y)


def write_sizes(p: Parameters, c: Constants, y: Outputs) -> None:
    """What a maker must know: hub, mass of the bristles, and how densely they stand on the hub."""
    section = p.n * p.bristles_per_filament * 0.25 * pi * p.d * p.d
    y.R_h = c.R_h
    y.m_filaments = section * p.rho * p.L
    y.packing = section / (2.0 * pi * y.R_h * p.width)


def accounts(c: Constants, x: State, y: Outputs) -> None:
    """What the integration created: stored energy less what was supplied and not lost."""
    y.E_centrifugal = c.speed_2 * x.E_per_speed_2
    # inputs that jump do work at once; it is booked when the next step begins
    jump = y.E_contact - x.E_contact + y.E_centrifugal - x.E_per_speed_2 * x.speed_2
    supplied = x.W_hub + x.W_hull + jump - x.W_damping - x.W_friction - x.W_contact - x.W_water
    y.energy_residual = y.E_kinetic + y.E_strain + y.E_centrifugal + y.E_contact - supplied


def write_modes(m: Modes, y: Outputs) -> None:
    """Eigenvalues and frequencies."""
    for r in range(6):
        y.lambda_r[r] = m.lambda_r[r]
        y.omega_r[r] = m.omega_r[r]


def advance_rod(
    k: int, g: int, h: float, u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch,
) -> Advanced:
    """Advance rod k of group g, which is awake, by h, in micro-steps if it can reach the hull; add it to the outputs.

    delta is that of its strip.
    """
    i = filament_of(k, p)
    take(k, s.now, p, x)
    at = at_begin(i, u.delta, p, x, s)
    end = at_end(i, u.delta + u.delta_dot * h, p, x, s)
    reach = evaluate(True, s.now, at, u, p, s)
    count_strike(x.touches[k], s.now, s.c, x)
    E_start = contact_energy(reach.Delta, p)
    rate = reach.rate
    far = False
    if p.C_d > 0.0:
        farthest = h * (abs(u.omega_b) * tip_radius(s.c) + abs(u.delta_dot) + tip_speed_bound(s.now, p, s.k))
        rate = rate + add_drag(0.0, s.now, at, u, p, s.c, s.modes, s.shapes)
        farthest = farthest + pushed_by_water(h, s.now, p, s.c)
        x.linear[k] = 0.0
        if reach.Delta + farthest < 0.0 and is_near_the_flow(s.now, u, p, s.c, s.k, s):
            x.linear[k] = 1.0
    elif not may_sleep(p):
        way = within_step(h, u, p)
        far = is_far(g, at, swing_of(g, s.now, p, s.k, x.at_rest), way, s.c, x)
    Delta = 0.0
    if far or x.linear[k] > 0.0:
        if far:
            lost = modal_mass(s.c) * advance_free(s.now, s.end, p, s.k, s)
            x.W_damping = x.W_damping + share_of(s.c) * lost
        else:
            turn = turn_by(0.5 * u.omega_b * h)
            middle = turned(at, turn, 0.0, u)
            advance_free_in_water(middle, h, u, p, x, s)
        reach = evaluate_at(x.linear[k], end, u, p, s)
        Delta = reach.Delta
        x.deflection_ratio = max(x.deflection_ratio, deflection_ratio(s.now, p, s.c, s.modes))
    else:
        touched = advance_touching(at, h, x.h_next[k], rate, u, p, x, s)
        x.h_next[k] = touched.h_next
        Delta = touched.Delta
    x.touches[k] = touches(s.now)
    E_end = contact_energy(Delta, p)
    add_rod(place(strip_of(k, g, p), p), E_end, end, p, y, s)
    give(k, s.now, p, x)
    return Advanced(E_start, E_end, centrifugal_energy(s.now, p, s.c, s.modes, s.S))


def advance_group(g: int, h: float, u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> Advanced:
    """Advance the rods of group g by h, those that are awake one by one, the sleepers together; add to the outputs."""
    E_start = 0.0
    E_end = 0.0
    E_per_speed_2 = 0.0
    take_group(g, u, p, x, s)
    if p.C_d == 0.0:
        follow_speed(g, p, s.c, s.modes, s.k, s.S, x, s)
    if may_sleep(p):
        settle(g, h, u, p, x, s)
        wake_near(g, h, u, p, x, s)
    if are_asleep(g, p, x) or not may_sleep(p):
        map_of_step(g, h, u, p, s.c, x, s)
    for a in range(int(x.awake_count[g])):
        k = int(x.awake[g * p.n * p.n_strips + a])
        w = place(strip_of(k, g, p), p)
        there = at_strip(w, u.delta, u, p)
        J_x = x.J_x
        J_z = x.J_z
        rod = advance_rod(k, g, h, there, p, x, y, s)
        x.J_Mx = x.J_Mx + w * (x.J_z - J_z)
        x.J_Mz = x.J_Mz - w * (x.J_x - J_x)
        E_start = E_start + rod.E_start
        E_end = E_end + rod.E_end
        E_per_speed_2 = E_per_speed_2 + rod.E_per_speed_2
    if are_asleep(g, p, x):
        x.deflection_ratio = largest_asleep(g, x.deflection_ratio, p, s.c, s.modes, s.k, x, s)
        carry(g, p, x, s)
        keep_map(g, p, x, s)
        first = g * (2 * p.N_m + 1)
        E_per_speed_2 = E_per_speed_2 + centrifugal_energy_of_sum(first, p, s.c, s.modes, s.S, x.sums)
        begin_left(g, p, x, s)
    group_sums(g, p, x, y, s)
    share = share_of(s.c)
    return Advanced(share * E_start, share * E_end, share * E_per_speed_2)


def book_step(E_start: float, E_end: float, E_per_speed_2: float, speed_2: float, x: State) -> None:
    """Work of the jumps of omega_b and delta before this step, and what the next one begins with."""
    x.W_hub = x.W_hub + (speed_2 - x.speed_2) * x.E_per_speed_2
    x.W_hull = x.W_hull + E_start - x.E_contact
    x.E_contact = E_end
    x.E_per_speed_2 = E_per_speed_2
    x.speed_2 = speed_2


def step(h: float, u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Advance the brush by h at constant omega_b, v_rov and delta_dot; delta goes on from its value at the start."""
    J_x = x.J_x
    J_z = x.J_z
    J_T = x.J_T
    E_start = 0.0
    E_end = 0.0
    E_per_speed_2 = 0.0
    x.deflection_ratio = 0.0
    begin_sums(p, y, s)
    stand(u.omega_b * h, x, s)
    for g in range(p.n_groups):
        group = advance_group(g, h, u, p, x, y, s)
        E_start = E_start + group.E_start
        E_end = E_end + group.E_end
        E_per_speed_2 = E_per_speed_2 + group.E_per_speed_2
    end_sums(y, s)
    turn_page(x)
    x.h_before = h
    x.delta = u.delta
    x.delta_end = u.delta + u.delta_dot * h
    if has_pack_torque(p):
        T_pack = pack_torque(u, p, s.c)
        x.J_T = x.J_T + T_pack * h
        x.W_water = x.W_water - u.omega_b * T_pack * h
    x.theta_b = x.theta_b + u.omega_b * h
    x.W_hub = x.W_hub - u.omega_b * (x.J_T - J_T)
    x.W_hull = x.W_hull + u.v_rov * (x.J_x - J_x) - u.delta_dot * (x.J_z - J_z)
    book_step(E_start, E_end, E_per_speed_2, acting_speed_2(s.c), x)
    x.deflection_ratio_max = max(x.deflection_ratio, x.deflection_ratio_max)
    write_others(u, p, x, y, s)


def acting_speed_2(c: Constants) -> float:
    """omega_b^2 as far as it acts on the filaments."""
    return c.speed_2
