"""Whether several threads step the FMUs of a run: by the times of its first steps, and by what became of it then."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence

import numpy as np

from ...errors import InputError
from ...loop import cells
from ...loop.machine.compiled import compiled_run
from ...loop.workers.cells import CALLS
from ...loop.workers.pool import Pool, Stepped, why_not_here
from ...plan.plan import Plan
from .blocks import Blocks

ENOUGH = 20  # steps of each that are timed
HANDOVER = 1.5e-6  # s that it takes to give a step to another thread and to hear of it
GAIN = 0.1  # of the time of the groups, below which it does not pay
PROOF = 0.02  # s of blocks that show what became of it


def processors() -> int:
    """How many this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def expected(groups: Sequence[Sequence[float]], threads: int) -> float:
    """How long groups take whose steps take so long [s], each shared among threads, the longest step first."""
    whole = 0.0
    for costs in groups:
        loads = [0.0] * min(threads, len(costs))
        for cost in sorted(costs, reverse=True):
            loads[loads.index(min(loads))] += cost
        whole += max(loads) + (HANDOVER * (len(costs) - 1) if threads > 1 else 0.0)
    return whole


def chosen(groups: Sequence[Sequence[float]], most: int) -> int:
    """The number of threads that takes the least time; 1 where more gain too little."""
    alone = expected(groups, 1)
    best = min(range(1, max(most, 1) + 1), key=lambda n: expected(groups, n))
    return best if expected(groups, best) < (1.0 - GAIN) * alone else 1


class Workers:
    """Of a plan that has groups; `after` is called behind every block. To be closed before the FMUs are."""

    def __init__(self, plan: Plan, blocks: Blocks) -> None:
        self.groups, self.blocks = plan.together.groups, blocks
        self.asked = plan.system.workers
        self._rows = [list(plan.system.components).index(name) for group in self.groups for name in group]
        table = blocks.components
        self._own = table[self._rows, cells.DO_STEP].copy()
        every = iter(self._rows)
        self.pool = Pool([
            [Stepped(*(int(table[row, k]) for k in (cells.FMI, cells.DO_STEP, cells.INSTANCE)))
             for row in (next(every) for _ in group)]
            for group in self.groups
        ])  # fmt: skip
        table[self._rows, cells.DO_STEP] = self.pool.addresses
        self.threads, self.said = 1, ""
        self._waiting = self.asked == "auto"  # for the times of the first steps
        self._before = self._since = float("nan")  # s of a cycle on one thread, and on several
        self._proof = 0.0
        if not self._waiting:
            self._share(min(int(self.asked), max(map(len, self.groups))))

    def after(self, code: int, cycles: int, spent: float) -> None:
        """A block of so many cycles took so long [s]."""
        if code != cells.DONE:
            self.pool.settle()
        elif self._waiting:
            self._decide(spent / cycles)
        elif self._proof > 0.0:
            self._prove(spent, cycles)

    def costs(self) -> list[list[float]]:
        """The mean time of a step of each member of each group [s]."""
        found = iter(self.pool.costs().tolist())
        return [[next(found) for _ in group] for group in self.groups]

    def _decide(self, cycle: float) -> None:
        self._before = min(cycle, self._before) if self._before == self._before else cycle
        if int(np.min(self.pool.jobs[:, CALLS])) < ENOUGH:
            return
        self._waiting = False
        costs = self.costs()
        threads = chosen(costs, min(processors(), max(map(len, self.groups))))
        self.said = in_words(dict(zip(self.groups, costs, strict=True)), threads, processors())
        if threads == 1:
            self._stop()
        else:
            self._share(threads)
            self._proof = PROOF

    def _prove(self, spent: float, cycles: int) -> None:
        """Go back to one thread where several turn out not to be faster."""
        self._since = min(self._since, spent / cycles) if self._since == self._since else spent / cycles
        self._proof -= spent
        if self._proof <= 0.0 and self._since >= self._before:
            self._stop()
            self.said += f"; they were not faster ({1e6 * self._since:.3g} us a cycle, {1e6 * self._before:.3g} before)"

    def _share(self, threads: int) -> None:
        self.threads = threads
        if threads > 1:
            self.blocks.exchange_function(compiled_run(waits=True))  # workers may call back into Python, too
            self.pool.share(threads - 1)

    def _stop(self) -> None:
        """One thread from now on, as if there had been no others."""
        self.pool.close()
        self.pool.forget()
        self.threads = 1
        self.blocks.components[self._rows, cells.DO_STEP] = self._own
        self.blocks.exchange_function(compiled_run())

    def forget(self) -> None:
        """The run goes back to where it was."""
        self.pool.forget()

    def close(self) -> None:
        """End the threads."""
        self.pool.close()


def workers_of(plan: Plan, blocks: Blocks) -> Workers | None:
    """What steps the FMUs of a plan on several threads; None where nobody asks, or nothing can be stepped at once.

    Raises InputError where there can be no workers and a number of them was asked for.
    """
    if plan.system.workers == "1" or not plan.together.groups:
        return None
    if why := why_not_here():
        if plan.system.workers == "auto":
            return None
        raise InputError(f"workers = {plan.system.workers}: {why}")
    if plan.system.workers == "auto" and processors() == 1:
        return None
    return Workers(plan, blocks)


def in_words(costs: Mapping[tuple[str, ...], Sequence[float]], threads: int, most: int) -> str:
    """What was measured of groups, and what is expected."""
    groups = list(costs.values())
    alone, shared = 1e6 * expected(groups, 1), 1e6 * expected(groups, max(threads, 2))
    each = "; ".join(
        ", ".join(f"{name} {1e6 * cost:.3g} us" for name, cost in zip(names, found, strict=True))
        for names, found in costs.items()
    )
    if threads > 1:
        return f"workers: {threads} threads of {most} processors ({each}: {alone:.3g} us, {shared:.3g} expected)"
    return f"workers: one thread, more do not pay ({each}: {alone:.3g} us, on two threads {shared:.3g} expected)"
