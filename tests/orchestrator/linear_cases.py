"""Plants as Python objects for tests of linear models, each with a closed form."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
from rovbrush.orchestrator.fmu.mock import MockFmu, Model, mock_fmu
from rovbrush.orchestrator.system.component import Component
from rovbrush.orchestrator.system.connection import Connection
from rovbrush.orchestrator.system.model import System
from scipy.linalg import expm


class Plant(Model):
    """x' = A x + B u, y = C x + D u, exactly, u held over a step."""

    A: Any = ((0.0,),)
    B: Any = (1.0,)
    C: Any = (1.0,)
    D = 0.0

    def __init__(self, starts: Mapping[str, float]) -> None:
        super().__init__(starts)
        self.x = np.zeros(len(self.A))

    def step(self, time: float, length: float) -> int | None:
        n = len(self.A)
        both = np.zeros((n + 1, n + 1))
        both[:n, :n], both[:n, n] = np.array(self.A) * length, np.array(self.B) * length
        whole = expm(both)
        self.x = whole[:n, :n] @ self.x + whole[:n, n] * self.values["u"]
        return None

    def get(self, names: Iterable[str]) -> list[float]:
        y = float(np.array(self.C) @ self.x) + self.D * self.values.get("u", 0.0)
        return [y if name == "y" else self.values[name] for name in names]

    def save(self) -> dict[str, Any]:
        return {"values": dict(self.values), "x": self.x.copy()}

    def restore(self, state: dict[str, Any]) -> None:
        self.values, self.x = dict(state["values"]), state["x"].copy()


def plant(A: Any, B: Any, C: Any, D: float = 0.0) -> MockFmu:
    kind = type("Chosen", (Plant,), {"A": A, "B": B, "C": C, "D": D})
    return mock_fmu("plant", kind, ["u"], ["y"], feedthrough={"y": ["u"] if D else []})


class Late(Model):
    """y is u some steps ago."""

    steps = 3

    def __init__(self, starts: Mapping[str, float]) -> None:
        super().__init__(starts)
        self.line = [0.0] * self.steps

    def step(self, time: float, length: float) -> int | None:
        self.line = [*self.line[1:], self.values["u"]]
        return None

    def get(self, names: Iterable[str]) -> list[float]:
        return [self.line[0] if name == "y" else self.values[name] for name in names]

    def save(self) -> dict[str, Any]:
        return {"values": dict(self.values), "line": list(self.line)}

    def restore(self, state: dict[str, Any]) -> None:
        self.values, self.line = dict(state["values"]), list(state["line"])


class Turning(Model):
    """x' = u - x, read by something that turns 40 steps a turn: y = (1 + cos(theta) / 2) x."""

    STEPS = 40

    def __init__(self, starts: Mapping[str, float]) -> None:
        super().__init__(starts)
        self.x, self.count = 0.0, 0

    def step(self, time: float, length: float) -> int | None:
        left = float(np.exp(-length))
        self.x, self.count = left * self.x + (1.0 - left) * self.values["u"], self.count + 1
        return None

    def get(self, names: Iterable[str]) -> list[float]:
        theta = 2.0 * np.pi * self.count / self.STEPS
        known = {"y": (1.0 + 0.5 * float(np.cos(theta))) * self.x, "theta": theta}
        return [known[name] if name in known else self.values[name] for name in names]

    def save(self) -> dict[str, Any]:
        return {"values": dict(self.values), "x": self.x, "count": self.count}

    def restore(self, state: dict[str, Any]) -> None:
        self.values, self.x, self.count = dict(state["values"]), state["x"], state["count"]


def turning() -> MockFmu:
    return mock_fmu("turning", Turning, ["u"], ["y", "theta"])


class Gain(Model):
    """y = k u + w."""

    def get(self, names: Iterable[str]) -> list[float]:
        v = self.values
        return [v["k"] * v["u"] + v["w"] if name == "y" else v[name] for name in names]


def gain(k: float) -> MockFmu:
    return mock_fmu("gain", Gain, ["u", "w"], ["y"], {"k": k}, {"y": ["u", "w"]})


def system(
    parts: Mapping[str, tuple[MockFmu, str]], wires: Iterable[str] = (), stop: str = "10", **keys: Any
) -> System:
    """`parts`: FMU and period [s] by name; `wires`: `a.y -> b.u`."""
    components = {name: Component(name, fmu, Fraction(period)) for name, (fmu, period) in parts.items()}
    ends = [tuple(end.strip() for end in wire.split("->")) for wire in wires]
    connections = tuple(Connection(tuple(a.split(".")), tuple(b.split("."))) for a, b in ends)  # type: ignore[arg-type]
    return System(
        "mocks", Path("mocks.toml"), "", Fraction(stop), algorithm="gauss-seidel", order=tuple(parts),
        components=components, connections=connections,
    )  # fmt: skip


def loop(k: float, late: int = 0, period: str = "0.01") -> System:
    """An integrator under a gain of -k, its output `late` steps late: in samples k T/(z - 1) z^-late."""
    parts = {"p": (plant([[0.0]], [1.0], [1.0]), period), "g": (gain(-k), period)}
    if not late:
        return system(parts, ["p.y -> g.u", "g.y -> p.u"])
    kind = type("Chosen", (Late,), {"steps": late})
    parts["d"] = (mock_fmu("late", kind, ["u"], ["y"]), period)
    return system(parts, ["p.y -> d.u", "d.y -> g.u", "g.y -> p.u"])
