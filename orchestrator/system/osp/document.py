"""The XML files of OSP, read safely: an OspSystemStructure.xml, and OspModelDescription.xml of its FMUs."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from lxml import etree

from ...errors import FmuError, InputError, shown
from ...fmu.tolerant.rules import Notes, Rule
from ...fmu.tolerant.xml import read_xml
from ..ssp.files.rules import FOREIGN

# What is read, by the element that it stands in; what else stands there is passed over and noted, but for what lies in
# the first three: a connection or a function that is passed over would be another system.
NEEDED = {"Connections", "Functions", "Simulators"}
CHILDREN = {
    "OspSystemStructure": {
        "StartTime", "EndTime", "BaseStepSize", "Algorithm", "Simulators", "Functions", "Connections",
        "EccoConfiguration", "Description", "VariableConnections",
    },
    "Simulators": {"Simulator"},
    "Simulator": {"InitialValues"},
    "InitialValues": {"InitialValue"},
    "InitialValue": {"Real", "Integer", "Boolean", "String", "Enumeration"},
    "Functions": {"LinearTransformation", "Sum", "VectorSum"},
    "Connections": {"VariableConnection", "SignalConnection", "VariableGroupConnection", "SignalGroupConnection"},
    "VariableConnection": {"Variable"},
    "SignalConnection": {"Variable", "Signal"},
    "VariableGroupConnection": {"VariableGroup"},
    "SignalGroupConnection": {"VariableGroup", "SignalGroup"},
    "VariableConnections": {"ScalarConnection"},  # of the first versions
    "ScalarConnection": {"Source", "Target"},
}  # fmt: skip
REQUIRED = {
    "Simulator": ("name", "source"), "InitialValue": ("variable",), "Variable": ("simulator", "name"),
    "VariableGroup": ("simulator", "name"), "Signal": ("function", "name"), "SignalGroup": ("function", "name"),
    "Source": ("simulator", "endpoint"), "Target": ("simulator", "endpoint"),
    "LinearTransformation": ("name",), "Sum": ("name", "inputCount"), "VectorSum": ("name", "inputCount", "dimension"),
}  # fmt: skip
EARLY = Rule("connections as the first versions wrote them", "taken as variables", "write VariableConnection")


class OspDocument:
    """One file, and where its elements stand in it."""

    def __init__(self, path: Path, kind: str, notes: Notes) -> None:
        """Read and check. `kind` is the name of the root element. Raises InputError."""
        self.path, self.notes = path, notes
        try:
            self.root = read_xml(path, path.name, notes)
        except OSError as error:
            raise InputError(f"{path.name} cannot be read: {error.strerror}") from None
        except FmuError as error:
            raise InputError(str(error)) from None
        if local(self.root) != kind:
            raise self.fail(f"<{local(self.root)}> is no <{kind}>", self.root)
        if kind == "OspSystemStructure":
            self._check(self.root)

    def at(self, element: Any) -> str:
        """`(OspSystemStructure.xml, line 12)`."""
        return f"({self.path.name}, line {element.sourceline})"

    def fail(self, message: str, element: Any) -> InputError:
        return InputError(f"{message} {self.at(element)}")

    def text(self, name: str) -> str:
        """The text of an element of the root; empty where there is none."""
        return next(((element.text or "").strip() for element in find(self.root, name)), "")

    def number(self, text: str, what: str, element: Any, default: float | None = None) -> float:
        """A finite number. Raises InputError for anything else, and for none without a `default`."""
        if not text and default is not None:
            return default
        try:
            found = float(text)
            if math.isfinite(found):
                return found
        except ValueError:
            pass
        raise self.fail(f"{what} = '{shown(text)}' is no finite number", element)

    def _check(self, element: Any) -> None:
        kind = local(element)
        for attribute in REQUIRED.get(kind, ()):
            if not element.get(attribute):
                state = "missing" if element.get(attribute) is None else "empty"
                raise self.fail(f"<{kind}>: the attribute {attribute} is {state}", element)
        for child in list(element):
            if kind in CHILDREN and local(child) not in CHILDREN[kind]:
                if kind in NEEDED:
                    raise self.fail(f"<{local(child)}> in <{kind}> is not supported", child)
                if len(child) or (child.text or "").strip():  # an empty list of something is nothing
                    self.notes.add(FOREIGN, f"<{local(child)}> {self.at(child)}")
            elif kind != "EccoConfiguration":
                self._check(child)


def local(element: Any) -> str:
    """The name of an element without its namespace."""
    return str(etree.QName(element).localname)


def find(element: Any, path: str) -> list[Any]:
    """Elements below this one, by a path of names in whatever namespace."""
    found: list[Any] = element.findall("/".join(f"{{*}}{name}" for name in path.split("/")))
    return found


def in_order(element: Any, *names: str) -> Iterator[Any]:
    """The children of these names, in the order of the file."""
    for child in element:
        if local(child) in names:
            yield child
