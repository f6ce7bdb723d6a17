"""The report's page: claims, Table 3, figures, readings of the equations, verification, energy flow, motion."""

from __future__ import annotations

import platform
from collections.abc import Sequence
from importlib.metadata import version
from typing import Any

from ...results.manifest import PACKAGES
from ...results.summary import comparison
from ..claims import VERDICTS
from ..lab import Lab
from .figures import paper_figures
from .html import Html, element, image, join, page, table
from .interactive import energy, motion
from .readings import readings
from .verification import checks

CHIPS = dict(zip(VERDICTS, ("yes", "fit", "no"), strict=True))


def report_page(lab: Lab, rows: Sequence[dict[str, Any]]) -> str:
    """The whole document."""
    parts = [
        ("claims", "Claims", claims(rows)),
        ("table3", "Table 3", table_3(lab)),
        ("figures", "Figures 2, 3 and 4", figures(lab)),
        ("readings", "How the equations were read", equations(lab)),
        ("verification", "Verification", checks(lab, rows)),
        ("energy", "Energy from battery to hull", energy(lab)),
        ("motion", "In motion", motion(lab)),
        ("provenance", "What was run", provenance(lab)),
    ]
    return page("The rolling-brush paper, claim by claim", lead(rows), parts)


def lead(rows: Sequence[dict[str, Any]]) -> Html:
    """What this is, and how it came out."""
    counts = element(
        "div", *(chip(v, f"{sum(r['verdict'] == v for r in rows)} {v}") for v in VERDICTS), class_="counts"
    )
    return join([
        element("p", "Each claim of “Hierarchical Multi-Scale Modelling of ROV-Mounted Rolling Brush Systems” beside "
                     "what a co-simulation of four FMUs gives. Every number on this page was computed when the page "
                     "was made; each row names the commands that repeat its runs. A verdict follows from comparing "
                     "the two with the stated rule: a claim that rests on a fitted number is at best reproduced by "
                     "calibration."),
        counts,
    ])  # fmt: skip


def chip(verdict: str, text: str = "") -> Html:
    return element("span", text or verdict, class_=f"chip {CHIPS[verdict]}")


def number(value: float) -> str:
    return f"{value:.5g}"


def claims(rows: Sequence[dict[str, Any]]) -> Html:
    """One row per claim; the numbers of several checks stand below each other."""
    body = []
    for row in rows:
        lines = [
            (
                c["quantity"],
                f"{'≤ ' if c['rule'] == 'at most' else '≥ ' if c['rule'] == 'at least' else ''}{number(c['paper'])}",
                number(c["computed"]),
                "" if c["unit"] == "1" else c["unit"],
                c["rule"] if c["rule"] not in ("at most", "at least") else "",
                element("span", "holds" if c["holds"] else "fails", class_=f"chip {'yes' if c['holds'] else 'no'}"),
            )
            for c in row["checks"]
        ]
        inner = table(["quantity", "paper or bound", "computed", "unit", "rule", ""], lines, "checks")
        words = []
        if row.get("arithmetic"):
            words.append(element("p", element("b", "Arithmetic: "), row["arithmetic"]))
        if row.get("note"):
            words.append(element("p", row["note"], class_="soft"))
        commands = element("details", element("summary", "commands"), element("code", row["answer"]),
                           *(element("code", c) for c in row["command"].split("; ")))  # fmt: skip
        body.append((
            str(row["number"]),
            join([
                element("b", row["claim"]), element("div", row["place"], class_="soft"), chip(row["verdict"]), commands,
            ]),
            join([inner, *words]),
        ))  # fmt: skip
    return table(["", "the paper says", "computed here"], body, "claims")


def table_3(lab: Lab) -> Html:
    """The paper's table beside the means of the nominal run, with ratios."""
    case = lab.case("nominal")
    rows = [
        (r["label"], r["unit"], f"{r['reference']:g}", number(r["value"]), f"{r['ratio']:.4f}",
         "" if r.get("tolerance") is None else f"{100 * r['tolerance']:g} %")
        for r in comparison(case.run, dict(case.summary))
    ]  # fmt: skip
    begin, end = case.window
    return join([
        element("p", f"Means over {case.summary['window_turns']} whole turns, {begin:.2f} to {end:g} s of the nominal "
                     "run (penetration 5 mm, 0.05 m/s along the hull, 12 V). F_z and omega_b are met by the "
                     "calibration; F_y and T_brush contradict each other in the paper (claim 10), and the fit shares "
                     "the difference. q is reported, not claimed (claim 15)."),
        table(["quantity", "unit", "paper", "computed", "ratio", "bound"], rows, "numbers"),
        element("code", case.command),
    ])  # fmt: skip


def figures(lab: Lab) -> Html:
    """The paper's description on the left, the figure on the right."""
    return join(
        element("div",
                element("div", element("h3", title), element("p", "The paper: ", words),
                        element("p", "Here: ", here)),
                image(figure, f"{title}: {words}"), class_="beside")
        for title, words, here, figure in paper_figures(lab.case("nominal"))
    )  # fmt: skip


def equations(lab: Lab) -> Html:
    return join([
        element("p", "Where the paper is incomplete or contradicts itself, the model differs from what is printed:"),
        table(["where", "as printed", "as computed here"], readings(lab.case("nominal"))),
    ])  # fmt: skip


def provenance(lab: Lab) -> Html:
    """FMUs by content, software by version."""
    fmus = sorted({(c.fmu.path.name, c.fmu.digest) for c in lab.case("nominal").run.plan.system.components.values()})
    versions = [("python", platform.python_version()), *((p, version(p)) for p in (*PACKAGES, "plotly"))]
    return join([
        table(["FMU", "sha256"], [(name, element("code", digest)) for name, digest in fmus]),
        element("p", ", ".join(f"{name} {number}" for name, number in versions), class_="soft"),
        element("code", "rovbrush reproduce --out DIR"),
    ])  # fmt: skip
