"""The XML files of an SSP, read safely: no entities, nothing remote, and no element that would be passed over."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any

import fmpy.ssp
from lxml import etree

from ...errors import InputError

BASE = "http://ssp-standard.org/SSP1/SystemStructure"
NAMESPACES = {
    "ssc": f"{BASE}Common",
    "ssd": f"{BASE}Description",
    "ssv": f"{BASE}ParameterValues",
    "ssm": f"{BASE}ParameterMapping",
}
SCHEMAS = {
    "SystemStructureDescription": "SystemStructureDescription.xsd",
    "ParameterSet": "SystemStructureParameterValues.xsd",
    "ParameterMapping": "SystemStructureParameterMapping.xsd",
}
TYPES = {"Real", "Integer", "Boolean", "String", "Enumeration", "Float64", "Float32"}
TYPES |= {f"{sign}Int{bits}" for sign in ("", "U") for bits in (8, 16, 32, 64)}
MAPPINGS = {"BooleanMappingTransformation", "IntegerMappingTransformation", "EnumerationMappingTransformation"}

# What is read, by the element that it stands in. Whatever else stands there is an error that names it.
CHILDREN = {
    "SystemStructureDescription": {"System", "Units", "DefaultExperiment"},
    "System": {"Connectors", "ParameterBindings", "Elements", "Connections"},
    "Elements": {"Component", "System"},
    "Component": {"Connectors", "ParameterBindings"},
    "Connectors": {"Connector"},
    "Connector": TYPES,
    "Connections": {"Connection"},
    "Connection": {"LinearTransformation"},
    "ParameterBindings": {"ParameterBinding"},
    "ParameterBinding": {"ParameterValues", "ParameterMapping"},
    "ParameterValues": {"ParameterSet"},
    "ParameterSet": {"Parameters", "Units"},
    "Parameters": {"Parameter"},
    "Parameter": TYPES,
    "ParameterMapping": {"ParameterMapping", "MappingEntry"},
    "MappingEntry": {"LinearTransformation", *MAPPINGS},
    **{name: {"MapEntry"} for name in MAPPINGS},
    "Units": {"Unit"},
    "Unit": {"BaseUnit"},
    **{name: {"Value"} for name in ("String", "Enumeration")},
}
# What has no bearing on a simulation: drawings, names of enumeration items (the FMUs have them), signatures.
PASSED_OVER = {"ElementGeometry", "ConnectorGeometry", "ConnectionGeometry", "SystemGeometry", "GraphicalElements"}
PASSED_OVER |= {"Enumerations", "Annotations", "MetaData", "Signature"}
REFUSED_ATTRIBUTES = ("startIndices", "endIndices")
# What must be there and what must be a number, in versions too for which there is no schema.
REQUIRED_CHILDREN = {"SystemStructureDescription": "ssd:System", "Unit": "ssc:BaseUnit"}
REQUIRED_ATTRIBUTES = {
    **{name: ("name",) for name in ("SystemStructureDescription", "System", "Component", "Parameter", "Unit")},
    "Connector": ("name", "kind"),
    "Connection": ("startConnector", "endConnector"),
    **{name: ("source", "target") for name in ("MappingEntry", "MapEntry")},
}
NUMBERS = {"factor", "offset", "startTime", "stopTime"}


class Document:
    """One XML file, and where its elements stand in it. `shown` is what messages call it."""

    def __init__(self, path: Path, shown: str, kind: str) -> None:
        """Read, validate and check. `kind` is the name of the root element. Raises InputError."""
        self.path, self.shown = path, shown
        parser = etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False)
        try:
            tree = etree.parse(str(path), parser)
        except OSError:
            raise InputError(f"{shown} does not exist") from None
        except etree.XMLSyntaxError as error:
            raise InputError(f"{shown} is not well-formed XML: {error}") from error
        if tree.docinfo.doctype:
            raise InputError(f"{shown} has a document type declaration, which can open files; remove it")
        self.root = tree.getroot()
        self.version = str(self.root.get("version"))
        if local(self.root) != kind:
            raise self.fail(f"<{local(self.root)}> is no <{kind}>", self.root)
        if self.version.startswith("1."):
            validate(self.root, shown)
        elif self.version != "2.0":
            raise self.fail(f"SSP version {self.version} is not known; 1.0 and 2.0 are", self.root)
        self._check(self.root)

    def at(self, element: Any) -> str:
        """`(vehicle.ssp/SystemStructure.ssd, line 12)`."""
        return f"({self.shown}, line {element.sourceline})"

    def fail(self, message: str, element: Any) -> InputError:
        return InputError(f"{message} {self.at(element)}")

    def _check(self, element: Any) -> None:
        for attribute in REFUSED_ATTRIBUTES:
            if element.get(attribute) is not None:
                raise self.fail(f"<{local(element)}>: the attribute {attribute} is not supported", element)
        for attribute in REQUIRED_ATTRIBUTES.get(local(element), ()):
            if not element.get(attribute):
                state = "missing" if element.get(attribute) is None else "empty"
                raise self.fail(f"<{local(element)}>: the attribute {attribute} is {state}", element)
        for attribute in sorted(NUMBERS.intersection(element.keys())):
            if not is_finite(element.get(attribute)):
                text = element.get(attribute)
                raise self.fail(f"<{local(element)}>: {attribute} = '{text}' is no finite number", element)
        needed, children = REQUIRED_CHILDREN.get(local(element)), list(element.iterchildren(tag=etree.Element))
        if needed and not find(element, needed):
            raise self.fail(f"<{local(element)}> has no <{needed.partition(':')[2]}> of the namespace of SSP", element)
        for child in children:
            if local(child) in PASSED_OVER:
                continue
            if local(child) not in CHILDREN.get(local(element), ()):
                name = f" '{child.get('name')}'" if child.get("name") else ""
                raise self.fail(f"<{local(child)}>{name} in <{local(element)}> is not supported", child)
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
    """Elements below this one, by a path of prefixed names: `ssd:Connectors/ssd:Connector`."""
    found: list[Any] = element.findall(path, NAMESPACES)
    return found


def typed_child(element: Any) -> Any:
    """The element that states the type, unit or value of a connector or parameter; None if there is none."""
    return next((child for child in element.iterchildren(tag=etree.Element) if local(child) in TYPES), None)


def validate(root: Any, shown: str) -> None:
    """Raise InputError unless the tree is valid against the SSP 1.0 schema of its root element."""
    schema = _schema(local(root))
    if not schema.validate(root):
        entry = schema.error_log[0]
        raise InputError(f"{shown} is no valid SSP file: {entry.message} ({shown}, line {entry.line})")


@cache
def _schema(kind: str) -> Any:
    return etree.XMLSchema(file=str(Path(fmpy.ssp.__file__).parent / "schema" / SCHEMAS[kind]))
