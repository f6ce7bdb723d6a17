"""What is true at an instant: no output is older than its instant, whatever its inputs have become there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import cos, sin
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import column
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.mock import MockFmu, Model, mock_fmu
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.component import Component
from rovbrush.orchestrator.system.connection import Bond, Connection
from rovbrush.orchestrator.system.model import System

MASS, STIFFNESS, DAMPING, H = (1.0, 2.0), 40.0, 0.3, 1e-4


class Mass(Model):
    """m x'' = F by explicit Euler; x and v do not answer to F at once."""

    def __init__(self, starts: Mapping[str, float]) -> None:
        super().__init__(starts)
        self.values["x"] = 0.1

    def step(self, time: float, length: float) -> int | None:
        v = self.values["v"]
        self.values["v"] += length * self.values["F"] / self.values["m"]
        self.values["x"] += length * v
        return None


class Force(Model):
    """F = k x + d v of the differences, at once."""

    def get(self, names: Iterable[str]) -> list[float]:
        u = self.values
        u["F"] = STIFFNESS * (u["x2"] - u["x1"]) + DAMPING * (u["v2"] - u["v1"])
        u["back"] = -u["F"]
        return super().get(names)


class Ramp(Model):
    """y = t."""

    def step(self, time: float, length: float) -> int | None:
        self.values["y"] = time + length
        return None


class Sum(Model):
    """y = 2 u + w, at once."""

    def get(self, names: Iterable[str]) -> list[float]:
        self.values["y"] = 2.0 * self.values.get("u", 0.0) + self.values.get("w", 0.0)
        return super().get(names)


def planned(parts: Mapping[str, tuple[MockFmu, str]], wires: Iterable[str], stop: str, **keys: Any) -> Plan:
    direct: Mapping[str, str] = keys.pop("direct", {})
    parameters: Mapping[str, dict[str, float]] = keys.pop("parameters", {})
    components = {
        name: Component(name, fmu, Fraction(h), parameters.get(name, {}), direct=direct.get(name, "stated"))
        for name, (fmu, h) in parts.items()
    }
    ends = ((a.split("."), b.split(".")) for a, b in (wire.split(" -> ") for wire in wires))
    connections = tuple(Connection((a[0], a[1]), (b[0], b[1]), transfer="hold") for a, b in ends)
    keys = {"algorithm": "jacobi", "order": tuple(parts)} | keys
    return make_plan(
        System("mocks", Path("mocks.toml"), "", Fraction(stop), components=components, connections=connections, **keys)
    )


def total(direct: bool = True) -> MockFmu:
    return mock_fmu("sum", Sum, ["u", "w"], ["y"], feedthrough={"y": ["u", "w"]} if direct else {})


def two_masses(algorithm: str, stop: str) -> Plan:
    mass = mock_fmu("mass", Mass, ["F"], ["x", "v"], {"m": 1.0})
    force = mock_fmu("force", Force, ["x1", "v1", "x2", "v2"], ["F", "back"],
                     feedthrough={"F": ["x1", "v1", "x2", "v2"], "back": ["x1", "v1", "x2", "v2"]})  # fmt: skip
    parts = {name: (fmu, str(H)) for name, fmu in (("a", mass), ("b", mass), ("f", force))}
    wires = ["a.x -> f.x1", "a.v -> f.v1", "b.x -> f.x2", "b.v -> f.v2", "f.F -> a.F", "f.back -> b.F"]
    return planned(parts, wires, stop, algorithm=algorithm, parameters={"a": {"m": MASS[0]}, "b": {"m": MASS[1]}})


def test_two_masses_and_their_force_are_the_monolithic_explicit_euler_solution(measured: Any) -> None:
    plan = two_masses("jacobi", "10")
    run = simulate(plan)
    assert not run.failure
    x, v = [0.1, 0.1], [0.0, 0.0]
    rows = [0.1]
    for _ in range(100_000):
        force = STIFFNESS * (x[1] - x[0]) + DAMPING * (v[1] - v[0])
        x = [x[0] + H * v[0], x[1] + H * v[1]]
        v = [v[0] + H * force / MASS[0], v[1] - H * force / MASS[1]]
        rows.append(x[0])
    measured("two masses by a force, jacobi, 100 000 steps: error of x(10 s) [m]",
             abs(column(run, "a.x")[1][-1] - rows[-1]), 1e-12)  # fmt: skip
    assert np.max(np.abs(column(run, "a.x")[1] - rows)) <= 1e-12


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize("interpreted", [True, False], ids=["interpreted", "compiled"])
def test_rows_hold_what_a_chain_answers_at_its_instant(algorithm: str, interpreted: bool) -> None:
    """r -> s1 -> s2, written against the order of dependence."""
    parts = {"s2": (total(), "0.001"), "s1": (total(), "0.001"), "r": (mock_fmu("r", Ramp, [], ["y"]), "0.001")}
    plan = planned(parts, ["s1.y -> s2.u", "r.y -> s1.u"], "0.0104", algorithm=algorithm)  # the last step is shorter
    run = simulate(plan, interpreted)
    t, y = column(run, "s2.y")
    assert t[-1] == 0.0104
    assert y.tolist() == pytest.approx((4.0 * t).tolist(), abs=1e-15)


def test_what_is_not_stated_costs_nothing_and_off_forbids() -> None:
    ramp = mock_fmu("r", Ramp, [], ["y"])

    def operations(stated: bool, **keys: Any) -> int:
        parts = {"r": (ramp, "0.001"), "s": (total(stated), "0.001")}
        return len(planned(parts, ["r.y -> s.u"], "0.01", **keys).cycle)

    assert operations(False) == operations(True, direct={"s": "off"}) < operations(True)
    assert operations(False, direct={"s": "all"}) == operations(True)


@pytest.mark.parametrize("interpreted", [True, False], ids=["interpreted", "compiled"])
def test_only_what_answers_is_read_again(interpreted: bool) -> None:
    asked: list[tuple[str, ...]] = []

    class Two(Sum):
        def get(self, names: Iterable[str]) -> list[float]:
            asked.append(tuple(names))
            self.values["slow"] = self.values["other"] = 0.0
            return super().get(asked[-1])

    two = mock_fmu("two", Two, ["u"], ["slow", "y", "other"], feedthrough={"y": ["u"]})
    plan = planned({"s": (two, "0.001"), "r": (mock_fmu("r", Ramp, [], ["y"]), "0.001")}, ["r.y -> s.u"], "0.01")
    run = simulate(plan, interpreted)
    assert not run.failure and asked[-2:] == [("slow", "y", "other"), ("y",)]
    t, y = column(run, "s.y")
    assert y.tolist() == pytest.approx((2.0 * t).tolist(), abs=1e-15)


def test_between_its_own_instants_nobody_is_touched() -> None:
    slow = total()
    parts = {"r": (mock_fmu("r", Ramp, [], ["y"]), "0.001"), "s": (slow, "0.003")}
    run = simulate(planned(parts, ["r.y -> s.u"], "0.006"), interpreted=True)
    assert column(run, "s.y")[1].tolist() == pytest.approx([0.0, 0.006, 0.012], abs=1e-15)
    times = [call for call in slow.made[0].calls if call[0] in ("set", "step")]
    assert [kind for kind, *_ in times[-6:]] == ["set", "step", "set", "set", "step", "set"]


class Loop(Model):
    """y = g u + s(t), at once; the nonlinear one y = cos(u) + s(t) / 2."""

    nonlinear = False

    def step(self, time: float, length: float) -> int | None:
        self.values["s"] = sin(10.0 * (time + length))
        return None

    def get(self, names: Iterable[str]) -> list[float]:
        u, s = self.values["u"], self.values.get("s", 0.0)
        self.values["y"] = cos(u) + 0.5 * s if self.nonlinear else self.values["g"] * u + s
        return super().get(names)


class Cosine(Loop):
    nonlinear = True


@pytest.mark.parametrize("model", [Loop, Cosine])
@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
@pytest.mark.parametrize("interpreted", [True, False], ids=["interpreted", "compiled"])
def test_a_loop_of_direct_dependences_is_at_its_fixed_point_in_every_row(
    model: type[Model], algorithm: str, interpreted: bool
) -> None:
    fmu = mock_fmu("loop", model, ["u"], ["y"], {"g": 0.5}, {"y": ["u"]})
    plan = planned({"a": (fmu, "0.001"), "b": (fmu, "0.001")}, ["a.y -> b.u", "b.y -> a.u"], "0.0504",
                   algorithm=algorithm, parameters={"a": {"g": -2.5}, "b": {"g": 0.7}})  # fmt: skip
    assert "solve" in explain(plan) and "loop" in explain(plan)
    run = simulate(plan, interpreted)
    assert not run.failure
    t, a = column(run, "a.y")
    b, s = column(run, "b.y")[1], np.sin(10.0 * t)
    found = np.cos(b) + 0.5 * s - a if model is Cosine else -2.5 * b + s - a
    other = np.cos(a) + 0.5 * s - b if model is Cosine else 0.7 * a + s - b
    assert max(np.max(np.abs(found)), np.max(np.abs(other))) <= 1e-12


def test_a_loop_without_a_solution_ends_the_run_with_its_name_and_its_rows() -> None:
    class Away(Loop):
        def get(self, names: Iterable[str]) -> list[float]:
            self.values["y"] = self.values["u"] * (1.0 if self.values.get("s") else 0.5) + self.values.get("s", 0.0)
            return [self.values[name] for name in names]

    fmu = mock_fmu("away", Away, ["u"], ["y"], feedthrough={"y": ["u"]})
    run = simulate(planned({"a": (fmu, "0.001"), "b": (fmu, "0.001")}, ["a.y -> b.u", "b.y -> a.u"], "0.01"))
    assert "finds no solution of the algebraic loop b.u, a.u at t = 0.001 s" in run.failure
    assert column(run, "a.y")[0].tolist() == [0.0]


@pytest.mark.parametrize("algorithm", ["adaptive", "ecco"])
def test_rows_of_other_algorithms_are_of_their_instant_too(algorithm: str) -> None:
    parts = {"r": (mock_fmu("r", Ramp, [], ["y"]), "0.001"), "s": (total(), "0.001")}
    keys: dict[str, Any] = {"algorithm": algorithm}
    wires = ["r.y -> s.u"]
    if algorithm == "ecco":
        parts["q"] = (mock_fmu("q", Ramp, ["e"], ["y"]), "0.001")
        wires += ["s.y -> q.e", "q.y -> s.w"]
        keys["bonds"] = (Bond("b", ("s.y", "q.e"), ("q.y", "s.w"), 1.0),)
    run = simulate(planned(parts, wires, "0.01", **keys), interpreted=True)
    assert not run.failure
    t, y = column(run, "s.y")
    assert y.tolist() == pytest.approx(((2.0 if algorithm == "adaptive" else 3.0) * t).tolist(), abs=1e-12)


def test_an_fmu_that_must_not_be_read_again_is_an_error_before_the_first_step_that_names_the_key() -> None:
    class Strict(Sum):
        def get(self, names: Iterable[str]) -> list[float]:
            if ("exit",) in self.calls and self.calls[-1][0] == "set":
                raise ValueError("not between a set and a step")
            return super().get(names)

    strict = mock_fmu("strict", Strict, ["u", "w"], ["y"], feedthrough={"y": ["u"]})
    parts = {"r": (mock_fmu("r", Ramp, [], ["y"]), "0.001"), "s": (strict, "0.001")}
    with pytest.raises(FmuError, match=r'answer at once to u, .* direct = "off" under \[components.s\]'):
        simulate(planned(parts, ["r.y -> s.u"], "0.01"))
    assert not any(call[0] == "step" for call in strict.made[0].calls)
    assert not simulate(planned(parts, ["r.y -> s.u"], "0.01", direct={"s": "off"})).failure
