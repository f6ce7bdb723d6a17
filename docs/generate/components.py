"""A page for each FMU of ours, from its README and the guide for its users, whose tables the tests hold to the code."""

from __future__ import annotations

import re
from functools import cache
from html import escape

from .sections import ROOT, linked, section, wide

GUIDE = "fmus/README.md"
EQUATIONS = re.compile(r"<!-- equations: .*? -->(.*?)<!-- end of equations -->", re.DOTALL)
ROW = re.compile(r"^\| `(\w+)` \| (.*) \| (.*) \| (.*) \|$", re.MULTILINE)
VARIABLES = (
    "`ref` is the value reference, of an array that of its first element (in FMI 2.0 the others follow, in FMI 3.0 it "
    'is the only one). An output that "reacts at once" has direct feedthrough.'
)


@cache
def names() -> list[str]:
    """The components, in the order of the guide."""
    return list(_rows())


def page(name: str) -> str:
    """Name, README and variables of a component."""
    _, step, run = _rows()[name]
    first, _, last = run.partition(": ")
    given = "with its default inputs" if first == "none" else f"with {first}"
    return "\n\n".join(
        [
            EQUATIONS.sub(lambda found: wide(found[1].strip()), linked(_readme(name), f"components/{name}/README.md")),
            "## Use it elsewhere",
            f"Communication step {step}. A first run of 2 s {given}, all else as it is by default, ends with {last}. "
            "Which file to take and how: [in other tools](/howto/other-tools.md).",
            "## Variables",
            VARIABLES,
            wide(_variables(name)),
        ]
    )


def overview() -> str:
    """A table of all components."""
    lines = ["| FMU | what it is | communication step | inputs | outputs |", "|---|---|---|---|---|"]
    for name, (what, step, _) in _rows().items():
        inputs, outputs = (_variables(name).count(f" | {kind} | ") for kind in ("input", "output"))
        lines.append(f"| [{name}](/fmus/{name}.md) | {what} | {step} | {inputs} | {outputs} |")
    return "\n".join(lines)


def computed(number: str) -> str:
    """The lines of kernels that compute an equation; an error if there is none."""
    found = [row for name in names() for row in re.findall(rf"^\| Eq\. {number} \| .*$", _readme(name), re.MULTILINE)]
    if not found:
        raise ValueError(f"no line of a kernel computes Eq. {number}")
    lines = []
    for row in dict.fromkeys(found):
        text, place = (cell.strip(" `").replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", row)[3:5])
        lines.append(f"<code>{escape(text)}</code> <small>{place}</small>")
    return f'<div class="kernel wide">{"<br>".join(lines)}</div>'


@cache
def _readme(name: str) -> str:
    return (ROOT / "components" / name / "README.md").read_text(encoding="utf-8")


@cache
def _rows() -> dict[str, tuple[str, str, str]]:
    """What each component is, its step and its first run."""
    guide = (ROOT / GUIDE).read_text(encoding="utf-8").partition("## What every host must do")[0]
    return {name: (what, step, run) for name, what, step, run in ROW.findall(guide)}


@cache
def _variables(name: str) -> str:
    return section(GUIDE, name).partition("\n| ")[2].join(["| ", ""]).strip()
