"""The paper's Figs. 2 to 4 from the nominal run, and its description of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from ...results.pictures.canvas import captioned, legend_above, new_figure
from ...results.pictures.lines import draw
from .. import mode_shapes
from ..claims.transients import transient
from ..lab import Case

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ONSET = 0.8  # s shown of the first touch


def onset_and_run(case: Case, name: str, reference: float, title: str) -> Figure:
    """The first touch above, the whole run below, with the paper's mean."""
    signal = case.signals[name]
    figure, axes = new_figure(title, 2, share=False)
    for axis, end in zip(axes, (ONSET, case.run.end), strict=True):
        inside = signal.time <= end
        draw(axis, signal.time[inside], signal.values[inside], name, "-")
        axis.axhline(reference, color="black", linestyle="--", linewidth=1.0,
                     label=f"paper: {reference:g} {signal.unit}")  # fmt: skip
        axis.set_ylabel(signal.label)
        axis.set_xlabel("time [s]")
    legend_above(axes[0])
    return figure


def paper_figures(case: Case) -> Iterator[tuple[str, str, str, Figure]]:
    """Title, what the paper says, what is seen here, and the figure."""
    lam = ", ".join(f"{value:.4f}" for value in case.calculated("brush.lambda_r", 3))
    yield (
        "Figure 2",
        "First three bending mode shapes of the filament: the fundamental has one antinode at the tip, the higher "
        "modes have interior nodes.",
        f"Eq. 3 with the eigenvalues of the brush FMU, {lam}.",
        captioned(
            mode_shapes.draw(
                case.run.calculated,
                {"title": "Mode shapes of a filament (paper's Fig. 2)", "component": "brush", "modes": 3},
            ),
            case.run,
        ),
    )  # fmt: skip
    for title, name, reference, words in (
        ("Figure 3", "F_z", -221.7, "Normal contact force: the transient impact with phase and the settling to a mean "
                                    "load of -221 N."),
        ("Figure 4", "T_brush", -16.63, "Brush resistive torque, opposing the motor rotation and stabilising at about "
                                        "-16.63 N.m under load."),
    ):  # fmt: skip
        mean, seen = case.summary[f"{name}_mean"], transient(case, name)
        signal = case.signals[f"brush.{name}"]
        yield (
            title,
            words,
            f"Overshoot {100 * seen.overshoot:.1f} % by averages over a blade pass, within 5 % after "
            f"{seen.settled:.2f} s, mean {mean:.4g} {signal.unit} over {case.summary['window_turns']} whole turns, "
            f"ripple at {case.summary['blade_pass_hz']:.1f} Hz. The run begins with the brush turning at 20 rad/s and "
            "touching at time 0.",
            captioned(
                onset_and_run(case, signal.name, reference, f"{name} (paper's {title.replace('ure', '.')})"), case.run
            ),
        )
