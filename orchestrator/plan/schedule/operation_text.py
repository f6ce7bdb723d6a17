"""Operations as text."""

from __future__ import annotations

from collections import Counter

from ...clock import seconds_text
from ...errors import counted
from ...fmu.fmu import Fmu
from ...loop.operations import (
    ACCUMULATE,
    ACCUMULATE_ON,
    ADVANCE,
    AS_IT_BEGINS,
    AT_AN_INSTANT,
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
    LINEAR,
    MIX,
    MOVE,
    NAMES,
    NUMBER,
    PACE,
    PAUSE,
    PUSH,
    QUADRATIC,
    RECORD,
    REPEAT,
    RESTORE,
    REWIND,
    RISE,
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
from ..plan import Plan
from .layout import by_component

SHOWN = 6  # names of variables in one line, at most


class OperationText:
    """What every operation of a plan does, with the names of its signals."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        layout = plan.layout
        self.components = list(plan.system.components)
        self.inputs, self.outputs = (by_component(layout.by_the_loop(t)) for t in (layout.inputs, layout.outputs))
        self.slots = {slot: ".".join(key) for table in (layout.outputs, layout.inputs) for key, slot in table.items()}
        for foreign in (layout.foreign_inputs, layout.foreign_outputs):
            for (name, variable), slot in foreign.items():
                fmu = plan.system.components[name].fmu
                self.slots[slot] = f"'{fmu.own_name(variable)}' of {fmu.path.name}"
        for words, table in (
            ("previous", layout.previous),
            ("twice previous", layout.before),
            ("integral for", layout.integrals),
            ("integral, in this step, for", layout.part_integrals),
            ("the planned", layout.samples),
            ("the last", layout.parts),
        ):
            self.slots |= {slot: f"{words} {'.'.join(key)}" for key, slot in table.items()}
        self.slots |= {slot: f"{'.'.join(key)} at the beginning" for key, slot in layout.begins.items()}
        self.slots |= {extra.slot: ".".join(key) for key, extra in layout.extras.items()}
        self.slots |= layout.named

    def text(self, row: list[int]) -> str:
        """One operation in one line."""
        code, _, component, *_ = row
        name = self.components[component] if component >= 0 and code != SOLVE else ""
        describe = self._exchange if code in (SET, STEP, STEP_ON, GET, SAVE, RESTORE) else self._signal
        if code in (WATCH, FAULT):
            return f"{NAMES[code]:<10}  {self._event(row)}"
        if code == PACE:
            waits = "wait until the clock on the wall is there"
            return f"{NAMES[code]:<10}  {f'how long the step of {name} took' if name else waits}"
        if code in (RECORD, REWIND, ITERATE, REPEAT, GAUGE, CONTROL, HALVE, ADVANCE, ESTIMATE, SOLVE, PAUSE):
            return f"{NAMES[code]:<10}  {self._flow(row)}"
        return f"{NAMES[code]:<10}  {describe(row, name)}"

    def _exchange(self, row: list[int], name: str) -> str:
        """What passes between the loop and an FMU."""
        code, _, component, a, b, *_ = row
        clock = self.plan.clock
        if code == STEP_ON:
            end = seconds_text(clock.seconds(a + b))
            return f"{name} from where it is to {end}, or to an event before"
        if code == STEP:
            if self.plan.adaptive:
                return f"{name} by the macro step"
            return f"{name} from {seconds_text(clock.seconds(b)) if b else '0 s'} by {seconds_text(clock.seconds(a))}"
        if code in (SAVE, RESTORE):
            return f"the state of {name}" if component >= 0 else counted(a, "signal")
        table = (self.inputs if code == SET else self.outputs).get(name, {})
        again = f" as its step begins: {self.plan.rereads[name]}" if code == GET and a == AS_IT_BEGINS else ""
        again += " again, as they are with the inputs of this instant" if code == GET and a == AT_AN_INSTANT else ""
        return f"{name}: {_types(self.plan.system.components[name].fmu, [variable for _, variable in table])}{again}"

    def _event(self, row: list[int]) -> str:
        """What is done for events."""
        code, _, _, a, b, *_ = row
        events, layout = self.plan.system.events, self.plan.layout
        if code == WATCH:
            number = next(number for number, cell in layout.watches.items() if cell == b)
            crossing = events[number].when
            return f"{self.slots[a]} for {events[number].name}: {crossing.text if crossing else ''}"
        number = next(number for (number, _), cell in layout.faults.items() if cell == a)
        fault = events[number].fault
        return f"{self.slots[b]} by {events[number].name}, as long as it lasts: {fault.kind if fault else ''}"

    def _flow(self, row: list[int]) -> str:
        """What decides how the list goes on, and what is recorded."""
        code, _, _, a, b, p, q, k = row
        c, s = self.plan.coefficients, self.slots
        if code in (RECORD, REWIND):
            group = self.plan.groups[a]
            what = f"{counted(len(group.columns), 'signal')} of {', '.join(group.components)}"
            return what if code == RECORD else f"the last {counted(b, 'row')} of the {what}"
        if code == REPEAT:
            return f"from operation {a + 1} on"
        if code == ITERATE:
            unknowns = f"{counted(q, 'unknown')} {'is' if q == 1 else 'are'} consistent"
            return f"go to operation {a + 1} if {unknowns} within {c[k]:g}, at most {c[k + 1]:g} times"
        if code == SOLVE:
            again = f"otherwise the last {counted(a, 'operation')} again"
            return f"{self.plan.layout.loops[row[2]]} within {c[k]:g}, {again}, at most {c[k + 1]:g} times"
        if code == PAUSE:
            return "for what happens at this instant, if anything does, then the list goes on"
        if code == HALVE:
            return "the macro step, to do it again as two"
        if code == ADVANCE:
            return "to the middle of the macro step"
        if code == ESTIMATE:
            return (
                f"{s[b]}, {s[b + 1]}, {s[b + 2]}, {s[b + 3]}: move the clock on and go to operation {a + 1} if {q} "
                f"signals of one step and of two agree within {c[k]:g}; otherwise go back and take a shorter step"
            )
        if code == GAUGE:
            return f"{s[b]} times {s[p]} against {s[q]} times {s[a]}, tolerance {c[k]:g} J plus {c[k + 1]:g} of it"
        return f"{s[a]}, {s[a + 1]}, {s[a + 2]}: move the clock on and choose the next step"

    def _signal(self, row: list[int], _: str) -> str:
        """Arithmetic on signals."""
        code, _tick, _component, a, b, p, q, k = row
        c, s = self.plan.coefficients, self.slots
        if code in (SERIES, SAMPLE):
            return self._table(row)
        if code in (MOVE, PUSH):
            return f"{s[b]} = {s[a]}"
        if code == ACCUMULATE:
            return f"{s[b]} += {c[k]:g} ({s[p]} + {s[a]})"
        if code == RISE:
            return f"{s[b]} += {c[k]:g} ({s[a]} - {s[p]})"
        if code == ACCUMULATE_ON:
            return f"{s[b]} += {c[k]:g} ({s[p]} + {s[a]}) times the step"
        if code == WORK_ON:
            return f"{s[b]} += {s[q]} ({c[k]:g} {s[p]} + {c[k + 1]:g} {s[a]}) times the step"
        if code == LEDGER:
            return f"{s[q]} = {s[a]} - {s[p]}; {s[b]} = its rise"
        if code == WORK:
            h = "the macro step" if c[k + 2] == 0.0 else f"{c[k + 2]:g}"
            return f"{s[b]} += {s[q]} ({c[k]:g} {s[p]} + {c[k + 1]:g} {s[a]}) {h}"
        if code == MIX:
            begin = f"{c[k + 3]:g}" if c[k] == 0.0 else s[b]
            return f"{s[b]} = {begin} + {c[k + 1]:g} {s[a]} + {c[k + 2]:g} {s[p]}"
        gain = "" if (c[k], c[k + 1]) == (1.0, 0.0) else f" (times {c[k]:g} plus {c[k + 1]:g})"
        if code in (COPY, NUMBER):
            return f"{s[b]} = {s[a]}{gain}"
        if code == FIT:
            return f"{s[b]} = {'the whole number nearest to ' * p}{s[a]}{gain}, which its type must hold"
        if code == LINEAR:
            return f"{s[b]} = {s[a]} + {c[k + 2]:g} ({s[a]} - {s[p]}){gain}"
        if code == QUADRATIC:
            return f"{s[b]} = {s[a]} + {c[k + 2]:g} ({s[a]} - {s[p]}) + {c[k + 3]:g} ({s[a]} - 2 {s[p]} + {s[q]}){gain}"
        tail = "" if (c[k + 2], c[k + 3]) == (0.0, 0.0) else f" + {c[k + 2]:g} {s[a]} + {c[k + 3]:g} {s[p]}"
        return f"{s[b]} = {s[q]}{tail}{gain}, begin a new integral"

    def _table(self, row: list[int]) -> str:
        """An input that follows a table."""
        code, _, _, _, b, start, length, _ = row
        name, _, variable = self.slots[b].partition(".")
        origin, seconds = self.plan.system.components[name].series[variable].origin, self.plan.clock.seconds
        begin = seconds_text(seconds(start)) if start else "0 s"
        if code == SAMPLE:
            return f"{self.slots[b]} = {origin} at {'the beginning' if self.plan.adaptive else begin}"
        span = "the macro step" if self.plan.adaptive else f"{begin} by {seconds_text(seconds(length))}"
        return f"{self.slots[b]} = mean of {origin} over {span}"


def _types(fmu: Fmu, variables: list[str]) -> str:
    """`u, v`, or of many `u, v, w and 9 more`; where not all are floating point behind `2 Real, 1 Boolean: `."""
    kinds = [kind for kind in map(fmu.type_of, variables) if kind is not None]
    names = ", ".join(variables if len(variables) <= SHOWN else variables[: SHOWN - 1])
    if len(variables) > SHOWN:
        names += f" and {len(variables) - SHOWN + 1} more"
    if all(kind.real for kind in kinds):
        return names or "nothing"
    return f"{', '.join(f'{n} {name}' for name, n in Counter(kind.name for kind in kinds).items())}: {names}"
