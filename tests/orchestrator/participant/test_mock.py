"""Plans and algorithms on mocks: exactly what is called, when, in which order; no file, no library, milliseconds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import column
from rovbrush.orchestrator.fmu.mock import MockFmu, Model, mock_fmu
from rovbrush.orchestrator.participant.base import CallError
from rovbrush.orchestrator.participant.outside.instance import DeclaredInstance
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.component import Component
from rovbrush.orchestrator.system.connection import Connection
from rovbrush.orchestrator.system.model import System


class Integrator(Model):
    """y' = u."""

    def step(self, time: float, length: float) -> int | None:
        self.values["y"] += length * self.values["u"]
        return None


class Ramp(Model):
    """y = t."""

    def step(self, time: float, length: float) -> int | None:
        self.values["y"] = time + length
        return None


def part(model: Callable[[Mapping[str, float]], Model], inputs: tuple[str, ...] = ("u",)) -> MockFmu:
    return mock_fmu(model.__name__.lower(), model, inputs, ["y"])


def run(parts: Mapping[str, tuple[MockFmu, str]], wires: list[str], stop: str = "0.004", **keys: Any) -> Run:
    """A run by the interpreter; `parts`: FMU and period [s] by name."""
    keys = {"algorithm": "jacobi", "order": tuple(parts)} | keys
    components = {name: Component(name, fmu, Fraction(period)) for name, (fmu, period) in parts.items()}
    connections = tuple(
        Connection(
            (a.split(".")[0], a.split(".")[1]),
            (b.split(".")[0], b.split(".")[1]),
            transfer="" if keys["algorithm"] == "iterated" else "hold",
        )
        for a, b in (wire.split(" -> ") for wire in wires)
    )
    interpreted = keys.pop("interpreted", True)
    system = System(
        "mocks", Path("mocks.toml"), "", Fraction(stop), components=components, connections=connections, **keys
    )
    return simulate(make_plan(system), interpreted=interpreted)


def calls(fmu: MockFmu, *kinds: str) -> list[tuple[Any, ...]]:
    return [call for call in fmu.made[0].calls if call[0] in kinds]


def test_jacobi_sets_steps_and_holds_at_exactly_these_instants() -> None:
    ramp, integrator = part(Ramp, ()), part(Integrator)
    found = run({"r": (ramp, "0.001"), "i": (integrator, "0.002")}, ["r.y -> i.u"])
    assert [c[1] for c in calls(ramp, "step")] == [0.0, 0.001, 0.002, 0.003]
    in_loop = integrator.made[0].calls[integrator.made[0].calls.index(("exit",)) + 1 :]
    assert in_loop == [
        ("set", {"u": 0.0}), ("step", 0.0, 0.002), ("set", {"u": 0.002}), ("step", 0.002, 0.002),
        ("terminate",), ("free",),
    ]  # fmt: skip
    assert column(found, "i.y")[1].tolist() == [0.0, 0.0, 0.002 * 0.002]


def test_gauss_seidel_gives_the_second_what_the_first_has_just_computed() -> None:
    ramp, integrator = part(Ramp, ()), part(Integrator)
    run({"r": (ramp, "0.001"), "i": (integrator, "0.001")}, ["r.y -> i.u"], "0.002", algorithm="gauss-seidel")
    assert [c[1] for c in calls(integrator, "set")][-2:] == [{"u": 0.001}, {"u": 0.002}]


def test_the_life_of_a_mock_is_that_of_any_fmu() -> None:
    integrator = part(Integrator)
    run({"i": (integrator, "0.001"), "r": (part(Ramp, ()), "0.001")}, ["r.y -> i.u"], "0.001")
    kinds = [call[0] for call in integrator.made[0].calls]
    assert kinds[:2] == ["set up", "set"] and kinds[-2:] == ["terminate", "free"]
    assert kinds.index("enter") < kinds.index("exit") < kinds.index("step")


def test_iterated_coupling_goes_back_to_the_beginning_of_a_step_and_repeats_it() -> None:
    a, b = part(Integrator), part(Integrator)
    found = run({"a": (a, "0.001"), "b": (b, "0.001")}, ["a.y -> b.u", "b.y -> a.u"], "0.002", algorithm="iterated")
    assert not found.failure
    times = [c[1] for c in calls(a, "step")]
    assert times == sorted(times) and set(times) == {0.0, 0.001}
    assert len(calls(a, "restore")) == len(times) - 2, "every pass but the first of a step begins with a restored state"


@pytest.mark.parametrize("interpreted", [True, False], ids=["interpreted", "compiled"])
def test_a_mock_that_raises_is_an_error_with_its_words(interpreted: bool) -> None:
    class Breaks(Model):
        def step(self, time: float, length: float) -> int | None:
            if time > 0.0015:
                raise ValueError("no more of this")
            return None

    plan = {"b": (part(Breaks, ()), "0.001"), "i": (part(Integrator), "0.001")}
    found = run(plan, ["b.y -> i.u"], interpreted=interpreted)
    assert "component b returned fmi2Error in the step to t = 0.003 s" in found.failure
    assert found.failure.endswith("no more of this")


def test_both_loops_call_a_mock_alike() -> None:
    seen = []
    for interpreted in (True, False):
        ramp, integrator = part(Ramp, ()), part(Integrator)
        found = run({"r": (ramp, "0.001"), "i": (integrator, "0.002")}, ["r.y -> i.u"], interpreted=interpreted)
        seen.append((integrator.made[0].calls, [table.tobytes() for table in found.tables]))
    assert seen[0] == seen[1]


def test_a_mock_refuses_what_is_out_of_turn() -> None:
    instance = DeclaredInstance(part(Integrator), "i")
    with pytest.raises(CallError, match="cannot step from 0 s while it is instantiated"):
        instance.step(0.0, 1.0)
    instance.begin(1.0)
    instance.exit_initialization()
    kept = instance.save()
    instance.set("u", 2.0)
    instance.step(0.0, 1.0)
    assert instance.get("y") == 2.0
    instance.restore(kept)
    assert np.isclose(instance.get("y"), 0.0)
    assert instance.close() == "" and instance.dead
