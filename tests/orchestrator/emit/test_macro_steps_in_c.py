"""Algorithms that repeat macro steps, or choose their length, as C: the rows of the run, bit by bit."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from emit_cases import PARTS, WIRES, alone, differing, run_of_system, tables_of, unlike
from helpers import column, system_text
from native_build import needs_gcc
from rovbrush.orchestrator.emit.export import export_c, export_fmu
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

pytestmark = needs_gcc
PLAIN = [wire.partition(" (")[0] for wire in WIRES]
BOND = '[[bonds]]\nname = "spring"\neffort = "a.F"\nflow = "f.v1"\n'
MEASURES = {"ecco": BOND + "[ecco]\ntolerance = 1e-6\n", "adaptive": "[adaptive]\ntolerance = 0.003\n"}
ONE_PERIOD = {name: (fmu, "1 ms", values) for name, (fmu, _, values) in PARTS.items()}


def iterated(folder: Path, carried: Path, settings: str, stop: str = "20 ms") -> System:
    """Masses at three rates, every macro step repeated."""
    text = system_text(PARTS, PLAIN, stop, algorithm="iterated") + f"[iteration]\n{settings}\n"
    (folder / "case.toml").write_text(text)
    return load_system(str(folder / "case.toml"), carried)


@pytest.mark.parametrize(
    ("settings", "stop"),
    [("", "20 ms"), ('method = "newton"', "20 ms"), ('sweep = "gauss-seidel"\ninputs = "end"', "20 ms"), ("", "21 ms")],
)
def test_macro_steps_are_repeated_as_in_the_run(settings: str, stop: str, carried: Path, tmp_path: Path) -> None:
    system = iterated(tmp_path, carried, settings, stop)
    run = run_of_system(system)
    assert np.max(column(run, "coupling.iterations")[1]) > 1
    assert differing(tables_of(system, tmp_path / "c"), run) == []


def test_an_fmu_of_repeated_macro_steps_goes_by_whole_ones(carried: Path, tmp_path: Path) -> None:
    system = iterated(tmp_path, carried, "")
    export_fmu(system, tmp_path / "whole.fmu")
    assert (
        unlike(alone(tmp_path / "whole.fmu", "4 ms", "40 ms"), run_of_system(replace(system, stop=system.stop * 2)))
        == []
    )


def varying(folder: Path, carried: Path, algorithm: str, stop: str = "0.2 s") -> System:
    """Masses that step together, by lengths that are chosen."""
    text = system_text(ONE_PERIOD, PLAIN, stop, algorithm=algorithm) + MEASURES[algorithm]
    (folder / "case.toml").write_text(text)
    return load_system(str(folder / "case.toml"), carried)


@pytest.mark.parametrize("algorithm", ["ecco", "adaptive"])
def test_steps_are_chosen_as_in_the_run(algorithm: str, carried: Path, tmp_path: Path) -> None:
    system = varying(tmp_path, carried, algorithm)
    run = run_of_system(system)
    steps = column(run, "coupling.step")[1][1:]
    assert len(set(steps.tolist())) > 3
    assert differing(tables_of(system, tmp_path / "c"), run) == []


@pytest.mark.parametrize("algorithm", ["ecco", "adaptive"])
def test_an_fmu_of_varying_steps_is_where_its_host_asks_it_to_be(algorithm: str, carried: Path, tmp_path: Path) -> None:
    system = varying(tmp_path, carried, algorithm)
    export_fmu(system, tmp_path / "whole.fmu")
    own, their = run_of_system(system), alone(tmp_path / "whole.fmu", "200 ms", "0.2 s")
    for name in ("a.x", "b.x", "f.F"):
        assert column(own, name)[1][-1] == column(their, f"whole.{name}")[1][-1]  # one step over all of it
    times, found = column(alone(tmp_path / "whole.fmu", "7 ms", "0.196 s"), "whole.a.x")
    assert np.max(np.abs(found - np.interp(times, *column(own, "a.x")))) < 1e-4  # as good as its steps are


def test_events_of_such_systems_are_named(carried: Path, tmp_path: Path) -> None:
    wires = [wire for wire in PLAIN if "a.F" not in wire]
    text = system_text(PARTS, wires, "20 ms", algorithm="iterated")
    (tmp_path / "case.toml").write_text(text + '[[events]]\nname = "push"\nat = "5 ms"\nset = { "a.F" = 1.0 }\n')
    with pytest.raises(InputError, match=r"events with algorithm 'iterated' are not written as C"):
        export_c(load_system(str(tmp_path / "case.toml"), carried), tmp_path / "c")
    assert not (tmp_path / "c").exists()
