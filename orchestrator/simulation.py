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

from . import exchange, execute
from .errors import RunError
from .initialize import initialize
from .instance import STATUS, Instance
from .instances import start
from .memory import Memory
from .plan import Plan
from .process import seconds_since_start
from .texts import Texts

REPORTED = {
    exchange.TERMINATE: " asks to end the simulation (terminateSimulation)",
    exchange.EARLY: " returned early (earlyReturn), which it was not allowed to,",
    exchange.EVENT: " needs event handling (eventHandlingNeeded), which this master does not do,",
}
BLOCK = 0.1  # s of wall time between two looks at progress and signals


@dataclass
class Run:
    """What a run leaves: one table per rate, and how it ended. `failure` is empty if it reached the stop time."""

    plan: Plan
    tables: list[np.ndarray]  # per group: (rows, columns), row 0 at time 0
    failure: str = ""
    end: float = 0.0  # s
    wall: float = 0.0  # s, in the loop
    start: float = 0.0  # s, from the start of the process to the end of the first block of steps
    sweeps: int = 0
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
            sweeps = initialize(plan, instances, memory)
            calculated = {
                f"{name}.{variable}": instance.get(variable)
                for name, instance in instances.items()
                for variable in instance.fmu.names("calculatedParameter")
                if instance.fmu.type_of(variable) is not None
            }
            run = _Loop(plan, instances, memory, control).go(interpreted, progress)
        run.sweeps, run.calculated = sweeps, calculated
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
        self.rows_wanted = [plan.clock.stop // group.period + 1 for group in plan.groups]
        sizes = [rows * len(group.slots) for rows, group in zip(self.rows_wanted, plan.groups, strict=True)]
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
        function = execute.run if interpreted else execute.compiled_run()
        cycles = clock.stop // clock.hyperperiod  # every period divides the stop
        code, wall, reached, began, failure = execute.DONE, 0.0, 0.0, 0.0, ""
        first, block = 0, 1
        while first < cycles and code == execute.DONE:
            size = min(block, cycles - first)
            begin = time.perf_counter()
            code = function(
                plan.cycle, plan.coefficients, self.components, self.blocks, self.z, *self.typed, self.slots,
                self.groups, self.buffer, self.rows, self.control, first, size, clock.hyperperiod, clock.numerator,
                clock.denominator,
            )  # fmt: skip
            spent = time.perf_counter() - begin
            wall += spent
            began = began or seconds_since_start()
            first += size
            block = max(1, min(2 * block, int(size * BLOCK / max(spent, 1e-6))))
            if code == execute.DONE:
                reached = clock.time(first * clock.hyperperiod)
                if progress:
                    progress(reached)
        if code != execute.DONE:
            reached, failure = self._failure(code)
        tables = [
            self.buffer[start : start + rows * columns].reshape(rows, columns)
            for (_, columns, start), rows in zip(self.groups.tolist(), self.rows.tolist(), strict=True)
        ]
        return Run(plan, tables, failure, reached, wall, began, texts=self.memory.texts)

    def _failure(self, code: int) -> tuple[float, str]:
        """The time until which every component is complete, and what happened."""
        clock, operations = self.plan.clock, self.plan.cycle
        row = operations[self.control[execute.AT_OPERATION]]
        begin = int(self.control[execute.AT_CYCLE]) * clock.hyperperiod
        name = list(self.plan.system.components)[row[2]]
        ahead = clock.periods[name] if row[2] >= 0 and name in self.plan.samplers else 0
        at = clock.time(begin + int(row[1]) + ahead)
        ticks = operations[:, 1]
        end = clock.time(begin + int(np.max(ticks, where=ticks < row[1], initial=0)))
        if code == execute.INTERRUPTED:
            return end, f"interrupted by the user at t = {end:.9g} s"
        return end, f"component {name}{self._what(name, code)} in the step to t = {at:.9g} s" + self._hint(name, code)

    def _what(self, name: str, code: int) -> str:
        """What a component did."""
        status, instance = int(self.control[execute.STATUS]), self.instances[name]
        slot = int(self.control[execute.SLOT])
        if code == execute.NOT_FINITE:
            return f": output {self._output(name, slot)} became {self.z[slot]}"
        if instance.fault:
            return f": {instance.fault}"
        if status == exchange.NO_ROOM:
            output = self._output(name, slot)
            return f": there is no room for another text of output {output}; do not record or connect it,"
        if status in REPORTED:
            return REPORTED[status]
        instance.dead = status == 4
        return f" returned {instance.prefix}{STATUS[status]}"

    def _hint(self, name: str, code: int) -> str:
        instance = self.instances[name]
        if code == execute.NOT_FINITE:
            return f"; see its inputs and parameters{instance.log_text()}"
        discarded = code == execute.BAD_STATUS and self.control[execute.STATUS] == 2
        return (instance.why_discarded() if discarded else "") + instance.log_text()

    def _output(self, name: str, slot: int) -> str:
        return next(variable for variable, s in self.plan.layout.exchanged(name)[1].items() if s == slot)


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
