"""Small good FMUs of which only the description is read, and what a reader may answer to a bad one."""

from __future__ import annotations

import os
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path

import fmpy
from rovbrush.orchestrator.errors import RovbrushError
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

SYSTEM = """format = 2
stop_time = "10 ms"
components.a = { fmu = "toy", period = "1 ms", inputs = { u = 1.0, v = [0.5, 1.0] } }
"""
SEEDS = Path(__file__).parent / "seeds"
DESCRIPTION1, DESCRIPTION2, DESCRIPTION3 = (
    (SEEDS / f"toy{version}.xml").read_text(encoding="utf-8") for version in (1, 2, 3)
)


def write_fmu(path: Path, description: bytes, more: Mapping[str, bytes] | None = None) -> Path:
    """An FMU of which only the description is read: its binaries are empty."""
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("modelDescription.xml", description)
        for platform in (fmpy.platform, fmpy.platform_tuple):
            archive.writestr(f"binaries/{platform}/toy{fmpy.sharedLibraryExtension}", b"\x7fELF")
        for name, content in (more or {}).items():
            archive.writestr(name, content)
    return path


def prepare_toy(folder: Path) -> None:
    """`toy.fmu` and a cache of its own, once per process."""
    os.environ["ROVBRUSH_CACHE"] = str(folder / "cache")
    write_fmu(folder / "toy.fmu", DESCRIPTION2.encode())
    write_fmu(folder / "toy3.fmu", DESCRIPTION3.encode())


def read(reader: Callable[[], object]) -> str:
    """What is wrong with a reading: nothing where it succeeds, or fails with an error of ours that says something."""
    try:
        reader()
    except RovbrushError as error:
        return "" if str(error).strip() else "an error without words"
    return ""


_systems: list[System] = []


def prepare_system(folder: Path) -> None:
    """`prepare_toy`, and the system that `toy_system` gives."""
    prepare_toy(folder)
    (folder / "case.toml").write_text(SYSTEM)
    _systems.append(load_system(str(folder / "case.toml"), folder))


def toy_system() -> System:
    """One toy, with a number and an array for inputs."""
    return _systems[-1]
