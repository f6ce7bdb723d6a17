"""What can be touched while a system runs: free inputs, tunable parameters, signals that break, what happens by hand.

All of it is done by events of the system, which have their cells in the plan from the start and happen when they are
told to. So what is done by hand is what a scenario does at the same instant, bit for bit.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from ..clock import seconds_text
from ..errors import InputError, nearest
from ..fmu.types import REALS, Value
from ..plan.happening.scenario import check_scenario
from ..plan.plan import Plan
from ..system.event import Event, Key
from ..system.file.events.read import events_of
from ..system.model import System
from ..system.values import checked_values, follows_tables

WHOLE = ("Integer", "Enumeration", "Int64", "Int32", "Int16", "Int8", "UInt64", "UInt32", "UInt16", "UInt8")
KINDS = {**dict.fromkeys(REALS, "number"), **dict.fromkeys(WHOLE, "whole"), "Boolean": "switch", "String": "text"}
BY_HAND = "by hand"  # what the rows of a run call it
FAULTS = ("loss", "hold", "bias", "scale", "noise")


def free(system: System) -> dict[Key, Value]:
    """What can be set while the run goes, by hand too, with its value at the start: scalars that nothing drives."""
    found: dict[Key, Value] = {}
    for name, component in system.components.items():
        for scalar in component.fmu.names("input", "parameter"):
            variable = component.fmu.variables[scalar]
            usual = follows_tables(variable) and variable.type in KINDS and not component.clocks_of(scalar)
            if usual and (name, scalar) not in system.drivers and scalar not in component.series:
                given = {**component.parameters, **component.inputs}
                found[name, scalar] = given.get(scalar, component.fmu.start(scalar))
    return found


def breakable(system: System) -> list[str]:
    """The outputs whose loss an input notices."""
    return list(dict.fromkeys(".".join(c.source) for c in system.connections))


def touchable(system: System) -> System:
    """The system with an event for everything that can be touched; none of them happens by itself."""
    before = len(system.events)
    wanted: list[dict[str, Any]] = [{"set": {".".join(key): _plain(value)}} for key, value in free(system).items()]
    wanted += [{"fault": "hold", "on": name} for name in breakable(system)]
    found: list[Event] = []
    for table in wanted:
        try:
            (event,) = _stated(system, {"at": "0 s", **table})
            check_scenario(replace(system, events=(event,)), _anything)
        except InputError:  # solved inside a group of FMUs, say: it cannot be touched
            continue
        name = f"by hand {len(found) + before + 1}"
        found.append(replace(event, name=name, at=None, stated=table))
    return replace(system, events=(*system.events, *found))


class _Anything:
    """An algorithm that takes all events."""

    takes_noise = True


_anything: Any = _Anything()


def _stated(system: System, table: Mapping[str, Any]) -> tuple[Event, ...]:
    return events_of(None, system.components, system.connections, [dict(table)])


def _plain(value: Value) -> Any:
    return value.item() if hasattr(value, "item") else value


@dataclass(frozen=True)
class Given:
    """An event that is to happen, by its number in the plan."""

    number: int
    event: Event


class Touch:
    """What of a plan can be touched, and what a wish is as events. Raises InputError for what cannot be."""

    def __init__(self, plan: Plan) -> None:
        self.plan, self.system = plan, plan.system
        self._sets: dict[Key, int] = {}
        self._faults: dict[str, int] = {}
        self._named: dict[str, int] = {}
        for number, event in enumerate(self.system.events):
            if event.at is not None or event.when is not None:
                continue
            if event.name.startswith("by hand ") and "name" not in event.stated:
                if event.fault:
                    self._faults[".".join(event.fault.on)] = number
                else:
                    (key,) = event.settings
                    self._sets[key] = number
            else:
                self._named[event.name] = number

    @property
    def inputs(self) -> list[Key]:
        return list(self._sets)

    @property
    def breakable(self) -> list[str]:
        return list(self._faults)

    @property
    def happenings(self) -> list[str]:
        """The events of the system that happen by hand."""
        return list(self._named)

    def set(self, name: str, value: object, at: Fraction) -> list[Given]:
        """An input or a tunable parameter, of an array all of it."""
        name = self.system.full_name(name)
        (event,) = _stated(self.system, {"at": _text(at), "set": {name: value}})
        owner, _, variable = name.partition(".")
        values = checked_values(self.system.components[owner], variable, value, "set")
        found = []
        for scalar, each in values.items():
            if (owner, scalar) not in self._sets:
                raise InputError(f"set: {owner}.{scalar} cannot be set by hand while this run goes")
            stated = {"at": _text(at), "set": {f"{owner}.{scalar}": _plain(each)}}
            one = replace(event, name=BY_HAND, settings={(owner, scalar): each}, stated=stated)
            found.append(Given(self._sets[owner, scalar], one))
        return found

    def fault(self, name: str, kind: str, value: object, at: Fraction) -> Given:
        """A signal that breaks."""
        if name not in self._faults:
            raise InputError(f"no signal '{name}' can break{nearest(name, self._faults)}")
        if kind not in FAULTS:
            raise InputError(f"no fault is of the kind '{kind}'{nearest(kind, FAULTS)}")
        number = {} if kind == "hold" or value is None else {"value": value}
        (event,) = _stated(self.system, {"at": _text(at), "fault": kind, "on": name, **number})
        check_scenario(replace(self.system, events=(event,)), self.plan.algorithm)
        return Given(self._faults[name], replace(event, name=BY_HAND))

    def mended(self, name: str) -> int:
        """The number of the fault of a signal."""
        if name not in self._faults:
            raise InputError(f"no signal '{name}' can break{nearest(name, self._faults)}")
        return self._faults[name]

    def happen(self, name: str, at: Fraction) -> Given:
        """An event that the system has for this."""
        if name not in self._named:
            raise InputError(f"no event '{name}' happens by hand{nearest(name, self._named)}")
        event = self.system.events[self._named[name]]
        stated = {key: value for key, value in event.stated.items() if key not in ("by_hand", "name")}
        return Given(self._named[name], replace(event, at=at, stated={"at": _text(at), **stated}))


def _text(time: Fraction) -> str:
    return seconds_text(time)
