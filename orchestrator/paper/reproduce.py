"""`rovbrush reproduce`: the paper's claims answered one by one, as claims.json and a report that needs no network."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from rich.table import Table

from ..cli.console import console
from ..errors import InputError, nearest
from ..files import prepare_folder, write_file, write_json
from .claims import CLAIMS, VERDICTS, Claim, Finding
from .lab import Lab


def reproduce(out: Path, fmus: Path | None, numbers: Sequence[int] = ()) -> list[dict[str, Any]]:
    """Answer the claims `numbers` (all by default) and print them; all 25 are also written with the report.

    Raises InputError for an unknown claim, a missing plotly or a folder that cannot be written, before any run.
    """
    for number in numbers:
        if number not in CLAIMS:
            raise InputError(f"--claim {number}: the claims are 1 to {max(CLAIMS)}{nearest(str(number), [])}")
    if not numbers:
        if find_spec("plotly") is None:
            raise InputError("the report's animation needs plotly: python -m pip install 'rovbrush[report]'")
        prepare_folder(out)
    lab = Lab(fmus, lambda command: console.print(f"[dim]{command}[/]"))
    console.print("every run of the report, by the command that repeats it:")
    rows = []
    for number in numbers or sorted(CLAIMS):
        lab.used.clear()
        finding = CLAIMS[number].answer(lab)
        rows.append(claim_row(CLAIMS[number], finding, list(lab.used)))
    show(rows)
    if numbers:
        print_checks(rows)
        return rows
    from .page.page import report_page

    text = report_page(lab, rows)
    paths = [
        write_file(out / "claims.json", lambda path: write_json(path, rows)),
        write_file(out / "report.html", lambda path: path.write_text(text, encoding="utf-8")),
    ]
    console.print(f"wrote {', '.join(path.name for path in paths)} to {out}; open {paths[-1]} in a browser")
    return rows


def claim_row(claim: Claim, finding: Finding, commands: Sequence[str]) -> dict[str, Any]:
    """One claim as JSON. `paper` and `computed` are numbers, or lists of them where a claim has several checks."""
    checks = [
        {"quantity": c.quantity, "paper": c.paper, "computed": float(c.computed), "unit": c.unit, "rule": c.rule,
         "holds": bool(c.holds)}
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


def show(rows: Sequence[dict[str, Any]]) -> None:
    """The claims on the terminal."""
    table = Table(title="The paper, claim by claim", title_justify="left", show_lines=False)
    for heading in ("", "claim", "verdict"):
        table.add_column(heading)
    color = dict(zip(VERDICTS, ("green", "blue", "red"), strict=True))
    for row in rows:
        table.add_row(str(row["number"]), row["claim"], f"[{color[row['verdict']]}]{row['verdict']}[/]")
    console.print(table)
    counts = (f"{sum(row['verdict'] == verdict for row in rows)} {verdict}" for verdict in VERDICTS)
    console.print(", ".join(counts))


def print_checks(rows: Sequence[dict[str, Any]]) -> None:
    """Every number behind the claims on the terminal."""
    for row in rows:
        for c in row["checks"]:
            sign = "" if c["holds"] else "  does not hold"
            console.print(
                f"  {row['number']}: {c['quantity']} = {c['computed']:.6g} {c['unit']}, paper {c['paper']:g} "
                f"({c['rule']}){sign}"
            )
        for key in ("arithmetic", "note"):
            if row.get(key):
                console.print(f"  {row['number']}: {row[key]}")
