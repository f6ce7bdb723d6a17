"""The terminals of an FMU: named groups of variables that are connected together (FMI 3.0, section 2.4.9).

They stand in a file of their own, which FMUs of FMI 2.0 may have too. Nothing in a run needs it: what is wrong there is
passed over and noted.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ...errors import FmuError
from ..tolerant.literals import place
from ..tolerant.rules import TERMINAL, TERMINALS_FILE, Notes
from ..tolerant.xml import safe_xml

FILE, ROOT = "terminalsAndIcons.xml", "fmiTerminalsAndIcons"
BY_NAME, BUS, SEQUENCE = "plug", "bus", "sequence"  # the matching rules of the standard
SIGNAL, INFLOW, OUTFLOW = "signal", "inflow", "outflow"  # the kinds of variables of the standard
DEEPEST = 20  # terminals in terminals


@dataclass(frozen=True)
class Member:
    """A variable of a terminal, by the name that the other side knows it by (empty where the order tells)."""

    name: str
    variable: str
    kind: str = SIGNAL  # or "inflow", "outflow", or what another standard says


@dataclass(frozen=True)
class Stream:
    """A quantity that a flow carries: what comes with what flows in, and what goes with what flows out."""

    inside: Member
    outside: Member


@dataclass(frozen=True)
class Terminal:
    """A terminal, its variables, and the terminals in it."""

    name: str
    rule: str  # how members find each other: by name, all ("plug") or those that are there ("bus"), or "sequence"
    kind: str = ""
    description: str = ""
    members: tuple[Member, ...] = ()
    streams: tuple[Stream, ...] = ()
    terminals: tuple[Terminal, ...] = ()

    def all(self, path: str = "") -> Iterator[tuple[str, Terminal]]:
        """Itself and those in it, with their names: `port`, `port.inner`."""
        name = f"{path}.{self.name}" if path else self.name
        yield name, self
        for inner in self.terminals:
            yield from inner.all(name)


def terminals_of(path: Path, folder: Path, variables: Collection[str], notes: Notes) -> dict[str, Terminal]:
    """The terminals of an unpacked FMU by name, with those inside of others; what they hold are `variables`."""
    places = [folder / "terminalsAndIcons" / FILE, *sorted(folder.glob(f"extra/*/{FILE}"))]
    found = next((file for file in places if file.is_file()), None)
    if found is None:
        return {}
    try:
        root = safe_xml(path, found, notes)
    except (FmuError, OSError) as error:
        notes.add(TERMINALS_FILE, str(error))
        return {}
    if root.tag != ROOT:
        notes.add(TERMINALS_FILE, f"it begins with <{root.tag}>")
        return {}
    reader = _Reader(variables, notes)
    return dict(entry for terminal in reader.terminals(root.findall("Terminals/Terminal")) for entry in terminal.all())


class _Reader:
    def __init__(self, variables: Collection[str], notes: Notes) -> None:
        self.variables, self.notes = variables, notes

    def note(self, element: Any, what: str) -> None:
        self.notes.add(TERMINAL, f"{what} {place(element)} in {FILE}")

    def terminals(self, elements: list[Any], depth: int = 0) -> tuple[Terminal, ...]:
        found: dict[str, Terminal] = {}
        for element in elements:
            name = (element.get("name") or "").strip()
            if not name or name in found or depth > DEEPEST:
                self.note(element, "another of the name," if name in found else "")
                continue
            rule = element.get("matchingRule") or ""
            if not rule:
                self.note(element, "no matchingRule of")
            found[name] = Terminal(
                name, rule or BY_NAME, element.get("terminalKind") or "", element.get("description") or "",
                self.members(element, rule), self.streams(element),
                self.terminals(element.findall("Terminal"), depth + 1),
            )  # fmt: skip
        return tuple(found.values())

    def members(self, terminal: Any, rule: str) -> tuple[Member, ...]:
        found: list[Member] = []
        for element in terminal.findall("TerminalMemberVariable"):
            name, variable = element.get("memberName") or "", element.get("variableName") or ""
            member = Member(name, variable, element.get("variableKind") or SIGNAL)
            named = member.name and member.name not in [known.name for known in found]
            if member.variable in self.variables and (named or rule == SEQUENCE):
                found.append(member)
            else:
                self.note(element, f"{member.name or member.variable!r} of")
        return tuple(found)

    def streams(self, terminal: Any) -> tuple[Stream, ...]:
        found: list[Stream] = []
        for element in terminal.findall("TerminalStreamMemberVariable"):
            ends = [
                Member(element.get(f"{side}StreamMemberName") or "", element.get(f"{side}StreamVariableName") or "")
                for side in ("in", "out")
            ]
            if all(end.name and end.variable in self.variables for end in ends):
                found.append(Stream(*ends))
            else:
                self.note(element, f"{' and '.join(end.name or end.variable for end in ends)!r} of")
        return tuple(found)


def as_data(terminals: Mapping[str, Terminal]) -> list[dict[str, Any]]:
    """Ready for JSON; those in others by their whole names."""
    return [
        {
            "name": name, "matchingRule": t.rule, "terminalKind": t.kind, "description": t.description,
            "members": [{"name": m.name, "variable": m.variable, "kind": m.kind} for m in t.members],
            "streams": [
                {
                    "in": {"name": s.inside.name, "variable": s.inside.variable},
                    "out": {"name": s.outside.name, "variable": s.outside.variable},
                }
                for s in t.streams
            ],
        }
        for name, t in terminals.items()
    ]  # fmt: skip
