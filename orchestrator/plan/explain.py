"""A plan as text: whatever the executor does can be read here first."""

from __future__ import annotations

from math import inf

import numpy as np

from ..clock import seconds_text
from ..errors import counted
from ..system.inputs.free_inputs import start_notes
from ..system.inputs.series import series_in_words
from .at_once import explained as together_in_words
from .capabilities import remarks
from .exchange import explained
from .happening.clocks import clock_words
from .happening.events import event_words
from .happening.scenario_text import scenario_in_words
from .plan import Plan
from .remarks import aliased, chosen, held_now
from .schedule.operation_text import OperationText
from .speed.fused import fused_words
from .speed.straight import straight_words


def explain(plan: Plan, operations: int | None = None) -> str:
    """Components, connections with their transfers and reasons, order, and the operations of one hyperperiod.

    `operations` limits how many operations are shown (None: all).
    """
    system, clock = plan.system, plan.clock
    tick, again = seconds_text(clock.seconds(1)), seconds_text(clock.seconds(clock.hyperperiod))
    lines = [
        f"system {system.name}" + (f": {system.description}" if system.description else ""),
        *([f"parameters: {system.parameter_set}"] if system.parameter_set else []),
        (f"start {seconds_text(system.start)}, " if system.start else "") + f"stop {seconds_text(system.stop)}; "
        f"tick {tick}; "
        + (f"the first step is {again}" if plan.adaptive else f"the schedule repeats every {again}"),
        f"algorithm {system.algorithm}: {plan.algorithm.explanation()}",
        f"order {', '.join(plan.order)} ({plan.order_reason})",
        *([f"real time: {_deadlines(plan)}"] if plan.deadlines else []),
        *(together_in_words(plan.together, system.workers) if system.workers != "1" else []),
        "", "components",
    ]  # fmt: skip
    for name in plan.order:
        component = system.components[name]
        lines.append(
            f"  {name:<12} every {seconds_text(component.period):<8} {component.fmu.path.name}, "
            f"{component.fmu.standard}, sha256 {component.fmu.digest[:12]}{remarks(component)}"
        )
    lines += [f"  {system.path.name} breaks the standard: {note.found}" for note in system.breaches]
    lines += [f"  {remark}" for remark in system.remarks]
    for name in plan.order:
        lines += [f"  {note}" for note in system.components[name].notes]
    lines += [f"  {note}" for note in start_notes(system)]
    lines += [f"  {note}" for note in last_steps(plan)]
    lines += [f"  {line}" for line in explained(plan.system, plan.algorithm.saves_states)]
    for name in plan.samplers:
        lines.append(f"  {name} samples: its step is done at its beginning, its outputs are in force from then on")
    for name in plan.leaders:
        lines.append(f"  {name} steps first: its outputs are interpolated, so its step is done at its beginning")
    for name, reason in plan.rereads.items():
        lines.append(f"  {name} is read at both ends of its steps: {reason}")
    for name, inputs in plan.instants.read_again(plan.cycle).items():
        lines.append(f"  {name} is read again at its instants: its outputs answer at once to {inputs}")
    for cut, loop in plan.instants.cuts.items():
        lines.append(f"  the {loop} is cut at {cut.label}, which is no floating-point signal: its last value counts")
    if plan.events:
        said = event_words(plan.events, clock, plan.order, plan.exchange)
        said += clock_words(system, clock.seconds(clock.hyperperiod))
        lines += ["", "events", *(f"  {line}" for line in said)]
    lines += ["", "connections"]
    for connection, choice in plan.choices.items():
        changes = [words] if (words := plan.conversions[connection].words) else []
        if (connection.gain, connection.offset) != (1.0, 0.0):
            changes.append(f"{connection.gain:g} x + {connection.offset:g}")
        converted = f"; exactly, by the rise of {'.'.join(connection.counted)}" if connection.counted else ""
        converted += f"; converted: {', '.join(changes)}" if changes else ""
        lines.append(f"  {connection.label:<46} {choice.transfer:<11} {choice.reason}{converted}")
    lines += [f"  {line}" for line in (chosen(plan), *held_now(plan), *aliased(plan)) if line]
    tables = series_in_words(system)
    lines += ["", "inputs that follow tables", *tables] if tables else []
    lines += scenario_in_words(plan)
    for bond in system.bonds:
        effort, flow = (" -> ".join(filter(None, ends)) for ends in (bond.effort, bond.flow))
        exactly = [f"exactly by {name}" for name in (bond.impulse, bond.displacement) if name]
        limits = [f"{bond.limit:g} J"] * (bond.limit < inf) + [f"{bond.limit_relative:g} of it"] * (
            bond.limit_relative < inf
        )
        lines.append(
            f"  power bond {bond.name}: {effort} times {flow}"
            + (f"; counted {' and '.join(exactly)}" if exactly else "")
            + (f"; the coupling may make {' and '.join(limits)}" if limits else "")
        )
    lines += ["", "initialization, in this order"]
    lines += [f"  {block.label}{' (solved as a whole)' if block.loop else ''}" for block in plan.start] or ["  nothing"]
    if plan.layout.previous:
        lines.append("  before the first step every 'previous' value is that of the start")
    lines += ["", "recorded"]
    for group in plan.groups:
        every = "macro step" if plan.adaptive else seconds_text(clock.seconds(group.period))
        lines.append(f"  every {every:<8} {counted(len(group.columns), 'signal')} of {', '.join(group.components)}")
    lines += _listed(plan, plan.cycle, f"every {'macro step' if plan.adaptive else again} again", operations)
    few = None if operations is None else operations // 4
    lines += fused_words(plan, plan.cycle, few)
    if len(plan.last):
        lines += _listed(plan, plan.last, f"in the last {seconds_text(clock.seconds(clock.rest))}", operations)
        lines += fused_words(plan, plan.last, few)
    lines += straight_words(plan)
    if plan.events:
        for name, rows in plan.at_events.bring.items():
            lines += _listed(plan, rows, f"to bring {name} to an event, as from the beginning of its step", operations)
            if name in plan.at_events.form:
                form = np.vstack([_at(start, rows) for start, rows in plan.at_events.form[name].items()])
                lines += _listed(plan, form, f"before that, by where its step begins: {name}", operations)
        for known, rows in plan.at_events.after.items():
            them = ", ".join(name for name in plan.order if name in known) or "nobody"
            lines += _listed(plan, rows, f"in each round of an event at which are {them}", operations)
    return "\n".join(lines)


def _deadlines(plan: Plan) -> str:
    """When a run in real time waits for the clock on the wall."""
    if plan.algorithm.steps_vary or plan.algorithm.saves_states:
        return "it waits for the clock on the wall at the end of each macro step"
    return f"it waits for the clock on the wall every {seconds_text(plan.clock.seconds(plan.deadlines))}"


def _at(tick: int, rows: np.ndarray) -> np.ndarray:
    found = rows.copy()
    found[:, 1] = tick
    return found


def _listed(plan: Plan, rows: np.ndarray, when: str, most: int | None) -> list[str]:
    """Operations in words, at most so many."""
    lines = ["", f"operations ({len(rows)}, {when})"]
    shown, names, seconds = rows[:most], OperationText(plan), plan.clock.seconds
    for number, row in enumerate(shown.tolist(), 1):
        at = seconds_text(seconds(row[1])) if row[1] else "0 s"
        lines.append(f"{number:>6} {'end' if plan.adaptive and row[1] else at:>10}  {names.text(row)}")
    if len(shown) < len(rows):
        lines.append(f"  ... and {len(rows) - len(shown)} more (--all shows them)")
    return lines


def last_steps(plan: Plan) -> list[str]:
    """Who makes a shorter last step, a line for each length."""
    found: dict[int, list[str]] = {}
    for name, length in plan.short_steps().items():
        found.setdefault(length, []).append(name)
    return [
        f"the last step of {', '.join(names)} is a shorter one of {seconds_text(plan.clock.seconds(length))}, which "
        f"ends at the stop"
        for length, names in found.items()
    ]
