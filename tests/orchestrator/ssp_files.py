"""SSPs written by hand, as other tools write them, for the tests of the import."""

from __future__ import annotations

import zipfile
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from rovbrush.orchestrator.system.model import System

Read = Callable[..., System]  # the fixture `read`

XMLNS = " ".join(
    f'xmlns:{prefix}="http://ssp-standard.org/SSP1/SystemStructure{name}"'
    for prefix, name in (
        ("ssc", "Common"), ("ssd", "Description"), ("ssv", "ParameterValues"),
        ("ssm", "ParameterMapping"), ("ssb", "SignalDictionary"),
    )
)  # fmt: skip


def component(name: str, fmu: str, inside: str = "", **attributes: str) -> str:
    more = "".join(f' {key}="{value}"' for key, value in attributes.items())
    return f'<ssd:Component name="{name}" source="resources/{fmu}.fmu"{more}>{inside}</ssd:Component>'


def connectors(**kinds: str) -> str:
    """`u="input"`, or `u="input|rpm"` with a unit."""
    rows = []
    for name, text in kinds.items():
        kind, _, unit = text.partition("|")
        typed = f'<ssc:Real unit="{unit}"/>' if unit else ""
        rows.append(f'<ssd:Connector name="{name}" kind="{kind}">{typed}</ssd:Connector>')
    return f"<ssd:Connectors>{''.join(rows)}</ssd:Connectors>"


def connection(start: str, end: str, inside: str = "", more: str = "") -> str:
    """`a.y` is a connector of an element, `y` one of the system itself."""
    ends = []
    for side, text in (("start", start), ("end", end)):
        element, dot, name = text.rpartition(".")
        ends.append((f'{side}Element="{element}" ' if dot else "") + f'{side}Connector="{name}"')
    return f"<ssd:Connection {' '.join(ends)} {more}>{inside}</ssd:Connection>"


def system(elements: str, connections: str = "", head: str = "", tail: str = "", name: str = "whole") -> str:
    """`head`: connectors and bindings of the system; `tail`: what stands behind the connections."""
    wires = f"<ssd:Connections>{connections}</ssd:Connections>" if connections else ""
    return f'<ssd:System name="{name}">{head}<ssd:Elements>{elements}</ssd:Elements>{wires}{tail}</ssd:System>'


def bindings(*entries: str) -> str:
    return f"<ssd:ParameterBindings>{''.join(entries)}</ssd:ParameterBindings>"


def inline(values: str, mapping: str = "", prefix: str = "") -> str:
    """A binding with its values inside."""
    mapped = (
        f'<ssd:ParameterMapping><ssm:ParameterMapping version="1.0">{mapping}</ssm:ParameterMapping>'
        "</ssd:ParameterMapping>"
        if mapping
        else ""
    )
    return (
        f'<ssd:ParameterBinding prefix="{prefix}"><ssd:ParameterValues>{value_set(values, "")}</ssd:ParameterValues>'
        f"{mapped}</ssd:ParameterBinding>"
    )


def value_set(values: str, namespaces: str = XMLNS, version: str = "1.0") -> str:
    return (
        f'<ssv:ParameterSet {namespaces} version="{version}" name="values"><ssv:Parameters>{values}</ssv:Parameters>'
        "</ssv:ParameterSet>"
    )


def real(name: str, value: str, unit: str = "") -> str:
    unit = f' unit="{unit}"' if unit else ""
    return f'<ssv:Parameter name="{name}"><ssv:Real value="{value}"{unit}/></ssv:Parameter>'


def document(top: str, units: str = "", experiment: str = 'stopTime="0.1"', version: str = "1.0") -> str:
    default = f"<ssd:DefaultExperiment {experiment}/>" if experiment else ""
    units = f"<ssd:Units>{units}</ssd:Units>" if units else ""
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<ssd:SystemStructureDescription {XMLNS} version="{version}" '
        f'name="stranger">{top}{units}{default}</ssd:SystemStructureDescription>'
    )


def write_ssp_file(
    path: Path, fmus: Path, text: str, used: Iterable[str], files: Mapping[str, str] | None = None
) -> Path:
    """A .ssp with a structure, FMUs by name in resources/, and further text files."""
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("SystemStructure.ssd", text)
        for name in used:
            archive.write(fmus / f"{name}.fmu", f"resources/{name}.fmu")
        for name, content in (files or {}).items():
            archive.writestr(name, content)
    return path


GAINS = component("a", "gain") + component("b", "gain")
CHAIN = system(GAINS, connection("a.y", "b.u"))
