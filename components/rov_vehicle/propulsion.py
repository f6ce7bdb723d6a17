"""Thrusters: commands on their way, thrust, current, lag, loss near the hull and wrench (Eq. 20)."""

from math import exp, sqrt

from ..declare.record import Vector
from ..library.matrices import rows_times
from ..library.rotation import turned_back
from .parameters import Parameters
from .records import Inputs, Motion, Scratch, State


def ring(k: float) -> float:
    """A place in the ring of commands on their way, of one up to a turn beyond or behind its ends."""
    place_in_ring = k
    if k >= 128.0:
        place_in_ring = k - 128.0
    if k < 0.0:
        place_in_ring = k + 128.0
    return place_in_ring


def take_commands(u: Inputs, p: Parameters, x: State) -> None:
    """New commands act at once, or join those on their way; 128 changes within the delay have their exact times."""
    newest = int(ring(x.first_held + x.count_held - 1.0))
    changed = False
    for j in range(8):
        last = x.command[j]
        if x.count_held > 0.0:
            last = x.held[newest, j]
        if last != u.u_thruster[j]:
            changed = True
    if p.thruster_delay <= 0.0:
        for j in range(8):
            x.command[j] = u.u_thruster[j]
    elif changed:
        slot = newest
        if x.count_held < 128.0:
            slot = int(ring(newest + 1.0))
            x.count_held = x.count_held + 1.0
            x.due[slot] = x.clock + p.thruster_delay
        for j in range(8):
            x.held[slot, j] = u.u_thruster[j]


def until_next_command(longest: float, x: State) -> float:
    """Let the commands act that are due, and give the time until the next one, at most `longest`."""
    now = x.clock + 1e-9  # rounding of sums of steps
    while x.count_held > 0.0 and x.due[int(x.first_held)] <= now:
        first = int(x.first_held)
        for j in range(8):
            x.command[j] = x.held[first, j]
        x.first_held = ring(x.first_held + 1.0)
        x.count_held = x.count_held - 1.0
    part = longest
    if x.count_held > 0.0 and x.due[int(x.first_held)] < now + longest - 2e-9:
        part = x.due[int(x.first_held)] - x.clock
    return part


def acting(u: float, p: Parameters) -> float:
    """A command within -1 and 1, and 0 within the dead band."""
    c = min(1.0, max(-1.0, u))
    if abs(c) < p.thruster_dead_band:
        c = 0.0
    return c


def in_table(c: float, dead_band: float, u: Vector, F: Vector) -> float:
    """Thrust at a command: its root, the speed of the propeller, straight between the points and the dead band.

    Points within the dead band do not count: beyond it the thrust rises from 0 to the next point.
    """
    if abs(c) <= dead_band:
        return 0.0
    k = 0
    for i in range(1, 6):
        if c > u[i]:
            k = i
    low = u[k]
    high = u[k + 1]
    F_low = F[k]
    F_high = F[k + 1]
    if c > 0.0 and low < dead_band:
        low = dead_band
        F_low = 0.0
    if c < 0.0 and high > -dead_band:
        high = -dead_band
        F_high = 0.0
    share = min(1.0, max(0.0, (c - low) / (high - low)))
    root = (1.0 - share) * sqrt(abs(F_low)) + share * sqrt(abs(F_high))
    thrust = root * root
    if c < 0.0:
        thrust = -thrust
    return thrust


def thrust_of(u: float, V: float, p: Parameters) -> float:
    """Steady thrust of a command: k_T sgn(u) u^2, or from the table, which goes on straight beyond 12 and 16 V."""
    c = acting(u, p)
    if p.thrust_table:
        F = in_table(c, p.dead_band_12V, p.table_u, p.F_12V)
        F = F + 0.25 * (V - 12.0) * (in_table(c, p.dead_band_16V, p.table_u, p.F_16V) - F)  # Eq. V9
        if F * c < 0.0:
            F = 0.0
    else:
        F = p.k_T_forward * c * c
        if c < 0.0:
            F = -p.k_T_reverse * c * c
    return F


def current_of(u: float, V: float, p: Parameters) -> float:
    """Steady current of a thruster, from its table at 12 V; the voltage scales it."""
    along = 8.0 * (acting(u, p) + 1.0)
    k = min(int(along), 15)
    i_12V = p.i_12V[k] + (along - k) * (p.i_12V[k + 1] - p.i_12V[k])
    scale = 1.0 + 0.25 * (V - 12.0) * (p.i_ratio_16V - 1.0)
    return i_12V * max(0.0, scale)  # Eq. V10


def steady(u: Inputs, p: Parameters, x: State, s: Scratch) -> float:
    """The thrusts that the commands lead to, and the current of all thrusters."""
    i = 0.0
    for j in range(8):
        s.F_steady[j] = thrust_of(x.command[j], u.V_thruster, p)
        i += current_of(x.command[j], u.V_thruster, p)
    return i


def draw(h: float, i_steady: float, p: Parameters, x: State) -> None:
    """The current after the time h: it follows with the lag of the thrust."""
    decay = 0.0
    if p.thruster_lag > 0.0:
        decay = exp(-h / p.thruster_lag)
    x.i_thruster = i_steady + decay * (x.i_thruster - i_steady)


def thruster_wrench(decay: float, x: State, s: Scratch) -> None:
    """B F (Eq. 20) with the thrusts after a time in which the distance to their steady values fell by `decay`."""
    for j in range(8):
        s.F[j] = decay * x.thrust[j] + (1.0 - decay) * s.F_steady[j]
    wrench_of(s.F, x, s)


def wrench_of(thrust: Vector, x: State, s: Scratch) -> None:
    """B F (Eq. 20)."""
    rows_times(s.F_control, x.B, 0, 3, thrust, 8)  # Eq. 20
    rows_times(s.M_control, x.B, 3, 6, thrust, 8)  # Eq. 20


def near_hull(z: Motion, p: Parameters, x: State, s: Scratch) -> None:
    """The same wrench of thrusters that lose thrust as they come near the hull plane."""
    distance = 0.0
    for i in range(3):
        distance += p.hull_normal[i] * (z.position[i] - p.hull_point[i])
        s.normal[i] = -turned_back(s.R, i, p.hull_normal)
    for j in range(8):
        d = distance
        for i in range(3):
            d -= s.normal[i] * p.thruster_position[3 * j + i]
        s.F_near[j] = s.F[j] * (1.0 - p.hull_loss * exp(-max(0.0, d) / p.hull_loss_length))  # Eq. V11
    wrench_of(s.F_near, x, s)


def thrusts(decay: float, x: State, s: Scratch) -> None:
    """The thrusts after a time in which the distance to their steady values fell by `decay`."""
    for j in range(8):
        x.thrust[j] = decay * x.thrust[j] + (1.0 - decay) * s.F_steady[j]
