"""Which rods can reach the hull within a step: by their angle, and by a bound on how far each can swing about its rest.

The swing of a rod is the root of twice its energy about its rest per modal mass, which no free flight increases. A
change of the speed moves the rest and stiffens the modes: it raises all bounds of a group alike, by a factor and
a term.
"""

from math import atan2, ceil, floor, pi, sqrt

from ..declare.record import Matrix
from ..library.matrices import solve
from .parameters import Parameters
from .records import Constants, Inputs, Modes, Placement, Scratch, Span, Stage, State, Stiffness, Sweep
from .standing import turn_by


def start_bounds(p: Parameters, x: State) -> None:
    """Bounds at rest, of straight filaments."""
    for g in range(p.n_groups):
        x.grow[g] = 1.0
        x.lift[g] = 0.0
        x.widest[g] = 0.0
        x.since[g] = 0.0
        x.y_rest[g] = 0.0
        x.y_per_swing[g] = 0.0
        x.nearby_h[g] = 0.0
        for j in range(p.n_strips):
            x.arc_low[g * p.n_strips + j] = 0.0
            x.arc_high[g * p.n_strips + j] = -1.0
        for r in range(p.N_m):
            x.at_rest[g, r] = 0.0


def follow_speed(
    g: int, p: Parameters, c: Constants, m: Modes, k: Stiffness, S: Matrix, x: State, s: Scratch,
) -> None:
    """Rest and bounds of group g at the speed of this step, if it is another than in the last one.

    With K' = K + D T, T = S - chi, D the change of omega_b^2: V' <= V (1 + ratio |D|), ratio the norm of T over K, and
    the rest moves by the root of twice the energy of its way.
    """
    change = abs(c.speed_2 - x.speed_2)
    if change > 0.0 or x.y_per_swing[g] == 0.0:
        ratio = relative_stiffening(p, c, k, S)
        copy_stiffness(p, k, s.A)
        for r in range(p.N_m):
            s.lean[r] = m.Y_L[r]
        solve(s.A, s.lean, p.N_m)
        reach = 0.0
        for r in range(p.N_m):
            reach = reach + m.Y_L[r] * s.lean[r]
        x.y_per_swing[g] = 0.0
        if ratio >= 0.0:
            x.y_per_swing[g] = sqrt(abs(reach))
        copy_stiffness(p, k, s.A)
        for r in range(p.N_m):
            s.lean[r] = k.load[r]
        solve(s.A, s.lean, p.N_m)
        x.y_rest[g] = 0.0
        way = 0.0
        for r in range(p.N_m):
            pull = 0.0
            for q in range(p.N_m):
                pull = pull + k.K[r, q] * (s.lean[q] - x.at_rest[g, q])
            way = way + pull * (s.lean[r] - x.at_rest[g, r])
        for r in range(p.N_m):
            x.at_rest[g, r] = s.lean[r]
            x.y_rest[g] = x.y_rest[g] + m.Y_L[r] * s.lean[r]
        x.grow[g] = x.grow[g] * sqrt(1.0 + abs(ratio) * change)
        x.lift[g] = x.lift[g] + sqrt(abs(way)) / x.grow[g]
        if x.grow[g] + x.lift[g] > 1e3:
            note_anew(g, p, x)


def note_anew(g: int, p: Parameters, x: State) -> None:
    """The same bounds without what has gathered beside them."""
    first = g * p.n * p.n_strips
    for k in range(first, first + p.n * p.n_strips):
        x.swing[k] = known_swing(g, x.swing[k], x)
    x.widest[g] = known_swing(g, x.widest[g], x)
    x.grow[g] = 1.0
    x.lift[g] = 0.0


def copy_stiffness(p: Parameters, k: Stiffness, A: Matrix) -> None:
    """The stiffness for a solver that uses it up."""
    for r in range(p.N_m):
        for q in range(p.N_m):
            A[r, q] = k.K[r, q]


def relative_stiffening(p: Parameters, c: Constants, k: Stiffness, S: Matrix) -> float:
    """A bound on (eta T eta)/(eta K eta), T = dK/d(omega_b^2); -1 where K is too far from its diagonal to tell."""
    largest = 0.0
    beside = 0.0
    for r in range(p.N_m):
        row = 0.0
        off = 0.0
        for q in range(p.N_m):
            size = sqrt(max(k.K[r, r] * k.K[q, q], 1e-300))
            T = S[r, q]
            if r == q:
                T = T - c.chi
                if k.K[r, r] <= 0.0:
                    beside = 1.0
            else:
                off = off + abs(k.K[r, q]) / size
            row = row + abs(T) / size
        largest = max(largest, row)
        beside = max(beside, off)
    ratio = -1.0
    if beside < 0.5:  # then K is at least 1 - beside of its diagonal
        ratio = largest / (1.0 - beside)
    return ratio


def swing_of(g: int, f: Stage, p: Parameters, k: Stiffness, rest: Matrix) -> float:
    """The swing of a rod of group g at the stiffness k."""
    energy = 0.0
    for r in range(p.N_m):
        pull = 0.0
        for q in range(p.N_m):
            pull = pull + k.K[r, q] * (f.eta[q] - rest[g, q])
        energy = energy + f.eta_dot[r] * f.eta_dot[r] + pull * (f.eta[r] - rest[g, r])
    return sqrt(max(energy, 0.0))


def known_swing(g: int, bound: float, x: State) -> float:
    """A bound on the swing now, from what was noted of it."""
    return x.grow[g] * (bound + x.lift[g])


def note_swing(g: int, swing: float, x: State) -> float:
    """What to note of a swing, for `known_swing` at any later time."""
    bound = swing / x.grow[g] - x.lift[g]
    x.widest[g] = max(x.widest[g], bound)
    return bound


def within_step(h: float, u: Inputs, p: Parameters) -> Sweep:
    """What happens within h."""
    angle = u.omega_b * h
    turn = turn_by(angle)
    deepest = max(u.delta, u.delta + u.delta_dot * h)
    return Sweep(angle, turn.sine, turn.cosine, h_least=p.R_brush - deepest)


def tip_range(g: int, swing: float, x: State) -> float:
    """How far the tip of a rod of this swing goes to both sides of its rest."""
    return 1.000001 * x.y_per_swing[g] * swing


def is_far(g: int, at: Placement, swing: float, way: Sweep, c: Constants, x: State) -> bool:
    """Does a rod of this swing, which stands so when the step begins, certainly stay off the hull?

    The tip goes on a circle for each deflection; between the least and the largest its height is linear. Foreshortening
    takes it farther away (as long as it points downwards: a hull within the deflection of the axis counts as near).
    """
    far = False
    y = tip_range(g, swing, x)
    middle = c.x_t + x.y_rest[g]
    if x.y_per_swing[g] > 0.0 and way.h_least > abs(middle) + y:
        sin_1 = at.sin_psi * way.cos_turn + at.cos_psi * way.sin_turn
        cos_1 = at.cos_psi * way.cos_turn - at.sin_psi * way.sin_turn
        far = True
        for side in range(2):
            x_t = middle + (2.0 * side - 1.0) * y
            top = highest_tip(x_t, at.sin_psi, at.cos_psi, sin_1, cos_1, way.turn, c)
            if top + 1e-9 * c.R_tip >= way.h_least:
                far = False
    return far


def highest_tip(x_t: float, sin_0: float, cos_0: float, sin_1: float, cos_1: float, turn: float, c: Constants) -> float:
    """How far below the axis a tip comes that goes on the circle of a deflection."""
    top = max(c.x_a * cos_0 + x_t * sin_0, c.x_a * cos_1 + x_t * sin_1)
    rises = (x_t * cos_0 - c.x_a * sin_0) * turn > 0.0
    falls = (x_t * cos_1 - c.x_a * sin_1) * turn < 0.0
    if (rises and falls) or abs(turn) > 1.0:
        top = sqrt(c.x_a * c.x_a + x_t * x_t)
    return top


def span_within(g: int, way: Sweep, p: Parameters, c: Constants, x: State) -> Span:
    """The rods of a strip that come within reach if they swing as far as any of their group."""
    y = tip_range(g, known_swing(g, x.widest[g], x), x)
    low = c.x_t + x.y_rest[g] - y
    high = c.x_t + x.y_rest[g] + y
    if x.y_per_swing[g] > 0.0 and way.h_least > max(abs(low), abs(high)):
        begin = min(arc_begin(low, way.h_least, c), arc_begin(high, way.h_least, c))
        end = max(arc_end(low, way.h_least, c), arc_end(high, way.h_least, c))
    else:
        begin = -4.0
        end = 4.0
    span = span_between(begin, end, way, p, x)
    return Span(span.first, span.count)


def span_in_step(g: int, j: int, way: Sweep, p: Parameters, c: Constants, x: State) -> Span:
    """The same of strip j, which remembers the arc as long as it is wide enough and not far too wide."""
    at = g * p.n_strips + j
    y = tip_range(g, known_swing(g, x.widest[g], x), x)
    low = c.x_t + x.y_rest[g] - y
    high = c.x_t + x.y_rest[g] + y
    small = 1e-6 * p.R_brush
    holds = x.arc_low[at] <= low and high <= x.arc_high[at] and x.arc_h[at] <= way.h_least
    if x.y_per_swing[g] == 0.0:
        x.arc_low[at] = 0.0
        x.arc_high[at] = -1.0  # none is of less than nothing
        x.arc_begin[at] = -4.0
        x.arc_end[at] = 4.0
    elif not holds or (
        2.0 * y < 0.9 * (x.arc_high[at] - x.arc_low[at]) - 4.0 * small or way.h_least > x.arc_h[at] + small
    ):
        x.arc_low[at] = low - 0.02 * y - small
        x.arc_high[at] = high + 0.02 * y + small
        x.arc_h[at] = way.h_least
        x.arc_begin[at] = -4.0
        x.arc_end[at] = 4.0
        if way.h_least > max(abs(x.arc_low[at]), abs(x.arc_high[at])):
            x.arc_begin[at] = min(arc_begin(x.arc_low[at], way.h_least, c), arc_begin(x.arc_high[at], way.h_least, c))
            x.arc_end[at] = max(arc_end(x.arc_low[at], way.h_least, c), arc_end(x.arc_high[at], way.h_least, c))
    span = span_between(x.arc_begin[at], x.arc_end[at], way, p, x)
    return Span(span.first, span.count)


def span_between(begin: float, end: float, way: Sweep, p: Parameters, x: State) -> Span:
    """The rods of a strip whose axes come into an arc; -4 to 4: all."""
    first = ceil((begin - max(way.turn, 0.0) + p.alpha - x.theta_b) * p.n / (2.0 * pi) - 1e-6)
    last = floor((end - min(way.turn, 0.0) + p.alpha - x.theta_b) * p.n / (2.0 * pi) + 1e-6)
    count = min(max(0, last - first + 1), p.n)
    if begin == -4.0 and end == 4.0:
        first = 0
        count = p.n
    return Span(first, count)


def arc_begin(x_t: float, h_least: float, c: Constants) -> float:
    """The least psi at which a tip of this deflection reaches the hull; 4 for one that never does."""
    square = c.x_a * c.x_a + x_t * x_t - h_least * h_least
    begin = 4.0
    if square > -1e-8 * c.x_a * c.x_a:
        along = sqrt(square + 1e-8 * c.x_a * c.x_a)
        begin = atan2(x_t * h_least - c.x_a * along, c.x_a * h_least + x_t * along)
    return begin


def arc_end(x_t: float, h_least: float, c: Constants) -> float:
    """The largest psi, or -4."""
    square = c.x_a * c.x_a + x_t * x_t - h_least * h_least
    end = -4.0
    if square > -1e-8 * c.x_a * c.x_a:
        along = sqrt(square + 1e-8 * c.x_a * c.x_a)
        end = atan2(x_t * h_least + c.x_a * along, c.x_a * h_least - x_t * along)
    return end


def filament_at(first: int, m: int, p: Parameters) -> int:
    """The m-th filament from `first` on, round the hub."""
    at = first + m
    return at - p.n * floor((at + 0.5) / p.n)
