"""The map of free flight over a step while the speed changes little: a parabola over its square, made of three maps.

The linear part of Eq. 4 is linear in omega_b^2, and a change of it moves the map the less the shorter the step: over a
change d the term of third order is below (h^2 d T)^3/720, T the norm of dK/d(omega_b^2). With h^2 d T at most 1e-4 that
is below rounding.
"""

from ..declare.record import Matrix
from .free_flight import free_flight
from .modes import stiffness
from .parameters import Parameters
from .records import Constants, Inputs, Scratch, State


def map_of_step(g: int, h: float, u: Inputs, p: Parameters, c: Constants, x: State, s: Scratch) -> None:
    """Fill P with the map of group g over h."""
    near = False
    if p.C_d == 0.0:
        near = h == x.nearby_h[g] and abs(c.speed_2 - x.nearby_speed_2[g]) <= x.nearby_range[g]
        if not near and h == x.h_before:
            wide = 1e-4 / (h * h * largest_change(p, c, s.S))
            if abs(c.speed_2 - x.speed_2) < 0.25 * wide:
                make_nearby(g, h, wide, u, p, c, x, s)
                near = True
    if near:
        take_nearby(g, c.speed_2, p, x, s)
    else:
        free_flight(h, c.omega_max, u, p, c, s.modes, s.k, s)


def largest_change(p: Parameters, c: Constants, S: Matrix) -> float:
    """The norm of dK/d(omega_b^2), by rows; at least 1."""
    largest = 1.0
    for r in range(p.N_m):
        row = c.chi
        for q in range(p.N_m):
            row = row + abs(S[r, q])
        largest = max(largest, row)
    return largest


def make_nearby(
    g: int, h: float, wide: float, u: Inputs, p: Parameters, c: Constants, x: State, s: Scratch,
) -> None:
    """Make the parabola of group g about the present speed, from the maps at it and `wide` to both sides."""
    size = 2 * p.N_m
    first = 3 * size * g
    speed_2 = c.speed_2
    c.speed_2 = speed_2 + wide
    fastest = stiffness(-c.x_t, s.k, p, c, s.modes, s.S)
    free_flight(h, fastest, u, p, c, s.modes, s.k, s)
    keep_rows(first + 2 * size, size, s.P, x.nearby)
    c.speed_2 = speed_2 - wide
    stiffness(-c.x_t, s.k, p, c, s.modes, s.S)
    free_flight(h, fastest, u, p, c, s.modes, s.k, s)
    keep_rows(first + size, size, s.P, x.nearby)
    c.speed_2 = speed_2
    stiffness(-c.x_t, s.k, p, c, s.modes, s.S)
    free_flight(h, fastest, u, p, c, s.modes, s.k, s)
    keep_rows(first, size, s.P, x.nearby)
    for i in range(first, first + size):
        for j in range(size + 1):
            below = x.nearby[i + size, j] - x.nearby[i, j]
            above = x.nearby[i + 2 * size, j] - x.nearby[i, j]
            x.nearby[i + size, j] = 0.5 * (above - below)
            x.nearby[i + 2 * size, j] = 0.5 * (above + below)
    x.nearby_h[g] = h
    x.nearby_speed_2[g] = speed_2
    x.nearby_range[g] = wide


def keep_rows(first: int, size: int, P: Matrix, nearby: Matrix) -> None:
    """A map from the row `first` on."""
    for i in range(size):
        for j in range(size + 1):
            nearby[first + i, j] = P[i, j]


def take_nearby(g: int, speed_2: float, p: Parameters, x: State, s: Scratch) -> None:
    """Fill P from the parabola of group g."""
    size = 2 * p.N_m
    first = 3 * size * g
    t = (speed_2 - x.nearby_speed_2[g]) / x.nearby_range[g]
    for i in range(size):
        for j in range(size + 1):
            s.P[i, j] = x.nearby[first + i, j] + t * (
                x.nearby[first + size + i, j] + t * x.nearby[first + 2 * size + i, j])
        s.P[size, i] = 0.0
    s.P[size, size] = 1.0
