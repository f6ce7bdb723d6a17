"""The start of a run as rows of the loop: what `initialize` does one variable at a time, for systems without loops.

It is for FMUs of which the order of calls within a mode is known not to matter, our own: a component gets all its
inputs where `initialize` sets one, and is asked for all its outputs where that reads one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ...fmu.conversions import How
from ...fmu.types import Value
from ...loop.cells import DONE
from ...loop.machine.frame import with_arrays
from ...loop.operations import AT_ITS_END, COLUMNS, COPY, GET, SET
from ...participant.here.loaded import LoadedInstance
from ...plan.plan import Plan
from ...plan.start import Block
from ...system.assigned import Values
from ...system.inputs.free_inputs import left_alone
from ..blocks.blocks import NO_ROWS, NO_TURNS
from .restart import Restart, restart_of

if TYPE_CHECKING:
    from ..session.session import Session


def why_not_quick(plan: Plan) -> str:
    """Why a start needs more than rows; empty where it does not."""
    if any(block.loop for block in (*plan.start, *_at_once(plan))):
        return "a loop"
    if any(plan.conversions[c].how is not How.REAL or np.isfinite(plan.conversions[c].largest)
           for c in plan.system.connections):  # fmt: skip
        return "connections that are not between doubles"
    if plan.system.requirements:
        return "what the system requires of its start"
    return ""


def _at_once(plan: Plan) -> Sequence[Block]:
    """The connections whose new values outputs answer at once, as at every instant."""
    return plan.instants.blocks(frozenset(plan.system.components) - set(plan.early))


class QuickStart:
    """Rows for a plan and a session of it whose FMUs are reset."""

    def __init__(self, plan: Plan, session: Session) -> None:
        self.plan, self.memory = plan, session.memory
        index = {name: k for k, name in enumerate(plan.system.components)}
        layout, factors = plan.layout, [0.0]

        def along(blocks: Sequence[Block]) -> list[tuple[int, ...]]:
            rows = list[tuple[int, ...]]()
            for c in (c for block in blocks for c in block.connections):
                rows.append((GET, 0, index[c.source[0]], AT_ITS_END, 0, 0, 0, 0))
                rows.append((COPY, 0, -1, layout.outputs[c.source], layout.inputs[c.target], 0, 0, len(factors)))
                rows.append((SET, 0, index[c.target[0]], 0, 0, 0, 0, 0))
                factors.extend((c.gain, c.offset))
            return rows

        names = [name for name in index if any(key[0] == name for key in layout.outputs)]
        read = [(GET, 0, index[name], AT_ITS_END, 0, 0, 0, 0) for name in names]
        sweep, at_once = along(plan.start), along(_at_once(plan))
        again = dict.fromkeys(row[2] for row in at_once if row[0] == SET)
        again_read = [row for row in read if row[2] in again]
        self._clock = plan.cycle_ticks, plan.clock.numerator, plan.clock.denominator
        self._sweep, self._read = (
            with_arrays(
                session.loop.function,
                (
                    np.array(rows, dtype=np.int64).reshape(-1, len(COLUMNS)), np.array(factors),
                    session.loop.components, session.loop.blocks, self.memory.z, *session.loop.typed, *NO_ROWS,
                    session.control, *session.space.arrays, *NO_TURNS,
                ),
            )
            for rows in ([*sweep, *read], [*read, *at_once, *again_read])
        )  # fmt: skip
        tables = (layout.previous, layout.before, layout.begins, layout.samples, layout.parts)
        copied = [(slot, layout.outputs[key]) for table in tables for key, slot in table.items()]
        self._to, self._from = (np.array([pair[n] for pair in copied], dtype=np.int64) for n in (0, 1))
        end, begin = (plan.clock.time(tick) for tick in (plan.clock.stop, 0))
        always, free = dict[str, dict[str, Value]](), left_alone(plan.system)
        self._restarts = dict[str, Restart]()
        for name, component in plan.system.components.items():
            always[name] = {**component.parameters, **component.first_inputs(begin)}
            always[name] |= {variable: component.fmu.start(variable) for variable in free.get(name, ())}
            instance = session.instances[name]
            assert isinstance(instance, LoadedInstance)
            self._restarts[name] = restart_of(instance, always[name], end, begin)
        self._inputs = layout.inputs
        for key, slot in layout.inputs.items():
            start = always[key[0]].get(key[1], plan.system.components[key[0]].fmu.start(key[1]))
            self.memory.put(key, slot, start)
        self._slots = np.array(list(layout.inputs.values()), dtype=np.int64)
        self._starts = self.memory.z[self._slots]

    def start(self, values: Values) -> bool:
        """From the end of a run to time 0, as a reset and `initialize` do with other values; False if that is not
        found.

        Raises FmuError or RunError if an FMU refuses.
        """
        z = self.memory.z
        for name, restart in self._restarts.items():
            restart.enter(values.get(name, {}))
        z[self._slots] = self._starts
        for (name, variable), slot in self._inputs.items():
            if name in values and variable in values[name]:
                self.memory.put((name, variable), slot, values[name][variable])
        if self.plan.start and not self._settled():
            return False
        for restart in self._restarts.values():
            restart.leave()
        if self._read(0, 1, *self._clock) != DONE:
            return False
        z[self._to] = z[self._from]
        return True

    def _settled(self) -> bool:
        """Whether values propagate until nothing changes."""
        for sweep in range(len(self._restarts) + 2):
            before = self.memory.whole.copy()
            if self._sweep(0, 1, *self._clock) != DONE:
                return False
            if sweep and np.array_equal(before, self.memory.whole):
                return True
        return False
