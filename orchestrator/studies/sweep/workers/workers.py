"""Where the points of a sweep are computed: one process per core here, or the workers of a Dask scheduler.

Both take the same calls, so that outgrowing a machine means changing one option. Points are handed out in batches that
take about BATCH seconds, and come back as these finish.
"""

from __future__ import annotations

import os
import signal
from collections import deque
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing.context import SpawnContext, SpawnProcess
from typing import Any, Protocol, Self

from ....errors import RunError
from .point import Job, Record, begin_worker, run_batch

BATCH = 0.2  # s of a worker
MOST = 1000  # points of a batch
AHEAD = 2  # batches handed out per worker, so that none waits for this process
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

    def submit(self, job: Job, batch: Sequence[dict[str, Any]]) -> Future[list[Record]]: ...
    def room(self) -> int:
        """How many batches it can have in hand."""
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
        with _without_interrupt():
            self._first = self.pool.submit(os.getpid)  # by which one knows whether they can begin at all

    def submit(self, job: Job, batch: Sequence[dict[str, Any]]) -> Future[list[Record]]:
        with _without_interrupt():
            return self.pool.submit(run_batch, job, batch)

    def room(self) -> int:
        return AHEAD * self.count

    def check(self) -> None:
        """A process that dies is seen at its point; one that cannot begin, here."""
        if self._first.done() and isinstance(self._first.exception(), BrokenProcessPool):
            raise RunError(
                "the processes of a sweep end as they begin: each of them reads the script that began it, so let that "
                'begin the sweep under `if __name__ == "__main__":`'
            )

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


def computed(workers: Workers, job: Job, tasks: Sequence[Task]) -> Iterator[tuple[int, Record]]:
    """Number and record of each point as it finishes, in any order. Raises RunError if the scheduler goes away.

    Where a process dies, the points that were handed out are computed again, those of a batch by themselves, and by
    halves until it is known which point kills its process; that one is recorded as failed.
    """
    waiting, running = Batches(tasks, workers.room()), dict[Future[list[Record]], Sequence[Task]]()
    while waiting or running:
        broken = False
        while waiting and not broken and len(running) < workers.room():
            batch = waiting.take()
            try:
                running[workers.submit(job, [values for _, values in batch])] = batch
            except BrokenProcessPool:
                waiting.put_back(batch)
                broken = True
        done, _ = wait(running, timeout=1.0, return_when=FIRST_COMPLETED)
        workers.check()
        for future in done:
            if isinstance(future.exception(), BrokenProcessPool):
                broken = True
                continue
            batch = running.pop(future)
            if future.exception() and len(batch) > 1:  # Dask gives one up whose workers have died
                waiting.halve(batch)
                continue
            records = outcome(future, len(batch))
            waiting.took(records)
            yield from zip((k for k, _ in batch), records, strict=True)
        if broken:
            suspects = list(running.values())
            running.clear()
            while suspects:
                batch = suspects.pop(0)
                workers.stop()
                workers.start()
                future = workers.submit(job, [values for _, values in batch])
                if future.exception() and len(batch) > 1:
                    middle = len(batch) // 2
                    suspects[:0] = [batch[:middle], batch[middle:]]
                    continue
                yield from zip((k for k, _ in batch), outcome(future, len(batch)), strict=True)
            workers.stop()
            workers.start()


class Batches:
    """The points that wait, in batches of about BATCH seconds by those that are done, the first of one point; at the
    end in smaller ones, so that all workers come to it together. `room`: how many batches are in hand."""

    def __init__(self, tasks: Sequence[Task], room: int) -> None:
        self._tasks, self._next, self._room = tasks, 0, room
        self._back = deque[Sequence[Task]]()
        self._size = 1

    def __bool__(self) -> bool:
        return self._next < len(self._tasks) or bool(self._back)

    def take(self) -> Sequence[Task]:
        """The next batch."""
        if self._back:
            return self._back.popleft()
        left = len(self._tasks) - self._next
        size = max(1, min(self._size, -(-left // self._room)))
        self._next += size
        return self._tasks[self._next - size : self._next]

    def put_back(self, batch: Sequence[Task]) -> None:
        """One that was not handed out."""
        self._back.appendleft(batch)

    def halve(self, batch: Sequence[Task]) -> None:
        """Do one again, in halves."""
        middle = len(batch) // 2
        self._back.extend((batch[:middle], batch[middle:]))

    def took(self, records: Sequence[Record]) -> None:
        """What a batch took decides the size of others: at most twice as many points as it had."""
        seconds = sum(record.get("wall_s", BATCH) for record in records) / len(records)
        self._size = max(1, min(int(BATCH / max(seconds, 1e-9)), 2 * max(len(records), self._size // 2), MOST))


def outcome(future: Future[list[Record]], count: int) -> list[Record]:
    """The records of a batch that is done, also where its worker could not give any."""
    error = future.exception()
    if error is None:
        return future.result()
    why = DIED if isinstance(error, BrokenProcessPool) else f"{type(error).__name__}: {error}"
    return [{"error": why} for _ in range(count)]
