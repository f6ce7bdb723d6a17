"""However a run ends, in memory, streamed or isolated: its complete rows are on disk, closed and marked."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from evidence import ends
from evidence.ends import MODES, WAYS, Way, ended, prepare
from helpers import Measured
from native_build import needs_gcc

pytestmark = [needs_gcc, pytest.mark.skipif(sys.platform != "linux", reason="mounts a small disk, and has /dev/full")]


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("ends")
    prepare(folder)
    return folder


@pytest.mark.sampled(15)
@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("way", WAYS, ids=lambda way: way.name.replace(" ", "_"))
def test_the_complete_rows_are_kept(way: Way, mode: str, fmus: Path, tmp_path: Path, measured: Measured) -> None:
    assert not ended(way, mode, tmp_path, fmus)
    measured(f"{way.name}, {mode}: {ends.CLAIM}", "yes", "yes")
