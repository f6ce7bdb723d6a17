"""The operations that a plan is made of: their codes, names and columns, as rows of whole numbers."""

from __future__ import annotations

COPY, LINEAR, MEAN, SET, STEP, GET, PUSH, ACCUMULATE, RECORD, MOVE = range(10)
NAMES = ("copy", "linear", "mean", "set", "step", "get", "push", "accumulate", "record", "move")
COLUMNS = ("code", "tick", "component", "a", "b", "p", "q", "k")
