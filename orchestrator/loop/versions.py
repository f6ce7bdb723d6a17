"""Where FMI 2.0 and 3.0 differ below the loop: how values are exchanged, how a step is made and what it reports.

The functions of FMI 1.0 have the signatures of FMI 2.0.

Scalars only: an array as an argument would cost more than the call. One source with two lives, like `run.run`.
"""

from __future__ import annotations

from .calls import byte_at, do_step, do_step3, exchange2, exchange3, exchange_bytes
from .lives import compilable

REPORTS = 1 << 40  # from here on, where no status of an FMU can be: a C int
EVENT, TERMINATE, EARLY = REPORTS, REPORTS + 1, REPORTS + 2  # what fmi3DoStep reports beside its status
NO_ROOM = REPORTS + 3  # for another text


def signatures(version: int) -> int:
    """Whose signatures the functions of a version of FMI have: `fmi` of the functions below."""
    return max(version, 2)


@compilable
def good(status: int) -> bool:
    """Whether a status is OK (0) or Warning (1): anything else is none, the unknown too."""
    return (status | 1) == 1


@compilable
def exchange(fmi: int, function: int, instance: int, references: int, count: int, values: int, size: int) -> int:
    """Set or get `size` values at address `values`, of `count` variables at `references`; the status.

    `function` of bytes (Binary) is the negative of its address: it wants their sizes too, which lie behind the values.
    """
    if fmi == 2:
        return exchange2(function, instance, references, count, values)
    if function < 0:
        return exchange_bytes(-function, instance, references, count, values + 8 * size, values, size)
    return exchange3(function, instance, references, count, values, size)


@compilable
def step(fmi: int, function: int, instance: int, time: float, length: float, final: int, flags: int) -> int:
    """Step from `time` over `length` [s]; the status, or EVENT, TERMINATE, EARLY. `flags`: see calls.STEP_FLAGS."""
    if fmi == 2:
        return do_step(function, instance, time, length, final)
    status = do_step3(function, instance, time, length, final, flags)
    if good(status):
        if byte_at(flags + 1) != 0:
            return TERMINATE
        if byte_at(flags + 2) != 0:
            return EARLY
        if byte_at(flags) != 0:
            return EVENT
    return status
