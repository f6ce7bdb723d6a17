"""Small systems of mocks with events, as a system file states them: what the tests of events share."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from rovbrush.orchestrator.fmu.mock import MockFmu, Model, mock_fmu
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.system.component import Component
from rovbrush.orchestrator.system.connection import Bond, Connection
from rovbrush.orchestrator.system.file.events.read import events_of
from rovbrush.orchestrator.system.model import System


class Ramp(Model):
    """y = t."""

    def step(self, time: float, length: float) -> int | None:
        self.values["y"] = time + length
        return None


class Keep(Model):
    """y is what u was over the step."""

    def step(self, time: float, length: float) -> int | None:
        self.values["y"] = self.values["u"]
        return None


class Integral(Model):
    """y' = k u, by explicit Euler."""

    def step(self, time: float, length: float) -> int | None:
        self.values["y"] += length * self.values.get("k", 1.0) * self.values["u"]
        return None


class Sum(Model):
    """y = 2 u + w, at once."""

    def get(self, names: Iterable[str]) -> list[float]:
        self.values["y"] = 2.0 * self.values.get("u", 0.0) + self.values.get("w", 0.0)
        return super().get(names)


class Flow(Model):
    """y follows e slowly, from 1."""

    def __init__(self, starts: Mapping[str, float]) -> None:
        super().__init__(starts)
        self.values["y"] = 1.0

    def step(self, time: float, length: float) -> int | None:
        self.values["y"] += length * (self.values["e"] - self.values["y"])
        return None


RAMP = mock_fmu("ramp", Ramp, [], ["y"])
KEEP = mock_fmu("keep", Keep, ["u"], ["y"])
SUM = mock_fmu("sum", Sum, ["u", "w"], ["y"], feedthrough={"y": ["u", "w"]})
FLOW = mock_fmu("flow", Flow, ["e"], ["y"])
INTEGRAL = mock_fmu("integral", Integral, ["u"], ["y"], {"k": 1.0})
FIXED = mock_fmu("fixed", Integral, ["u"], ["y"], {"k": 1.0})
FIXED.interface.canHandleVariableCommunicationStepSize = False
for _variable in INTEGRAL.description.modelVariables:
    if _variable.name == "k":
        _variable.variability = "tunable"

Parts = Mapping[str, tuple[MockFmu, str]]


def system_of(
    parts: Parts, wires: Iterable[str], events: Iterable[Mapping[str, Any]], stop: str, **keys: Any
) -> System:
    """Mocks by name with their periods [s], connections, and events as tables of a system file."""
    transfer = keys.pop("transfer", "")
    components = {name: Component(name, fmu, Fraction(h)) for name, (fmu, h) in parts.items()}
    ends = ((a.split("."), b.split(".")) for a, b in (wire.split(" -> ") for wire in wires))
    connections = tuple(Connection((a[0], a[1]), (b[0], b[1]), transfer) for a, b in ends)
    found = events_of(None, components, connections, [dict(event) for event in events])
    order = tuple(sorted(parts, key=lambda name: Fraction(parts[name][1])))
    keys = {"algorithm": "gauss-seidel", "order": order} | keys
    return System("mocks", Path("mocks.toml"), "", Fraction(stop), components=components, connections=connections,
                  events=found, **keys)  # fmt: skip


def planned(parts: Parts, wires: Iterable[str], events: Iterable[Mapping[str, Any]], stop: str, **keys: Any) -> Plan:
    return make_plan(system_of(parts, wires, events, stop, **keys))


def ramp_into_keep(*events: Mapping[str, Any], stop: str = "0.01", **keys: Any) -> Plan:
    """a.y = t into b.u, both every ms."""
    return planned({"a": (RAMP, "0.001"), "b": (KEEP, "0.001")}, ["a.y -> b.u"], events, stop, **keys)


def bonded(*events: Mapping[str, Any], stop: str = "1", **keys: Any) -> Plan:
    """Two that follow each other, with a power bond between them, for algorithms that judge by energy."""
    parts = {"p": (FLOW, "0.01"), "q": (FLOW, "0.01"), "r": (RAMP, "0.01")}
    bond = Bond("b", ("p.y", "q.e"), ("q.y", "p.e"), 1.0)
    return planned(parts, ["p.y -> q.e", "q.y -> p.e"], events, stop, bonds=(bond,), **keys)


def without_events(plan: Plan) -> Plan:
    return make_plan(replace(plan.system, events=()))
