"""The connections of a system file, checked against the FMUs at both ends."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from ....errors import InputError, nearest
from ....fmu.conversions import LossyError, conversion_of
from ....fmu.fmu import Fmu
from ....toml.file import TomlFile
from ....units import conversion
from ...component import Component
from ...connection import Connection
from ...schema.keys.system import TRANSFERS
from .clock_links import clock_connection
from .counters import counters_of
from .link import ROUND, Link
from .terminals import links_of_terminals

ANYTHING = "application/octet-stream"  # the kind of bytes that state none
OF = re.compile(r"mean\s+of\s+(\S.*)")
WORDS = r"\w+(?:\s*,\s*\w+)?|mean\s+of\s+\S.*"  # in brackets behind a connection


def connections_of(file: TomlFile, components: dict[str, Component], entry: object) -> list[Connection]:
    """The connections of an entry: of two variables, of the elements of two arrays, or of all that two terminals have
    in common. Raises InputError."""
    if isinstance(entry, Link):
        return _of_variables(components, entry, entry.where or file.at(str(entry)))
    link, where = _parsed(file, components, entry), file.at(str(entry))
    links = links_of_terminals(components, link, where)
    if links and link.counter:
        raise InputError(f"connection {link}: mean of {link.counter} is of one output, not of a terminal {where}")
    links = links or [link]
    return [connection for one in links for connection in _of_variables(components, one, one.where or where)]


def _of_variables(components: dict[str, Component], link: Link, where: str) -> list[Connection]:
    source, output, target, input_, transfer = link.source, link.output, link.target, link.input_, link.transfer
    label = f"connection {link}"
    if transfer and transfer not in TRANSFERS:
        raise InputError(f"{label}: unknown transfer '{transfer}'{nearest(transfer, (*TRANSFERS, ROUND))} {where}")
    if (ticks := clock_connection(components, (source, output), (target, input_), transfer, where)) is not None:
        return [ticks]
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
            known = [*fmu.base_names(causality), *fmu.terminals]
            why = _other_causality(fmu, variable, causality) or nearest(variable, known)
            raise InputError(f"{label}: {fmu.description.modelName} has {article} '{variable}'{why} {where}")
        ends.append(scalars)
    if len(ends[0]) != len(ends[1]):
        raise InputError(f"{label}: {len(ends[0])} elements cannot drive {len(ends[1])} {where}")
    found = []
    counters = counters_of(components, link, ends[0], where)
    for a, b, (counter, per_second) in zip(*ends, counters, strict=True):
        rounded = _loses(components, (source, a), (target, b), link, where)
        units = components[source].fmu.unit(a), components[target].fmu.unit(b)
        try:
            gain, offset = conversion(*units, label) if link.factor is None else (link.factor, link.offset)
        except InputError as error:
            raise InputError(f"{error} {where}") from None
        gain, offset = link.sign * gain, link.sign * offset + 0.0  # no -0.0
        real = components[source].fmu.is_real(a) or components[target].fmu.is_real(b)
        if (gain, offset) != (1.0, 0.0) and not real:
            kind = components[target].fmu.variables[b].type
            raise InputError(f"{label}: a {kind} is not transformed, by {gain:g} x + {offset:g}; remove that {where}")
        by = (counter, per_second)
        found.append(Connection((source, a), (target, b), transfer, gain, offset, where, rounded, *by))
    return found


def _parsed(file: TomlFile, components: Mapping[str, Component], entry: object) -> Link:
    """The ends of a connection: names that the FMUs have, whatever characters are in them."""
    text = str(entry).strip()
    match = re.fullmatch(rf"(.*\S)\s+\(({WORDS})\)", text)
    for whole, words in ((text, ""), *([(match[1], match[2])] if match else [])):
        for arrow in re.finditer("->", whole):
            ends = [part.strip().partition(".") for part in (whole[: arrow.start()], whole[arrow.end() :])]
            (source, _, output), (target, _, input_) = ends
            if _is(components, source, output, "output") and _is(components, target, input_, "input"):
                return _worded(Link(source, output, target, input_), words)
    match = re.fullmatch(r"(\w+)\.(.+?)\s*->\s*(\w+)\.(.+?)(?:\s+\((mean\s+of\s+.+|\w[^()]*)\))?", text)
    if match is None:
        raise file.fail(
            f'connection {entry!r} is not of the form "a.output -> b.input" or "a.output -> b.input (mean)"', str(entry)
        )
    source, output, target, input_, words = match.groups(default="")
    return _worded(Link(source, output, target, input_), words)


def _worded(link: Link, words: str) -> Link:
    """With what stands in brackets behind it: a transfer, `round`, or both; or `mean of` a counter."""
    if of := OF.fullmatch(words):
        return replace(link, transfer="mean", counter=of[1])
    said = [word.strip() for word in words.split(",")] if words else []
    others = [word for word in said if word != ROUND]
    return replace(link, transfer=", ".join(others), rounded=ROUND in said)


def _is(components: Mapping[str, Component], name: str, variable: str, causality: str) -> bool:
    """Whether a component has this variable, or array, of a causality."""
    if name not in components:
        return False
    fmu = components[name].fmu
    return variable in fmu.variables and fmu.variables[variable].causality == causality


def _other_causality(fmu: Fmu, name: str, wanted: str) -> str:
    there = fmu.expand(name)
    found = fmu.variables[there[0]].causality if there else ""
    return f"; its '{name}' is declared with causality {found}, where {wanted} is needed" if found else ""


def _loses(
    components: dict[str, Component], source: tuple[str, str], target: tuple[str, str], link: Link, where: str
) -> bool:
    """Whether values may lose something, as the link allows. Raises InputError where that is not allowed, or there is
    no conversion."""
    (a, u), (b, v) = ((components[name].fmu, variable) for name, variable in (source, target))
    kinds = [fmu.detail(name, "mimeType") or ANYTHING for fmu, name in ((a, u), (b, v))]
    if ANYTHING not in kinds and kinds[0] != kinds[1]:
        raise InputError(
            f"connection {link}: {kinds[0]} and {kinds[1]} are different kinds of data (mimeType); put an FMU between "
            f"that makes one of the other {where}"
        )
    try:
        conversion_of(a.variables[u], a.type_of(u), b.variables[v], b.type_of(v))
    except InputError as error:
        if link.rounded and isinstance(error, LossyError):
            return True
        words = ", ".join(filter(None, (link.transfer, ROUND)))
        mend = f'; write "{link} ({words})" for the nearest it holds' if isinstance(error, LossyError) else ""
        raise InputError(
            f"connection {link}: {'.'.join(source)} is of type {a.variables[u].type}, {'.'.join(target)} of type "
            f"{b.variables[v].type}: {error}{mend} {where}"
        ) from None
    return False


def check_drivers(file: TomlFile, components: dict[str, Component], connections: tuple[Connection, ...]) -> None:
    """No input has two origins: a connection and another one, or a value in the file."""
    driver: dict[tuple[str, str], Connection] = {}
    for connection in connections:
        label = ".".join(connection.target)
        if connection.target in driver:
            raise InputError(
                f"input {label} is driven twice: by {driver[connection.target].label} and by {connection.label} "
                f"{connection.where}"
            )
        target = components[connection.target[0]]
        if connection.target[1] in target.inputs or connection.target[1] in target.series:
            raise file.fail(
                f"input {label} is driven by {connection.label} and has a value too; remove one",
                connection.target[1].split("[")[0],
                f"components.{connection.target[0]}",
            )
        driver[connection.target] = connection
