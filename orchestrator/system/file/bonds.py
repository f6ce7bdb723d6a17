"""The power bonds of a system file, and what it requires at time 0, checked against connections and FMUs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from msgspec import structs

from ...errors import InputError, nearest
from ...fmu.types import BINARY, TEXT
from ...toml.file import TomlFile
from ...units import conversion
from ..component import Component
from ..connection import Bond, Connection
from ..model import Requirement
from ..schema.checked import checked
from ..schema.keys.bonds import BondTable, RequirementTable


def bonds_of(
    file: TomlFile,
    components: Mapping[str, Component],
    connections: tuple[Connection, ...],
    entries: list[dict[str, Any]],
) -> tuple[Bond, ...]:
    """All bonds. Raises InputError."""
    by_target = {".".join(c.target): c for c in connections} if entries else {}
    return tuple(_bond(file, components, by_target, entry) for entry in entries)


def _bond(
    file: TomlFile, components: Mapping[str, Component], by_target: Mapping[str, Connection], entry: dict[str, Any]
) -> Bond:
    """`effort` and `flow` name the connected inputs that carry them; they must cross between the same components.

    `flow` may also name an output of the component that receives the effort: a flow that the other side is not told of.
    """
    label = f"bond {entry.get('name', entry.get('effort'))}"
    for key in ("effort", "flow"):
        if key not in entry:
            raise file.fail(f"{label}: {key} = None is no connected input{nearest('', by_target)}", label, "bonds")
    table = checked(BondTable, entry, label, file, "bonds")
    table = structs.replace(table, effort=_main(components, table.effort), flow=_main(components, table.flow))
    bond = Bond(
        table.name or table.effort, ("", ""), ("", ""), table.sign,
        limit=math.inf if table.limit is None else table.limit,
        limit_relative=math.inf if table.limit_relative is None else table.limit_relative,
    )  # fmt: skip
    owner, _, variable = table.flow.partition(".")
    if table.effort in by_target and owner in components and _is_output(components[owner], variable):
        effort = by_target[table.effort]
        if effort.target[0] == owner:
            bond = replace(bond, effort=_ends(effort), flow=(table.flow, ""))
            return _with_counters(file, components, table, bond)
    ends = []
    for key, text in (("effort", table.effort), ("flow", table.flow)):
        if text not in by_target:
            raise file.fail(
                f"bond {bond.name}: {key} = {text!r} is no connected input{nearest(text, by_target)}", text, "bonds"
            )
        ends.append(by_target[text])
    if ends[0].source[0] != ends[1].target[0] or ends[0].target[0] != ends[1].source[0]:
        raise file.fail(
            f"bond {bond.name}: effort and flow do not cross between the same two components", table.effort, "bonds"
        )
    return _with_counters(file, components, table, replace(bond, effort=_ends(ends[0]), flow=_ends(ends[1])))


def _main(components: Mapping[str, Component], name: str) -> str:
    """`component.variable`, an alias by the name of the variable that it is."""
    owner, _, variable = name.partition(".")
    return f"{owner}.{components[owner].fmu.main_name(variable)}" if owner in components else name


def _ends(connection: Connection) -> tuple[str, str]:
    return ".".join(connection.source), ".".join(connection.target)


def _is_output(component: Component, variable: str) -> bool:
    found = component.fmu.variables.get(variable)
    return found is not None and found.causality == "output"


def _with_counters(file: TomlFile, components: Mapping[str, Component], table: BondTable, bond: Bond) -> Bond:
    """`impulse` and `displacement`: outputs of the sources of effort and flow that count their time integrals."""
    for key, text, source in (
        ("impulse", table.impulse, bond.effort[0]),
        ("displacement", table.displacement, bond.flow[0]),
    ):
        if text is None:
            continue
        owner, _, variable = text.partition(".")
        giver = source.partition(".")[0]
        if owner != giver or not _is_output(components[giver], variable):
            raise file.fail(
                f"bond {bond.name}: {key} = {text!r} is no output of {giver}, which gives {source}"
                f"{nearest(variable, components[giver].fmu.names('output'))}",
                text,
                "bonds",
            )
        bond = replace(bond, impulse=text) if key == "impulse" else replace(bond, displacement=text)
    for name in filter(None, (*bond.effort, *bond.flow, bond.impulse, bond.displacement)):
        owner, _, variable = name.partition(".")
        if not components[owner].fmu.is_real(variable):
            raise file.fail(f"bond {bond.name}: {name} is no floating-point signal and carries no power", "bonds")
    return bond


def requirement_of(file: TomlFile, components: Mapping[str, Component], entry: dict[str, Any]) -> Requirement:
    """`value` names an output or parameter; `minimum`, `maximum` bound it at time 0; `message` says what is wrong
    otherwise. Raises InputError for names that are none, and for bounds whose units do not fit."""
    label = f"require {entry.get('value', '')}".rstrip()
    table = checked(RequirementTable, entry, label, file, "require")
    value = _known(file, components, table.value, "require: '{}' is no output or parameter")
    minimum = _bound(file, components, "minimum", table, value)
    maximum = _bound(file, components, "maximum", table, value)
    return Requirement(
        value,
        -math.inf if minimum is None else minimum,
        math.inf if maximum is None else maximum,
        table.message,
        table.otherwise,
    )


def _bound(
    file: TomlFile, components: Mapping[str, Component], key: str, table: RequirementTable, value: tuple[str, str]
) -> float | tuple[str, str] | None:
    """A bound of a requirement as it is, or by component and variable in a unit that fits the value."""
    bound: float | str | None = getattr(table, key)
    if not isinstance(bound, str):
        return bound
    label = f"require {table.value}: {key}"
    name = _known(file, components, bound, f"{label} = '{{}}' must be a number, an output or a parameter")
    own, wanted = (components[owner].fmu.unit(variable) for owner, variable in (name, value))
    try:
        conversion(own, wanted, label)
    except InputError as error:
        raise file.fail(str(error), bound, "require") from None
    return name


def _known(file: TomlFile, components: Mapping[str, Component], name: str, message: str) -> tuple[str, str]:
    """A floating-point or whole number that can be read at time 0, by component and variable."""
    owner, _, variable = name.partition(".")
    kinds = ("output", "parameter", "calculatedParameter")
    if owner not in components or variable not in components[owner].fmu.names(*kinds):
        names = [f"{c.name}.{v}" for c in components.values() for v in c.fmu.names(*kinds)]
        raise file.fail(message.format(name) + nearest(name, names), name, "require")
    kind = components[owner].fmu.type_of(variable)
    if kind is None or kind.code in (TEXT, BINARY):
        raise file.fail(f"require: {name} is no number", name, "require")
    return owner, variable
