"""What stands before the variables: version, names, capabilities, default experiment, units and types."""

from __future__ import annotations

import re
from typing import Any

from attrs import fields
from fmpy.model_description import BaseUnit, CoSimulation, Item, ModelExchange, ScheduledExecution, SimpleType

from ..reading.details import OF_TYPE
from .literals import mend_boolean, mend_number, number, place
from .rules import MISSING, NAMELESS, NUMBER, UNKNOWN, VERSION, Notes

INTERFACES = {"CoSimulation": CoSimulation, "ModelExchange": ModelExchange, "ScheduledExecution": ScheduledExecution}
FLAGS3 = ("canGetAndSetFMUState", "canSerializeFMUState")  # FMI 3 spells them so, fmpy's classes as FMI 2 does
TYPE_ATTRIBUTES = {f.name for f in fields(SimpleType)} - {"name", "type", "items"}
ITEM_ATTRIBUTES = {f.name for f in fields(Item)}
BASE = [f.name for f in fields(BaseUnit)]
REAL_TYPES = ("Real", "Float64Type", "Float32Type")


def version_of(text: str | None) -> int | None:
    """1, 2 or 3 for an fmiVersion that can be taken for one; None for any other."""
    if text is not None and re.fullmatch(r"1(\.0([.-].*)?)?", text.strip()):
        return 1
    if text is not None and re.fullmatch(r"2(\.0([.-].*)?)?", text.strip()):
        return 2
    return 3 if text is not None and re.fullmatch(r"3([.-].*)?", text.strip()) else None


def mend_version(root: Any, version: int, notes: Notes) -> None:
    """Write the version as the standard does."""
    stated = root.get("fmiVersion")
    if stated != f"{version}.0":
        notes.add(VERSION, f"fmiVersion={stated[:40]!r}, taken for {version}.0")
        root.set("fmiVersion", f"{version}.0")


def mend_head(root: Any, version: int, stem: str, notes: Notes) -> None:
    """All that stands before the variables; `stem`: what to call a model without a name."""
    token = "guid" if version == 2 else "instantiationToken"
    for attribute, default in (("modelName", stem), (token, "")):
        if root.get(attribute) is None:
            notes.add(MISSING, attribute)
            root.set(attribute, default)
    mend_number(root, "numberOfEventIndicators", notes, integer=True)
    for experiment in root.findall("DefaultExperiment"):
        for attribute in ("startTime", "stopTime", "tolerance", "stepSize"):
            mend_number(experiment, attribute, notes)
    for tag, kind in INTERFACES.items():
        for element in root.findall(tag):
            for attribute, f in {**{f.name: f.type for f in fields(kind)}, **dict.fromkeys(FLAGS3, "bool")}.items():
                if f in ("bool", bool):
                    mend_boolean(element, attribute, notes)
                elif "int" in str(f) or "float" in str(f):
                    mend_number(element, attribute, notes, integer=f in ("int", int))
    _units(root, notes)
    _types(root, version, notes)


def _units(root: Any, notes: Notes) -> None:
    for unit in root.findall("UnitDefinitions/Unit"):
        if not unit.get("name"):
            notes.add(NAMELESS, place(unit))
            unit.getparent().remove(unit)
            continue
        for base in unit.findall("BaseUnit"):
            for attribute in BASE:
                mend_number(
                    base, attribute, notes, integer=attribute not in ("factor", "offset"), name=unit.get("name")
                )
            if number(base.get("factor", "1")) in (0.0, float("inf"), -float("inf")):
                notes.add(NUMBER, f"factor={base.get('factor')!r} of {place(base, unit.get('name'))}")
                unit.remove(base)
        for display in unit.findall("DisplayUnit"):
            for attribute in ("factor", "offset"):
                mend_number(display, attribute, notes)
            mend_boolean(display, "inverse", notes)


def _types(root: Any, version: int, notes: Notes) -> None:
    for simple in root.findall("TypeDefinitions/SimpleType" if version == 2 else "TypeDefinitions/*"):
        inner = (simple[0] if len(simple) else None) if version == 2 else simple
        if not simple.get("name") or inner is None:
            notes.add(NAMELESS, place(simple))
            simple.getparent().remove(simple)
            continue
        own = {"name", *OF_TYPE.get(str(inner.tag).removesuffix("Type"), ())} if version == 3 else set()
        _known(inner, TYPE_ATTRIBUTES | own, notes, simple.get("name"))
        mend_boolean(inner, "relativeQuantity", notes, simple.get("name"))
        mend_boolean(inner, "unbounded", notes, simple.get("name"))
        for attribute in ("min", "max", "nominal"):
            mend_number(inner, attribute, notes, integer=inner.tag not in REAL_TYPES, name=simple.get("name"))
        for item in inner.findall("Item"):
            mend_number(item, "value", notes, integer=True)
            _known(item, ITEM_ATTRIBUTES, notes, simple.get("name"))
            if not item.get("name") or item.get("value") is None:
                notes.add(NAMELESS, f"an item of {place(item, simple.get('name'))}")
                inner.remove(item)


def _known(element: Any, known: set[str], notes: Notes, name: str) -> None:
    """Leave out attributes that fmpy's classes do not have."""
    for attribute in set(element.attrib) - known:
        notes.add(UNKNOWN, f"{attribute} of {place(element, name)}")
        del element.attrib[attribute]
