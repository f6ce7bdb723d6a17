"""Inputs that an FMU has already: what was set at an instant need not be set again for the step that begins there.

Values are numbered: a copy of the same value by the same coefficients has the same number, all else a new one. A SET
is dropped where its component has made no step since the last one, and every cell has the number that was sent then.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import count

from ...loop.operations import (
    ADVANCE,
    CONTROL,
    COPY,
    ESTIMATE,
    FAULT,
    FIT,
    GAUGE,
    GET,
    HALVE,
    ITERATE,
    LEDGER,
    MEAN,
    MOVE,
    MOVES,
    NUMBER,
    PACE,
    PAUSE,
    PUSH,
    RECORD,
    REPEAT,
    RESTORE,
    REWIND,
    SAVE,
    SET,
    SOLVE,
    STEP,
    STEP_ON,
    TURNS,
    WATCH,
)
from .values import Row

REPEATED = {  # operations behind or around which others are done again
    ADVANCE, CONTROL, ESTIMATE, GAUGE, HALVE, ITERATE, MOVES, REPEAT, RESTORE, REWIND, SAVE, SOLVE, TURNS,
}  # fmt: skip


def without_repeats(
    rows: Iterable[Row], inputs: Mapping[int, Sequence[int]], outputs: Mapping[int, Sequence[int]],
    changed: Sequence[int] = (),
) -> list[Row]:  # fmt: skip
    """The operations of a cycle without such SETs; `inputs`, `outputs`: the cells of each component, by its number;
    `changed`: cells that events may change where they act.

    Operations that are repeated or taken back stay as they are.
    """
    listed = list(rows)
    if any(row[0] in REPEATED for row in listed):
        return listed
    fresh = count()
    known: dict[object, int] = {}  # numbers of copies
    values: dict[int, int] = {}  # by cell
    sent: dict[int, list[int]] = {}
    acts = 0  # places where faults may have changed

    def value(cell: int) -> int:
        return values.setdefault(cell, next(fresh))

    kept: list[Row] = []
    for row in listed:
        code, _, component, a, b, p, q, k = row
        if code == SET:
            now = [value(cell) for cell in inputs[component]]
            if sent.get(component) == now:
                continue
            sent[component] = now
        elif code in (STEP, STEP_ON):
            sent.pop(component, None)
        elif code == GET:
            values.update((cell, next(fresh)) for cell in outputs[component])
        elif code in (MOVE, PUSH):
            values[b] = value(a)
        elif code in (COPY, NUMBER, FIT):
            copy = code, value(a), k
            values[b] = known.setdefault(copy, next(fresh))
        elif code == FAULT:
            values[b] = known.setdefault((code, value(b), a, p, acts), next(fresh))
        elif code == PAUSE:
            acts += 1
            values.update((cell, next(fresh)) for cell in changed)
        elif code not in (PACE, RECORD, WATCH):
            values[b] = next(fresh)
            if code in (MEAN, LEDGER):
                values[q] = next(fresh)
        kept.append(row)
    return kept
