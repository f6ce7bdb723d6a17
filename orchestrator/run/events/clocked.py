"""What is exchanged in event mode only: clocked variables at the ticks of their clocks, and discrete inputs.

Clocks that are connected tick together. Values go round among those at one instant until none changes; a partition of
scheduled execution runs once, when all that it is given is there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction

from ...errors import RunError
from ...participant.base import Participant
from ...plan.happening.events import Known
from ...plan.plan import Plan
from ...plan.schedule.layout import Key
from ..memory.memory import Memory
from .member import Member

MOST_PASSES = 1000  # of values in one round of an instant


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
