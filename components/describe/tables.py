"""The variable tables of `fmus/README.md`, written from the interface declarations of the components.

`python -m rovbrush.components.describe` writes them anew, between the two marks in the file.
"""

from __future__ import annotations

import sys
from pathlib import Path

from ..build import COMPONENTS, HERE, folder_of
from ..declare.interface import INF, Variable
from ..errors import BuildError
from ..python.component import component_class
from . import theory

README = HERE.parent / "fmus" / "README.md"
BEGIN = "<!-- variables: written by `python -m rovbrush.components.describe` -->"
END = "<!-- end of variables -->"
COLUMNS = ("ref", "name", "causality", "type", "unit", "start", "range", "description", "source")


def described(text: str) -> str:
    """`text` with the tables of all components between the marks. Raises BuildError if a mark is missing."""
    return _with(text, "\n\n".join(section(name) for name in COMPONENTS))


def _with(text: str, tables: str) -> str:
    head, begin, rest = text.partition(BEGIN)
    _, end, tail = rest.partition(END)
    if not (begin and end):
        raise BuildError(f"the tables stand between the lines '{BEGIN}' and '{END}'; put them into the file")
    return f"{head}{BEGIN}\n\n{tables}\n\n{END}{tail}"


def section(name: str) -> str:
    """Heading, description and variable table of the component `name`, in Markdown."""
    return "\n".join([f"### {name}", "", f"{(component_class(name).__doc__ or '').strip()}.", "", variable_table(name)])


def variable_table(name: str) -> str:
    """The variables of a component in Markdown, in value-reference order."""
    lines = [_row(COLUMNS), _row(("---",) * len(COLUMNS))]
    reference = 0
    for variable in component_class(name).variables():
        lines.append(_row(_cells(variable, reference)))
        reference += len(variable.start)
    return "\n".join(lines)


def _row(cells: tuple[str, ...]) -> str:
    return f"| {' | '.join(cells)} |"


def _cells(v: Variable, reference: int) -> tuple[str, ...]:
    given = v.causality in ("parameter", "input")
    description = v.description + (f"; reacts at once to {', '.join(v.depends)}" if v.depends else "")
    return (
        str(reference), f"`{v.name}`", "calculated parameter" if v.causality == "calculatedParameter" else v.causality,
        f"{v.kind}[{v.size}]" if v.size else v.kind, v.unit if v.kind == "Real" else "",
        _start(v) if given else "", _range(v), description.replace("|", "\\|"), v.source.replace("|", "\\|"),
    )  # fmt: skip


def _start(v: Variable) -> str:
    if v.kind == "Boolean":
        return ", ".join(str(bool(value)).lower() for value in v.start)
    if len(v.start) > 1 and len(set(v.start)) == 1:
        return f"{_number(v.start[0])} each"
    return ", ".join(map(_number, v.start))


def _range(v: Variable) -> str:
    if v.kind == "Boolean" or (v.minimum == -INF and v.maximum == INF):
        return ""
    if v.maximum == INF:
        return f"at least {_number(v.minimum)}"
    if v.minimum == -INF:
        return f"at most {_number(v.maximum)}"
    return f"{_number(v.minimum)} to {_number(v.maximum)}"


def _number(value: float) -> str:
    """All digits, in the shorter of two forms."""
    full, short = repr(float(value)).removesuffix(".0"), f"{value:g}"
    return short if float(short) == value and len(short) < len(full) else full


def main(path: Path = README) -> None:
    """Write the tables into the file at `path`, and the equations of each component into its README."""
    try:
        path.write_text(described(path.read_text(encoding="utf-8")), encoding="utf-8")
        for name in COMPONENTS:
            path = HERE / name / "README.md"
            describe_component(name)
    except (OSError, BuildError) as error:
        sys.exit(f"{path}: {error}")


def describe_component(name: str) -> Path:
    """Write the tables that the README of a component has marks for; its path. Raises OSError, BuildError."""
    path = folder_of(name) / "README.md"
    before = text = path.read_text(encoding="utf-8")
    if theory.BEGIN in text:
        text = theory.with_table(text, name)
    if BEGIN in text:
        text = _with(text, variable_table(name))
    if text != before:
        path.write_text(text, encoding="utf-8")
    return path
