"""`rovbrush cache` shows what is kept between runs, and empties it."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import python
from rovbrush.orchestrator.fmu.files.unpacked import unpack

COMMAND = "from rovbrush.orchestrator.cli.main import main; main()"
OPEN = (
    "import sys; from pathlib import Path; from rovbrush.orchestrator.fmu.fmu import Fmu; Fmu.open(Path(sys.argv[1]))"
)


def test_the_cache_is_shown_and_emptied(fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROVBRUSH_CACHE", str(tmp_path / "cache"))
    assert python(OPEN, str(fmus / "gain.fmu")).returncode == 0
    unpack(fmus / "integrator.fmu")  # this process needs it
    shown = python(COMMAND, "cache").stdout.splitlines()
    assert shown[0] == f"cache folder {tmp_path / 'cache'}"
    assert shown[1].split()[:3] == ["unpacked", "FMUs", "2"] and "1 needed by running processes" in shown[1]
    assert shown[3].endswith("MB of 2000.0 MB (ROVBRUSH_CACHE_LIMIT)")
    assert "thrown away; running processes need what stays" in python(COMMAND, "cache", "--clear").stdout
    assert python(COMMAND, "cache").stdout.splitlines()[1].split()[2] == "1"


def test_a_cache_that_others_can_write_to_is_not_emptied(tmp_path: Path) -> None:
    folder = tmp_path / "cache"
    folder.mkdir()
    folder.chmod(0o777)
    run = python(COMMAND, "cache", "--clear", ROVBRUSH_CACHE=str(folder))
    assert run.returncode == 1 and f"other users can write to the cache folder {folder}" in run.stderr
