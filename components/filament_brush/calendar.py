"""The maps of past steps, by which a rod in free flight catches up when somebody looks at it (Eq. 4).

Sixteen steps are an epoch, sixteen epochs an era. Kept are the map of each step of the present epoch, of each epoch of
the present era, of the epoch so far, and of all past epochs of the era. A rod's clock stands within this epoch or
where one begins, so it catches up by thirty maps at most; once in an era all do.
"""

from math import floor

from ..declare.record import Matrix, Vector
from .parameters import Parameters
from .reactions import give, take
from .records import Scratch, Stage, State


def row_of(g: int, k: int, p: Parameters) -> int:
    """First row of a map of group g: of step k, of epoch k - 16, of the epoch so far (32), of the era so far (33)."""
    return (34 * g + k) * 2 * p.N_m


def move_rod(row: int, f: Stage, moved: Vector, maps: Matrix, p: Parameters) -> None:
    """A rod by the map that begins at a row."""
    N_m = p.N_m
    for r in range(2 * N_m):
        total = maps[row + r, 2 * N_m]
        for q in range(N_m):
            total = total + maps[row + r, q] * f.eta[q] + maps[row + r, N_m + q] * f.eta_dot[q]
        moved[r] = total
    for r in range(N_m):
        f.eta[r] = moved[r]
        f.eta_dot[r] = moved[N_m + r]


def put_map(row: int, P: Matrix, maps: Matrix, p: Parameters) -> None:
    """Keep a map at a row."""
    for i in range(2 * p.N_m):
        for j in range(2 * p.N_m + 1):
            maps[row + i, j] = P[i, j]


def copy_map(row: int, source: int, maps: Matrix, p: Parameters) -> None:
    """The map at a row is that at another."""
    for i in range(2 * p.N_m):
        for j in range(2 * p.N_m + 1):
            maps[row + i, j] = maps[source + i, j]


def append_map(row: int, source: int, maps: Matrix, Q: Matrix, p: Parameters) -> None:
    """The map at a row, and then that at another."""
    size = 2 * p.N_m
    for i in range(size):
        for j in range(size + 1):
            total = 0.0
            for k in range(size):
                total = total + maps[source + i, k] * maps[row + k, j]
            Q[i, j] = total
        Q[i, size] = Q[i, size] + maps[source + i, size]
    put_map(row, Q, maps, p)


def catch_up(k: int, g: int, f: Stage, p: Parameters, x: State, s: Scratch) -> None:
    """Sleeping rod k of group g as it is before this step, from what the state holds of it."""
    begin = x.clock[k]
    first = floor(begin - x.epoch_begin)
    count = floor(x.steps - begin)
    last = 0
    if begin < x.epoch_begin:
        first = 16 + epochs(begin, x)
        count = 16 + epochs(x.epoch_begin, x) - first
        if begin == x.era_begin:
            first = 33
            count = 1
        if x.steps > x.epoch_begin:
            last = 1
    take(k, f, p, x)
    for m in range(count + last):
        row = row_of(g, first + m, p)
        if m == count:
            row = row_of(g, 32, p)
        move_rod(row, f, s.moved, x.maps, p)


def epochs(begin: float, x: State) -> int:
    """Epochs of this era that are over where one begins."""
    return floor((begin - x.era_begin) / 16.0)


def keep_map(g: int, p: Parameters, x: State, s: Scratch) -> None:
    """Note the map of this step for the sleepers of group g."""
    past = int(x.steps - x.epoch_begin)
    put_map(row_of(g, past, p), s.P, x.maps, p)
    if past == 0:
        copy_map(row_of(g, 32, p), row_of(g, 0, p), x.maps, p)
    else:
        append_map(row_of(g, 32, p), row_of(g, past, p), x.maps, s.Q, p)
    if past == 15:
        end_epoch(g, p, x, s)


def end_epoch(g: int, p: Parameters, x: State, s: Scratch) -> None:
    """Note the map of an epoch; those that fell asleep within it go to its end."""
    first = g * p.n * p.n_strips
    for a in range(int(x.late_count[g])):
        k = int(x.late[first + a])
        x.is_late[k] = 0.0
        if x.clock[k] > x.epoch_begin:
            take(k, s.now, p, x)
            for past in range(int(x.clock[k] - x.epoch_begin), 16):
                move_rod(row_of(g, past, p), s.now, s.moved, x.maps, p)
            give(k, s.now, p, x)
            x.clock[k] = x.steps + 1.0
    x.late_count[g] = 0.0
    epoch = epochs(x.epoch_begin, x)
    copy_map(row_of(g, 16 + epoch, p), row_of(g, 32, p), x.maps, p)
    if epoch == 0:
        copy_map(row_of(g, 33, p), row_of(g, 32, p), x.maps, p)
    else:
        append_map(row_of(g, 33, p), row_of(g, 32, p), x.maps, s.Q, p)
    if epoch == 15:
        end_era(g, p, x, s)


def end_era(g: int, p: Parameters, x: State, s: Scratch) -> None:
    """All sleepers go to the end of the era."""
    begin = g * p.n * p.n_strips
    for k in range(begin, begin + p.n * p.n_strips):
        if x.clock[k] >= 0.0 and x.clock[k] <= x.steps:
            first = 16 + epochs(x.clock[k], x)
            last = 32
            if x.clock[k] == x.era_begin:
                first = 33
                last = 34
            take(k, s.now, p, x)
            for m in range(first, last):
                move_rod(row_of(g, m, p), s.now, s.moved, x.maps, p)
            give(k, s.now, p, x)
            x.clock[k] = x.steps + 1.0


def turn_page(x: State) -> None:
    """Count the step."""
    x.steps = x.steps + 1.0
    if x.steps - x.epoch_begin >= 16.0:
        x.epoch_begin = x.steps
    if x.steps - x.era_begin >= 256.0:
        x.era_begin = x.steps
