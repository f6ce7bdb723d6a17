"""The reference of the command line, from the declarations that it is made of."""

from __future__ import annotations

import re
from importlib import import_module
from typing import Any

import typer

from .sections import wide


def commands() -> dict[str, Any]:
    """The commands by name, in the order of the alphabet."""
    group: Any = typer.main.get_command(import_module("rovbrush.orchestrator.cli.main").app)
    return dict(sorted(group.commands.items()))


def reference() -> str:
    """A section for each command: what it does, how it is called, its arguments and options."""
    return "\n\n".join(_section(name, command) for name, command in commands().items())


def _section(name: str, command: Any) -> str:
    arguments = [p for p in command.params if p.param_type_name == "argument"]
    options = [p for p in command.params if p.param_type_name == "option" and not p.hidden]
    call = " ".join(["rovbrush", name, *(_argument(p) for p in arguments), *(["[OPTIONS]"] if options else [])])
    rows = [f"| `{_argument(p)}` | {text(p.help)} |" for p in arguments]
    rows += [f"| {_option(p)} | {text(p.help)}{_default(p)} |" for p in options]
    table = ["", wide("\n".join(["| | |", "|---|---|", *rows]))] if rows else []
    return "\n".join([f"({anchor(name)})=", f"## {name}", "", text(command.help), "", "```text", call, "```", *table])


def anchor(name: str) -> str:
    """Where other pages find a command."""
    return f"rovbrush-{name}"


def text(said: str | None) -> str:
    """A help text within a cell of a table."""
    return re.sub(r"\s+", " ", said or "").strip().replace("|", "\\|")


def _argument(p: Any) -> str:
    name = p.metavar or p.name.upper()
    return name if p.required or name.startswith("[") else f"[{name}]"


def _option(p: Any) -> str:
    names = ", ".join(f"`{name}`" for name in (*p.opts, *p.secondary_opts))
    return names if isinstance(p.default, bool) else f"{names} `{p.metavar or 'VALUE'}`"


def _default(p: Any) -> str:
    if p.default in (None, "", [], (), False, True) or callable(p.default):
        return ""
    return f" Else `{p.default}`."
