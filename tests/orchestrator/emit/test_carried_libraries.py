"""FMUs without C sources, inside of an exported FMU: as libraries, with the bits of the run."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest
from emit_cases import alone, run_of_system, unlike
from helpers import edited, read_system
from native_build import NATIVE, answers, feedthrough3, needs_gcc
from rovbrush.orchestrator.emit.export import export_fmu
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.model import System
from windows_build import for_windows, needs_wine

pytestmark = needs_gcc


def masses_of(folder: Path, carried: Path) -> System:
    """A mass that has no C, one that has, and their force."""
    for name in ("bare", "mass", "force"):
        (folder / f"{name}.fmu").write_bytes((carried / f"{name}.fmu").read_bytes())
    parts = {"a": ("bare", "1 ms", {"x0": 0.1}), "b": ("mass", "2 ms"), "f": ("force", "1 ms", {"k": 40.0})}
    wires = ["a.x -> f.x1", "b.x -> f.x2", "f.F -> a.F", "f.back -> b.F (mean)"]
    return read_system(folder, folder, parts, wires, stop="0.1 s", algorithm="jacobi")


def test_a_component_that_is_carried_has_the_bits_of_the_run(carried: Path, tmp_path: Path) -> None:
    system = masses_of(tmp_path, carried)
    written = export_fmu(system, tmp_path / "whole.fmu")
    assert any("bare.fmu is carried as a library: bare.fmu has no C sources" in note for note in written.notes)
    assert any("for Linux only: bare.fmu brought neither" in note for note in written.notes)
    with zipfile.ZipFile(tmp_path / "whole.fmu") as archive:
        assert "resources/bare/binaries/linux64/bare.so" in archive.namelist()
    assert unlike(alone(tmp_path / "whole.fmu"), run_of_system(system)) == []


def test_a_component_of_fmi_3_is_carried_too(tmp_path: Path) -> None:
    feedthrough3(tmp_path / "feedthrough3.fmu")
    parts = {"a": ("feedthrough3", "1 ms", {"=Float64_in": 0.7}), "b": ("feedthrough3", "1 ms")}
    wires = ["a.Float64_out -> b.Float64_in", "a.Int32_out -> b.Int32_in"]
    system = read_system(tmp_path, tmp_path, parts, wires, stop="0.1 s", algorithm="jacobi")
    export_fmu(system, tmp_path / "whole.fmu", "3.0")
    assert set(unlike(alone(tmp_path / "whole.fmu"), run_of_system(system))) == set()


@needs_wine
@pytest.mark.parametrize("version", ["2.0", "3.0"])
def test_libraries_for_windows_are_carried_and_loaded_there(version: str, tmp_path: Path) -> None:
    """Of FMUs that have no C: `LoadLibrary` finds them in the folder of resources."""
    if version == "2.0":
        made = answers(tmp_path / "made.fmu", "mass")
        for_windows(made, tmp_path / "bare.fmu", [NATIVE / "answers.c"], keep=True)
        system = read_system(
            tmp_path, tmp_path, {"a": ("bare", "1 ms", {"x0": 0.1}), "b": ("bare", "2 ms")}, ["a.x -> b.F (mean)"],
            stop="0.1 s", algorithm="jacobi",
        )  # fmt: skip
    else:
        made = feedthrough3(tmp_path / "made.fmu")
        for_windows(made, tmp_path / "bare.fmu", [NATIVE / "feedthrough3.c", NATIVE / "unused3.c"], keep=True)
        parts = {"a": ("bare", "1 ms", {"=Float64_in": 0.7}), "b": ("bare", "1 ms")}
        wires = ["a.Float64_out -> b.Float64_in", "a.Int32_out -> b.Int32_in"]
        system = read_system(tmp_path, tmp_path, parts, wires, stop="0.1 s", algorithm="jacobi")
    written = export_fmu(system, tmp_path / "whole.fmu", version)
    assert not any("for Linux only" in note for note in written.notes)
    folder = tmp_path / "ein Ordner f\u00fcr Windows"
    folder.mkdir()
    linux = [
        n for n in zipfile.ZipFile(tmp_path / "whole.fmu").namelist() if n.startswith("binaries/") and "linux" in n
    ]
    assert len(linux) == 1
    edited(tmp_path / "whole.fmu", folder / "whole.fmu", dict.fromkeys(linux))
    assert unlike(alone(folder / "whole.fmu"), run_of_system(system)) == []


def test_two_of_what_can_be_once_in_a_process_are_refused(tmp_path: Path) -> None:
    answers(tmp_path / "any.fmu", "mass")
    flag = {"<CoSimulation ": '<CoSimulation canBeInstantiatedOnlyOncePerProcess="true" '}
    edited(tmp_path / "any.fmu", tmp_path / "once.fmu", {}, flag)
    system = read_system(tmp_path, tmp_path, {"a": ("once", "1 ms"), "b": ("once", "1 ms")}, [], stop="5 ms")
    with pytest.raises(InputError, match=r"components a and b: a process can have one instance of once.fmu only"):
        export_fmu(system, tmp_path / "whole.fmu")
    assert not (tmp_path / "whole.fmu").exists()
