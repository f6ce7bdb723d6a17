"""`rovbrush design`: the designer's page, and its numbers as design.json."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from importlib.util import find_spec
from math import isfinite
from pathlib import Path
from typing import Any

from ...errors import InputError
from ...files import prepare_folder, write_file, write_json
from ..lab import Lab
from ..thrust_budget import Budget, thrust_budget
from . import sections
from .spread import Spread, spread
from .task import Task, task


@dataclass(frozen=True)
class Designed:
    """The answers as rows (quantity, unit, task, 5 %, 95 %), what is said of the points, and the files."""

    answers: sections.Rows
    verdict: str
    paths: list[Path] = field(default_factory=list)


def design(
    out: Path,
    fmus: Path | None,
    points: int | None = None,
    tell: Callable[[str], None] = lambda _command: None,
    progress: Callable[[int, int], None] = lambda _done, _of: None,
) -> Designed:
    """Run the task, the tools of the thrust budget and the points of its sweep, and write page and numbers.

    `points`: None for as many as the sweep says, 0 for none. They are kept in a folder of `out`, and an interrupted
    sweep goes on there. `tell` hears the command of each run before it. Raises InputError for a missing library or a
    folder that cannot be written, before any run.
    """
    for library in ("jinja2", "latex2mathml", "scipy"):
        if find_spec(library) is None:
            raise InputError(f"the page needs {library}: python -m pip install 'rovbrush[report]'")
    prepare_folder(out)
    lab = Lab(fmus, tell)
    asked = task(lab)
    found = None if points == 0 else spread(asked, out, points or asked.study.random, fmus, progress)
    tools = thrust_budget(lab)
    margins = sections.margins(asked, fmus)
    from ..page.design import design_page

    text = design_page(lab, asked, tools, margins, found)
    rows = {**numbers(asked, tools, found), "margins": margins}
    paths = [
        write_file(out / "design.json", lambda path: write_json(path, rows)),
        write_file(out / "design.html", lambda path: path.write_text(text, encoding="utf-8")),
    ]
    return Designed(sections.answers(asked, found), "" if found is None else sections.verdict(found), paths)


def numbers(asked: Task, tools: list[Budget], found: Spread | None) -> dict[str, Any]:
    """The page's tables for programs."""
    points = found and {"held": int(found.held.sum()), "of": len(found.error), "verdict": sections.verdict(found)}
    return {
        "task": {
            "force_N": asked.force, "radius_m": asked.radius if isfinite(asked.radius) else None,
            "current_m_s": asked.current, "command": asked.case.command,
        },
        "short": sections.short(asked, tools, found), "answers": sections.answers(asked, found),
        "gains": [number.cells for number in sections.gains(asked)], "sensors": sections.sensors(asked),
        "budget": sections.budget(asked, tools), "points": points,
    }  # fmt: skip
