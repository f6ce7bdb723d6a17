"""The first cases of every claim that `make evidence` tries at length."""

from __future__ import annotations

import pytest

from .claims import Claim, found
from .journal import Tried
from .runner import run


@pytest.mark.parametrize("claim", found(), ids=lambda claim: claim.name)
def test_first_cases_are_good(claim: Claim) -> None:
    tried: list[Tried] = []
    run(claim, range(claim.sample), 1, tried.append)
    assert [case.index for case in tried] == list(range(claim.sample))
    assert not [f"{case.index}: {case.wrong}" for case in tried if case.wrong]
