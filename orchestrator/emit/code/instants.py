"""The instants of a cycle as functions of C, alike ones once; and what each costs at most.

What is listed at an instant up to its rows ends the steps to it; behind them begin the steps from it. A host stops
between the two, so that what it sets there is seen by all that begins there.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field
from itertools import groupby, pairwise

import numpy as np

from ...clock import seconds_text
from ...loop.operations import (
    ESTIMATE,
    FAULT,
    GET,
    ITERATE,
    PAUSE,
    RECORD,
    REPEAT,
    SAMPLE,
    SERIES,
    SOLVE,
    STEP,
    STEP_ON,
)
from ...plan.schedule.operation_text import OperationText
from .beginning import CELLS
from .exchange import Names, indented
from .names import comment, number
from .operations.cost import Cost, Row, cost_of
from .operations.rows import Rows

JUMPS = (ITERATE, REPEAT, ESTIMATE)  # lead to the row of their column a


@dataclass
class Functions:
    """Functions of C, and the tables of instants that name them."""

    texts: list[str] = field(default_factory=list)
    known: dict[tuple[str, tuple[Row, ...], tuple[str, ...]], str] = field(default_factory=dict)
    costs: dict[str, Cost] = field(default_factory=dict)


@dataclass(frozen=True)
class Cycle:
    """The instants of a cycle: where each is [ticks], the function that begins steps there, that which ends them."""

    instants: tuple[tuple[int, str, str, str], ...]  # the first has nothing that ends, the last nothing that begins;
    # and the table of where steps begin that events before it find
    step: Cost  # of the dearest step from an instant to the next
    whole: Cost


class Instants:
    """Cycles as C."""

    def __init__(self, names: Names, rows: Rows) -> None:
        self.names, self.rows, self.plan = names, rows, names.plan
        self.found = Functions()
        self.text = OperationText(names.plan)
        self.solvers: list[str] = []  # tables of settings of loops
        self.starts: dict[tuple[int, ...], str] = {}  # tables of where steps begin, for events

    def cycle(self, operations: np.ndarray) -> Cycle:
        """The functions of a cycle's instants, made where they are not known."""
        if not self.plan.algorithm.one_pass:
            return self._macro(operations)
        listed: list[tuple[int, list[Row]]] = [
            (tick, [tuple(row) for row in rows])
            for tick, rows in groupby(operations.tolist(), key=lambda row: int(row[1]))
        ]
        if not listed or listed[0][0] != 0:
            listed.insert(0, (0, []))
        instants: list[tuple[int, str, str, str]] = []
        events = self.plan.at_events if operations is self.plan.cycle else self.plan.at_last_events
        self._behind, first = events.starts.behind, 0
        for tick, rows in listed:
            split = max((k for k, row in enumerate(rows) if row[0] == RECORD), default=len(rows) - 1) + 1
            split = split if tick else 0
            ends = self._function("end", rows[:split], tick, first) if tick else ""
            starts = self._starts(first, tick) if self.plan.system.events else ""
            instants.append((tick, self._function("begin", rows[split:], tick, first + split), ends, starts))
            first += len(rows)
        costs = self.found.costs | {"": Cost()}
        steps = [costs[here[1]] + costs[there[2]] for here, there in pairwise(instants)]
        dearest, whole = Cost(), Cost()
        for cost in steps:
            dearest, whole = dearest.most(cost), whole + cost
        return Cycle(tuple(instants), dearest, whole)

    def _macro(self, operations: np.ndarray) -> Cycle:
        """A macro step that is done as a whole."""
        rows: list[Row] = [tuple(row) for row in operations.tolist()]
        vary = self.plan.algorithm.steps_vary
        end = max((row[1] for row in rows), default=0)
        if not rows:
            return Cycle(((0, "", "", ""),), Cost(), Cost())
        lines, cost = self._body(rows, 0 if vary else end, {row[3] for row in rows if row[0] in JUMPS})
        again = [row for row in rows if row[0] == ITERATE]
        passes = sum(int(self.plan.coefficients[row[7] + 1]) * (row[6] + 1) for row in again) or 1
        name = f"{self.names.system}_macro_step" if vary else f"macro_step_{len(self.found.costs) + 1}"
        head = (
            f"int {name}({self.names.system} *s) {{"
            if vary
            else f"static int {name}({self.names.system} *s, int64_t at) {{"
        )
        first = ["    int64_t at = s->now.first + s->now.clock[NOW] + s->now.clock[OFFSET];"] if vary else []
        self.found.texts.append("\n".join([
            f"/* A macro step{' of the length that was chosen' if vary else ''}. */", head, *CELLS, *first,
            "    (void)at;", *indented(lines), "    return 0;", "}",
        ]))  # fmt: skip
        self.found.costs[name] = cost = cost.times(passes)
        return Cycle(((0, "", "", ""), (end, "", name, "")), cost, cost)

    def _starts(self, row: int, tick: int) -> str:
        """The table of where each component's first step begins that is not done before an operation, from here on."""
        key = tuple(start - tick for start in self._behind(row))
        return self.starts.setdefault(key, f"STARTS_{len(self.starts)}")

    def starts_tables(self) -> list[str]:
        """All of these tables."""
        return [f"static const int64_t {name}[] = {{{', '.join(map(str, k))}}};" for k, name in self.starts.items()]

    def lines(self, rows: np.ndarray, at: str = "at") -> list[str]:
        """Operations of an event as lines, as from time 0; `at`: where the steps begin to which faults belong."""
        self.rows.begins = at
        lines, _ = self._body([tuple(row) for row in rows.tolist()], 0)
        self.rows.begins = "at"
        return lines

    def _function(self, what: str, rows: list[Row], tick: int, first: int) -> str:
        """The name of the function that does these rows, of which `first` is the number of the first one; empty where
        there are none."""
        if not rows:
            return ""
        pauses = [self._starts(first + k, tick) for k, row in enumerate(rows) if row[0] == PAUSE]
        self.rows.pauses = iter(pauses)
        key = what, tuple(_from_here(row, tick) for row in rows), tuple(pauses)
        if key in self.found.known:
            return self.found.known[key]
        name = f"{what}_{sum(known.startswith(f'{what}_') for known in self.found.known.values()) + 1}"
        self.found.known[key] = name
        lines, cost = self._body(rows, tick)
        there = seconds_text(self.plan.clock.seconds(tick))
        words = "What ends" if what == "end" else "What begins"
        self.found.texts.append("\n".join([
            f"/* {words} at an instant, as {there} behind the beginning of a cycle. */",
            f"static int {name}({self.names.system} *s, int64_t at) {{",
            *CELLS, "    (void)at;", *indented(lines), "    return 0;", "}",
        ]))  # fmt: skip
        self.found.costs[name] = cost
        return name

    def _body(self, rows: list[Row], tick: int, labels: Collection[int] = ()) -> tuple[list[str], Cost]:
        """The lines of rows; those that a loop repeats stand in one. `labels`: rows to which others lead."""
        again = {k - row[3]: (k, row) for k, row in enumerate(rows) if row[0] == SOLVE}
        lines: list[str] = []
        cost, k = Cost(), 0
        while k < len(rows):
            if k in labels:
                lines.append(f"row_{k}:;")
            if k in again:
                end, solve = again[k]
                inside, once = self._body(rows[k:end], tick)
                more, passes = self._solve(solve)
                lines += ["for (int again = 1; again;) {", *indented([*inside, *more]), "}"]
                cost, k = cost + once.times(passes) + Cost(passes * (20 * solve[6] + solve[6] ** 3)), end + 1
                continue
            said = " ".join(self.text.text(list(rows[k])).split(None, 1)[1:])
            made = self.rows.lines(rows[k], tick)
            if rows[k][0] in (STEP, STEP_ON, GET, SOLVE):
                lines.append("")
            if made:
                lines += [f"/* {comment(said.strip())} */", *made]
            cost, k = cost + cost_of(self.names, rows[k]), k + 1
        return lines, cost

    def _solve(self, row: Row) -> tuple[list[str], int]:
        """Newton on a loop: whether its rows are done again, and how often at most."""
        _, _, memory, _, unknowns, images, n, k = row
        settings = self.plan.coefficients[k : k + 3 + n].tolist()
        table = f"SOLVER_{len(self.solvers)}"
        self.solvers.append(f"static const double {table}[] = {{{', '.join(map(number, settings))}}};")
        u, g = self.names.cells[unknowns], self.names.cells[images]
        lines = [
            f"again = iterate(z, {u}, {g}, {n}, {table}, s->now.solver + {memory});",
            f"if (again < 0) return not_converged(s, {u});",
        ]
        return lines, int(settings[1]) * (n + 1)


def _from_here(row: Row, tick: int) -> Row:
    """A row with its times from its instant on."""
    code, _, c, a, b, p, q, k = row
    if code in (STEP, STEP_ON):
        b -= tick
    if code in (SERIES, SAMPLE, FAULT):
        p -= tick
    return (code, 0, c, a, b, p, q, k)
