"""The connections and power bonds of a system file, checked against the FMUs at both ends."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from typing import Any

from ..errors import InputError, nearest
from ..fmu.fmu import Fmu
from ..fmu.types import mismatch
from ..toml_file import TomlFile
from ..units import conversion
from .model import Bond, Component, Connection, Requirement
from .settings import TRANSFERS

BOND_KEYS = {"name", "effort", "flow", "sign", "impulse", "displacement", "limit", "limit_relative"}


@dataclass(frozen=True)
class Link:
    """A connection as a file states it. `factor` and `offset`, where given, are all that happens to the value."""

    source: str
    output: str
    target: str
    input_: str
    transfer: str = ""
    factor: float | None = None
    offset: float = 0.0
    where: str = ""

    def __str__(self) -> str:
        return f"{self.source}.{self.output} -> {self.target}.{self.input_}"


def connections_of(file: TomlFile, components: dict[str, Component], entry: object) -> list[Connection]:
    link = entry if isinstance(entry, Link) else _parsed(file, entry)
    source, output, target, input_, transfer = link.source, link.output, link.target, link.input_, link.transfer
    label, where = f"connection {link}", link.where or file.at(str(entry))
    if transfer and transfer not in TRANSFERS:
        raise InputError(f"{label}: unknown transfer '{transfer}'{nearest(transfer, TRANSFERS)} {where}")
    ends = []
    for name, variable, causality, article in (
        (source, output, "output", "no output"),
        (target, input_, "input", "no input"),
    ):
        if name not in components:
            raise InputError(f"{label}: no component '{name}'{nearest(name, components)} {where}")
        fmu = components[name].fmu
        scalars = [s for s in fmu.expand(variable) if fmu.variables[s].causality == causality]
        if not scalars:
            raise InputError(
                f"{label}: {fmu.description.modelName} has {article} '{variable}'"
                f"{_other_causality(fmu, variable, causality) or nearest(variable, fmu.base_names(causality))} {where}"
            )
        ends.append(scalars)
    if len(ends[0]) != len(ends[1]):
        raise InputError(f"{label}: {len(ends[0])} elements cannot drive {len(ends[1])} {where}")
    found = []
    for a, b in zip(*ends, strict=True):
        _check_types(components, (source, a), (target, b), label, where)
        units = [components[source].fmu.variables[a].unit, components[target].fmu.variables[b].unit]
        try:
            gain, offset = conversion(units[0], units[1], label) if link.factor is None else (link.factor, link.offset)
        except InputError as error:
            raise InputError(f"{error} {where}") from None
        found.append(Connection((source, a), (target, b), transfer or "", gain, offset, where))
    return found


def _parsed(file: TomlFile, entry: object) -> Link:
    match = re.fullmatch(r"(\w+)\.(\S+)\s*->\s*(\w+)\.(\S+)(?:\s+\((\S+)\))?", str(entry).strip())
    if match is None:
        raise file.fail(
            f'connection {entry!r} is not of the form "a.output -> b.input" or "a.output -> b.input (mean)"', str(entry)
        )
    source, output, target, input_, transfer = match.groups(default="")
    return Link(source, output, target, input_, transfer)


def _other_causality(fmu: Fmu, name: str, wanted: str) -> str:
    there = fmu.expand(name)
    found = fmu.variables[there[0]].causality if there else ""
    return f"; its '{name}' is declared with causality {found}, where {wanted} is needed" if found else ""


def _check_types(
    components: dict[str, Component], source: tuple[str, str], target: tuple[str, str], label: str, where: str
) -> None:
    ends = [(components[name].fmu, variable) for name, variable in (source, target)]
    (a, u), (b, v) = ends
    reason = mismatch(a.variables[u], a.type_of(u), b.variables[v], b.type_of(v))
    if reason:
        types = [fmu.variables[variable].type for fmu, variable in ends]
        raise InputError(
            f"{label}: {'.'.join(source)} is of type {types[0]}, {'.'.join(target)} of type {types[1]}: "
            f"{reason} {where}"
        )


def check_drivers(file: TomlFile, components: dict[str, Component], connections: tuple[Connection, ...]) -> None:
    """Every input has exactly one origin: one connection, or a value in the file."""
    driver: dict[tuple[str, str], Connection] = {}
    for connection in connections:
        label = ".".join(connection.target)
        if connection.target in driver:
            raise InputError(
                f"input {label} is driven twice: by {driver[connection.target].label} and by {connection.label} "
                f"{connection.where}"
            )
        target = components[connection.target[0]]
        if connection.target[1] in (*target.inputs, *target.series):
            raise file.fail(
                f"input {label} is driven by {connection.label} and has a value too; remove one",
                connection.target[1].split("[")[0],
                f"components.{connection.target[0]}",
            )
        driver[connection.target] = connection
    for component in components.values():
        for name in component.fmu.names("input"):
            known = component.fmu.type_of(name) is not None  # Binary and Clock inputs keep what the FMU starts with
            given = (component.name, name) in driver or name in component.inputs or name in component.series
            if known and not given:
                start = component.fmu.variables[name].start
                base = name.split("[")[0]
                raise file.fail(
                    f"input {component.name}.{name} has no driver; connect it, or give it a value under "
                    f"[components.{component.name}.inputs], for instance {base} = {start}",
                    f"[components.{component.name}]",
                )


def bond_of(
    file: TomlFile, components: dict[str, Component], connections: tuple[Connection, ...], entry: dict[str, Any]
) -> Bond:
    """`effort` and `flow` name the connected inputs that carry them; they must cross between the same components.

    `flow` may also name an output of the component that receives the effort: a flow that the other side is not told of.
    """
    by_target = {".".join(c.target): c for c in connections}
    ends = []
    name = str(entry.get("name", entry.get("effort")))
    for key in entry.keys() - BOND_KEYS:
        raise file.fail(f"bond {name}: unknown key '{key}'{nearest(key, BOND_KEYS)}", key, "bonds")
    if entry.get("sign", 1.0) not in (1.0, -1.0):
        raise file.fail(f"bond {name}: sign = {entry['sign']!r} must be 1 or -1", "sign", "bonds")
    sign = float(entry.get("sign", 1.0))
    limits: dict[str, Any] = {
        key: _limit(file, name, key, entry) for key in ("limit", "limit_relative") if key in entry
    }
    owner, _, variable = str(entry.get("flow")).partition(".")
    if entry.get("effort") in by_target and owner in components and variable in components[owner].fmu.names("output"):
        effort = by_target[entry["effort"]]
        if effort.target[0] == owner:
            pair = (".".join(effort.source), ".".join(effort.target))
            return _with_counters(
                file, components, entry, Bond(name, pair, (f"{owner}.{variable}", ""), sign, **limits)
            )
    for key in ("effort", "flow"):
        if entry.get(key) not in by_target:
            raise file.fail(
                f"bond {entry.get('name')}: {key} = {entry.get(key)!r} is no connected input"
                f"{nearest(str(entry.get(key)), by_target)}",
                str(entry.get(key)),
            )
        ends.append(by_target[entry[key]])
    if ends[0].source[0] != ends[1].target[0] or ends[0].target[0] != ends[1].source[0]:
        raise file.fail(
            f"bond {entry.get('name')}: effort and flow do not cross between the same two components",
            str(entry["effort"]),
        )
    pairs = [(".".join(c.source), ".".join(c.target)) for c in ends]
    return _with_counters(file, components, entry, Bond(name, pairs[0], pairs[1], sign, **limits))


def _limit(file: TomlFile, name: str, key: str, entry: dict[str, Any]) -> float:
    value = entry[key]
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not value >= 0.0:
        unit = " of J" if key == "limit" else ""
        raise file.fail(f"bond {name}: {key} = {value!r} must be a number{unit}, 0 or more", key, "bonds")
    return float(value)


def _with_counters(file: TomlFile, components: dict[str, Component], entry: dict[str, Any], bond: Bond) -> Bond:
    """`impulse` and `displacement`: outputs of the sources of effort and flow that count their time integrals."""
    for key, source in (("impulse", bond.effort[0]), ("displacement", bond.flow[0])):
        if key not in entry:
            continue
        owner, _, variable = str(entry[key]).partition(".")
        outputs = [f"{owner}.{v}" for v in components[owner].fmu.names("output")] if owner in components else []
        if owner != source.partition(".")[0] or f"{owner}.{variable}" not in outputs:
            known = components[source.partition(".")[0]].fmu.names("output")
            raise file.fail(
                f"bond {bond.name}: {key} = {entry[key]!r} is no output of {source.partition('.')[0]}, "
                f"which gives {source}{nearest(variable, known)}",
                str(entry[key]),
            )
        found: dict[str, Any] = {key: f"{owner}.{variable}"}
        bond = replace(bond, **found)
    for name in filter(None, (*bond.effort, *bond.flow, bond.impulse, bond.displacement)):
        owner, _, variable = name.partition(".")
        if not components[owner].fmu.is_real(variable):
            raise file.fail(f"bond {bond.name}: {name} is no floating-point signal and carries no power", "bonds")
    return bond


def requirement_of(file: TomlFile, components: dict[str, Component], entry: dict[str, Any]) -> Requirement:
    """`value` names an output; `minimum`, `maximum` bound it at time 0; `message` says what is wrong otherwise."""
    text = str(entry.get("value"))
    name, _, variable = text.partition(".")
    if name not in components or variable not in components[name].fmu.names("output"):
        outputs = [f"{c.name}.{v}" for c in components.values() for v in c.fmu.names("output")]
        raise file.fail(f"require: '{text}' is no output{nearest(text, outputs)}", text, "require")
    bounds = []
    for key, free in (("minimum", -math.inf), ("maximum", math.inf)):
        bound = entry.get(key, free)
        if isinstance(bound, bool) or not isinstance(bound, (int, float)):
            raise file.fail(f"require {text}: {key} = {bound!r} must be a number", key, "require")
        bounds.append(float(bound))
    return Requirement((name, variable), bounds[0], bounds[1], str(entry.get("message", "out of bounds at time 0")))
