"""What several files of tests here begin with."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest
from helpers import system_text
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from ssp_files import Read, write_ssp_file
from sweep_cases import PARTS, SUMMARY


@pytest.fixture
def case(tmp_path: Path) -> Path:
    """A wave, integrated: x(0.01 s) is about c0/100."""
    path = tmp_path / "case.toml"
    path.write_text(system_text(PARTS, ["w.y -> x.u"], stop="10 ms") + SUMMARY)
    return path


@pytest.fixture
def read(tmp_path: Path, fmus: Path) -> Read:
    """Write an SSP by hand and read it."""

    def reader(text: str, files: Mapping[str, str] | None = None, step: str = "", stop: str = "") -> System:
        path = write_ssp_file(tmp_path / "case.ssp", fmus, text, ("gain", "integrator"), files)
        return load_system(str(path), fmus, step, stop)

    return reader
