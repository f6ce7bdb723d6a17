"""The report's sections with plotly figures: the energy flow and the vehicle in motion."""

from __future__ import annotations

from typing import Any

from .. import energy_flow
from ..lab import Lab
from .mission_picture import ON_A_PHONE, mission_figure
from .motion import Motion

MISSION = "hull_pass"  # what is shown in motion
CONFIG = {"displaylogo": False, "responsive": True}


def plotly_html(figure: Any, with_script: bool, after: str = "") -> str:
    """A plotly figure; the first one of the page brings the script. `after`: what is done once it is drawn."""
    import plotly.io

    text: str = plotly.io.to_html(
        figure, config=CONFIG, full_html=False, include_plotlyjs=with_script, auto_play=False, post_script=after or None
    )
    return text


def energy(lab: Lab) -> dict[str, Any]:
    """The flow diagram of the nominal run and its numbers."""
    import plotly.graph_objects as go

    case = lab.case("nominal")
    links = energy_flow.flows(case)
    names = list(dict.fromkeys(name for link in links for name in (link.source, link.target)))
    supplied = links[0].energy
    totals = {n: max(sum(x.energy for x in links if x.source == n), sum(x.energy for x in links if x.target == n))
              for n in names}  # fmt: skip
    figure = go.Figure(go.Sankey(
        arrangement="snap", valueformat=".0f", valuesuffix=" J",
        node={"label": [f"{n}: {totals[n]:.0f} J ({100 * totals[n] / supplied:.1f} %)" for n in names], "pad": 26,
              "thickness": 18, "color": "#3c78b4"},
        link={"source": [names.index(x.source) for x in links], "target": [names.index(x.target) for x in links],
              "value": [x.energy for x in links], "color": "rgba(60, 120, 180, 0.28)"},
    ))  # fmt: skip
    figure.update_layout(height=430, margin={"l": 10, "r": 10, "t": 20, "b": 20}, font={"size": 13})
    rows = [(x.source, x.target, f"{x.energy:.2f}", f"{100 * x.energy / supplied:.2f} %") for x in links]
    open_ends = ", ".join(f"{node} {energy_flow.imbalance(links, node):+.3f} J" for node in ("motor", "brush"))
    return {
        "end": case.run.end, "open_ends": open_ends, "figure": plotly_html(figure, with_script=False), "rows": rows,
        "command": case.command,
    }  # fmt: skip


def motion(lab: Lab) -> dict[str, Any]:
    """The animation of the closed loop."""
    case = lab.case(MISSION)
    moved, words = Motion(case), case.run.plan.system.description
    return {
        "words": f"{words[0].upper()}{words[1:]}", "largest": moved.largest,
        "figure": plotly_html(mission_figure(moved), with_script=True, after=ON_A_PHONE), "command": case.command,
    }  # fmt: skip
