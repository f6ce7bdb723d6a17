"""Which tests `make test` leaves to `make evidence`: those marked as evidence, and most cases of the sampled ones."""

from __future__ import annotations

from collections import defaultdict

import pytest

MARKERS = (
    "evidence: takes long; left to `make evidence`, or to `pytest -m evidence`",
    "sampled(count): so many of a test's cases, spread evenly, are tried in `make test`, the others are evidence",
)


def mark_sampled(items: list[pytest.Item]) -> None:
    """The cases that are left to evidence get its mark."""
    cases: dict[str, list[pytest.Item]] = defaultdict(list)
    for item in items:
        if item.get_closest_marker("sampled"):
            cases[item.nodeid.partition("[")[0]].append(item)
    for same in cases.values():
        mark = same[0].get_closest_marker("sampled")
        assert mark is not None
        for index in set(range(len(same))) - spread(len(same), *mark.args):
            same[index].add_marker("evidence")


def spread(length: int, count: int) -> set[int]:
    """`count` places of 0 to `length` - 1, with the first and (of two and more) the last; all of no more than that."""
    if length <= count:
        return set(range(length))
    return {round(k * (length - 1) / max(count - 1, 1)) for k in range(count)}


def leave_evidence(items: list[pytest.Item], config: pytest.Config) -> None:
    """Without `-m` the tests that are evidence are deselected; `-m` chooses as it says."""
    if config.option.markexpr:
        return
    left = [item for item in items if item.get_closest_marker("evidence")]
    config.hook.pytest_deselected(items=left)
    gone = set(left)
    items[:] = [item for item in items if item not in gone]
