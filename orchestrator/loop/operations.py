"""The operations that a plan is made of: their codes, names and columns, as rows of whole numbers."""

from __future__ import annotations

COPY, LINEAR, MEAN, SET, STEP, GET, PUSH, ACCUMULATE, RECORD, MOVE = range(10)
QUADRATIC, MIX, WORK, LEDGER, SAVE, RESTORE, REWIND, ITERATE, REPEAT, GAUGE, CONTROL = range(10, 21)
SERIES, SAMPLE, HALVE, ADVANCE, ESTIMATE, SOLVE, NUMBER, FIT = range(21, 29)
STEP_ON, PAUSE, ACCUMULATE_ON, WORK_ON = range(29, 33)
WATCH, FAULT, RISE, PACE = range(33, 37)
MOVES, TURNS, SEGMENT = range(37, 40)  # of no plan: what several become, see `plan/speed/fused.py` and `loop/straight/`
NAMES = (
    *("copy", "linear", "mean", "set", "step", "get", "push", "accumulate", "record", "move"),
    *("quadratic", "mix", "work", "ledger", "save", "restore", "rewind", "iterate", "repeat", "gauge", "control"),
    *("series", "sample", "halve", "advance", "estimate", "solve", "number", "fit"),
    *("step on", "pause", "accumulate", "work"),
    *("watch", "fault", "rise", "pace"),
    *("moves", "turns", "segment"),
)
COLUMNS = ("code", "tick", "component", "a", "b", "p", "q", "k")
AT_ITS_END, AS_IT_BEGINS, AT_AN_INSTANT = range(3)  # column a of GET: when outputs are read; again: at an instant
