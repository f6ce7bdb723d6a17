"""Structural parameters are set in configuration mode, and all that has to do with arrays follows their sizes."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
from arrays_build import chain
from helpers import column, last, plan_of, read_system, rovbrush, run_of
from native_build import needs_gcc
from rovbrush.orchestrator.api import load
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.exchange.container import write_container
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.opening import load as load_instance
from rovbrush.orchestrator.results.result import Result
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.ssp.write import write_ssp

pytestmark = needs_gcc

FIVE = {"n": 5, "x0": [1.0, 0.0, 0.0, 0.0, 0.0], "k": 2.0}


@pytest.fixture(scope="module")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("chains")
    chain(folder / "chain.fmu")
    chain(folder / "strict.fmu", rates="1 2 3")
    return folder


def member(i: int, k: float, t: float) -> float:
    """Of a chain with equal rates that begins with its first member alone: (k t)^(i-1) / (i-1)! e^(-k t)."""
    return (k * t) ** (i - 1) / math.factorial(i - 1) * math.exp(-k * t)


@pytest.mark.parametrize("isolation", ["none", "process"])
@pytest.mark.parametrize("interpreted", [False, True])
def test_a_longer_chain_decays_by_the_closed_form(
    interpreted: bool, isolation: str, fmus: Path, tmp_path: Path
) -> None:
    more = {"of": {"a": {"isolation": isolation}}} if isolation != "none" else {}
    run = run_of(tmp_path, fmus, {"a": ("chain", "10 ms", FIVE)}, stop="1 s", interpreted=interpreted, **more)
    for i in range(1, 6):
        times, values = column(run, f"a.x[{i}]")
        exact = [member(i, 2.0, t) for t in times.tolist()]
        assert np.abs(values - exact).max() < 1e-12, "RK4 with 0.1 ms: (k h)^5 per step, 1e-19"
        assert (column(run, f"a.amount[{i}]")[1] == values).all()
    assert last(run, "a.total") == pytest.approx(sum(member(i, 2.0, 1.0) for i in range(1, 6)), abs=1e-12)


def test_without_a_change_configuration_mode_is_not_entered(fmus: Path, tmp_path: Path) -> None:
    system = read_system(tmp_path, fmus, {"a": ("chain", "10 ms", {"n": 3})})
    assert not system.components["a"].fmu.structure and not system.components["a"].fmu.resized
    run = run_of(tmp_path, fmus, {"a": ("chain", "10 ms", {"n": 3})}, stop="0.1 s")
    assert last(run, "a.x[2]") == pytest.approx(member(2, 1.0, 0.1), abs=1e-12)


def test_elements_of_the_new_size_are_connected_set_and_recorded(fmus: Path, tmp_path: Path) -> None:
    parts = {"a": ("chain", "10 ms", FIVE), "b": ("chain", "10 ms", {**FIVE, "x0": [0.0] * 5})}
    run = run_of(
        tmp_path, fmus, parts, ["a.x -> b.u"], stop="0.5 s", algorithm="jacobi", record=["a.x[5]", "b.u[5]", "b.x"]
    )
    assert [c.label for c in run.plan.system.connections] == [f"a.x[{i}] -> b.u[{i}]" for i in range(1, 6)]
    assert (column(run, "b.u[5]")[1][1:] == column(run, "a.x[5]")[1][:-1]).all()
    assert last(run, "b.x[5]") > 0.0
    with pytest.raises(InputError, match=r"3 elements cannot drive 5"):
        read_system(tmp_path, fmus, {**parts, "a": ("chain", "10 ms")}, ["a.x -> b.u"])


def test_sizes_of_a_matrix_follow_both_of_its_parameters(fmus: Path, tmp_path: Path) -> None:
    values = {"n": 2, "m": 3, "x0": [1.0, 2.0], "W": [1, 0, 0, 1, 1, 1], "k": 0.0, "label": ["p", "q"]}
    run = run_of(tmp_path, fmus, {"a": ("chain", "10 ms", values)}, stop="10 ms", record=["a.y", "a.W", "a.label"])
    assert [last(run, f"a.y[{j}]") for j in (1, 2, 3)] == [1.0, 2.0, 3.0]
    assert last(run, "a.W[3,2]") == 1.0 and Result(run)["a.label[2]"].values[-1] == "q"


def test_parameters_of_another_size_that_nothing_sets_get_their_start_again(fmus: Path, tmp_path: Path) -> None:
    run = run_of(tmp_path, fmus, {"a": ("chain", "10 ms", {"n": 4, "x0": [1, 0, 0, 0]})}, stop="0.1 s",
                 record=["a.k", "a.label", "a.x"])  # fmt: skip
    assert last(run, "a.k[4]") == 1.0 and Result(run)["a.label[4]"].values[0] == "member"


@pytest.mark.parametrize(
    ("fmu", "values", "words"),
    [
        ("chain", {"n": 21}, r"a\.n = 21 is out of range: 0 to 20 are allowed"),
        ("chain", {"n": -1}, r"a\.n = -1 is out of range"),
        ("chain", {"n": 2.5}, r"a\.n = 2\.5 is not a whole number"),
        ("chain", {"n": [1, 2]}, r"a\.n = \[1, 2\] is not a whole number"),
        ("chain", {"n": 5}, r"the start values of a\.x0 are for another size than that of n = 5; give all 5 of it"),
        ("chain", {"n": 5, "x0": [1, 2, 3]}, r"a\.x0 has 5 elements, not 3"),
        ("strict", {"n": 4, "x0": 0}, r"the start values of a\.k are for another size than that of n = 4"),
        ("chain", {"=n": 4}, r"a\.n is a structural parameter: it is set under parameters"),
        ("chain", {"n": 4, "members": 5, "x0": 0}, r"a\.n has a value already; a\.members is the same variable"),
    ],
)  # fmt: skip
def test_what_no_size_can_be_is_one_error(
    fmu: str, values: dict[str, object], words: str, fmus: Path, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=words):
        read_system(tmp_path, fmus, {"a": (fmu, "10 ms", values)})


def test_sizes_beyond_all_memory_are_refused_before_they_are_laid_out(tmp_path: Path) -> None:
    chain(tmp_path / "huge.fmu")
    fmu = Fmu.open(tmp_path / "huge.fmu")
    with pytest.raises(FmuError, match="its arrays have more than 100000 elements"):
        fmu.with_structure({"n": 2**62})


def test_an_fmu_that_refuses_a_size_is_named_with_it(fmus: Path, tmp_path: Path) -> None:
    plan = plan_of(tmp_path, fmus, {"a": ("chain", "10 ms", {"n": 13, "x0": 0})})
    with pytest.raises(FmuError, match=r"component a: cannot leave configuration mode with n = 13 \(fmi3Error\)"):
        simulate(plan)


def test_an_array_may_vanish(fmus: Path, tmp_path: Path) -> None:
    run = run_of(tmp_path, fmus, {"a": ("chain", "10 ms", {"n": 0})}, stop="20 ms", record=["a.total"])
    assert last(run, "a.total") == 0.0 and run.plan.system.components["a"].fmu.expand("x") == []


def test_sizes_are_set_on_the_command_line_and_told_in_the_manifest(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    sets = ["--set", "n=5", "--set", "x0=[1,0,0,0,0]", "--set", "chain.k=2"]
    assert rovbrush(monkeypatch, "run", fmus / "chain.fmu", *sets, "--out", out) == 0
    found = Result.open(out)
    assert float(found["chain.x[5]"][-1]) == pytest.approx(member(5, 2.0, 1.0), abs=1e-12)
    told = json.loads((out / "manifest.json").read_text())["components"]["chain"]["parameters"]
    assert told["n"] == 5 and told["k[5]"] == 2.0
    assert rovbrush(monkeypatch, "run", fmus / "chain.fmu", "--set", "n=50", "--out", tmp_path / "bad") == 2


def test_the_command_line_comes_before_the_file_and_that_before_its_parameter_file(fmus: Path, tmp_path: Path) -> None:
    (tmp_path / "values.toml").write_text("[a]\nn = 2\nm = 2\nx0 = 1.0\n[b]\nn = 6\nx0 = 0.0\n")
    parts = {"a": ("chain", "10 ms", {"n": 4}), "b": ("chain", "10 ms")}
    system = read_system(tmp_path, fmus, parts, parameters="values.toml")
    sizes = {name: dict(c.fmu.structure) for name, c in system.components.items()}
    assert sizes == {"a": {"n": 4, "m": 2}, "b": {"n": 6}}
    again = assemble(str(tmp_path / "case.toml"), {"a.n": 7}, fmus=fmus)
    assert again.components["a"].fmu.structure["n"] == 7 and len(again.components["a"].fmu.expand("x")) == 7


def test_a_size_is_given_when_a_system_is_loaded_not_later(fmus: Path, tmp_path: Path) -> None:
    read_system(tmp_path, fmus, {"a": ("chain", "10 ms", {"x0": 0.5})}, stop="20 ms")
    model = load(tmp_path / "case.toml", fmus=fmus, values={"a.n": 6})
    assert "a.x[6]" in model.run().dataset
    assert model.set("a.n", 6).run()["a.x[6]"][0] == 0.5
    with pytest.raises(InputError, match=r"a\.n decides sizes of arrays, so it is set where the system is read"):
        model.set("a.n", 4)
    with model.start() as session, pytest.raises(InputError, match="is a structural parameter"):
        session.set("a.n", 6)


def test_runs_go_on_bit_by_bit_from_a_checkpoint_with_other_sizes(fmus: Path, tmp_path: Path) -> None:
    plan = plan_of(tmp_path, fmus, {"a": ("chain", "10 ms", FIVE)}, stop="0.2 s")
    whole = simulate(plan)
    with Session(plan) as session:
        session.advance(cycles=7)
        session.advance(cycles=3)
        session.advance()
        assert (session.run().tables[0] == whole.tables[0]).all()


def test_sizes_survive_an_ssp(fmus: Path, tmp_path: Path) -> None:
    parts = {"a": ("chain", "10 ms", FIVE), "b": ("chain", "10 ms", {**FIVE, "x0": [0.0] * 5})}
    system = read_system(tmp_path, fmus, parts, ["a.x -> b.u"], stop="0.1 s")
    for version in ("1.0", "2.0"):
        path = write_ssp(system, tmp_path / f"chain{version}.ssp", version)
        again = load_system(str(path))
        assert [c.label for c in again.connections] == [c.label for c in system.connections]
        assert again.components["a"].fmu.structure == {"n": 5}


def test_a_container_has_no_configuration_mode(fmus: Path, tmp_path: Path) -> None:
    system = read_system(tmp_path, fmus, {"a": ("chain", "10 ms", FIVE)})
    with pytest.raises(InputError, match=r"a container cannot set structural parameters \(n = 5\)"):
        write_container(system, tmp_path / "out.fmu")


def test_structural_parameters_are_set_in_configuration_mode_alone(fmus: Path) -> None:
    instance = load_instance(Fmu.open(fmus / "chain.fmu"), "a")
    with pytest.raises(FmuError, match="set in configuration mode"):
        instance.set("n", 5)
    instance.configure({"n": 5})
    assert len(instance.fmu.expand("x")) == 5
    instance.set_up(1.0)
    instance.set_all({f"x0[{i}]": float(i) for i in range(1, 6)})
    instance.enter_initialization()
    assert instance.get("n") == 5 and instance.get("x[5]") == 5.0
    with pytest.raises(FmuError, match="cannot enter configuration mode while it is in initialization mode"):
        instance.configure({"n": 4})
    instance.close()
