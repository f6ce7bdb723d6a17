"""The XML files of an SSP, read safely: no entities, nothing remote. What a run can do without is noted."""

from __future__ import annotations

import math
import re
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import fmpy.ssp
from lxml import etree

from ....errors import FmuError, InputError, shown
from ....fmu.tolerant.rules import Notes
from ....fmu.tolerant.xml import read_xml
from .rules import FOREIGN, NAMELESS, NAMESPACE, SCHEMA, VERSION
from .vocabulary import (
    CHILDREN,
    DRAFT,
    MISSED,
    NAMED,
    NUMBERS,
    PASSED_OVER,
    REFUSED_ATTRIBUTES,
    REQUIRED_ATTRIBUTES,
    REQUIRED_CHILDREN,
    STATED_ATTRIBUTES,
    TYPES,
)  # fmt: skip

BASE = "http://ssp-standard.org/SSP1/SystemStructure"
NAMESPACES = {
    "ssc": f"{BASE}Common",
    "ssd": f"{BASE}Description",
    "ssv": f"{BASE}ParameterValues",
    "ssm": f"{BASE}ParameterMapping",
    "ssb": f"{BASE}SignalDictionary",
}
STANDARD = set(NAMESPACES.values())
ALIKE = re.compile(r"SystemStructure(Common|Description|Parameter|SignalDictionary)|ssp-standard\.org")
UNDECLARED = re.compile(r"(ss[cdvmb])[_:](\w+)")  # what `read_xml` makes of a prefix that nothing declares
SCHEMAS = {
    "SystemStructureDescription": "SystemStructureDescription.xsd",
    "ParameterSet": "SystemStructureParameterValues.xsd",
    "ParameterMapping": "SystemStructureParameterMapping.xsd",
    "SignalDictionary": "SystemStructureSignalDictionary.xsd",
}
TOLD = 20  # faults of a file that a schema names, at most


class Document:
    """One XML file, and where its elements stand in it. `shown` is what messages call it."""

    def __init__(self, path: Path, shown_: str, kind: str, notes: Notes | None = None) -> None:
        """Read and check. `kind` is the name of the root element; `notes`: where the file breaks the standard.

        Raises InputError.
        """
        self.path, self.shown, self.notes = path, shown_, notes or Notes()
        try:
            self.root = read_xml(path, shown_, self.notes)
        except OSError:
            raise InputError(f"{shown_} does not exist") from None
        except FmuError as error:
            raise InputError(str(error)) from None
        if local(self.root) != kind:
            raise self.fail(f"<{local(self.root)}> is no <{kind}>", self.root)
        self.version = self._version()
        self._retag(self.root)
        if self.version == "1":
            for fault in faults(self.root)[:TOLD]:
                self.notes.add(SCHEMA, f"{self.shown}, {fault}")
        self._check(self.root)

    def _version(self) -> str:
        """The first number of the version. Raises InputError for one that is not known."""
        text = (self.root.get("version") or "").strip()
        draft = re.fullmatch(r"(?i)draft.*", text)
        if text and not draft and not re.fullmatch(r"[12]([-.].*)?", text):
            raise self.fail(f"SSP version {shown(text)} is not known; 1.0 and 2.0 are", self.root)
        if draft or not text:
            self.notes.add(VERSION, self.place(self.root))
        return "1" if draft else text[:1] or "1"

    def at(self, element: Any) -> str:
        """`(vehicle.ssp/SystemStructure.ssd, line 12)`."""
        return f"({self.shown}, line {element.sourceline})"

    def place(self, element: Any) -> str:
        """`motor (vehicle.ssp/SystemStructure.ssd, line 12)`."""
        return f"{element.get('name') or local(element)} {self.at(element)}"

    def fail(self, message: str, element: Any) -> InputError:
        return InputError(f"{message} {self.at(element)}")

    @cached_property
    def enumerations(self) -> dict[str, dict[str, str]]:
        """The items of each enumeration that the file defines anywhere, by name: their numbers."""
        return {
            enumeration.get("name", ""): {i.get("name", ""): i.get("value", "") for i in find(enumeration, "Item")}
            for enumerations in self.root.iter("{*}Enumerations")
            for enumeration in find(enumerations, "Enumeration")
        }  # fmt: skip

    def _retag(self, element: Any) -> None:
        """Give what is of SSP, whatever it declares, the standard's names; take out what is not."""
        for child in list(element):
            name = etree.QName(child)
            undeclared = UNDECLARED.fullmatch(name.localname)
            if undeclared:  # noted already
                child.tag = f"{{{NAMESPACES[undeclared[1]]}}}{undeclared[2]}"
            elif name.namespace not in STANDARD:
                if name.namespace is not None and not ALIKE.search(name.namespace):
                    self.notes.add(FOREIGN, f"<{name.localname}> {self.at(child)}")
                    element.remove(child)
                    continue
                self.notes.add(NAMESPACE, f"{name.namespace or 'none'} in {self.shown}")
            if local(child) not in PASSED_OVER:
                self._retag(child)

    def _check(self, element: Any) -> None:
        kind = local(element)
        for attribute in REFUSED_ATTRIBUTES:
            if element.get(attribute) is not None:
                raise self.fail(f"<{kind}>: the attribute {attribute} is not supported", element)
        for attribute in (*REQUIRED_ATTRIBUTES.get(kind, ()), *STATED_ATTRIBUTES.get(kind, ())):
            if element.get(attribute) is None or (not element.get(attribute) and kind not in STATED_ATTRIBUTES):
                state = "missing" if element.get(attribute) is None else "empty"
                raise self.fail(f"<{kind}>: the attribute {attribute} is {state}", element)
        for attribute in sorted(NUMBERS.intersection(element.keys())):
            if not is_finite(element.get(attribute)):
                text = shown(element.get(attribute))
                raise self.fail(f"<{kind}>: {attribute} = '{text}' is no finite number", element)
        needed, children = REQUIRED_CHILDREN.get(kind), list(element)
        if needed and not find(element, needed):
            raise self.fail(f"<{kind}> has no <{needed}> of the namespace of SSP", element)
        for child in children:
            if local(child) in PASSED_OVER or (kind == "Connector" and local(child) == "Clock"):
                continue
            if local(child) not in CHILDREN.get(kind, ()) and (kind not in MISSED or local(child) in DRAFT):
                self.notes.add(FOREIGN, f"<{local(child)}> in <{kind}> {self.at(child)}")
                continue
            if local(child) not in CHILDREN.get(kind, ()):
                name = f" '{shown(child.get('name'))}'" if child.get("name") else ""
                raise self.fail(f"<{local(child)}>{name} in <{kind}> is not supported", child)
            if local(child) in NAMED and not child.get("name"):
                self.notes.add(NAMELESS, f"<{local(child)}> {self.at(child)}")
                element.remove(child)
                continue
            self._check(child)


def is_finite(text: str) -> bool:
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def local(element: Any) -> str:
    """The name of an element without its namespace."""
    return str(etree.QName(element).localname)


def find(element: Any, path: str) -> list[Any]:
    """Elements below this one, by a path of names in whatever namespace: `Connectors/Connector`."""
    found: list[Any] = element.findall("/".join(f"{{*}}{name}" for name in path.split("/")))
    return found


def typed_child(element: Any) -> Any:
    """The element that states the type, unit or value of a connector or parameter; None if there is none."""
    return next((child for child in element.iterchildren(tag=etree.Element) if local(child) in TYPES), None)


def validate(root: Any, shown_: str) -> None:
    """Raise InputError unless the tree is valid against the SSP 1.0 schema of its root element."""
    for fault in faults(root):
        raise InputError(f"{shown_} is no valid SSP file: {fault}")


def faults(root: Any) -> list[str]:
    """What the SSP 1.0 schema of the root element has against a tree, each with its line."""
    schema = _schema(local(root))
    if schema.validate(root):
        return []
    return [f"line {entry.line}: {entry.message}" for entry in schema.error_log]


@cache
def _schema(kind: str) -> Any:
    return etree.XMLSchema(file=str(Path(fmpy.ssp.__file__).parent / "schema" / SCHEMAS[kind]))
