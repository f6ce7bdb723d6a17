"""What SSP has no words for travels as annotations of our own: the keys of a system file, as JSON.

Other tools pass them over. Of a system: algorithm, order, bonds, balance, what is recorded, required and reported;
of a component: its period; of a connection: its transfer.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any

from lxml import etree

from ..clock import seconds_text
from ..system import Bond, Component, Connection, Requirement, System
from .document import NAMESPACES, Document, find

TYPE = "rovbrush.simulation"  # the type of our annotations
NAMESPACE = "urn:rovbrush:simulation:1"


def system_keys(system: System) -> dict[str, Any]:
    """The top-level keys of a system file that SSP cannot say."""
    keys = {
        "algorithm": system.algorithm,
        "order": list(system.order),
        "record": list(system.record),
        "bonds": [_bond(bond) for bond in system.bonds],
        "require": [_requirement(requirement) for requirement in system.requirements],
        **system.reporting,
    }
    return {key: value for key, value in keys.items() if value or key == "record"}


def component_keys(component: Component) -> dict[str, Any]:
    return {"period": seconds_text(component.period)}


def connection_keys(connection: Connection) -> dict[str, Any]:
    return {"transfer": connection.transfer} if connection.transfer else {}


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
    for entry in find(element, "ssd:Annotations/ssc:Annotation"):
        if entry.get("type") == TYPE:
            try:
                keys = json.loads(entry[0].text)
            except (ValueError, TypeError, IndexError, RecursionError) as error:
                raise document.fail(f"the {TYPE} annotation is no JSON: {error}", entry) from None
            if not isinstance(keys, dict) or (allowed and not keys.keys() <= set(allowed)):
                raise document.fail(f"the {TYPE} annotation may hold {', '.join(allowed) or 'a table'} only", entry)
            found |= keys
    return found


def _bond(bond: Bond) -> dict[str, Any]:
    return {"name": bond.name, "effort": bond.effort[1], "flow": bond.flow[1] or bond.flow[0], "sign": bond.sign}


def _requirement(requirement: Requirement) -> dict[str, Any]:
    bounds = {"minimum": requirement.minimum, "maximum": requirement.maximum}
    return {
        "value": ".".join(requirement.value),
        **{key: bound for key, bound in bounds.items() if math.isfinite(bound)},
        "message": requirement.message,
    }
