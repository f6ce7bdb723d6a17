"""One operation of a plan as lines of C, and what it costs: the same arithmetic in the same order as `loop/run.py`."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil, log2

from ...loop.formulas import FORMULAS, arithmetic
from ...loop.operations import (
    ACCUMULATE_ON,
    ADVANCE,
    AT_AN_INSTANT,
    CONTROL,
    ESTIMATE,
    FAULT,
    FIT,
    GAUGE,
    GET,
    HALVE,
    ITERATE,
    MOVE,
    NUMBER,
    PAUSE,
    PUSH,
    RECORD,
    REPEAT,
    RESTORE,
    REWIND,
    SAMPLE,
    SAVE,
    SERIES,
    SET,
    SOLVE,
    STEP,
    STEP_ON,
    WATCH,
    WORK,
    WORK_ON,
)
from .exchange import Names, indented
from .formulas import in_c
from .names import number, whole

Row = tuple[int, ...]
HOW = {
    **dict.fromkeys((SAVE, RESTORE), "_state"),
    REWIND: "_rewind",
    ITERATE: "_iterate",
    REPEAT: "_repeat",
    GAUGE: "_gauge",
    CONTROL: "_control",
    HALVE: "_halve",
    ADVANCE: "_advance",
    ESTIMATE: "_estimate",
    SET: "_set",
    GET: "_get",
    STEP: "_step",
    RECORD: "_record",
    FIT: "_fit",
    SERIES: "_series",
    SAMPLE: "_sample",
    **dict.fromkeys(FORMULAS, "_sum"),
    STEP_ON: "_step_on",
    **dict.fromkeys((ACCUMULATE_ON, WORK_ON), "_on"),
    WATCH: "_watch",
    FAULT: "_fault",
    PAUSE: "_pause",
}  # operations, and what writes them
WRITTEN = frozenset({*HOW, SOLVE})  # loops of direct dependence around others


@dataclass(frozen=True)
class Cost:
    """At most so many: operations on floating-point numbers, calls of FMI functions, cells that are moved."""

    arithmetic: int = 0
    calls: int = 0
    moves: int = 0

    def __add__(self, other: Cost) -> Cost:
        return Cost(self.arithmetic + other.arithmetic, self.calls + other.calls, self.moves + other.moves)

    def times(self, factor: int) -> Cost:
        """As often as that."""
        return Cost(self.arithmetic * factor, self.calls * factor, self.moves * factor)

    def most(self, other: Cost) -> Cost:
        """What is enough for either."""
        return Cost(max(self.arithmetic, other.arithmetic), max(self.calls, other.calls), max(self.moves, other.moves))


class Rows:
    """Rows of a plan as C. `at` is the instant [ticks from time 0]; rows know how far they are from it."""

    def __init__(self, names: Names) -> None:
        self.names, self.plan = names, names.plan
        self.tables: dict[int, str] = {}  # where a table lies in the coefficients, and its name in C
        self.items: dict[tuple[int, ...], str] = {}
        self.begins = "at"  # where steps begin to which faults belong: here, or by a table of all components
        self.settings: list[str] = []  # tables of settings of macro steps
        self.vary = self.plan.algorithm.steps_vary
        self.step = " + s->now.clock[STEP_TICKS]" if self.vary else ""  # what is added to a length
        self.final = "0" if self.plan.algorithm.saves_states else "s->final"
        self.pauses: Iterator[str] = iter(())  # tables of where steps begin, of the pauses to come

    def lines(self, row: Row, tick: int) -> list[str]:
        """The lines of an operation that is listed at `tick`."""
        made: list[str] = getattr(self, HOW[row[0]])(row, tick)
        return made

    def cost(self, row: Row) -> Cost:
        """What an operation costs at most."""
        code, _, component, a, _, _, q, k = row
        if code in (SET, GET):
            name = self.names.components[component]
            blocks = self.names.given(name) if code == SET else self.names.taken(name, a == AT_AN_INSTANT)
            return Cost(0, len(blocks), sum(block.size for block in blocks))
        if code in (STEP, STEP_ON):
            return Cost(8, 1)
        if code in (SAVE, RESTORE):
            return Cost(0, int(component >= 0), a if component < 0 else 0)
        if code in (GAUGE, CONTROL, ITERATE, ESTIMATE):
            return Cost({GAUGE: 12, CONTROL: 200, ITERATE: 12 * q, ESTIMATE: 200 + 6 * q}[code])
        if code in (RECORD, PAUSE, REWIND, REPEAT, HALVE, ADVANCE):
            return Cost()  # of the program, and of events, not of the system
        if code in (SERIES, SAMPLE):
            rows = int(self.plan.coefficients[k])
            return Cost(2 * ceil(log2(rows + 1)) + (8 * rows + 16) * (code == SERIES), 0, 1)
        if code in FORMULAS:
            return Cost(arithmetic(code) + (code == NUMBER), 0, 1)
        return Cost({FIT: 5 + 2 * q, ACCUMULATE_ON: 5, WORK_ON: 6, WATCH: 2, FAULT: 40}[code], 0, 1)

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
            f"const double t = seconds({_at(b - tick)});",
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
            f"double t = seconds({_at(b - tick)}), h = seconds({a}), until = seconds({_at(b + a - tick)});",
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
        at = "s->now.first + s->now.clock[NOW]" if self.vary else _at(row[1] - tick)
        return [f"if (s->record) s->record(s->user, s, {row[3]}, {at});"]

    # --- macro steps that are repeated or vary ---

    def _state(self, row: Row, _tick: int) -> list[str]:
        code, _, component, a, *_ = row
        if component < 0:
            to, what = ("s->saved", "z") if code == SAVE else ("z", "s->saved")
            return [f"memcpy({to}, {what}, {a} * sizeof *z);"]
        part = self.names.parts[self.names.components[component]]
        return [f"if ({'keep' if code == SAVE else 'go_back'}(s, {part})) return 1;"]

    def _rewind(self, row: Row, _tick: int) -> list[str]:
        return [f"if (s->rewind) s->rewind(s->user, {row[3]}, {row[4]});"]

    def _repeat(self, row: Row, _tick: int) -> list[str]:
        return [f"goto row_{row[3]};"]

    def _iterate(self, row: Row, _tick: int) -> list[str]:
        _, _, _, a, b, p, q, k = row
        lines = [
            f"const int verdict = iterate(z, {b}, {p}, {q}, {self._setting(k, 3 + q)}, s->now.work);",
            f"if (verdict < 0) return not_converged(s, {b} + (int)s->now.work[3]);", f"if (!verdict) goto row_{a};",
        ]  # fmt: skip
        return ["{", *indented(lines), "}"]

    def _gauge(self, row: Row, _tick: int) -> list[str]:
        _, _, _, a, b, p, q, k = row
        cells = ", ".join(self.names.cells[slot] for slot in (a, b, p, q))
        return [f"gauge(s, {cells}, {self._setting(k, 2)});"]

    def _control(self, row: Row, _tick: int) -> list[str]:
        a, k = row[3], row[7]
        now, step, found = (f"z[{self.names.cells[a + j]}]" for j in range(3))
        return [
            f"{step} = seconds(s->now.clock[STEP_TICKS]);", f"{found} = choose_step(s, {self._setting(k, 5)});",
            f"{now} = (double)s->now.clock[NOW];",
        ]  # fmt: skip

    def _halve(self, _row: Row, _tick: int) -> list[str]:
        return ["s->now.clock[STEP_TICKS] /= 2;"]

    def _advance(self, _row: Row, _tick: int) -> list[str]:
        return [
            "s->now.clock[OFFSET] = s->now.clock[STEP_TICKS];",
            "at = s->now.first + s->now.clock[NOW] + s->now.clock[OFFSET];",
        ]

    def _estimate(self, row: Row, _tick: int) -> list[str]:
        _, _, _, a, b, p, q, k = row
        now, step, found, rejected = (f"z[{self.names.cells[b + j]}]" for j in range(4))
        lines = [
            f"{step} = seconds(2 * s->now.clock[STEP_TICKS]);",
            f"const int verdict = estimate(s, {p}, {q}, {self._setting(k, 5 + q)});", "if (verdict < 0) return 1;",
            "if (verdict == 0) {",
            f"    {now} = (double)s->now.clock[NOW], {found} = s->now.work[0], {rejected} = s->now.work[2];",
            "    s->now.work[2] = 0.0;", f"    goto row_{a};", "}", "at = s->now.first + s->now.clock[NOW];",
        ]  # fmt: skip
        return ["{", *indented(lines), "}"]

    def _setting(self, k: int, count: int) -> str:
        """The name of a table of settings."""
        values = ", ".join(number(value) for value in self.plan.coefficients[k : k + count].tolist())
        self.settings.append(f"static const double STEPS_{len(self.settings)}[] = {{{values}}};")
        return f"STEPS_{len(self.settings) - 1}"

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

    def _fit(self, row: Row, _tick: int) -> list[str]:
        _, _, _, a, b, p, q, k = row
        c = self.plan.coefficients[k : k + 4 + 2 * q].tolist()
        source = self.names.cells[a]
        value = f"rint({number(c[0])} * z[{source}] + {number(c[1])})" if p else f"(double)w[{source}]"
        cell = "n >= 0x1p63 ? (int64_t)(n - 0x1p64) : (int64_t)n" if p else f"w[{source}]"
        lines = [f"const double n = {value};",
                 f"if (!({number(c[2])} <= n && n < {number(c[3])})) return unfit(s, {self.names.cells[b]});",
                 f"const int64_t found = {cell};"]  # fmt: skip
        if q:
            items = tuple((int(c[4 + 2 * j]) << 32) | int(c[5 + 2 * j]) for j in range(q))
            name = self.items.setdefault(items, f"ITEMS_{len(self.items)}")
            lines.append(f"if (!among(found, {name}, {q})) return unfit(s, {self.names.cells[b]});")
        return ["{", *indented([*lines, f"w[{self.names.cells[b]}] = found;"]), "}"]

    def _series(self, row: Row, tick: int) -> list[str]:
        _, _, _, _, b, p, q, k = row
        begin, end = f"seconds({_at(p - tick)})", f"seconds({_at(p + q - tick)}{self.step})"
        return [f"z[{self.names.cells[b]}] = mean_over({self._table(k)}, {begin}, {end});"]

    def _sample(self, row: Row, tick: int) -> list[str]:
        _, _, _, _, b, p, _, k = row
        found = f"held_at({self._table(k)}, seconds({_at(p - tick)}))"
        if self.names.whole[b]:
            return [
                "{",
                f"    const double found = {found};",
                f"    memcpy(&w[{self.names.cells[b]}], &found, 8);",
                "}",
            ]
        return [f"z[{self.names.cells[b]}] = {found};"]

    def _table(self, k: int) -> str:
        return self.tables.setdefault(k, f"TABLE_{len(self.tables)}")

    def constants(self) -> list[str]:
        """The tables that rows look into."""
        c = self.plan.coefficients
        lines = [
            f"static const double {name}[] = {{{', '.join(_bits(v) for v in c[k : k + 1 + 2 * int(c[k])])}}};"
            for k, name in self.tables.items()
        ]
        lines += self.settings
        lines += [
            f"static const int64_t {name}[] = {{{', '.join(map(whole, items))}}};" for items, name in self.items.items()
        ]
        return lines


def _bits(value: float) -> str:
    return number(float(value))


def _at(ticks: int) -> str:
    return "at" if ticks == 0 else f"at {'+' if ticks > 0 else '-'} {abs(ticks)}"
