"""The simulators of an OspSystemStructure.xml: their FMUs, steps and initial values."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from ...clock import duration, seconds_text
from ...errors import InputError, shown
from ...fmu.attributes import items_of
from ...fmu.fmu import Fmu
from ..ssp.files.rules import NOT_SETTABLE
from ..values import settable
from .document import OspDocument, find, local

FOLDERS = ("fmus", "FMUs", "fmu")  # beside the file or the folder that it is in, where a source names the file alone


@dataclass(frozen=True)
class Simulator:
    """One FMU. `component` is its name in letters, digits and _."""

    name: str
    component: str
    xml: Any
    fmu: Fmu
    step: str = ""  # s
    values: Mapping[str, str] = field(default_factory=dict)

    @property
    def label(self) -> str:
        return f"simulator '{shown(self.name)}'"


def simulators_of(document: OspDocument, remarks: list[str]) -> dict[str, Simulator]:
    """All simulators by name, in the order of the file. Raises InputError or FmuError."""
    base = document.text("BaseStepSize")
    (base_at,) = find(document.root, "BaseStepSize")[:1] or [document.root]
    step = duration(base, f"BaseStepSize {document.at(base_at)}") if base else None
    found: dict[str, Simulator] = {}
    taken: set[str] = set()
    for xml in find(document.root, "Simulators/Simulator"):
        name = str(xml.get("name"))
        if name in found:
            raise document.fail(f"there are two simulators '{shown(name)}'", xml)
        plain, count = re.sub(r"\W", "_", name), 2
        component = plain
        while component in taken:
            component = f"{plain}_{count}"
            count += 1
        taken.add(component)
        label = f"simulator '{shown(name)}'"
        fmu = Fmu.open(_file(document, xml, label))
        own = _step(document, xml, label, step, remarks)
        found[name] = Simulator(name, component, xml, fmu, own, _values(document, xml, fmu, label))
    if not found:
        raise InputError(f"{document.path.name} holds no simulator: there is nothing to simulate")
    return found


def _file(document: OspDocument, xml: Any, label: str) -> Path:
    """The FMU that a source names, from the file's folder on. Raises InputError."""
    source, folder = str(xml.get("source")).strip(), document.path.parent
    if os.path.exists(folder / source):
        return folder / source
    try:
        uri = urlsplit(source)
    except ValueError as error:
        raise document.fail(f"{label}: source '{shown(source)}' is no address of a file: {error}", xml) from None
    if (len(uri.scheme) > 1 and uri.scheme != "file") or uri.netloc not in ("", "localhost"):
        proxied = re.search(r"[?&]file=([^&]+)", source)
        mend = f': put {shown(proxied[1])} beside the file and write source="{shown(proxied[1])}"' if proxied else ""
        raise document.fail(
            f"{label}: source '{shown(source)}' is on another machine; nothing is fetched from elsewhere{mend}", xml
        )
    path = unquote(uri.path if uri.scheme == "file" else source).replace("\\", "/")
    for candidate in (folder / path, *(near / place / path for near in (folder, folder.parent) for place in FOLDERS)):
        try:
            if os.path.exists(candidate):
                return candidate
        except ValueError:  # NUL
            break
    raise document.fail(f"{label}: there is no file '{shown(source)}' from {folder.name or folder} on", xml)


def _step(document: OspDocument, xml: Any, label: str, base: Fraction | None, remarks: list[str]) -> str:
    """The step [s]: the simulator's own, as a whole number of base steps, else the base step; else empty."""
    text = (xml.get("stepSize") or "").strip()
    if text and document.number(text, f"{label}: stepSize", xml) > 0:
        own = duration(text, f"{label}: stepSize {document.at(xml)}")
        if base is None or (own / base).denominator == 1:
            return f"{own} s"
        whole = max(1, round(own / base)) * base
        remarks.append(
            f"{label}: its step of {seconds_text(own)} is no whole number of base steps; {seconds_text(whole)} is taken"
        )
        return f"{whole} s"
    return "" if base is None else f"{base} s"


def _values(document: OspDocument, xml: Any, fmu: Fmu, label: str) -> dict[str, str]:
    """The initial values that can be set, as text. Raises InputError for what the FMU does not have."""
    found = {}
    for entry in find(xml, "InitialValues/InitialValue"):
        variable = str(entry.get("variable"))
        typed = next((child for child in entry if child.get("value") is not None), None)
        if typed is None:
            raise document.fail(f"{label}: the initial value of '{shown(variable)}' is missing", entry)
        scalars = fmu.expand(variable)
        if scalars and (not settable(fmu.variables[scalars[0]]) or fmu.type_of(scalars[0]) is None):
            document.notes.add(NOT_SETTABLE, f"{xml.get('name')}.{variable} {document.at(entry)}")
            continue
        text = typed.get("value")
        if scalars and local(typed) != "String":
            text = str(items_of(fmu.variables[scalars[0]]).get(text, text))
        found[variable] = text
    return found
