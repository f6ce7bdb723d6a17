"""What is exchanged in event mode only: clocked variables at the ticks of their clocks, and discrete inputs.

Clocks that are connected tick together. Values go round among those at one instant until none changes; a partition of
scheduled execution runs once, when all that it is given is there.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import Any

from ...errors import RunError
from ...fmu.types import Value
from ...participant.base import Participant
from ...plan.happening.events import Known
from ...plan.plan import Plan
from ...plan.schedule.layout import Key
from ...system.model import Connection
from ..memory.memory import Memory
from .faults import broken

MOST_PASSES = 1000  # of values in one round of an instant


class Member:
    """A component with event mode or with partitions: what it is given and gives at events."""

    def __init__(self, plan: Plan, instance: Any, memory: Memory) -> None:
        self.plan, self.instance, self.memory, self.name = plan, instance, memory, instance.name
        component = plan.system.components[self.name]
        self.scheduled, fmu = component.scheduled, component.fmu
        layout = plan.layout
        apart = component.at_events - {c.target[1] for c in plan.inside if c.target[0] == self.name}
        clocked = {v: frozenset(component.clocks_of(v)) for v in component.at_events}
        self.given, self.taken = (
            {v: slot for (name, v), slot in table.items() if name == self.name and v in apart}
            for table in (layout.inputs, layout.outputs)
        )
        self.clocks = clocked
        self.inputs = {v: clocked[v] for v in self.given}
        self.outputs = {v: clocked[v] for v in self.taken}
        self.drivers = {v: plan.system.drivers.get((self.name, v)) for v in self.inputs}
        clocks = dict.fromkeys(fmu.own.clocks.values())
        self.output_clocks = [c.name for c in clocks if c.causality == "output"] if not self.scheduled else []
        self.now = plan.clock.seconds(plan.clock.start)  # s, the instant of the event that goes on
        self.by_hand: dict[str, Value] = {}  # inputs without cells that are still to be set
        self.sent: dict[str, Value] = {v: memory.value((self.name, v), self.given[v]) for v in self.inputs}

    def form_inputs(self) -> None:
        """What the sources of its inputs send now, into their cells."""
        for variable, driver in self.drivers.items():
            if driver is not None:
                self.memory.put((self.name, variable), self.given[variable], self._received(driver))

    def _now(self, variable: str) -> Value:
        """What an input is sent now, or was given otherwise."""
        driver = self.drivers[variable]
        slot = self.given[variable]
        return self.memory.value((self.name, variable), slot) if driver is None else self._received(driver)

    def _received(self, c: Connection) -> Value:
        value = self.memory.value(c.source, self.plan.layout.outputs[c.source])
        try:
            received = self.plan.conversions[c].convert(value, c.gain, c.offset)
        except ValueError as error:
            raise RunError(f"connection {c.label}: {error} {c.where}".rstrip()) from None
        if not self.plan.layout.faults:
            return received
        return broken(self.plan, self.memory, c.target, received, math.floor(self.now / self.plan.clock.seconds(1)))

    def set_inputs(self) -> bool:
        """Give it those that are new and may be set now; whether there were any."""
        active, changed = self.instance.active, dict[str, Value]()
        for variable, clocks in self.inputs.items():
            if clocks and clocks.isdisjoint(active):
                continue
            value = self.memory.value((self.name, variable), self.given[variable])
            if value != self.sent[variable]:
                changed[variable] = self.sent[variable] = value
        for variable in [v for v in self.by_hand if not self.clocks[v] or not self.clocks[v].isdisjoint(active)]:
            changed[variable] = self.by_hand.pop(variable)
        if changed:
            self.instance.set_all(changed)
        return bool(changed)

    def get_outputs(self) -> bool:
        """Take the outputs that may be read now; whether any has changed."""
        active, changed = self.instance.active, False
        for variable, clocks in self.outputs.items():
            if clocks and clocks.isdisjoint(active):
                continue
            key, slot = (self.name, variable), self.taken[variable]
            value = self.instance.get(variable)
            if isinstance(value, float) and not math.isfinite(value):
                raise RunError(f"component {self.name}: output {variable} became {value}{self.instance.log_text()}")
            before = int(self.memory.whole[slot])
            self.memory.put(key, slot, value)
            changed |= before != int(self.memory.whole[slot])
        return changed

    def waits_for_change(self) -> bool:
        """Whether a discrete input without a clock has another value than it was given."""
        return any(
            not clocks and self._now(variable) != self.sent[variable] for variable, clocks in self.inputs.items()
        )


class Clocked:
    """All members, and the clocks that tick together."""

    def __init__(self, plan: Plan, instances: Mapping[str, Participant], memory: Memory) -> None:
        self.members = {
            name: Member(plan, instances[name], memory) for name in plan.order if plan.system.components[name].in_events
        }
        self.followers: dict[Key, list[Key]] = {}
        for c in plan.system.clock_connections:
            self.followers.setdefault(c.source, []).append(c.target)
        self._ticked: set[Key] = set()
        self.late: dict[Key, Key] = {}  # clocks that are to tick as soon as their component is there, and with which

    def begin(self, now: Fraction) -> None:
        """It is another instant [s]."""
        for member in self.members.values():
            member.now = now

    def happened(self, known: Known) -> bool:
        """Whether a discrete input of one of `known` has changed, or a clock of it is to tick, which are events."""
        late = any(name in known for name, _ in self.late)
        return late or any(member.waits_for_change() for name, member in self.members.items() if name in known)

    def exchange(self, known: Known, values: Callable[[], bool]) -> tuple[bool, list[str]]:
        """A round among those of `known`: whether any value has changed, and which clocks ticked by others, in words.

        `values` passes what is connected without clocks on, and says whether it changed anything. Raises RunError.
        """
        members = [member for name, member in self.members.items() if name in known]
        self._ticked.clear()
        words: list[str] = []
        any_change = False
        for target, source in list(self.late.items()):
            if target[0] in known:
                del self.late[target]
                self._follow(source, target, words)
        for _ in range(MOST_PASSES):
            changed = False
            for member in members:
                member.form_inputs()
                changed |= member.set_inputs() and not member.scheduled
                for clock in member.instance.active:
                    self._tick((member.name, clock), known, words)
                if member.output_clocks:
                    found = zip(member.output_clocks, member.instance.ticking(member.output_clocks), strict=True)
                    ticking = [clock for clock, ticks in found if ticks]
                    member.instance.active |= frozenset(ticking)
                    for clock in ticking:
                        changed |= self._tick((member.name, clock), known, words)
                if not member.scheduled:
                    changed |= member.get_outputs()
            if not changed:
                changed = self._run_partition(members, known, words)
            if not changed:
                return any_change, words
            any_change = True
            values()
        names = ", ".join(member.name for member in members)
        raise RunError(
            f"values and clocks of {names} do not settle: after {MOST_PASSES} passes at one instant they still change"
        )

    def _run_partition(self, members: Iterable[Member], known: Known, words: list[str]) -> bool:
        """Run the next partition that is waiting, if one is."""
        for member in members:
            if member.scheduled and member.instance.waiting:
                _, ticked = member.instance.run_next()
                member.get_outputs()
                for clock in ticked:
                    words.append(f"{member.name}.{clock} ticks")
                    self._tick((member.name, clock), known, words)
                return True
        return False

    def _tick(self, source: Key, known: Known, words: list[str]) -> bool:
        """Let the clocks that follow one tick; whether there were any that did not yet. Raises RunError."""
        if source in self._ticked:
            return False
        self._ticked.add(source)
        followers = self.followers.get(source, [])
        for name, clock in followers:
            member = self.members[name]
            if member.instance.timetable.clocks.get(clock) is not None:
                continue  # a time-based one has the same times by itself
            if name in known:
                self._follow(source, (name, clock), words)
            else:
                self.late[name, clock] = source
        return bool(followers)

    def _follow(self, source: Key, target: Key, words: list[str]) -> None:
        self.members[target[0]].instance.activate([target[1]])
        words.append(f"{'.'.join(target)} ticks with {'.'.join(source)}")
