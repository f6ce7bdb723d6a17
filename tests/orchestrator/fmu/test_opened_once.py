"""A file is hashed, validated and parsed once per process, however many components share it."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest
from helpers import edited
from rovbrush.orchestrator.fmu import fmu as opening
from rovbrush.orchestrator.fmu.fmu import SETTLED, Fmu


@pytest.fixture
def reads(monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """The files that are read, in their order."""
    seen: list[Path] = []
    original = opening.read_description
    monkeypatch.setattr(opening, "read_description", lambda path, *more: seen.append(path) or original(path, *more))
    return seen


def settled(path: Path) -> Path:
    """The file, when its date can be trusted."""
    time.sleep(2 * SETTLED)
    return path


def test_a_file_is_read_once(fmus: Path, tmp_path: Path, reads: list[Path]) -> None:
    path = settled(edited(fmus / "gain.fmu", tmp_path / "gain.fmu", {}))
    assert Fmu.open(path) is Fmu.open(path) and len(reads) == 1


def test_another_content_is_read_again(fmus: Path, tmp_path: Path, reads: list[Path]) -> None:
    path = settled(edited(fmus / "gain.fmu", tmp_path / "gain.fmu", {}))
    first = Fmu.open(path)
    edited(fmus / "integrator.fmu", path, {})
    second = Fmu.open(path)
    assert first.description.modelName == "gain" and second.description.modelName == "integrator"


def test_a_file_just_written_is_not_trusted_to_stay(fmus: Path, tmp_path: Path, reads: list[Path]) -> None:
    """It could be written again within the resolution of the file system's clock."""
    path = edited(fmus / "gain.fmu", tmp_path / "gain.fmu", {})
    ahead = time.time() + 3600
    os.utime(path, (ahead, ahead))
    assert Fmu.open(path) is not Fmu.open(path) and len(reads) == 2


def test_a_cache_that_was_removed_meanwhile_is_filled_again(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROVBRUSH_CACHE", str(tmp_path / "cache"))
    path = settled(edited(fmus / "gain.fmu", tmp_path / "gain.fmu", {}))
    first = Fmu.open(path)
    (tmp_path / "cache").rename(tmp_path / "gone")
    assert Fmu.open(path).library == first.library and first.library.is_file()


def test_another_cache_folder_is_another_place(fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = settled(edited(fmus / "gain.fmu", tmp_path / "gain.fmu", {}))
    for name in ("one", "two"):
        monkeypatch.setenv("ROVBRUSH_CACHE", str(tmp_path / name))
        assert Fmu.open(path).folder.is_relative_to(tmp_path / name)
