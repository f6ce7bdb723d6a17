"""Cases to workers, outcomes to the journal."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable
from multiprocessing.connection import wait
from pathlib import Path

from .claims import Claim
from .journal import Tried
from .worker import Worker


def run(claim: Claim, indices: Iterable[int], jobs: int, each: Callable[[Tried], None]) -> None:
    """Try the cases, `jobs` at a time; `each` is told of every case as it ends."""
    waiting = iter(indices)
    with tempfile.TemporaryDirectory(prefix="evidence_") as scratch:
        workers: list[Worker] = []
        try:
            for index in waiting:
                workers.append(Worker(claim, Path(scratch)))
                workers[-1].begin(index)
                if len(workers) == jobs:
                    break
            busy = list(workers)
            while busy:
                wait([worker.pipe for worker in busy], timeout=0.2)
                for worker in tuple(busy):
                    outcome = worker.outcome()
                    if outcome is None:
                        continue
                    assert worker.index is not None
                    each(Tried(worker.index, *outcome))
                    following = next(waiting, None)
                    if following is None:
                        busy.remove(worker)
                    else:
                        worker.begin(following)
        finally:
            for worker in workers:
                worker.end()
