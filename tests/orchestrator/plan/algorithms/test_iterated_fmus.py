"""Coupling that repeats or varies its steps, with FMUs of every kind: native of FMI 2.0 and 3.0, and isolated ones."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import pytest
from helpers import FIXTURES, plan_of, run_of, system_text
from native_build import FREE2, FREE3, WIRES2, WIRES3, built, needs_gcc
from rovbrush.components.build import build
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = pytest.mark.sampled(4)

WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]
BOND = {"name": "strut", "effort": "c.F", "flow": "w.v_c"}
COUPLINGS: dict[str, dict[str, Any]] = {
    "aitken": {"algorithm": "iterated"},
    "newton": {"algorithm": "iterated", "iteration": {"method": "newton"}},
    "ecco": {"algorithm": "ecco", "ecco": {"tolerance": 0.1, "relative": 0.05}, "bonds": [BOND]},
}
needs_fork = pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")


@pytest.fixture(scope="module")
def cars(fmus: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """python/, fmi2/ and fmi3/, each with chassis.fmu and wheel.fmu."""
    folder = tmp_path_factory.mktemp("cars")
    (folder / "python").mkdir()
    for name in ("chassis", "wheel"):
        shutil.copy(fmus / f"{name}.fmu", folder / "python")
        if shutil.which("gcc"):
            build(FIXTURES / name, folder, 0, ("linux64",))
    return folder


@pytest.fixture(scope="module")
def typed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("typed"))


def car(folder: Path, cars: Path, chassis: str, wheel: str, keys: dict[str, Any], isolated: str = "") -> Run:
    """The quarter car with FMUs of two kinds; components named in `isolated` run in processes of their own."""
    kinds = {name: cars / ("python" if kind == "python" else f"native/{kind}") for name, kind in
             (("chassis", chassis), ("wheel", wheel))}  # fmt: skip
    parts = {"w": (f"{kinds['wheel']}/wheel.fmu", "2 ms"), "c": (f"{kinds['chassis']}/chassis.fmu", "2 ms")}
    text = system_text(parts, WIRES, stop="200 ms", **keys)
    for name in isolated:
        text = text.replace(f"[components.{name}]\n", f'[components.{name}]\nisolation = "process"\n')
    path = folder / "car.toml"
    path.write_text(text, encoding="utf-8")
    run = simulate(make_plan(load_system(str(path))))
    assert not run.failure, run.failure
    return run


def same(a: Run, b: Run) -> bool:
    assert len(a.tables[0]) > 2
    return all(x.tobytes() == y.tobytes() for x, y in zip(a.tables, b.tables, strict=True))


@pytest.mark.sampled(3)
@needs_gcc
@pytest.mark.parametrize("keys", COUPLINGS.values(), ids=COUPLINGS)
@pytest.mark.parametrize(("chassis", "wheel"), [("fmi2", "fmi2"), ("fmi3", "fmi3"), ("python", "fmi3")])
def test_native_fmus_of_both_versions_give_the_bits_of_the_python_fmus(
    chassis: str, wheel: str, keys: dict[str, Any], cars: Path, tmp_path: Path
) -> None:
    expected = car(tmp_path, cars, "python", "python", keys)
    assert same(car(tmp_path, cars, chassis, wheel, keys), expected)


@pytest.mark.sampled(2)
@needs_fork
@pytest.mark.parametrize("keys", COUPLINGS.values(), ids=COUPLINGS)
@pytest.mark.parametrize("isolated", ["w", "cw"])
def test_an_isolated_python_fmu_changes_no_bit(isolated: str, keys: dict[str, Any], cars: Path, tmp_path: Path) -> None:
    expected = car(tmp_path, cars, "python", "python", keys)
    assert same(car(tmp_path, cars, "python", "python", keys, isolated), expected)


@needs_gcc
@needs_fork
@pytest.mark.parametrize("kind", ["fmi2", "fmi3"])
def test_an_isolated_native_fmu_changes_no_bit(kind: str, cars: Path, tmp_path: Path) -> None:
    keys = COUPLINGS["aitken"]
    assert same(car(tmp_path, cars, kind, kind, keys, "w"), car(tmp_path, cars, kind, kind, keys))


# --- signals of other types are held, whatever the algorithm ---


@needs_gcc
@pytest.mark.parametrize("interpreted", [False, True])
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel", "iterated", "ecco"])
def test_every_type_passes_every_algorithm_unchanged(
    algorithm: str, interpreted: bool, typed: Path, tmp_path: Path
) -> None:
    """The real signals are a power bond, which ECCO needs."""
    free = {key: value for key, value in FREE2.items() if key != "=u"}
    parts = {"a": ("feedthrough2", "2 ms", free), "b": ("feedthrough2", "2 ms")}
    bond = [{"effort": "b.u", "flow": "a.u"}]
    plan = plan_of(
        tmp_path, typed, parts, [*WIRES2, "b.x -> a.u"], stop="8 ms", algorithm=algorithm, bonds=bond
    )  # fmt: skip
    assert explain(plan).count("is held\n") == 4
    signals = Signals(simulate(plan, interpreted))
    assert not signals.run.failure, signals.run.failure
    for key in ("n", "mode", "on", "s"):
        assert signals[f"b.{key}_out"].values.tolist()[-1] == FREE2[f"={key}_in"], key


@needs_gcc
@pytest.mark.parametrize("interpreted", [False, True])
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel", "iterated", "adaptive"])
def test_whole_numbers_become_real_ones_and_items_whatever_the_algorithm(
    algorithm: str, interpreted: bool, typed: Path, tmp_path: Path
) -> None:
    rest = {"=mode_in": 1, "=s_in": "", "=on_in": False}
    parts = {"a": ("feedthrough2", "2 ms", {k: v for k, v in FREE2.items() if k != "=u"}),
             "b": ("feedthrough2", "2 ms", rest)}  # fmt: skip
    wires = ["a.n_out -> b.u", "a.on_out -> b.n_in", "b.y -> a.u"]
    signals = Signals(run_of(tmp_path, typed, parts, wires, stop="8 ms", algorithm=algorithm, interpreted=interpreted))
    for name, value in (("b.u", -7.0), ("b.n_in", 1), ("a.u", -7.0)):
        assert set(signals[name].values.tolist()) == {value}, name
    assert signals["b.y"].values.tolist()[-1] == -7.0 and signals["b.n_out"].values.tolist()[-1] == 1


@needs_gcc
def test_what_steps_first_passes_its_whole_numbers_and_texts_on_unchanged(typed: Path, tmp_path: Path) -> None:
    parts = {"a": ("feedthrough3", "4 ms", FREE3), "b": ("feedthrough3", "2 ms")}
    wires = [w + " (interpolate)" if "Float64" in w else w for w in WIRES3]
    signals = Signals(run_of(tmp_path, typed, parts, wires, stop="16 ms"))
    for name in ("Int8", "UInt64", "Boolean", "String"):
        assert signals[f"b.{name}_out"].values.tolist()[-1] == FREE3[f"={name}_in"]


@needs_gcc
@pytest.mark.parametrize("transfer", ["linear", "quadratic", "interpolate", "mean"])
@pytest.mark.parametrize("name", ["n", "on", "s", "mode"])
def test_only_hold_has_a_meaning_for_them(name: str, transfer: str, typed: Path, tmp_path: Path) -> None:
    others = {key: value for key, value in FREE2.items() if key != f"={name}_in"}
    parts = {"a": ("feedthrough2", "2 ms", FREE2), "b": ("feedthrough2", "2 ms", others)}
    with pytest.raises(InputError, match=rf"is held, '{transfer}' has no meaning for it; take 'hold' \(case\.toml"):
        plan_of(tmp_path, typed, parts, [f"a.{name}_out -> b.{name}_in ({transfer})"])


@needs_gcc
def test_a_power_bond_needs_floating_point_signals(typed: Path, tmp_path: Path) -> None:
    rest = {key: value for key, value in FREE2.items() if key != "=n_in"}
    parts = {"a": ("feedthrough2", "2 ms", rest), "b": ("feedthrough2", "2 ms", rest)}
    bond = [{"effort": "b.n_in", "flow": "a.n_in"}]
    with pytest.raises(InputError, match=r"bond b\.n_in: a\.n_out is no floating-point signal and carries no power"):
        plan_of(tmp_path, typed, parts, ["a.n_out -> b.n_in", "b.n_out -> a.n_in"], bonds=bond)
