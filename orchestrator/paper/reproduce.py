"""`rovbrush reproduce`: the paper's claims answered one by one, as claims.json and a report that needs no network."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ..errors import InputError, nearest
from ..files import prepare_folder, write_file, write_json
from .claims import CLAIMS, VERDICTS, Claim, Finding
from .lab import Lab


@dataclass(frozen=True)
class Reproduction:
    """A row per claim, see `claim_row`, what the parameter sets say of themselves, and the files that were written."""

    rows: list[dict[str, Any]]
    parameter_sets: list[str]
    paths: list[Path] = field(default_factory=list)


def reproduce(
    out: Path, fmus: Path | None, numbers: Sequence[int] = (), tell: Callable[[str], None] = lambda _command: None
) -> Reproduction:
    """Answer the claims `numbers`, or all 25: these are also written, with the report.

    `tell` hears the command that repeats it before each run. Raises InputError for an unknown claim, a missing library
    of the report or a folder that cannot be written, before any run.
    """
    for number in numbers:
        if number not in CLAIMS:
            raise InputError(f"--claim {number}: the claims are 1 to {max(CLAIMS)}{nearest(str(number), [])}")
    if not numbers:
        for library in ("jinja2", "latex2mathml", "plotly", "scipy"):
            if find_spec(library) is None:
                raise InputError(f"the report needs {library}: python -m pip install 'rovbrush[report]'")
        prepare_folder(out)
    lab = Lab(fmus, tell)
    rows = []
    for number in numbers or sorted(CLAIMS):
        lab.used.clear()
        finding = CLAIMS[number].answer(lab)
        rows.append(claim_row(CLAIMS[number], finding, list(lab.used)))
    if numbers:
        return Reproduction(rows, lab.parameter_sets)
    paths = [write_file(out / "claims.json", lambda path: write_json(path, rows))]
    from .page.page import report_page

    text = report_page(lab, rows)
    paths.append(write_file(out / "report.html", lambda path: path.write_text(text, encoding="utf-8")))
    return Reproduction(rows, lab.parameter_sets, paths)


def claim_row(claim: Claim, finding: Finding, commands: Sequence[str]) -> dict[str, Any]:
    """One claim as JSON. `paper` and `computed` are numbers, or lists of them where a claim has several checks."""
    checks = [
        {"quantity": c.quantity, "paper": c.paper, "computed": float(c.computed), "unit": c.unit, "rule": c.rule,
         "reason": c.reason, "holds": bool(c.holds)}
        for c in finding.checks
    ]  # fmt: skip
    row: dict[str, Any] = {"number": claim.number, "claim": claim.text, "place": claim.place}
    for key in ("paper", "computed", "unit"):
        values = [check[key] for check in checks]
        single = len(values) == 1 or (key == "unit" and len(set(values)) == 1)
        row[key] = values[0] if single else values
    row |= {"command": "; ".join(commands), "answer": f"rovbrush reproduce --claim {claim.number}"}
    row |= {"verdict": finding.verdict, "checks": checks}
    if finding.verdict == VERDICTS[-1]:
        row["arithmetic"] = finding.arithmetic
    if finding.note:
        row["note"] = finding.note
    return row
