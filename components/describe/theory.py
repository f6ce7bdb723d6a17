"""The equations of a component, read from its kernel: number, symbol, file and line, as a table in its README.

An equation is a line of a kernel with a comment that begins with its number: `di = (V_in - R*i) / L_a  # Eq. 16`.
Those of the paper have its numbers; a component of another source numbers its own behind a letter, `# Eq. B1`.
"""

from __future__ import annotations

import ast
import io
import re
import tokenize
from dataclasses import dataclass
from pathlib import Path
from string import ascii_uppercase

from ..build import HERE, folder_of
from ..errors import BuildError
from ..lowering.lowered import lowered
from ..python.component import component_class

BEGIN = "<!-- equations: written by `python -m rovbrush.components.describe` -->"
END = "<!-- end of equations -->"
KINDS = (ast.Assign, ast.AugAssign, ast.Return, ast.Expr)
NUMBERS = re.compile(r"Eqs?\. ([A-Z]?\d+(?:(?:, | and |-)[A-Z]?\d+)*)")


@dataclass(frozen=True)
class Equation:
    """One line of a kernel that carries the number of an equation."""

    number: str
    symbol: str
    text: str
    path: Path
    line: int


def equations(name: str) -> list[Equation]:
    """The equations of a component's kernel, by number, then in the order of the text."""
    found = [one for part in lowered(component_class(name).kernel).parts for one in _of_file(part.path)]
    return sorted(found, key=lambda one: _order(one.number))


def _order(number: str) -> tuple[str, int]:
    return number.rstrip("0123456789"), int(number.lstrip(ascii_uppercase))


def _of_file(path: Path) -> list[Equation]:
    text = path.read_text(encoding="utf-8")
    statements = [s for s in ast.walk(ast.parse(text)) if isinstance(s, KINDS)]
    found = []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type != tokenize.COMMENT or not token.line[: token.start[1]].strip():
            continue
        match = re.match(r"# (Eqs?\. .*)", token.string)
        on_line = [s for s in statements if s.lineno <= token.start[0] <= (s.end_lineno or s.lineno)]
        if match and on_line:
            symbol, source = _symbol(on_line[0]), ast.unparse(on_line[0])
            found += [Equation(n, symbol, source, path, token.start[0]) for n in numbers(match[1])]
    return found


def _symbol(statement: ast.stmt) -> str:
    """What a statement computes: its target, what a called function fills, or what is returned."""
    if isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Call):
        return ast.unparse(statement.value.args[0])
    if isinstance(statement, ast.Return):
        return "result"
    return re.split(r" [-+*/]?= ", ast.unparse(statement))[0]


def numbers(text: str) -> list[str]:
    """The numbers of the equations that a text names: `Eq. 7`, `Eqs. 2, 3`, `Eqs. 14-17`, `Eqs. B1-B4`."""
    found: list[str] = []
    for match in NUMBERS.finditer(text):
        for one in re.split(r", | and ", match[1]):
            first, _, last = one.partition("-")
            (letter, begin), (_, end) = _order(first), _order(last or first)
            found += [f"{letter}{k}" for k in range(begin, end + 1)]
    return found


def table(name: str) -> str:
    """The equations of a component in Markdown, each with the place where it is computed."""
    folder = folder_of(name).parent
    rows = ["| equation | symbol | line of the kernel | where |", "| --- | --- | --- | --- |"]
    for one in equations(name):
        text = one.text.replace("|", "\\|")
        place = one.path.relative_to(folder if one.path.is_relative_to(folder) else HERE).as_posix()
        rows.append(f"| Eq. {one.number} | `{one.symbol}` | `{text}` | `{place}:{one.line}` |")
    return "\n".join(rows)


def with_table(text: str, name: str) -> str:
    """The README of a component with its equations between the marks. Raises BuildError if a mark is missing."""
    head, begin, rest = text.partition(BEGIN)
    _, end, tail = rest.partition(END)
    if not (begin and end):
        raise BuildError(f"the equations stand between the lines '{BEGIN}' and '{END}'; put them into the file")
    return f"{head}{BEGIN}\n\n{table(name)}\n\n{END}{tail}"


def prose(text: str) -> str:
    """A README without the generated table."""
    head, _, rest = text.partition(BEGIN)
    return head + rest.partition(END)[2]
