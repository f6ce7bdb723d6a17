"""The report's page: claims, Table 3, figures, readings of the equations, verification, energy flow, motion."""

from __future__ import annotations

import platform
from collections.abc import Sequence
from importlib.metadata import version
from typing import Any

from ...results.files.manifest import versions as installed
from ...results.summary.summary import comparison
from .. import water
from ..claims import VERDICTS
from ..lab import Lab
from .figures import paper_figures
from .interactive import energy, motion
from .readings import readings
from .rendering import image, number, render
from .verification import checks

TITLE = "The rolling-brush paper, claim by claim"
CHIPS = dict(zip(VERDICTS, ("yes", "fit", "no"), strict=True))  # classes of the style
SECTIONS = (  # each a template of that name; the first brings the script of all interactive figures
    ("motion", "In motion"),
    ("claims", "Claims"),
    ("table3", "Table 3"),
    ("figures", "Figures 2, 3 and 4"),
    ("readings", "How the equations were read"),
    ("verification", "Verification"),
    ("water", "In water"),
    ("energy", "Energy from battery to hull"),
    ("provenance", "What was run"),
)


def report_page(lab: Lab, rows: Sequence[dict[str, Any]]) -> str:
    """The whole document; `rows` are the claims."""
    content = {
        "title": TITLE, "sections": SECTIONS, "chips": CHIPS,
        "counts": [(verdict, sum(row["verdict"] == verdict for row in rows)) for verdict in VERDICTS],
        "claims": [{"arithmetic": "", "note": "", **row} for row in rows], "table3": table_3(lab),
        "figures": figures(lab), "readings": readings(lab), "verification": checks(lab, rows),
        "water": in_water(lab), "energy": energy(lab), "motion": motion(lab),
    }  # fmt: skip
    content |= {"provenance": provenance(lab), "parameter_sets": lab.parameter_sets}  # last: of all that was run
    return render("page.html", content)


def table_3(lab: Lab) -> dict[str, Any]:
    """The paper's table beside the means of both readings: the rolling brush of all claims, and the cup."""
    case, cup = lab.case("nominal"), lab.case("cup_nominal")
    of_cup = {row["label"]: row for row in comparison(cup.run, dict(cup.summary))}
    rows = []
    for r in comparison(case.run, dict(case.summary)):
        beside = of_cup.get(r["label"])
        bound = "" if r.get("tolerance") is None else f"{100 * r['tolerance']:g} %"
        rolling = (f"{r['reference']:g}", number(r["value"]), f"{r['ratio']:.4f}", bound)
        rows.append((r["label"], r["unit"], *rolling, *_cup_cells(beside)))
    begin, end = case.window
    turns = case.summary["window_turns"]
    return {"turns": turns, "begin": begin, "end": end, "rows": rows, "commands": (case.command, cup.command),
            "tufts": int(sum(cup.parameters("brush.row_tufts"))), "bristles": cup.parameter("brush.bristles_per_tuft"),
            "deflection": cup.summary["max_deflection_ratio"]}  # fmt: skip


def _cup_cells(row: dict[str, Any] | None) -> tuple[str, str]:
    """Value and ratio of the other reading; it has no pitch rate."""
    return ("", "") if row is None else (number(row["value"]), f"{row['ratio']:.4f}")


def in_water(lab: Lab) -> list[dict[str, Any]]:
    """Effects and errors of the water on each brush."""
    return [
        {"name": brush.name, "shielding": brush.shielding, "co_rotation": brush.co_rotation,
         "effects": (water.EFFECTS, water.effects(lab, brush)), "errors": (water.ERRORS, water.errors(lab, brush)),
         "dry": brush.run(lab, {}).command, "wet": brush.run(lab, brush.wet).command}
        for brush in water.brushes(lab)
    ]  # fmt: skip


def figures(lab: Lab) -> list[dict[str, str]]:
    """What the paper says of its figures, what is seen here, and the figure."""
    return [
        {"title": title, "words": words, "here": here, "image": image(figure)}
        for title, words, here, figure in paper_figures(lab.case("nominal"))
    ]


def provenance(lab: Lab) -> dict[str, Any]:
    """FMUs of all runs by content, software by version."""
    used: dict[tuple[str, str], list[str]] = {}
    for case in lab.cases:
        system = case.run.plan.system
        for component in system.components.values():
            names = used.setdefault((component.fmu.path.name, component.fmu.digest), [])
            names += {system.name} - set(names)
    versions = [
        ("python", platform.python_version()),
        *installed().items(),
        *((p, version(p)) for p in ("plotly", "jinja2")),
    ]
    return {
        "fmus": [(name, ", ".join(systems), digest) for (name, digest), systems in sorted(used.items())],
        "versions": ", ".join(f"{name} {number}" for name, number in versions),
    }
