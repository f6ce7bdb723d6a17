"""The events of a system as C: when they are due, what they do to whom, and how components are brought to them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import lcm

import numpy as np

from ...errors import InputError
from ...loop.cells import CHANGED, GAIN, OFFSET_OR_VALUE, REPLACED, SEED, SIGMA, THRESHOLD, WATCH_CELLS
from ...plan.happening.events import EventRows
from ...plan.happening.scenario import from_start, spacing, stopped
from ...plan.happening.scenario_text import what
from ...plan.plan import Plan
from ...system.event import Event, Key
from .exchange import Names, indented
from .instants import Instants
from .names import comment, number, text, whole

MOST_PARTS = 64  # bits of a set of components
WAITING = 64  # events that may wait to act, beside those of known times
LONGEST = 2**53  # fine ticks: times are exact in doubles


def fine_ticks(plan: Plan) -> int:
    """How many fine ticks a tick of the clock has, so that all times of events are whole. Raises InputError."""
    tick = plan.clock.seconds(1)
    times = [t for e in plan.system.events for t in (e.at, e.after, e.lasting, e.until) if t is not None]
    fine = lcm(*((Fraction(t) / tick).denominator for t in times)) if times else 1
    last = fine * max([abs(plan.clock.start) + plan.clock.stop, *(abs(int(t / tick)) + 1 for t in times)])
    exact = max(last * plan.clock.numerator, plan.clock.denominator * fine) <= LONGEST
    if not exact or len(plan.system.components) > MOST_PARTS:
        raise InputError(
            f"the events of {plan.system.name} cannot be counted in C, at times that need ticks of "
            f"{plan.clock.seconds(1) / fine} s or for more than {MOST_PARTS} components; export it without [[events]]"
        )
    return fine


class Happening:
    """What a system with events has beside its cycle."""

    def __init__(self, names: Names, instants: Instants) -> None:
        self.names, self.plan, self.instants = names, names.plan, instants
        self.system, self.fine = names.system, fine_ticks(names.plan)

    def sizes(self) -> dict[str, object]:
        """Constants of the header."""
        clock, events = self.plan.clock, self.plan.system.events
        return {
            "EVENTS": len(events), "MOST_DUE": WAITING + 4 * sum(len(e.components) for e in events), "FINE": self.fine,
            "BREAKABLE": max(len(self._breakable()), 1), "FINE_NUMERATOR": whole(clock.numerator),
            "FINE_DENOMINATOR": whole(clock.denominator * self.fine),
        }  # fmt: skip

    def texts(self) -> list[str]:
        """The functions and tables, behind those of the cycle."""
        plan, name = self.plan, self.system
        bring = [self._rows(plan.at_events, ""), self._rows(plan.at_last_events, "last_")]
        parts = list(plan.system.components)
        kept = {"order": [parts.index(n) for n in plan.order], "rank": [sorted(parts).index(n) for n in parts]}
        kept["breakable"] = self._breakable() or [0]
        gaps = [
            0 if stopped(plan, n) else spacing(plan.clock, plan.algorithm, n) for n in parts
        ]  # 0: it is brought to the instant
        tables = [f"const int {name}_{key}[] = {{{', '.join(map(str, values))}}};" for key, values in kept.items()]
        tables += [
            f"const int64_t {name}_spacing[] = {{{', '.join(map(str, gaps))}}};",
            f"const int64_t {name}_periods[] = {{{', '.join(str(plan.clock.periods[n]) for n in parts)}}};",
            f"const uint64_t {name}_stopped = {self._set(n for n in parts if stopped(plan, n))};",
            f"const uint64_t {name}_early = {self._set(plan.early)};",
        ]
        return [*bring, "\n".join(tables), self._events(), self._first(), self._acts()]

    def _set(self, names: Iterable[str]) -> str:
        index = list(self.plan.system.components)
        return f"UINT64_C({sum(1 << index.index(name) for name in names)})"

    def _breakable(self) -> list[int]:
        broken = {key for event in self.plan.system.events if event.fault for key in event.fault.values}
        return sorted(self.plan.layout.inputs[key] for key in broken)

    # --- operations of events ---

    def _rows(self, rows: EventRows, which: str) -> str:
        """Functions that bring components to an event, and that pass values on there, with their tables."""
        texts = []
        bring = []
        for name in self.plan.system.components:
            if name not in rows.bring:
                bring.append("NULL")
                continue
            made = f"bring_{which}{len(bring) + 1}"
            bring.append(made)
            lines = self._formed(rows.form.get(name, {}))
            lines += self.instants.lines(rows.bring[name])
            texts.append(
                self._function(made, f"Brings {name} to an event from where its step began.", "int64_t at", lines)
            )
        together: list[str] = []
        for known, table in rows.after.items():
            made = f"pass_on_{which}{len(together) + 1}"
            together.append(f"    {{{self._set(known)}, {made}}},")
            words = f"Values among {', '.join(n for n in self.plan.system.components if n in known) or 'none'}."
            texts.append(self._function(made, words, "const int64_t *starts", self.instants.lines(table, "starts")))
        parameters = f"{self.system} *s, int64_t at"
        texts.append(f"static int (*const bring_{which or 'all'}[])({parameters}) = {{{', '.join(bring)}}};")
        texts.append("\n".join([f"static const Together together_{which or 'all'}[] = {{", *together, "};"]))
        place = f"{self.system}_at_{which}events"
        texts.append(
            f"const EventRows {place} = {{bring_{which or 'all'}, together_{which or 'all'}, {len(together)}}};"
        )
        return "\n\n".join(texts)

    def _formed(self, form: Mapping[int, np.ndarray]) -> list[str]:
        """Inputs that change between the samples of their sources, by where in the cycle the step began."""
        if not form:
            return []
        lines = ["switch (at - s->now.begin) {"]
        for start, rows in form.items():
            lines += [f"case {start}:", *indented(self.instants.lines(rows)), "    break;"]
        return [*lines, "}"]

    def _function(self, name: str, words: str, parameter: str, lines: list[str]) -> str:
        used = parameter.rpartition(" ")[2].lstrip("*")
        return "\n".join([
            f"/* {comment(words)} */", f"static int {name}({self.system} *s, {parameter}) {{",
            "    double *const z = s->now.z;", "    int64_t *const w = s->now.whole;",
            f"    (void)z, (void)w, (void){used};", *indented(lines), "    return 0;", "}",
        ])  # fmt: skip

    # --- what is stated of them ---

    def _time(self, time: Fraction | None) -> str:
        return "NEVER" if time is None else whole(int(Fraction(time) / self.plan.clock.seconds(1) * self.fine))

    def _events(self) -> str:
        plan, early = self.plan, from_start(self.plan.system)
        lines, tables = [], []
        for n, e in enumerate(plan.system.events):
            tables.append(
                f"static const int TOUCHED_{n}[] = {{{', '.join(self.names.parts[c] for c in e.components)}}};"
            )
            watch = "-1, 0, 0, 0, 0"
            if e.when is not None:
                signal = e.when.signal
                kind = plan.system.components[signal[0]].fmu.type_of(signal[1])
                real = kind is not None and kind.real
                cells = self.names.cells
                watch = f"{cells[plan.layout.watches[n]]}, {cells[plan.layout.outputs[signal]]}, "
                watch += f"{self.names.parts[signal[0]]}, "
                watch += f"{int(not real)}, {int(e.when.rising)}"
            at = e.at if e.at is not None and (e in early or e.at > plan.system.start or not e.initial) else None
            times = ", ".join([self._time(at), self._time(e.after), self._time(e.lasting), self._time(e.until)])
            lines.append(
                f"    {{{text(e.name)}, {times}, {int(e in early)}, {int(e.repeat)}, {watch}, "
                f"{len(e.components)}, TOUCHED_{n}}},"
            )
        return "\n".join([*tables, f"const Event {self.system}_events[] = {{", *lines, "};"])

    def _first(self) -> str:
        """Thresholds, and faults from the start on."""
        lines = []
        for n, watch in self.plan.layout.watches.items():
            crossing = self.plan.system.events[n].when
            assert crossing is not None
            lines.append(f"s->now.z[{self.names.cells[watch + THRESHOLD]}] = {number(crossing.threshold)};")
        early = from_start(self.plan.system)
        for n, event in enumerate(self.plan.system.events):
            if event.fault and event in early:
                for key in event.fault.values:
                    cell = self.names.cells[self.plan.layout.inputs[key]]
                    lines += self._begin_fault(n, event, key, f"s->now.whole[{cell}]")
        head = f"void {self.system}_first_events({self.system} *s) {{"
        words = "/* What is waited for, and faults that are there from the start. */"
        return "\n".join([words, head, "    (void)s;", *indented(lines), "}"])

    def _acts(self) -> str:
        """What events do to components."""
        plan, lines = self.plan, ["switch (event) {"]
        breakable = self._breakable()
        for n, event in enumerate(plan.system.events):
            lines.append(f"case {n}:")
            for name in event.components:
                lines.append(f"    /* {comment(event.name)}: {comment(what(plan.system, event, name))} */")
                lines.append(f"    if (part == {self.names.parts[name]}) {{")
                inside: list[str] = []
                for key in event.settings:
                    if key[0] == name:
                        inside.append(self._put(key, plan.layout.inputs[key], event.settings[key]))
                for key in event.fault.values if event.fault else ():
                    if key[0] == name:
                        held = f"s->now.held[{breakable.index(plan.layout.inputs[key])}]"
                        inside.append(f"if (ends) s->now.z[{self.names.cells[plan.layout.faults[n, key]]}] = 0.0;")
                        inside += ["else {", *indented(self._begin_fault(n, event, key, held)), "}"]
                lines += [*indented(inside, 2), "    }"]
            lines.append("    break;")
        head = f"void {self.system}_act({self.system} *s, int event, int part, int ends) {{"
        return "\n".join([head, "    (void)s, (void)event, (void)part, (void)ends;", *indented([*lines, "}"]), "}"])

    def _begin_fault(self, n: int, event: Event, key: Key, held: str) -> list[str]:
        fault = event.fault
        assert fault is not None
        first, value, cells = self.plan.layout.faults[n, key], fault.values[key], self.names.cells
        if fault.kind == "hold":
            lines = [f"s->now.whole[{cells[first + OFFSET_OR_VALUE]}] = {held};"]
        elif fault.kind == "loss":
            lines = [self._put(key, first + OFFSET_OR_VALUE, value)]
        else:
            assert value is not None and not isinstance(value, str | bytes)
            numbers = {"bias": (1.0, value, 0.0), "scale": (value, 0.0, 0.0), "noise": (1.0, 0.0, value)}[fault.kind]
            places = zip((GAIN, OFFSET_OR_VALUE, SIGMA), numbers, strict=True)
            lines = [f"s->now.z[{cells[first + k]}] = {number(float(v))};" for k, v in places]
            lines.append(f"s->now.whole[{cells[first + SEED]}] = {whole(fault.seed)};")
        return [*lines, f"s->now.z[{cells[first]}] = {number(float(REPLACED if fault.replaces else CHANGED))};"]

    def _put(self, key: Key, cell: int, value: object) -> str:
        assert isinstance(value, int | float)
        if self.names.memory.kind(key).real:
            return f"s->now.z[{self.names.cells[cell]}] = {number(float(value))};"
        return f"s->now.whole[{self.names.cells[cell]}] = {whole(int(value))};"


assert WATCH_CELLS == 3  # as `watch` of inside.h has them
