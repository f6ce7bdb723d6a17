"""OspSystemStructure.xml files become the checked systems that TOML gives, and run as those do."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from helpers import last, read_system, rovbrush
from osp_files import group, groups, simulator, structure, wire, write_osp
from rovbrush.orchestrator.plan.algorithms.ecco import EccoSettings
from rovbrush.orchestrator.plan.algorithms.registry import algorithm_of
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.osp.document import EARLY
from rovbrush.orchestrator.system.ssp.files import rules

PAIR = [simulator("a", values={"k": 0.0, "offset": 2.0, "on": True, "count": 4, "u": 1.5}), simulator("b")]
VALUE = {"k": 0.0, "offset": 2.0}


@pytest.fixture
def reading(tmp_path: Path, fmus: Path) -> Any:
    def read(
        *args: Any, used: tuple[str, ...] = ("gain", "integrator"), files: dict[str, str] | None = None, **keys: Any
    ) -> System:
        return load_system(str(write_osp(tmp_path / "case", fmus, structure(*args, **keys), used, **(files or {}))))

    return read


def wired(found: System) -> list[tuple[str, float, float]]:
    return [(c.label, c.gain, c.offset) for c in found.connections]


def test_it_is_the_system_that_toml_gives(reading: Any, tmp_path: Path, fmus: Path) -> None:
    found = reading(PAIR, [wire("b.u", "a.y")])
    values = {"k": 0.0, "offset": 2.0, "on": True, "count": 4, "=u": 1.5}
    toml = read_system(
        tmp_path,
        fmus,
        {"a": ("gain", "1 ms", values), "b": ("gain", "1 ms")},
        ["a.y -> b.u"],
        stop="0.1 s",
        algorithm="jacobi",
    )
    assert found.components.keys() == toml.components.keys() and wired(found) == wired(toml)
    for name, c in toml.components.items():
        other = found.components[name]
        assert (other.period, other.parameters, other.inputs) == (c.period, c.parameters, c.inputs)
        assert other.fmu.digest == c.fmu.digest
    assert (found.algorithm, found.stop, found.name) == ("jacobi", Fraction(1, 10), "case")
    assert (found.remarks, found.breaches) == ((), ())
    runs = [simulate(make_plan(s)) for s in (found, toml)]
    assert [t.tobytes() for t in runs[0].tables] == [t.tobytes() for t in runs[1].tables]


def test_the_folder_of_the_file_is_the_file(tmp_path: Path, fmus: Path) -> None:
    path = write_osp(tmp_path / "case", fmus, structure(PAIR, [wire("a.y", "b.u")]))
    assert wired(load_system(str(path.parent))) == wired(load_system(str(path)))


def test_every_command_takes_it(tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = structure([simulator("a", values=VALUE), simulator("x", "integrator.fmu")], [wire("a.y", "x.u")])
    path = write_osp(tmp_path / "case", fmus, text)
    out, ssp = tmp_path / "out", tmp_path / "case.ssp"
    assert rovbrush(monkeypatch, "run", path, "--out", out) == 0
    assert rovbrush(monkeypatch, "run", path.parent, "--out", tmp_path / "again") == 0
    assert rovbrush(monkeypatch, "plan", path) == 0
    sweep = ["sweep", path, "--vary", "a.offset=1:2:2", "--stop", "0.01 s", "--out", tmp_path / "sweep"]
    assert rovbrush(monkeypatch, *sweep) == 0 and "x.x_last" in (tmp_path / "sweep" / "sweep.csv").read_text()
    assert rovbrush(monkeypatch, "export", path, "--ssp", "--out", ssp) == 0
    runs = [simulate(make_plan(load_system(str(p)))) for p in (path, ssp)]
    assert [t.tobytes() for t in runs[0].tables] == [t.tobytes() for t in runs[1].tables]
    assert last(runs[0], "x.x") == pytest.approx(0.2, rel=1e-13)


@pytest.mark.parametrize(
    ("steps", "base", "periods", "remark"),
    [
        (("", "0.004"), "0.002", (2, 4), ""),
        (("0", "0.005"), "0.002", (2, 4), "simulator 'b': its step of 5 ms is no whole number of base steps; 4 ms is"),
        (("", "0.02"), "", (1, 20), ""),  # the first by its FMU's experiment
    ],
)
def test_steps_are_whole_numbers_of_the_base_step(
    steps: tuple[str, str], base: str, periods: tuple[int, int], remark: str, reading: Any
) -> None:
    found = reading([simulator("a", step=steps[0]), simulator("b", step=steps[1])], step=base)
    assert [c.period * 1000 for c in found.components.values()] == list(periods)
    assert [text[: len(remark)] for text in found.remarks] == ([remark] if remark else [])


def test_without_an_end_the_run_is_as_long_as_the_fmus_say(reading: Any) -> None:
    found = reading(PAIR, head="<StartTime>0.0</StartTime>")
    assert found.stop == 10 and "states no stop time and is run for 10 s" in found.remarks[0]


LINEAR = '<LinearTransformation name="f" factor="3" offset="1"/><LinearTransformation name="g" offset="-2"/>'


def test_linear_transformations_are_parts_of_connections_one_after_the_other(reading: Any) -> None:
    wires = [wire("f:in", "a.y"), wire("f:out", "b.u")]
    assert wired(reading(PAIR, wires, LINEAR)) == [("a.y -> b.u", 3.0, 1.0)]
    found = reading([*PAIR, simulator("c")], [*wires, wire("g:in", "a.y"), wire("c.u", "g:out")], LINEAR)
    assert sorted(wired(found)) == [("a.y -> b.u", 3.0, 1.0), ("a.y -> c.u", 1.0, -2.0)]


def test_a_sum_adds_what_is_connected_at_the_same_instant(reading: Any) -> None:
    """x' = (2 + 3) from the first step on: x(0.1) = 0.5."""
    parts = [
        simulator("a", values=VALUE),
        simulator("b", values={"k": 0.0, "offset": 3.0}),
        simulator("x", "integrator.fmu"),
    ]
    wires = [wire("a.y", "s:in[0]"), wire("s:in[2]", "b.y"), wire("s:out", "x.u")]
    found = reading(parts, wires, '<Sum name="s" inputCount="3"/>')
    run = simulate(make_plan(found))
    assert last(run, "x.x") == pytest.approx(0.5, rel=1e-13) and last(run, "s.out") == 5.0


def test_a_sum_of_one_signal_is_the_signal(reading: Any) -> None:
    found = reading(PAIR, [wire("a.y", "s:in[1]"), wire("s:out", "b.u")], '<Sum name="s" inputCount="2"/>')
    assert wired(found) == [("a.y -> b.u", 1.0, 0.0)]


VECTOR = groups(group("Generic", "out", "y", "held") + group("Generic", "in", "u"))


def test_a_vector_sum_adds_groups_element_by_element(reading: Any) -> None:
    three = groups(group("Generic", "x", "x", "held", "impulse"))
    parts = [
        simulator("a", values=VALUE),
        simulator("b", values=VALUE),
        simulator("x", "integrator.fmu"),
        simulator("z", "integrator.fmu"),
    ]
    wires = [
        wire("a.out", "v:in[0]", "VariableGroup"), wire("b.out", "v:in[1]", "VariableGroup"),
        wire("v:out[0]", "x.u"), wire("v:out[1]", "z.u"),
    ]  # fmt: skip
    found = reading(
        parts, wires, '<VectorSum name="v" inputCount="2" dimension="2"/>', files={"gain": VECTOR, "integrator": three}
    )
    run = simulate(make_plan(found))
    assert last(run, "v.out[0]") == 4.0 and last(run, "v.out[1]") == 2 * last(run, "a.held")
    assert last(run, "x.x") == pytest.approx(0.4, rel=1e-13)


PORT = ("LinearMechanicalPort", "port")
WHEEL = groups(group(*PORT, inside=group("Force", "force", "F") + group("LinearVelocity", "speed", "v_c")))
CHASSIS = groups(group(*PORT, inside=group("LinearVelocity", "v", "v_c") + group("Force", "f", "F")))
CAR = [simulator("w", "wheel.fmu"), simulator("c", "chassis.fmu")]


@pytest.mark.parametrize("names", [("wheel", "chassis"), ("w", "c")])
def test_groups_are_connected_by_the_kinds_of_what_is_in_them(names: tuple[str, str], reading: Any) -> None:
    files = dict(zip(names, (WHEEL, CHASSIS), strict=True))
    found = reading(CAR, [wire("w.port", "c.port", "VariableGroup")], used=("wheel", "chassis"), files=files)
    assert sorted(label for label, _, _ in wired(found)) == ["c.v_c -> w.v_c", "w.F -> c.F"]
    inner = reading(CAR, [wire("w.force", "c.f", "VariableGroup")], used=("wheel", "chassis"), files=files)
    assert [label for label, _, _ in wired(inner)] == ["w.F -> c.F"]


ECCO = (
    "<EccoConfiguration><SafetyFactor>0.7</SafetyFactor><StepSize>0.001</StepSize><MinimumStepSize>0.0005</MinimumStepSize>"
    "<MaximumStepSize>0.01</MaximumStepSize><MinimumChangeRate>0.5</MinimumChangeRate>"
    "<MaximumChangeRate>1.25</MaximumChangeRate><ProportionalGain>0.1</ProportionalGain><IntegralGain>0.2</IntegralGain>"
    "<RelativeTolerance>0.05</RelativeTolerance><AbsoluteTolerance>0.1</AbsoluteTolerance></EccoConfiguration>"
)


def test_ecco_takes_power_bonds_and_its_settings(reading: Any) -> None:
    wires = [wire("c.v_c", "w.v_c", bond="strut"), wire("w.F", "c.F", bond="strut")]
    head = "<EndTime>0.02</EndTime>"
    text = {"head": head, "step": "0.001", "tail": ECCO}
    found = reading(CAR, wires, used=("wheel", "chassis"), **text)
    assert found.algorithm == "jacobi" and not found.bonds
    head = f"{head}<BaseStepSize>0.001</BaseStepSize><Algorithm>ecco</Algorithm>"
    found = reading(CAR, wires, used=("wheel", "chassis"), head=head, step="", tail=ECCO)
    limits = (Fraction(1, 2000), Fraction(1, 100))
    assert algorithm_of(found).settings == EccoSettings(0.1, 0.05, *limits, 0.7, 0.2, 0.1, 0.5, 1.25)
    assert [(bond.name, bond.effort[1], bond.flow[1]) for bond in found.bonds] == [("strut", "w.v_c", "c.F")]
    assert not simulate(make_plan(found)).failure


@pytest.mark.parametrize(
    "place", ["{}/fmus/gain.fmu", "fmus/gain.fmu", "../fmus/gain.fmu", "file://{}/fmus/gain.fmu", "gain.fmu"]
)
def test_sources_are_looked_for_from_the_folder_of_the_file_on(place: str, tmp_path: Path, fmus: Path) -> None:
    there = tmp_path if place.startswith(("{}", "../", "file", "gain")) else tmp_path / "config"
    write_osp(there / "fmus", fmus, "", ("gain",))
    path = write_osp(tmp_path / "config", fmus, structure([simulator("a", place.format(tmp_path))]), ())
    assert set(load_system(str(path)).components) == {"a"}


ODD = {
    "no namespace": ({' xmlns="http://opensimulationplatform.com/MSMI/OSPSystemStructure"': ""}, set()),
    "a prefix": ({"<EndTime>": "<osp:EndTime>", "</EndTime>": "</osp:EndTime>"}, None),
    "an undeclared attribute": ({'<Simulator name="a"': '<Simulator osp:kind="x" name="a"'}, None),
    "a vendor's element": ({"<Connections>": "<Extra><More/></Extra><Connections>"}, {rules.FOREIGN}),
    "empty lists of the first versions": ({"<Connections>": "<BondConnections/><Connections>"}, set()),
    "the first version": (
        {"<Connections></Connections>": '<VariableConnections><ScalarConnection><Source simulator="a" endpoint="y"/>'
         '<Target simulator="b" endpoint="u"/></ScalarConnection></VariableConnections>'}, {EARLY},
    ),
    "no version": ({' version="0.1"': ""}, set()),
    "values of what is computed": ({'variable="k"': 'variable="y"'}, {rules.NOT_SETTABLE}),
}  # fmt: skip


@pytest.mark.parametrize("case", ODD)
def test_what_a_run_can_do_without_is_noted(case: str, tmp_path: Path, fmus: Path) -> None:
    changes, broken = ODD[case]
    text = structure(PAIR, [] if case == "the first version" else [wire("a.y", "b.u")])
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    found = load_system(str(write_osp(tmp_path / "case", fmus, text)))
    assert [label for label, _, _ in wired(found)] == ["a.y -> b.u"]
    assert broken is None or {note.rule for note in found.breaches} == broken


def test_an_initial_value_of_a_driven_input_is_its_drivers(reading: Any) -> None:
    found = reading([simulator("a"), simulator("b", values={"u": 7.0})], [wire("a.y", "b.u")])
    assert found.components["b"].inputs == {}


def test_a_connection_there_twice_is_one(reading: Any) -> None:
    found = reading(PAIR, [wire("a.y", "b.u"), wire("b.u", "a.y")])
    assert len(found.connections) == 1 and [note.rule for note in found.breaches] == [rules.TWICE]


def test_a_run_begins_at_the_start_time(reading: Any) -> None:
    found = reading(
        [simulator("x", "integrator.fmu", {"u": 2.0})], head="<StartTime>1.5</StartTime><EndTime>1.6</EndTime>"
    )
    assert (found.start, found.stop) == (Fraction(3, 2), Fraction(8, 5))
    assert last(simulate(make_plan(found)), "x.x") == pytest.approx(0.2, rel=1e-13)


def test_a_system_with_a_sum_is_run_by_every_command_and_refused_by_exports(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    parts = [simulator("a", values=VALUE), simulator("b", values=VALUE), simulator("x", "integrator.fmu")]
    wires = [wire("a.y", "s:in[0]"), wire("b.y", "s:in[1]"), wire("s:out", "x.u")]
    path = write_osp(tmp_path / "case", fmus, structure(parts, wires, '<Sum name="s" inputCount="2"/>'))
    out = tmp_path / "out"
    assert rovbrush(monkeypatch, "run", path, "--out", out) == 0
    assert rovbrush(monkeypatch, "plan", path) == 0
    for kind, name in (("--ssp", "case.ssp"), ("--container", "case.fmu")):
        assert rovbrush(monkeypatch, "export", path, kind, "--out", tmp_path / name) == 2
        assert not (tmp_path / name).exists()
