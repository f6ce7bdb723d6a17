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

from . import ecco, execute, iteration
from .errors import RunError
from .fmu import STATUS, Instance
from .initialize import Started, initialize
from .plan import Plan
from .process import seconds_since_start
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
    calculated: dict[str, float] = field(default_factory=dict)  # calculated parameters, "component.variable"


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
                instances[name] = Instance(component.fmu, name)
            z = np.zeros(max(plan.layout.size, 1))
            started = initialize(plan, instances, z)
            calculated = {
                f"{name}.{variable}": float(instance.get(variable))
                for name, instance in instances.items()
                for variable in instance.fmu.names("calculatedParameter")
            }
            run = _Loop(plan, instances, z, control).go(interpreted, progress)
        run.started, run.calculated = started, calculated
        return run
    finally:
        for instance in instances.values():
            instance.close()


class _Loop:
    """The arrays that the loop works on, laid out for `execute.run`."""

    def __init__(self, plan: Plan, instances: dict[str, Instance], z: np.ndarray, control: np.ndarray) -> None:
        self.plan, self.instances, self.z, self.control = plan, instances, z, control
        self.keep: list[np.ndarray] = []  # value references, alive as long as their addresses are in use
        self.components = np.array([self._component(name) for name in plan.system.components], dtype=np.int64)
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
            self.buffer[cells[k] : cells[k] + len(group.slots)] = z[group.slots]

    def _component(self, name: str) -> list[int]:
        instance, layout = self.instances[name], self.plan.layout
        row = [instance.address(f) for f in ("fmi2SetReal", "fmi2GetReal", "fmi2DoStep")] + [
            int(instance.slave.component)
        ]
        for table in (layout.inputs, layout.outputs):
            slots = [(slot, variable) for (owner, variable), slot in table.items() if owner == name]
            references = np.array([instance.fmu.variables[v].valueReference for _, v in slots] or [0], dtype=np.uint32)
            self.keep.append(references)
            first = slots[0][0] if slots else 0
            row += [references.ctypes.data, len(slots), self.z.ctypes.data + 8 * first]
        return [*row, first]

    def go(self, interpreted: bool, progress: Callable[[float], None] | None) -> Run:
        clock, plan = self.plan.clock, self.plan
        function = execute.run if interpreted else execute.compiled_run()
        ticks = 0 if plan.adaptive else clock.hyperperiod
        cycles = clock.stop if plan.adaptive else clock.stop // clock.hyperperiod  # every period divides the stop
        code, wall, reached, start, failure = execute.DONE, 0.0, 0.0, 0.0, ""
        first, block = 0, 1
        while first < cycles and code == execute.DONE and (not plan.adaptive or self.space.clock[ecco.STEP] > 0):
            size = min(block, cycles - first)
            if plan.adaptive:
                self._make_room(size)
            begin = time.perf_counter()
            code = function(
                plan.cycle, plan.coefficients, self.components, self.z, self.slots, self.groups, self.buffer, self.rows,
                self.control, *self.space.arrays, first, size, ticks, clock.numerator, clock.denominator,
            )  # fmt: skip
            spent = time.perf_counter() - begin
            wall += spent
            start = start or seconds_since_start()
            first += size
            block = max(1, min(2 * block, int(size * BLOCK / max(spent, 1e-6))))
            if code == execute.DONE:
                reached = clock.time(int(self.space.clock[ecco.NOW]) or first * ticks)
                if progress:
                    progress(reached)
        if code != execute.DONE:
            reached, failure = self._failure(code)
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
        return Run(plan, tables, grids, failure, reached, wall, start)

    def _make_room(self, rows: int) -> None:
        """Let the one table of a run with varying steps hold this many more rows."""
        columns = int(self.groups[0, 1])
        missing = (int(self.rows[0]) + rows) * columns - len(self.buffer)
        if missing > 0:
            self.buffer = np.concatenate([self.buffer, np.zeros(max(missing, len(self.buffer)))])

    def _failure(self, code: int) -> tuple[float, str]:
        """The time until which every component is complete, and what happened."""
        clock, operations = self.plan.clock, self.plan.cycle
        row = operations[self.control[execute.AT_OPERATION]]
        begin = int(self.control[execute.AT_CYCLE]) * clock.hyperperiod
        name = list(self.plan.system.components)[row[2]]
        ahead = clock.periods[name] if row[2] >= 0 and name in self.plan.early else 0
        at = clock.time(begin + int(row[1]) + ahead)
        ticks = operations[:, 1]
        end = clock.time(begin + int(np.max(ticks, where=ticks < row[1], initial=0)))
        if self.plan.adaptive:
            now, step = int(self.space.clock[ecco.NOW]), int(self.space.clock[ecco.STEP])
            at, end = clock.time(now + step), clock.time(now)
        if self.plan.system.algorithm == "iterated":
            end = clock.time(begin)
        if code == execute.INTERRUPTED:
            return end, f"interrupted by the user at t = {end:.9g} s"
        if code == execute.NOT_CONVERGED:
            return end, self._not_converged(at)
        log = self.instances[name].log_text()
        if code == execute.NOT_FINITE:
            slot = int(self.control[execute.SLOT])
            variable = next(key for key, s in self.plan.layout.outputs.items() if s == slot)[1]
            return (
                end,
                f"component {name}: output {variable} became {self.z[slot]} in the step to t = {at:.9g} s; "
                f"see its inputs and parameters{log}",
            )
        status = int(self.control[execute.STATUS])
        self.instances[name].dead = status == 4
        return end, f"component {name} returned fmi2{STATUS[status]} in the step to t = {at:.9g} s{log}"

    def _not_converged(self, at: float) -> str:
        settings, work = self.plan.system.iteration, self.space.work
        names = [".".join(key) for key, _ in self.plan.layout.unknowns]
        return (
            f"the coupling did not converge in the step to t = {at:.9g} s: residual {work[iteration.RESIDUAL]:.3g} of "
            f"{names[int(work[iteration.WORST])]} after {int(work[iteration.COUNT])} iterations "
            f"({settings.method}, tolerance {settings.tolerance:g}); take smaller periods"
            + (', or method = "newton" under [iteration]' if settings.method == "aitken" else "")
        )


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
