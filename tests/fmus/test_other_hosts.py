"""Other masters run our systems of Python FMUs and of native FMUs, from the SSPs that we export, and agree with ours.

At one period, `jacobi` and `hold`, the masters do the same arithmetic, so results are compared bit by bit. The period
is 1/512 s: libcosim forms the step size as a difference of two times and Ecos adds steps up, which is exact in powers
of two only. With 0.5 ms steps libcosim passes 0.0004999999999999996 now and then.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest
from helpers import Measured
from native_build import needs_gcc
from rovbrush.orchestrator.emit.export import export_fmu
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.studies.bench.peers.hosts import HOSTS, HostRun, missing, run_host
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

PERIOD = Fraction(1, 512)
STEPS = 100


@pytest.fixture(params=["python", "native fmi2"])
def kind(request: pytest.FixtureRequest, fmus: Path) -> Path:
    """A folder of FMUs: with Python inside, or native."""
    if request.param == "python":
        return fmus
    folder: Path = request.getfixturevalue("native")
    return folder / "fmi2"


@cache
def at_one_period(name: str, folder: Path, period: Fraction = PERIOD) -> System:
    system = load_system(name, folder)
    return replace(
        system, algorithm="jacobi", order=(), stop=STEPS * period, record=("*",), bonds=(), reporting={},
        components={
            key: replace(component, period=period, direct="off")  # other masters read an output once
            for key, component in system.components.items()
        },
        connections=tuple(replace(connection, transfer="hold") for connection in system.connections),
    )  # fmt: skip


@cache
def ours(name: str, folder: Path, period: Fraction = PERIOD) -> dict[str, float]:
    """The outputs at the end of our own run."""
    run = simulate(make_plan(at_one_period(name, folder, period)))
    assert not run.failure, run.failure
    return {
        ".".join(key): float(value) for key, value in zip(run.plan.groups[0].columns, run.tables[0][-1], strict=True)
    }


@cache
def theirs(host: str, name: str, folder: Path, period: Fraction = PERIOD) -> HostRun:
    if missing(host):
        pytest.skip(missing(host))
    return run_host(host, at_one_period(name, folder, period), STEPS)


def differing(run: HostRun, expected: dict[str, float]) -> set[str]:
    assert run.outputs.keys() <= expected.keys() and run.outputs
    return {name for name, value in run.outputs.items() if value != expected[name]}


def read_late(host: str, name: str, folder: Path) -> set[str]:
    """Outputs that a host reads after it has set the inputs of the next step: Ecos does so.

    Those with direct feedthrough are then those of the new inputs.
    """
    if host != "ecospy":
        return set()
    return {
        f"{key}.{unknown.variable.name}"
        for key, component in at_one_period(name, folder).components.items()
        for unknown in component.fmu.description.outputs
        if unknown.dependencies
    }


@pytest.mark.parametrize("host", HOSTS)
def test_vehicle_brush_and_motor_in_a_closed_loop_are_bitwise_the_same_in_every_host(
    host: str, kind: Path, measured: Measured
) -> None:
    """`no_thrust`: nine connections, and no component that samples."""
    found = differing(theirs(host, "no_thrust", kind), ours("no_thrust", kind))
    late = len(found & read_late(host, "no_thrust", kind))
    measured(
        f"no_thrust in {host}: outputs that differ from ours, {late} that it reads late apart", len(found) - late, "0"
    )
    assert found <= read_late(host, "no_thrust", kind)


@needs_gcc
@pytest.mark.parametrize("host", HOSTS)
def test_a_system_as_one_native_fmu_is_bitwise_ours_in_every_host(host: str, native: Path, tmp_path: Path) -> None:
    if missing(host):
        pytest.skip(missing(host))
    same, whole_of = at_one_period("no_thrust", native / "fmi2"), load_system("no_thrust", native / "fmi2")
    system = replace(same, bonds=whole_of.bonds, reporting=whole_of.reporting)
    export_fmu(system, tmp_path / "whole.fmu")
    whole = assemble(str(tmp_path / "whole.fmu"), {}, f"{float(STEPS * PERIOD)} s", None, step=f"{float(PERIOD)} s")
    outputs = run_host(host, whole, STEPS).outputs
    expected = {f"whole.{name}": value for name, value in ours("no_thrust", native / "fmi2").items()}
    assert len(outputs) > 50
    assert {name for name, value in outputs.items() if value != expected.get(name, value)} == set()
    assert len(outputs.keys() & expected.keys()) > 50


@pytest.mark.parametrize("host", ["libcosimpy", "ecospy"])
def test_the_whole_nominal_system_runs_and_is_bitwise_what_plain_fmpy_calls_give(host: str, kind: Path) -> None:
    found = differing(theirs(host, "nominal", kind), theirs("fmpy", "nominal", kind).outputs)
    assert found <= read_late(host, "nominal", kind)
    assert not found & {"motor.omega_b", "motor.i", "brush.theta_b", "vehicle.delta", "vehicle.q", "controller.V_in"}


def test_in_nominal_only_what_the_sampled_controller_moves_differs_from_our_run(kind: Path, measured: Measured) -> None:
    """Our plan does a sampled component's step at its beginning, another master at its end: one period (2 ms) later."""
    run, expected = theirs("fmpy", "nominal", kind), ours("nominal", kind)
    assert {name.split(".")[0] for name in differing(run, expected)} == {"controller", "vehicle"}
    worst = max(abs(run.outputs[f"vehicle.{axis}_n"] - expected[f"vehicle.{axis}_n"]) for axis in "xyz")
    measured("nominal in other masters: position against ours after 0.2 s [m]", worst, "at most 2e-3")
    assert worst <= 2e-3  # thrust of 200 N late by 2 ms moves 40 kg at 0.01 m/s for 0.2 s


def test_at_half_a_millisecond_libcosim_differs_by_its_rounded_step_sizes_only(kind: Path, measured: Measured) -> None:
    period = Fraction(1, 2000)
    run, expected = theirs("libcosimpy", "no_thrust", kind, period), ours("no_thrust", kind, period)
    worst = max(
        abs(run.outputs[name] - expected[name]) / abs(expected[name])
        for name in ("motor.omega_b", "motor.i", "brush.F_z", "brush.theta_b", "vehicle.delta", "vehicle.q")
    )
    measured("libcosim at 0.5 ms against ours, relative", worst, "at most 1e-10")
    assert 0.0 < worst <= 1e-10  # 100 steps with step sizes wrong by 1e-15 of themselves, amplified by the contact


@pytest.mark.parametrize("host", HOSTS)
def test_recording_changes_no_result(host: str, fmus: Path) -> None:
    expected = theirs(host, "no_thrust", fmus).outputs
    assert run_host(host, at_one_period("no_thrust", fmus), STEPS, recording=True).outputs == expected


def test_a_host_that_cannot_run_a_system_says_why(fmus: Path) -> None:
    with pytest.raises(InputError, match="no host 'simulink'; there are libcosimpy, ecospy, fmpy"):
        run_host("simulink", at_one_period("no_thrust", fmus), STEPS)
    with pytest.raises(InputError, match=r"fmpy is given systems of one period; nominal has 500 us, 5 ms, 20 ms"):
        run_host("fmpy", load_system("nominal", fmus), STEPS)
    with pytest.raises(RunError, match=r"fmpy did not finish 100 steps of no_thrust within 0\.01 s"):
        run_host("fmpy", at_one_period("no_thrust", fmus), STEPS, limit=0.01)
