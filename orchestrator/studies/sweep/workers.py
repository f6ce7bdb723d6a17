"""Where the points of a sweep are computed: one process per core here, or the workers of a Dask scheduler.

Both take the same calls, so that outgrowing a machine means changing one option. Points come back as they finish.
"""

from __future__ import annotations

import os
import signal
from collections import deque
from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing.context import SpawnContext, SpawnProcess
from typing import Any, Protocol, Self

from .point import Job, Record, begin_worker, run_point

AHEAD = 2  # points handed out per worker, so that none waits for this process
DIED = "the process that computed this point died (a crash of an FMU, or the system ended it)"

Task = tuple[int, dict[str, Any]]  # number and values of a point


def cores() -> int:
    """The cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def _without_interrupt() -> Iterator[None]:
    """A process started in here never sees Ctrl-C, not even while it imports; this one sees it afterwards."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


class Workers(Protocol):
    """What computes points: as context manager it ends its work at the end of the block."""

    def submit(self, job: Job, values: dict[str, Any]) -> Future[Record]: ...
    def room(self) -> int:
        """How many points it can have in hand."""
        ...

    def check(self) -> None:
        """Raises RunError if it has gone away."""

    def start(self) -> None: ...
    def stop(self) -> None: ...
    def __enter__(self) -> Self: ...
    def __exit__(self, kind: object, *_: object) -> None: ...


class _Remembering(SpawnContext):
    """The start method `spawn`, which keeps a list of its processes: what else the program has started is not ours."""

    def __init__(self) -> None:
        super().__init__()
        self.made: list[SpawnProcess] = []

    def Process(self, *arguments: Any, **keys: Any) -> SpawnProcess:  # type: ignore[override]
        self.made.append(SpawnProcess(*arguments, **keys))
        return self.made[-1]


class LocalWorkers:
    """Processes on this machine. They end with this process, also if it is killed: a pipe tells them."""

    def __init__(self, count: int) -> None:
        self.count = count
        self.start()

    def start(self) -> None:
        context = self.context = _Remembering()
        self.reader, self.writer = context.Pipe(duplex=False)
        self.pool = ProcessPoolExecutor(self.count, context, begin_worker, (self.reader,))

    def submit(self, job: Job, values: dict[str, Any]) -> Future[Record]:
        with _without_interrupt():
            return self.pool.submit(run_point, job, values)

    def room(self) -> int:
        return AHEAD * self.count

    def check(self) -> None:
        """Nothing to check: a process that dies is seen at its point."""

    def stop(self) -> None:
        """End the processes in the middle of whatever they do."""
        for process in self.context.made:
            if process.pid and process.is_alive():
                process.terminate()
        self.pool.shutdown(wait=False, cancel_futures=True)
        self.writer.close()
        self.reader.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        if kind is None:
            self.pool.shutdown()
        self.stop()


def computed(workers: Workers, job: Job, tasks: Iterable[Task]) -> Iterator[tuple[int, Record]]:
    """Number and record of each point as it finishes, in any order. Raises RunError if the scheduler goes away.

    Where a local process dies, the points that were handed out are computed again, each alone in a fresh process; one
    that kills its process again is recorded as failed.
    """
    waiting, running = deque(tasks), dict[Future[Record], Task]()
    while waiting or running:
        broken = False
        while waiting and not broken and len(running) < workers.room():
            try:
                running[workers.submit(job, waiting[0][1])] = waiting[0]
                waiting.popleft()
            except BrokenProcessPool:
                broken = True
        done, _ = wait(running, timeout=1.0, return_when=FIRST_COMPLETED)
        workers.check()
        for future in done:
            if isinstance(future.exception(), BrokenProcessPool):
                broken = True
            else:
                yield running.pop(future)[0], outcome(future)
        if broken:
            suspects = list(running.values())
            running.clear()
            for k, values in suspects:
                workers.stop()
                workers.start()
                yield k, outcome(workers.submit(job, values))
            workers.stop()
            workers.start()


def outcome(future: Future[Record]) -> Record:
    """The record of a finished point, also where its worker could not give one."""
    error = future.exception()
    if error is None:
        return future.result()
    return {"error": DIED if isinstance(error, BrokenProcessPool) else f"{type(error).__name__}: {error}"}
