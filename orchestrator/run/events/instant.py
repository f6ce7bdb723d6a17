"""One instant of an event: who takes part, how they are brought there, and the values among them."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from fractions import Fraction

import numpy as np

from ...errors import RunError
from ...loop import cells, versions
from ...loop.calls import EARLY_RETURN, EVENT_NEEDED, LAST_TIME
from ...loop.operations import FAULT, SAMPLE, SERIES, STEP_ON
from ...loop.run import FOREVER
from ...participant.base import Participant
from ...plan.happening.events import EventRows, Known
from ...plan.plan import Plan
from ...plan.schedule.event_rows import at_instant
from ..ends.failure import failed_at
from ..memory.memory import Memory
from ..memory.moments import Moments

SAME = 1e-9  # of a time, or of a step: how far off an FMU may say that it came
RunRows = Callable[[np.ndarray, int], int]  # does operations in the loop, as of a cycle; the code that it ends with


class Place:
    """Where the loop stands: a cycle, an operation of it that is not done yet, and where each component is."""

    def __init__(self, plan: Plan, cycle: int, operation: int) -> None:
        self.plan, self.cycle, self.operation = plan, cycle, operation
        self.rows = plan.operations(cycle)
        last = cycle >= plan.clock.cycles
        self.base = cycle * plan.cycle_ticks  # ticks from the start
        self.event_rows: EventRows = plan.at_last_events if last else plan.at_events
        self.starts = self.event_rows.starts.behind(operation)

    def time_of(self, tick: int) -> float:
        """An instant of the cycle [ticks] as the loop has it [s]."""
        return self.plan.clock.time(self.base + tick)

    def known(self, time: float) -> Known:
        """Who is at an instant [s], or behind it, or is brought there."""
        events = self.plan.events
        assert events is not None
        there = [int(self.time_of(start) >= time) for start in self.starts]
        return at_instant(there, list(self.plan.system.components), 1, events.stopped, self.plan.early)


class Instant:
    """The work of an event; `run` calls the loop with a few operations."""

    def __init__(
        self, plan: Plan, instances: Mapping[str, Participant], memory: Memory, moments: Moments,
        control: np.ndarray, components: np.ndarray, run: RunRows,
    ) -> None:  # fmt: skip
        self.plan, self.instances, self.memory, self.moments = plan, instances, memory, moments
        self.control, self.components, self._run = control, components, run
        self.names = list(plan.system.components)
        self._faults = bool(plan.layout.faults)

    def at(self, name: str, place: Place) -> float:
        """How far a component has come [s], within its step or behind it."""
        k = self.names.index(name)
        return max(place.time_of(place.starts[k]), float(self.moments.reached[k]))

    def bring(self, name: str, place: Place, time: float) -> tuple[float, str] | None:
        """Bring a component that can be stopped to an instant [s], if it is not there; where an event of its own
        stopped it before, when, and what happened there in words. Raises RunError if it cannot be brought there."""
        if self.at(name, place) >= time:
            return None
        k = self.names.index(name)
        self.moments.latest = time
        rows, start = place.event_rows.bring[name], place.starts[k]
        if name in place.event_rows.form:
            rows = np.vstack((place.event_rows.form[name][start], rows))
        code = self._do(rows, place, start)
        self.moments.latest = FOREVER
        found = self.stopped_early(k, time) if code == cells.BAD_STATUS else None
        if found is None:
            self._require(code, time)
        return found

    def stopped_early(self, component: int, end: float) -> tuple[float, str] | None:
        """How far a step to `end` [s] went that an event ended, and what happened there in words, if anything did;
        None where that was not why it ended. The component is there then. Raises RunError where nobody can be."""
        name, status = self.names[component], int(self.control[cells.STATUS])
        found = self.instances[name].stopped()
        if found is None and status in (versions.EARLY, versions.EVENT):
            flags = int(self.components[component, cells.FLAGS])
            early = ctypes.c_ubyte.from_address(flags + EARLY_RETURN).value
            reached = ctypes.c_double.from_address(flags + LAST_TIME).value if early else end
            event = ctypes.c_ubyte.from_address(flags + EVENT_NEEDED).value
            found = reached, f"{name} has an event" if event else ""
        if found is None:
            return None
        began = float(self.moments.began[component])
        within = SAME * max(abs(end), end - began)
        if not began - within <= found[0] <= end + within:  # nor where it is no number
            raise RunError(
                f"component {name}: its step from t = {began:.9g} s ended early at {found[0]:.9g} s, which is not "
                f"between there and t = {end:.9g} s (lastSuccessfulTime){self.instances[name].log_text()}"
            )
        self.moments.reached[component] = reached = min(max(found[0], began), end)
        return reached, found[1]

    def values(self, place: Place, known: Known, time: float) -> bool:
        """Values along the held connections among those at an instant; whether any has changed."""
        before = self.memory.whole.copy()
        self._require(self._do(place.event_rows.after[known], place), time)
        return not np.array_equal(before, self.memory.whole)

    def _do(self, rows: np.ndarray, place: Place, start: int = 0) -> int:
        """Do operations that are listed as from the start of a cycle for a step that begins at `start`; noise is that
        of the present step of its component."""
        self._rows = rows
        if start:
            self._rows = rows = rows.copy()
            rows[rows[:, 0] == STEP_ON, 4] += start
            rows[(rows[:, 0] == SERIES) | (rows[:, 0] == SAMPLE) | (rows[:, 0] == FAULT), 5] += start
        elif self._faults and len(broken := np.flatnonzero(rows[:, 0] == FAULT)):
            self._rows = rows = rows.copy()
            rows[broken, 5] += np.array(place.starts, dtype=np.int64)[rows[broken, 2]]
        return self._run(self._rows, place.cycle)

    def _require(self, code: int, time: float) -> None:
        if code != cells.DONE:
            row, at = self._rows[int(self.control[cells.AT_OPERATION])], f"t = {time:.9g} s"
            raise RunError(failed_at(self.plan, self.instances, code, self.control, self.memory.z, row, at, True))


def exactly(plan: Plan, time: float | Fraction) -> Fraction:
    """An instant [s] in ticks from the start; where it is the double of a whole tick, that."""
    clock = plan.clock
    ticks = Fraction(time) / clock.seconds(1) - clock.start
    return Fraction(round(ticks)) if clock.time(round(ticks)) == float(time) else ticks
