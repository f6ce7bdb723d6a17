"""Load, initialize, execute, collect: one run of a plan."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from . import ecco, execute
from .compiled import compiled_run
from .errors import RunError
from .failure import failure_of
from .initialize import Started, initialize
from .instance import Instance
from .instances import start
from .memory import Memory
from .plan import Plan
from .process import seconds_since_start
from .texts import Texts
from .workspace import free_states, make_workspace

CHUNK = 4096  # rows that a table of unknown length begins with
BLOCK = 0.1  # s of wall time between two looks at progress and signals


@dataclass
class Run:
    """What a run leaves: one table per rate, and how it ended. `failure` is empty if it reached the stop time."""

    plan: Plan
    tables: list[np.ndarray]  # per group: (rows, columns), row 0 at time 0
    ticks: list[np.ndarray]  # per group: (rows,), the instants
    failure: str = ""
    end: float = 0.0  # s
    wall: float = 0.0  # s, in the loop
    start: float = 0.0  # s, from the start of the process to the end of the first block of steps
    started: Started = field(default_factory=Started)
    texts: Texts | None = None  # those whose numbers the tables hold
    calculated: dict[str, Any] = field(default_factory=dict)  # calculated parameters, "component.variable"


def simulate(plan: Plan, interpreted: bool = False, progress: Callable[[float], None] | None = None) -> Run:
    """Run a plan from time 0 to its stop.

    `interpreted` executes the same plan in plain Python, bitwise equal and slow. `progress` is called now and then
    with the time reached [s]. A failing FMU, a value that is not finite and Ctrl-C end the run early; the tables
    hold what was computed and `failure` says who, what and when. Raises FmuError before time 0.
    """
    instances: dict[str, Instance] = {}
    control = np.zeros(5, dtype=np.int64)
    try:
        with _stop_on_interrupt(control):
            for name, component in plan.system.components.items():
                instances[name] = start(component)
            memory = Memory(plan)
            started = initialize(plan, instances, memory)
            calculated = {
                f"{name}.{variable}": instance.get(variable)
                for name, instance in instances.items()
                for variable in instance.fmu.names("calculatedParameter")
                if instance.fmu.type_of(variable) is not None
            }
            run = _Loop(plan, instances, memory, control).go(interpreted, progress)
        run.started, run.calculated = started, calculated
        return run
    finally:
        for instance in instances.values():
            instance.close()


class _Loop:
    """The arrays that the loop works on, laid out for `execute.run`."""

    def __init__(self, plan: Plan, instances: dict[str, Instance], memory: Memory, control: np.ndarray) -> None:
        self.plan, self.instances, self.memory, self.control = plan, instances, memory, control
        self.z = memory.z
        self.components, self.blocks, self.typed = memory.tables(instances)
        self.space = make_workspace(plan, instances)
        rows_wanted = [CHUNK if plan.adaptive else plan.clock.stop // group.period + 1 for group in plan.groups]
        sizes = [rows * len(group.slots) for rows, group in zip(rows_wanted, plan.groups, strict=True)]
        firsts = np.cumsum([0, *(len(group.slots) for group in plan.groups)])
        cells = np.cumsum([0, *sizes])
        self.groups = np.array(
            [(firsts[k], len(group.slots), cells[k]) for k, group in enumerate(plan.groups)], dtype=np.int64
        ).reshape(-1, 3)
        self.slots = np.concatenate([np.zeros(0, dtype=np.int64), *(group.slots for group in plan.groups)])
        self.buffer = np.zeros(max(int(cells[-1]), 1))
        self.rows = np.ones(max(len(plan.groups), 1), dtype=np.int64)
        for k, group in enumerate(plan.groups):
            self.buffer[cells[k] : cells[k] + len(group.slots)] = self.z[group.slots]

    def go(self, interpreted: bool, progress: Callable[[float], None] | None) -> Run:
        clock, plan = self.plan.clock, self.plan
        function = execute.run if interpreted else compiled_run()
        ticks = 0 if plan.adaptive else clock.hyperperiod
        cycles = clock.stop if plan.adaptive else clock.stop // clock.hyperperiod  # every period divides the stop
        code, wall, reached, began, failure = execute.DONE, 0.0, 0.0, 0.0, ""
        first, block = 0, 1
        while first < cycles and code == execute.DONE and (not plan.adaptive or self.space.clock[ecco.STEP] > 0):
            size = min(block, cycles - first)
            if plan.adaptive:
                self._make_room(size)
            begin = time.perf_counter()
            code = function(
                plan.cycle, plan.coefficients, self.components, self.blocks, self.z, *self.typed, self.slots,
                self.groups, self.buffer, self.rows, self.control, *self.space.arrays, first, size, ticks,
                clock.numerator, clock.denominator,
            )  # fmt: skip
            spent = time.perf_counter() - begin
            wall += spent
            began = began or seconds_since_start()
            first += size
            block = max(1, min(2 * block, int(size * BLOCK / max(spent, 1e-6))))
            if code == execute.DONE:
                reached = clock.time(int(self.space.clock[ecco.NOW]) or first * ticks)
                if progress:
                    progress(reached)
        if code != execute.DONE:
            reached, failure = failure_of(plan, self.instances, code, self.control, self.z, self.space)
            if plan.system.algorithm == "iterated":  # what a pass recorded that was not the last
                whole = int(self.control[execute.AT_CYCLE]) * clock.hyperperiod
                self.rows[: len(plan.groups)] = [whole // group.period + 1 for group in plan.groups]
        free_states(self.space, self.instances)
        tables = [
            self.buffer[start : start + rows * columns].reshape(rows, columns)
            for (_, columns, start), rows in zip(self.groups.tolist(), self.rows.tolist(), strict=True)
        ]
        grids = [group.period * np.arange(len(table)) for group, table in zip(plan.groups, tables, strict=True)]
        if plan.adaptive:
            column = plan.groups[0].columns.index(("coupling", "tick"))
            grids = [tables[0][:, column].astype(np.int64)]
        return Run(plan, tables, grids, failure, reached, wall, began, texts=self.memory.texts)

    def _make_room(self, rows: int) -> None:
        """Let the one table of a run with varying steps hold this many more rows."""
        columns = int(self.groups[0, 1])
        missing = (int(self.rows[0]) + rows) * columns - len(self.buffer)
        if missing > 0:
            self.buffer = np.concatenate([self.buffer, np.zeros(max(missing, len(self.buffer)))])


@contextmanager
def _stop_on_interrupt(control: np.ndarray) -> Iterator[None]:
    """Ctrl-C stops the loop at the next instant instead of raising inside an FMU's Python code; twice insists."""
    ignored = signal.getsignal(signal.SIGINT) is signal.SIG_IGN  # nohup, and the processes of a sweep
    if ignored or threading.current_thread() is not threading.main_thread():
        yield
        return

    def request(_signal: int, _frame: Any) -> None:
        if control[execute.STOP_REQUEST]:
            raise KeyboardInterrupt
        control[execute.STOP_REQUEST] = 1

    before = signal.signal(signal.SIGINT, request)
    try:
        yield
    finally:
        with suppress(TypeError, ValueError):
            signal.signal(signal.SIGINT, before)


def require_complete(run: Run) -> Run:
    """The run itself, or RunError with its failure; for studies that need the whole run."""
    if run.failure:
        raise RunError(run.failure)
    return run
