"""Every message of the errors that the code raises, read from its source."""

from __future__ import annotations

import ast
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from .sections import ROOT, wide

MENDS = Path(__file__).parent / "mends.toml"
KINDS = ("InputError", "FmuError", "RunError", "CallError", "LossyError", "ProcessLostError", "NotLoadedError")


@dataclass(frozen=True)
class Message:
    """What an error says; `…` stands for names and values."""

    kind: str
    text: str
    path: Path
    line: int


def messages() -> list[Message]:
    """All of them, by file and line."""
    return [one for path in sorted((ROOT / "orchestrator").rglob("*.py")) for one in _of_file(path)]


def _of_file(path: Path) -> Iterator[Message]:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in KINDS and node.args:
            text = _text(node.args[0])
            if any(c.isalpha() for c in text):
                yield Message(node.func.id, text, path.relative_to(ROOT), node.lineno)


def _text(node: ast.expr) -> str:
    """The words of a message, with a sign in place of each value."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.JoinedStr):
        return "".join(_text(part) if isinstance(part, ast.Constant) else "…" for part in node.values)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return _text(node.left) + _text(node.right)
    return "…"


def reference() -> str:
    """A table for each room of the code."""
    rooms: dict[str, list[Message]] = {}
    for one in messages():
        parts = one.path.parts[1:]
        rooms.setdefault(parts[0] if len(parts) > 1 else "the ground", []).append(one)
    return "\n\n".join(f"## {room}\n\n{_table(found)}" for room, found in rooms.items())


def _table(found: list[Message]) -> str:
    cells = [one.text.replace("|", "\\|").replace("\n", " ").replace("`", "'") for one in found]
    rows = [f"| {one.kind} | `{cell}` |" for one, cell in zip(found, cells, strict=True)]
    return wide("\n".join(["| kind | message |", "|---|---|", *dict.fromkeys(rows)]))


def mends() -> str:
    """What the messages mean that people meet most, and what helps."""
    rows = [f"| `{one['says'].replace('`', chr(39))}` | {one['means']} | {one['mend']} |" for one in known()]
    return "\n".join(["| message | means | helps |", "|---|---|---|", *rows])


def known() -> list[dict[str, str]]:
    """The messages that are explained."""
    return list(tomllib.loads(MENDS.read_text(encoding="utf-8"))["mend"])
