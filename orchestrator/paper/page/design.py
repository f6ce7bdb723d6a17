"""The designer's page: the task and its answer, brush, gains, sensors, thrust, and how sure all that is."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ...results.pictures.canvas import captioned, legend_above, new_figure
from ..design import sections
from ..design.spread import LIMIT, Spread
from ..design.task import Task
from ..lab import Lab
from ..strategies import WINDOW, force_on_hull, held
from ..thrust_budget import Budget
from .page import provenance
from .rendering import image, render

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = "A brush on a hull: what holds it there"
SECTIONS = (  # each a template of that name
    ("answer", "Answer"),
    ("tool", "Brush and motor"),
    ("gains", "Gains and margins"),
    ("sensors", "Sensors"),
    ("budget", "Thrust"),
    ("spread", "How sure it is"),
    ("made", "What was run"),
)


def design_page(lab: Lab, task: Task, tools: list[Budget], margins: sections.Rows, found: Spread | None) -> str:
    """The whole document."""
    brush = sections.brush(task)
    content: dict[str, Any] = {
        "title": TITLE,
        "sections": SECTIONS,
        "task": {
            "force": task.force, "current": task.current, "command": task.case.command,
            "hull": f"a hull of {task.radius:g} m radius" if np.isfinite(task.radius) else "a plane hull",
        },
        "verdict": "" if found is None else sections.verdict(found),
        "short": sections.short(task, tools, found),
        "answers": sections.answers(task, found),
        "tracking": sections.tracking(task),
        "force_image": image(force_figure(task)),
        "brush": {
            "description": brush.description,
            "numbers": [number.cells for number in brush.numbers],
            "motor": [number.cells for number in brush.motor],
        },
        "gains": [number.cells for number in sections.gains(task)],
        "margins": margins,
        "budget": sections.budget(task, tools),
        "sensors": sections.sensors(task),
        "spread": None if found is None else spread_content(found),
        "spread_image": "" if found is None else image(spread_figure(found)),
        "provenance": provenance(lab),
    }  # fmt: skip
    return render("design.html", content)


def spread_content(found: Spread) -> dict[str, Any]:
    """Numbers of the section on error bars."""
    causes = [(c.name, f"{c.low:.4g}", f"{c.high:.4g}", f"{c.correlation:+.2f}") for c in found.causes]
    count = len(found.error)
    return {"count": count, "command": found.command, "causes": causes, "chance": 1.96 / np.sqrt(max(count - 1, 1))}


def force_figure(task: Task) -> Figure:
    """The force on the hull, averaged over WINDOW, beside what is asked for."""
    signals = task.case.signals
    time = signals["vehicle.delta"].time
    figure, (axis,) = new_figure(f"Force on the hull, averages over {1e3 * WINDOW:g} ms")
    axis.plot(time, force_on_hull(signals, time), linewidth=0.9, label="force on the hull")
    axis.plot(time, held(signals["mission.F_n_ref"], time), "k--", linewidth=0.9, label="asked for")
    axis.set_ylabel("force [N]")
    axis.set_xlabel("time [s]")
    legend_above(axis)
    return captioned(figure, task.case.run)


def spread_figure(found: Spread) -> Figure:
    """The force error of every point, in rising order; those that lose contact are marked."""
    order = np.argsort(found.error)
    place = np.arange(1, len(order) + 1)
    error, lost = 100.0 * found.error[order], found.contact[order] < 1.0
    figure, (axis,) = new_figure("Force error of every point, in rising order")
    axis.plot(place[~lost], error[~lost], "o", markersize=3.5, label="in contact all the time")
    axis.plot(place[lost], error[lost], "x", markersize=5.0, color="tab:red", label="loses contact")
    axis.axhline(100.0 * LIMIT, color="black", linestyle="--", linewidth=0.9, label=f"{100 * LIMIT:g} %")
    axis.set_ylabel("force error, rms [%]")
    axis.set_xlabel("points [1]")
    axis.set_ylim(bottom=0.0)
    legend_above(axis)
    return figure
