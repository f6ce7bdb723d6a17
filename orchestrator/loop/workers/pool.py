"""A pool of worker threads for the steps of one run, and the functions that stand in the place of DoStep."""

from __future__ import annotations

import ctypes
import sys
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec

import numpy as np

from ..machine.objects import Loaded, object_of
from . import cells
from .code import pause, text


@dataclass(frozen=True)
class Stepped:
    """A component that takes part: whose signatures its function has (2 or 3), that function and its instance."""

    fmi: int
    function: int
    instance: int


def why_not_here() -> str:
    """Why there are no workers on this machine; empty where there can be."""
    if sys.platform == "win32" or not pause():
        return "workers need Linux or macOS on x86-64 or aarch64"
    if find_spec("llvmlite") is None:
        return "workers need a compiler: python -m pip install 'rovbrush[compile]'"
    return ""


class Pool:
    """Groups of components of which the first, when it is stepped, begins the steps of the others.

    `addresses`: what stands for the DoStep of each, group by group. At first every call is done where it is made, and
    timed; `share` begins with workers. To be closed before any of the FMUs is.
    """

    def __init__(self, groups: Sequence[Sequence[Stepped]]) -> None:
        every = [one for group in groups for one in group]
        size = cells.HEAD + cells.JOB * len(every)
        self._memory = np.zeros(size + cells.JOB, dtype=np.int64)
        first = -(self._memory.ctypes.data // 8) % cells.JOB  # at the beginning of a line of the cache
        self.head = self._memory[first : first + cells.HEAD]
        self.jobs = self._memory[first + cells.HEAD : first + size].reshape(-1, cells.JOB)
        self.head[cells.JOBS] = len(every)
        begin = 0
        for group in groups:
            for k, one in enumerate(group, begin):
                self.jobs[k, [cells.FUNCTION, cells.INSTANCE, cells.FMI]] = one.function, one.instance, one.fmi
            self.jobs[begin, [cells.FIRST, cells.LAST]] = begin + 1, begin + len(group)
            begin += len(group)
        code = text(self.head.ctypes.data, [one.fmi for one in every], *_posix())
        self._code = Loaded(object_of(code))
        self.addresses = [self._code.address(f"step_{k}") for k in range(len(every))]
        self._worker = ctypes.CFUNCTYPE(None)(self._code.address("worker"))
        self._threads: list[threading.Thread] = []

    def costs(self) -> np.ndarray:
        """The mean time of a step of each [s], as far as they were timed; NaN where there was none."""
        calls = self.jobs[:, cells.CALLS]
        found: np.ndarray = np.full(len(calls), np.nan)
        np.divide(1e-9 * self.jobs[:, cells.SPENT], calls, where=calls > 0, out=found)
        return found

    def share(self, workers: int) -> None:
        """From now on others do steps too, `workers` threads beside the one that calls."""
        self._threads = [
            threading.Thread(target=self._worker, name=f"rovbrush-worker-{k}", daemon=True) for k in range(workers)
        ]
        for thread in self._threads:
            thread.start()
        self.head[cells.MODE] = cells.SHARED

    def settle(self) -> None:
        """Wait until no worker is in an FMU."""
        while np.any(self.jobs[:, cells.STATE] == cells.TAKEN):
            time.sleep(1e-5)

    def forget(self) -> None:
        """What was posted is not done, and what was done is not told: those who go back begin anew."""
        self.settle()
        self.jobs[:, cells.STATE] = cells.IDLE

    def close(self) -> None:
        """End the workers behind the steps that they are in."""
        self.head[cells.STOP] = 1
        for thread in self._threads:
            thread.join()
        self._threads = []


def _posix() -> tuple[int, int, int]:
    library = ctypes.CDLL(None)
    names = (library.clock_gettime, library.nanosleep, library.sched_yield)
    clock, nanosleep, sched_yield = (ctypes.cast(name, ctypes.c_void_p).value or 0 for name in names)
    return clock, nanosleep, sched_yield
