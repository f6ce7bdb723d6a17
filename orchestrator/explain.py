"""A plan as text: whatever the executor does can be read here first."""

from __future__ import annotations

from collections import Counter

from .capabilities import remarks
from .clock import seconds_text
from .fmu import Fmu
from .operations import ACCUMULATE, COPY, GET, LINEAR, MEAN, MOVE, NAMES, PUSH, RECORD, SET, STEP
from .plan import Plan


def explain(plan: Plan, operations: int | None = None) -> str:
    """Components, connections with their transfers and reasons, order, and the operations of one hyperperiod.

    `operations` limits how many operations are shown (None: all).
    """
    system, clock = plan.system, plan.clock
    tick, again = seconds_text(clock.seconds(1)), seconds_text(clock.seconds(clock.hyperperiod))
    lines = [
        f"system {system.name}: {system.description}",
        f"stop {seconds_text(system.stop)}; tick {tick}; the schedule repeats every {again}",
        f"algorithm {system.algorithm}; order {', '.join(plan.order)} ({plan.order_reason})",
        "", "components",
    ]  # fmt: skip
    for name in plan.order:
        component = system.components[name]
        lines.append(
            f"  {name:<12} every {seconds_text(component.period):<8} {component.fmu.path.name}, "
            f"FMI {component.fmu.description.fmiVersion}, sha256 {component.fmu.digest[:12]}{remarks(component)}"
        )
    for name in plan.order:
        lines += [f"  {note}" for note in system.components[name].notes]
    for name in plan.samplers:
        lines.append(f"  {name} samples: its step is done at its beginning, its outputs are in force from then on")
    lines += ["", "connections"]
    for connection, choice in plan.choices.items():
        converted = (
            ""
            if (connection.gain, connection.offset) == (1.0, 0.0)
            else f"; converted: {connection.gain:g} x + {connection.offset:g}"
        )
        lines.append(f"  {connection.label:<46} {choice.transfer:<7} {choice.reason}{converted}")
    for bond in system.bonds:
        effort, flow = (" -> ".join(filter(None, ends)) for ends in (bond.effort, bond.flow))
        lines.append(f"  power bond {bond.name}: {effort} times {flow}")
    lines += ["", "recorded"]
    for group in plan.groups:
        lines.append(
            f"  every {seconds_text(clock.seconds(group.period)):<8} {len(group.columns)} signals of "
            f"{', '.join(group.components)}"
        )
    total = len(plan.cycle)
    lines += [
        "",
        f"operations ({total}, every {again} again)",
    ]
    shown = plan.cycle[:operations]
    names = _Names(plan)
    for row in shown.tolist():
        lines.append(f"  {seconds_text(clock.seconds(row[1])) if row[1] else '0 s':>10}  {names.text(row)}")
    if len(shown) < total:
        lines.append(f"  ... and {total - len(shown)} more (--all shows them)")
    return "\n".join(lines)


def _types(fmu: Fmu, variables: list[str]) -> str:
    """`3 values`, or where not all are floating point `2 Real, 1 Boolean`."""
    kinds = [kind for kind in map(fmu.type_of, variables) if kind is not None]
    if all(kind.real for kind in kinds):
        return f"{len(variables)} values"
    return ", ".join(f"{n} {name}" for name, n in Counter(kind.name for kind in kinds).items())


class _Names:
    """Operations in words."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        layout = plan.layout
        self.slots = {slot: ".".join(key) for table in (layout.outputs, layout.inputs) for key, slot in table.items()}
        self.slots |= {slot: f"previous {'.'.join(key)}" for key, slot in layout.previous.items()}
        for table in (layout.foreign_inputs, layout.foreign_outputs):
            for (name, variable), slot in table.items():
                fmu = plan.system.components[name].fmu
                theirs = fmu.crossings[variable].name if variable in fmu.crossings else variable
                self.slots[slot] = f"'{theirs}' of {fmu.path.name}"
        self.slots |= {slot: f"integral for {'.'.join(key)}" for key, slot in layout.integrals.items()}

    def text(self, row: list[int]) -> str:
        code, _, component, a, b, p, q, k = row
        c, clock, s = self.plan.coefficients, self.plan.clock, self.slots
        name = list(self.plan.system.components)[component] if component >= 0 else ""
        head = f"{NAMES[code]:<10} "
        if code == STEP:
            begin = seconds_text(clock.seconds(b)) if b else "0 s"
            return f"{head} {name} from {begin} by {seconds_text(clock.seconds(a))}"
        if code in (SET, GET):
            table = self.plan.layout.inputs if code == SET else self.plan.layout.outputs
            return f"{head} {name}: {_types(self.plan.system.components[name].fmu, [v for o, v in table if o == name])}"
        if code == RECORD:
            group = self.plan.groups[a]
            return f"{head} {len(group.columns)} signals of {', '.join(group.components)}"
        if code in (MOVE, PUSH):
            return f"{head} {s[b]} = {s[a]}"
        if code == ACCUMULATE:
            return f"{head} {s[b]} += {c[k]:g} ({s[p]} + {s[a]})"
        gain = "" if (c[k], c[k + 1]) == (1.0, 0.0) else f" (times {c[k]:g} plus {c[k + 1]:g})"
        if code == COPY:
            return f"{head} {s[b]} = {s[a]}{gain}"
        if code == LINEAR:
            return f"{head} {s[b]} = {s[a]} + {c[k + 2]:g} ({s[a]} - {s[p]}){gain}"
        assert code == MEAN
        tail = "" if (c[k + 2], c[k + 3]) == (0.0, 0.0) else f" + {c[k + 2]:g} {s[a]} + {c[k + 3]:g} {s[p]}"
        return f"{head} {s[b]} = {s[q]}{tail}{gain}, begin a new integral"
