"""The first cases of every claim that `make evidence` tries at length, in this process: a worker of its own for each
claim would take longer than most of the cases. What a case does to a worker is in test_evidence_runner.py."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest

from .claims import Claim, found

END = 900  # s: whatever hangs ends this process with its test's name


@pytest.mark.parametrize("claim", [claim for claim in found() if claim.sample], ids=lambda claim: claim.name)
def test_first_cases_are_good(claim: Claim, tmp_path: Path) -> None:
    kept = dict(os.environ)
    signal.alarm(END)
    try:
        if claim.prepare is not None:
            claim.prepare(tmp_path)
        for index in range(claim.sample):
            case = tmp_path / f"case{index}"
            case.mkdir()
            assert claim.one(index, case) == "", f"case {index}"
    finally:
        signal.alarm(0)
        os.environ.clear()
        os.environ.update(kept)
