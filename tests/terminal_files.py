"""terminalsAndIcons.xml for tests: terminals as short texts, packed into an FMU that is there."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from helpers import edited

PLACE = "terminalsAndIcons/terminalsAndIcons.xml"
HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n<fmiTerminalsAndIcons fmiVersion="3.0">\n<Terminals>\n'
TAIL = "</Terminals>\n</fmiTerminalsAndIcons>\n"


def member(name: str, variable: str = "", kind: str = "signal") -> str:
    """A variable by a name of the terminal."""
    return f'<TerminalMemberVariable memberName="{name}" variableName="{variable or name}" variableKind="{kind}"/>\n'


def stream(inside: str, outside: str, name: str = "h") -> str:
    """What a flow carries: the variables that come in and that go out."""
    return (
        f'<TerminalStreamMemberVariable inStreamMemberName="{name}_in" outStreamMemberName="{name}_out" '
        f'inStreamVariableName="{inside}" outStreamVariableName="{outside}"/>\n'
    )


def terminal(name: str, *content: str, rule: str = "plug", kind: str = "") -> str:
    """A terminal of members, streams and terminals."""
    stated = f' terminalKind="{kind}"' if kind else ""
    return f'<Terminal name="{name}" matchingRule="{rule}"{stated}>\n{"".join(content)}</Terminal>\n'


def with_terminals(fmu: Path, target: Path, terminals: Iterable[str], place: str = PLACE) -> Path:
    """A copy of an FMU that has terminals."""
    return edited(fmu, target, {place: (HEAD + "".join(terminals) + TAIL).encode()})
