"""One operation of a plan as lines of C: the same arithmetic in the same order as `loop/run.py`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ....loop.formulas import FORMULAS
from ....loop.operations import (
    ACCUMULATE_ON,
    AT_AN_INSTANT,
    FAULT,
    GET,
    MOVE,
    PAUSE,
    PUSH,
    RECORD,
    SET,
    SOLVE,
    STEP,
    STEP_ON,
    WATCH,
    WORK,
    WORK_ON,
)
from ..exchange import Names, indented
from ..names import at, number, whole
from .cost import Row
from .formulas import in_c
from .lookups import Lookups
from .repeated import Repeated

HOW = {
    SET: "_set", GET: "_get", STEP: "_step", RECORD: "_record", **dict.fromkeys(FORMULAS, "_sum"), STEP_ON: "_step_on",
    **dict.fromkeys((ACCUMULATE_ON, WORK_ON), "_on"), WATCH: "_watch", FAULT: "_fault", PAUSE: "_pause",
}  # fmt: skip
WRITTEN = frozenset({*HOW, *Lookups.HOW, *Repeated.HOW, SOLVE})  # loops of direct dependence around others


class Rows:
    """Rows of a plan as C. `at` is the instant [ticks from time 0]; rows know how far they are from it."""

    def __init__(self, names: Names) -> None:
        self.names, self.plan = names, names.plan
        self.begins = "at"  # where steps begin to which faults belong: here, or by a table of all components
        self.vary = self.plan.algorithm.steps_vary
        self.step = " + s->now.clock[STEP_TICKS]" if self.vary else ""  # what is added to a length
        self.final = "0" if self.plan.algorithm.saves_states else "s->final"
        self.lookups, self.repeated = Lookups(names, self.step), Repeated(names)
        self.pauses: Iterator[str] = iter(())  # tables of where steps begin, of the pauses to come

    def lines(self, row: Row, tick: int) -> list[str]:
        """The lines of an operation that is listed at `tick`."""
        writers: tuple[tuple[object, Mapping[int, str]], ...] = (
            (self, HOW), (self.lookups, Lookups.HOW), (self.repeated, Repeated.HOW),
        )  # fmt: skip
        writer, how = next((writer, how[row[0]]) for writer, how in writers if row[0] in how)
        made: list[str] = getattr(writer, how)(row, tick)
        return made

    def constants(self) -> list[str]:
        """The tables that rows look into."""
        return [*self.lookups.constants(), *self.repeated.settings]

    # --- FMUs ---

    def _set(self, row: Row, _tick: int) -> list[str]:
        name = self.names.components[row[2]]
        return [line for block in self.names.given(name) for line in self.names.set_block(name, block)]

    def _get(self, row: Row, _tick: int) -> list[str]:
        name = self.names.components[row[2]]
        blocks = self.names.taken(name, row[3] == AT_AN_INSTANT)
        return [line for block in blocks for line in self.names.get_block(name, block)]

    def _step(self, row: Row, tick: int) -> list[str]:
        _, _, component, a, b, *_ = row
        name = self.names.components[component]
        begin = [
            f"const double t = seconds({at(b - tick)});",
            f"const double h = length_of(s, t, seconds({a}{self.step}));",
        ]
        return ["{", *indented([*begin, *self._do_step(name)]), "}"]

    def _do_step(self, name: str) -> list[str]:
        """The step of a component from `t` over `h`."""
        if self.names.units[name].version == 2:
            return [self.names.call(name, "make a step", "DoStep", f"t, h, {self.final}")]
        arguments = f"t, h, {self.final} != 0, &event, &end, &early, &last"
        return [
            "fmi3Boolean event = 0, end = 0, early = 0;", "fmi3Float64 last = t;",
            self.names.call(name, "make a step", "DoStep", arguments),
            f"if (end || early || event) return asks(s, {self.names.parts[name]}, end, early);",
        ]  # fmt: skip

    def _step_on(self, row: Row, tick: int) -> list[str]:
        _, _, component, a, b, *_ = row
        name = self.names.components[component]
        part = self.names.parts[name]
        lines = [
            f"double t = seconds({at(b - tick)}), h = seconds({a}), until = seconds({at(b + a - tick)});",
            f"if (part_of_step(s, {part}, &t, &h, &until)) {{", *indented(self._do_step(name)),
            f"    s->now.reached[{part}] = until;", "}",
        ]  # fmt: skip
        return ["{", *indented(lines), "}"]

    # --- events ---

    def _pause(self, row: Row, _tick: int) -> list[str]:
        if not self.plan.system.events:
            return []
        return [f"if (at >= s->now.event_at && paused(s, at, {next(self.pauses)})) return 1;"]

    def _watch(self, row: Row, _tick: int) -> list[str]:
        _, _, _, a, b, p, q, _ = row
        value = f"(double)w[{self.names.cells[a]}]" if p else f"z[{self.names.cells[a]}]"
        return [f"watch(s, {value}, {self.names.cells[b]}, {int(q)});"]

    def _fault(self, row: Row, tick: int) -> list[str]:
        _, _, component, a, b, p, q, _ = row
        begins = "at" if self.begins == "at" else f"starts[{self.names.parts[self.names.components[component]]}]"
        counter = f"{begins} + {p - tick}" if p != tick else begins
        return [f"fault(s, {self.names.cells[a]}, {self.names.cells[b]}, {whole(q)}, {counter});"]

    def _on(self, row: Row, _tick: int) -> list[str]:
        code, _, component, a, b, p, q, k = row
        part = self.names.parts[self.names.components[component]]
        c = [number(value) for value in self.plan.coefficients[k : k + 2].tolist()]
        za, zb, zp, zq = (f"z[{self.names.cells[slot]}]" for slot in (a, b, p, q))
        h = f"(s->now.reached[{part}] - s->now.began[{part}])"
        if code == ACCUMULATE_ON:
            return [f"{zb} += {c[0]} * {h} * ({zp} + {za});"]
        return [f"{zb} += {zq} * ({c[0]} * {zp} + {c[1]} * {za}) * {h};"]

    def _record(self, row: Row, tick: int) -> list[str]:
        here = "s->now.first + s->now.clock[NOW]" if self.vary else at(row[1] - tick)
        return [f"if (s->record) s->record(s->user, s, {row[3]}, {here});"]

    # --- cells ---

    def _sum(self, row: Row, _tick: int) -> list[str]:
        """Arithmetic on cells, by its formula."""
        code, _, _, a, b, p, q, k = row
        slots = {"a": a, "b": b, "p": p, "q": q}
        c = {j: number(value) for j, value in enumerate(self.plan.coefficients[k : k + 4].tolist())}
        if code == WORK and self.vary and self.plan.coefficients[k + 2] == 0.0:
            c[2] = "seconds(s->now.clock[STEP_TICKS])"
        n = f"(double){'(uint64_t)' if p else ''}w[{self.names.cells[a]}]"
        cell = self.names.cell if code in (MOVE, PUSH) else lambda slot: f"z[{self.names.cells[slot]}]"
        return in_c(code, lambda column: cell(slots[column]), c, n)
