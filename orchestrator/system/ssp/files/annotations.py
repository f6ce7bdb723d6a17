"""What SSP has no words for travels as annotations of our own: the keys of a system file, as JSON.

Other tools pass them over. Of a system: algorithm, order, bonds, events, connections of clocks, balance, what is
recorded, required and reported; of a component: its period; of a connection: its transfer.
"""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from lxml import etree
from msgspec import to_builtins

from ....clock import seconds_text
from ....fmu.kinds import usual_kind
from ...component import Component
from ...connection import Bond, Connection
from ...model import FORMATS, Requirement, System
from ...schema.keys.solving import Loops, Solver
from .document import NAMESPACES, Document, find

TYPE = "rovbrush.simulation"  # the type of our annotations
CLOCKS = "clock_connections"  # our key of those, of which a structure says nothing
NAMESPACE = "urn:rovbrush:simulation:1"


def system_keys(system: System) -> dict[str, Any]:
    """The top-level keys of a system file that SSP cannot say."""
    in_ssp = (
        "name",
        "path",
        "description",
        "start",
        "stop",
        "components",
        "connections",
        "clock_connections",
        "remarks",
        "breaches",
        "parameter_set",
    )
    return {
        **_stated(
            system,
            (*in_ssp, "format", "loops", "solver", "bonds", "events", "requirements", "reporting", "settings", "live"),
        ),
        **({"loops": to_builtins(system.loops)} if system.loops != Loops() else {}),
        **({"solver": to_builtins(system.solver)} if system.solver != Solver() else {}),
        **({"live": _without_none(to_builtins(system.live))} if system.live else {}),
        **system.settings,
        "bonds": [_bond(bond) for bond in system.bonds],
        **({CLOCKS: [c.label for c in system.clock_connections]} if system.clock_connections else {}),
        **({"events": [dict(event.stated) for event in system.events]} if system.events else {}),
        "require": [_requirement(requirement) for requirement in system.requirements],
        **{key: table for key, table in system.reporting.items() if table},
        "format": FORMATS[-1],
    }


def _without_none(value: Any) -> Any:
    """As a system file has it, where what is not stated is left out."""
    if isinstance(value, dict):
        return {key: _without_none(each) for key, each in value.items() if each is not None}
    return [_without_none(each) for each in value] if isinstance(value, list) else value


def component_keys(component: Component) -> dict[str, Any]:
    units = {"units": dict(component.fmu.units)} if component.fmu.units else {}
    clocks = {"clocks": {clock: seconds_text(s) for clock, s in component.clocks.items()}} if component.clocks else {}
    kind = {"kind": component.fmu.kind} if component.fmu.kind != usual_kind(component.fmu.description) else {}
    elsewhere = ("name", "fmu", "parameters", "inputs", "notes", "apart", "in_events", "clocks")
    return _stated(component, elsewhere) | kind | units | clocks


def connection_keys(connection: Connection) -> dict[str, Any]:
    elsewhere = ("source", "target", "gain", "offset", "where", "per_second")
    return _stated(connection, elsewhere if connection.counted else (*elsewhere, "counter"))


def _bond(bond: Bond) -> dict[str, Any]:
    ends = {"effort": bond.effort[1], "flow": bond.flow[1] or bond.flow[0]}
    return ends | _stated(bond, ("effort", "flow"))


def _requirement(requirement: Requirement) -> dict[str, Any]:
    keys = {k: ".".join(v) if isinstance(v, tuple) else v for k, v in _stated(requirement, ("value",)).items()}
    return {"value": ".".join(requirement.value)} | {k: v for k, v in keys.items() if v not in (math.inf, -math.inf)}


def _stated(item: Any, elsewhere: tuple[str, ...] = ()) -> dict[str, Any]:
    """Fields of a dataclass that are not at their defaults, as a system file has them: under their own names."""
    keys = {}
    for field in dataclasses.fields(item):
        value = getattr(item, field.name)
        default = field.default if field.default_factory is dataclasses.MISSING else field.default_factory()
        if field.name not in elsewhere and value != default:
            keys[field.name] = seconds_text(value) if isinstance(value, Fraction) else value
            if dataclasses.is_dataclass(value):
                keys[field.name] = _stated(value)
    return keys


def annotate(parent: Any, keys: Mapping[str, Any]) -> None:
    """Append our annotation to an element; nothing where there is nothing to say."""
    if not keys:
        return
    element = etree.SubElement(annotation(parent, TYPE), f"{{{NAMESPACE}}}Keys", nsmap={"rovbrush": NAMESPACE})
    element.text = json.dumps(keys, allow_nan=False)


def annotation(parent: Any, type_: str) -> Any:
    """A new <Annotation> of an element, behind those that it has."""
    ssd, ssc = (f"{{{NAMESPACES[prefix]}}}" for prefix in ("ssd", "ssc"))
    annotations = parent.find(f"{ssd}Annotations")
    if annotations is None:
        annotations = etree.SubElement(parent, f"{ssd}Annotations")
    return etree.SubElement(annotations, f"{ssc}Annotation", type=type_)


def annotated(document: Document, element: Any, allowed: tuple[str, ...] = ()) -> dict[str, Any]:
    """Our keys on an element, {} where there are none. `allowed`: all that may be there. Raises InputError."""
    found: dict[str, Any] = {}
    for entry in find(element, "Annotations/Annotation"):
        if entry.get("type") == TYPE:
            try:
                keys = json.loads(entry[0].text)
            except (ValueError, TypeError, IndexError, RecursionError) as error:
                raise document.fail(f"the {TYPE} annotation is no JSON: {error}", entry) from None
            if not isinstance(keys, dict) or (allowed and not keys.keys() <= set(allowed)):
                raise document.fail(f"the {TYPE} annotation may hold {', '.join(allowed) or 'a table'} only", entry)
            found |= keys
    return found
