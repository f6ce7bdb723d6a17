"""A kernel in the form that Numba and Pyccel take: its files' texts, and what its functions are called with.

`lowering/` makes it from the source. An FMU carries it ready-made, beside the source that it shows in errors.
"""

from __future__ import annotations

import ast
import io
import json
import tokenize
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from types import ModuleType

CARRIED = "lowered.json"


@dataclass(frozen=True)
class Part:
    """One file of a kernel: its text without imports from other files, line for line as in the file."""

    path: Path
    text: str


@dataclass(frozen=True)
class Lowered:
    """`parts` are the files of a kernel in the subset that Numba and Pyccel know, line for line those of the source.

    `arguments`: what a function is called with, by name: `t`, `h`, `y` (all outputs), arrays and variables.
    """

    parts: list[Part]
    arguments: dict[str, list[str]]

    @cached_property
    def text(self) -> str:
        """All in one, the parts one behind the other."""
        return "".join(f"{part.text}\n" for part in self.parts)

    def place(self, line: int) -> tuple[Path, int]:
        """File and line in it of a line of `text`."""
        for part in self.parts:
            count = part.text.count("\n")
            if line <= count:
                return part.path, line
            line -= count + 1
        return self.parts[-1].path, max(line, 1)

    def write(self, folder: Path, top: Path) -> None:
        """Put it into a folder, without comments, which stand in the source beside it; paths are relative to `top`, the
        package that is carried."""
        parts = [[part.path.relative_to(top).as_posix(), _bare(part.text)] for part in self.parts]
        text = json.dumps({"parts": parts, "arguments": self.arguments}, indent=0)
        (folder / CARRIED).write_text(text, encoding="utf-8")


def _bare(text: str) -> str:
    """The same statements on the same lines, without comments and docstrings."""
    lines = text.splitlines()
    for node in ast.walk(ast.parse(text)):
        body = node.body if isinstance(node, (ast.FunctionDef, ast.Module)) else []
        if len(body) > 1 and isinstance(body[0], ast.Expr) and isinstance(body[0].value, ast.Constant):
            for number in range(body[0].lineno, (body[0].end_lineno or 0) + 1):
                lines[number - 1] = ""
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            row, column = token.start
            lines[row - 1] = lines[row - 1][:column].rstrip()
    return "\n".join(lines) + "\n"


@cache
def lowered(kernel: ModuleType) -> Lowered:
    """A kernel module, lowered. Raises KernelError where it uses what cannot be compiled."""
    carried = Path(str(kernel.__file__)).with_name(CARRIED)
    if carried.is_file():
        content = json.loads(carried.read_text(encoding="utf-8"))
        parts = [Part(carried.parent.parent / path, text) for path, text in content["parts"]]
        return Lowered(parts, content["arguments"])
    from .lower import lower
    from .source import parts_of

    return lower(*parts_of(kernel))
