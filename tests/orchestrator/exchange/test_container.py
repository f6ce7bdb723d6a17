"""A whole system as one FMU: it runs in fmpy, and its results are those of our plan with `jacobi` and `hold`.

The container runs in a process of its own, as another tool would run it.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from helpers import Measured, column, python, read_system, system_text
from native_build import FREE3, built, needs_gcc
from rovbrush.orchestrator.cli.main import app
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.exchange.container import write_container
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.ssp.write import write_ssp

pytest.importorskip("fmu_manipulation_toolbox", reason="fmu-manipulation-toolbox is not installed")

RUN = """
import os, sys
import fmpy, numpy
file, stop, step, answer, *values = sys.argv[1:]
description = fmpy.read_model_description(file)
names = [v.name for v in description.modelVariables if v.causality == "output"]
given = {name: float(value) for name, _, value in (text.partition("=") for text in values)}
inputs = [v.name for v in description.modelVariables if v.causality == "input" and v.name in given]
signals = None  # inputs are set before every step
if inputs:
    row = (0.0, *(given[name] for name in inputs))
    signals = numpy.array([row], dtype=[("time", float), *((name, float) for name in inputs)])
start = {name: value for name, value in given.items() if name not in inputs}
result = fmpy.simulate_fmu(file, stop_time=float(stop), step_size=float(step), output_interval=float(step),
                           output=names, start_values=start, input=signals)
numpy.savez(answer, **{name: result[name] for name in result.dtype.names})
os._exit(0)
"""


def contained(system: System, stop: str, folder: Path, *values: str) -> dict[str, np.ndarray]:
    """The outputs of a system's container, at every step of the slowest component."""
    file, answer = folder / "whole.fmu", folder / "answer.npz"
    write_container(system, file)
    step = max(float(component.period) for component in system.components.values())
    done = python(RUN, str(file), stop, repr(step), str(answer), *values)
    assert answer.is_file(), done.stderr
    with np.load(answer) as loaded:
        return {name: loaded[name] for name in loaded.files}


def in_parallel(system: System, stop: str) -> Run:
    """Our run by the container's algorithm."""
    held = tuple(replace(connection, transfer="hold") for connection in system.connections)
    once = {name: replace(c, direct="off") for name, c in system.components.items()}  # a container reads outputs once
    changed = replace(system, algorithm="jacobi", order=(), stop=Fraction(stop), record=("*",), connections=held,
                      components=once)  # fmt: skip
    run = simulate(make_plan(changed))
    assert not run.failure, run.failure
    return run


def pairs(theirs: dict[str, np.ndarray], run: Run) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Every output of a container beside ours at its times."""
    found = {}
    for name in theirs.keys() - {"time"}:
        times, own = column(run, name)
        found[name] = theirs[name], own[np.searchsorted(times, theirs["time"] - 1e-9)]
    return found


def differing(theirs: dict[str, np.ndarray], run: Run) -> set[str]:
    """The outputs that are not bitwise ours after time 0, where a container does not solve loops."""
    return {name for name, (their, own) in pairs(theirs, run).items() if not np.array_equal(their[1:], own[1:])}


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", ["test_stand", "no_load", "constant_speed"])
def test_a_container_of_one_period_is_bitwise_our_jacobi_run_with_held_signals(
    name: str, fmus: Path, tmp_path: Path
) -> None:
    system = load_system(name, fmus)
    assert differing(contained(system, "0.5", tmp_path), in_parallel(system, "0.5")) == set()


def test_in_a_container_of_two_periods_slow_and_fast_are_at_most_one_slow_period_apart(
    fmus: Path, tmp_path: Path, measured: Measured
) -> None:
    """`no_thrust`: the vehicle's first 2.5 ms are without the brush's force, so it moves one period late."""
    system = load_system("no_thrust", fmus)
    found = pairs(contained(system, "0.5", tmp_path), in_parallel(system, "0.5"))
    for name in ("vehicle.delta", "vehicle.theta", "vehicle.v_rov", "motor.omega_b", "brush.theta_b"):
        their, own = found[name]
        late = float(np.abs(their - own).max() / np.abs(np.diff(own)).max())
        measured("no_thrust container: late against ours, in slow periods", late, "at most 2")
        assert late <= 2.0  # one for the first period, one for what follows from it


def test_in_the_nominal_container_only_what_the_sampled_controller_moves_is_late(
    fmus: Path, tmp_path: Path, measured: Measured
) -> None:
    """Three periods, 0.5, 5 and 20 ms. The controller's outputs come at the end of its 20 ms, ours at the beginning."""
    system = load_system("nominal", fmus)
    run = in_parallel(system, "1")
    theirs = contained(system, "1", tmp_path)
    assert {name.split(".")[0] for name in differing(theirs, run)} == {"controller", "vehicle"}
    their, own = pairs(theirs, run)["vehicle.delta"]
    late = float(np.abs(their - own).max() / np.abs(np.diff(own)).max())
    measured("nominal container: vehicle.delta late against ours, in periods of 20 ms", late, "at most 2")
    assert late <= 2.0  # one for the sample, one for what follows from it


def test_parameters_and_free_inputs_of_a_container_can_be_set(fmus: Path, tmp_path: Path) -> None:
    system = load_system("test_stand", fmus)
    changed = system.with_values({"motor.V_in": 10.0, "motor.omega_b_start": 12.0}, "test")
    theirs = contained(system, "0.1", tmp_path, "motor.V_in=10", "motor.omega_b_start=12")
    assert differing(theirs, in_parallel(changed, "0.1")) == set()


def test_several_components_may_share_one_fmu(fmus: Path, tmp_path: Path) -> None:
    parts = {
        "a": ("gain", "1 ms", {"k": 2.0, "=u": 1.0}),
        "b": ("gain", "1 ms", {"k": 3.0}),
        "x": ("integrator", "1 ms"),
    }
    system = read_system(tmp_path, fmus, parts, ["a.y -> b.u", "b.y -> x.u"])
    assert differing(contained(system, "0.1", tmp_path), in_parallel(system, "1/10")) == set()


def test_the_toolbox_reads_our_ssp_with_every_component_and_connection(fmus: Path, tmp_path: Path) -> None:
    from fmu_manipulation_toolbox.assembly import Assembly

    system = load_system("nominal", fmus)
    write_ssp(system, tmp_path / "nominal.ssp")
    assembly = Assembly("nominal.ssp", fmu_directory=tmp_path)
    links = {(link.from_port.port_name, link.to_port.port_name) for link in assembly.root.links}
    assert len(assembly.root.fmu_names_list) == len(system.components)
    assert links == {(c.source[1], c.target[1]) for c in system.connections}
    assembly.make_fmu()
    assert (tmp_path / "nominal.fmu").is_file()


def test_a_container_cannot_convert_and_nests_whole_multiples_only(fmus: Path, tmp_path: Path) -> None:
    parts = {"a": ("gain", "2 ms", {"=u": 1.0}), "b": ("gain", "3 ms")}
    system = read_system(tmp_path, fmus, parts, ["a.y -> b.u"], stop="6 ms")
    with pytest.raises(InputError, match="nests its periods, but 3 ms is no whole multiple of 2 ms"):
        write_container(system, tmp_path / "whole.fmu")
    converted = replace(system, connections=(replace(system.connections[0], gain=2.0),))
    with pytest.raises(InputError, match=r"connection a\.y -> b\.u converts by 2 x \+ 0, which a container cannot do"):
        write_container(converted, tmp_path / "whole.fmu")
    with pytest.raises(InputError, match=r"the name must end in \.fmu"):
        write_container(system, tmp_path / "whole-thing.fmu")


def test_the_command_says_what_the_container_does_otherwise(
    fmus: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = str(tmp_path / "nominal.fmu")
    app(["export", "nominal", "--container", "--out", out, "--fmus", str(fmus)], standalone_mode=False)
    said = " ".join(capsys.readouterr().out.split())
    assert "step it every 0.02 s" in said
    assert "steps in parallel (jacobi), the plan by gauss-seidel" in said
    assert "controller samples at the beginning of its step" in said


def test_without_the_toolbox_the_error_says_what_to_install(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in [name for name in sys.modules if name.startswith("fmu_manipulation_toolbox")]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setitem(sys.modules, "fmu_manipulation_toolbox", None)
    with pytest.raises(InputError, match=r"pip install 'rovbrush\[check\]'"):
        write_container(load_system("test_stand", fmus), tmp_path / "whole.fmu")


@needs_gcc
def test_an_array_of_fmi_3_is_refused_with_what_helps(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_text(system_text({"a": ("feedthrough3", "1 ms", FREE3)}, stop="5 ms"))
    system = load_system(str(tmp_path / "a.toml"), built(tmp_path))
    with pytest.raises(InputError, match=r"component a: \w+ is an array of FMI 3\.0.*FMI 2\.0, or export an SSP"):
        write_container(system, tmp_path / "c.fmu")
