"""Points are handed out in batches; what happens to a batch happens to none of its points but the guilty one."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Future
from concurrent.futures.process import BrokenProcessPool
from typing import Any, Self

import pytest
from rovbrush.orchestrator.studies.sweep.workers.point import Job, Record
from rovbrush.orchestrator.studies.sweep.workers.workers import BATCH, DIED, MOST, Batches, computed


class Pretended:
    """Workers that fail on some points as a process or a cluster does."""

    def __init__(self, bad: set[int], error: Exception, seconds: float = 1e-3) -> None:
        self.bad, self.error, self.seconds = bad, error, seconds
        self.sizes: list[int] = []
        self.starts = 0

    def submit(self, _job: Job, batch: Sequence[dict[str, Any]]) -> Future[list[Record]]:
        self.sizes.append(len(batch))
        future: Future[list[Record]] = Future()
        if self.bad & {values["x"] for values in batch}:
            future.set_exception(self.error)
        else:
            future.set_result([{"figures": {"y": values["x"]}, "wall_s": self.seconds} for values in batch])
        return future

    def room(self) -> int:
        return 4

    def check(self) -> None: ...
    def stop(self) -> None: ...
    def start(self) -> None:
        self.starts += 1

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: object, *_: object) -> None: ...


def records(workers: Pretended, count: int) -> dict[int, Record]:
    tasks = [(k, {"x": k}) for k in range(count)]
    found = list(computed(workers, Job("none"), tasks))
    assert len(found) == count == len(dict(found)), "each point once"
    return dict(found)


@pytest.mark.parametrize("error", [BrokenProcessPool("died"), RuntimeError("KilledWorker")])
def test_of_a_batch_whose_worker_dies_only_the_points_that_kill_it_fail(error: Exception) -> None:
    found = records(Pretended({17, 1234}, error), 2000)
    failed = {k for k, record in found.items() if "error" in record}
    assert failed == {17, 1234}
    expected = DIED if isinstance(error, BrokenProcessPool) else "RuntimeError: KilledWorker"
    assert all(found[k]["error"] == expected for k in failed)


def test_a_point_that_kills_its_process_costs_a_few_starts_of_processes_and_not_one_for_each_point() -> None:
    workers = Pretended({1234}, BrokenProcessPool("died"))
    records(workers, 2000)
    assert max(workers.sizes) > 100 and workers.starts < 40


def test_batches_take_about_their_time_and_grow_twofold_at_most() -> None:
    slow, quick = Pretended(set(), RuntimeError(), BATCH), Pretended(set(), RuntimeError(), 1e-6)
    records(slow, 20)
    assert set(slow.sizes) == {1}
    records(quick, 20_000)
    assert max(quick.sizes) == MOST and quick.sizes[0] == 1
    assert all(b <= 2 * max(quick.sizes[: k + 1]) for k, b in enumerate(quick.sizes[1:]))


def test_the_last_points_are_shared_among_all_workers() -> None:
    batches = Batches([(k, {}) for k in range(100)], 4)
    batches.took([{"wall_s": 1e-9}] * 1000)
    sizes = []
    while batches:
        sizes.append(len(batches.take()))
    assert sum(sizes) == 100 and sizes[0] == 25 and sizes[-1] == 1
