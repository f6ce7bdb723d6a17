"""Bode and Nyquist pictures of open loops, with their margins."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ....results.pictures.canvas import new_figure
from .margins import Margins
from .open_loop import Loop

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STYLES = ("-", "--", "-.", ":")
LOWEST = 900.0  # degrees: what is further behind is far above what a loop does
NEAR = 3.0  # of Nyquist's plane: what is further from -1 than this is of no concern


def hertz(omega: Any) -> Any:
    """Angular frequency [rad/s] as people read it [Hz]."""
    return omega / (2.0 * np.pi)


def bode(found: Sequence[Margins]) -> Figure:
    """Magnitude and phase of all loci over frequency, up to half the sampling frequency, margins marked."""
    figure, (size, phase) = new_figure(f"Open loop, broken at {', '.join(found[0].broken.names)}", rows=2)
    for label, style, loop in _lines(found):
        shown = np.degrees(np.unwrap(np.angle(loop.L)))
        shown -= 360.0 * np.round((shown[0] + 90.0) / 360.0)  # near -90 degrees at first, as most loops are
        size.loglog(hertz(loop.omega), np.abs(loop.L), style, label=label)
        (line,) = phase.semilogx(hertz(loop.omega), shown, style, label=label)
        for omega, angle in loop.crossovers():
            at = float(np.interp(omega, loop.omega, shown))
            size.plot(hertz(omega), 1.0, "o", color=line.get_color(), markersize=4)
            phase.plot(
                [hertz(omega)] * 2, [at, at - np.degrees(angle)], color=line.get_color(), linewidth=2.5, alpha=0.6
            )
        for omega, factor in loop.reversals():
            if factor not in (loop.gain_margin, loop.gain_reduction):
                continue
            size.plot([hertz(omega)] * 2, [1.0 / factor, 1.0], color=line.get_color(), linewidth=2.5, alpha=0.6)
    size.axhline(1.0, color="gray", linewidth=0.8)
    nyquist_frequency = 0.5 / found[0].closed.dt
    for axis in (size, phase):
        axis.axvline(nyquist_frequency, color="gray", linestyle=":", linewidth=0.8)
    low, high = phase.get_ylim()
    low = max(low, -LOWEST)
    phase.set_ylim(low, high)
    for angle in np.arange(np.ceil((low + 180.0) / 360.0), np.floor((high + 180.0) / 360.0) + 1.0):
        phase.axhline(360.0 * angle - 180.0, color="gray", linewidth=0.8)
    size.set_ylabel("|L| [1]")
    phase.set_ylabel("phase of L [deg]")
    phase.set_xlabel(f"frequency [Hz], up to half of the {2 * nyquist_frequency:.4g} samples per second")
    if sum(len(m.loops) for m in found) > 1:
        size.legend(fontsize=8)
    return figure


def nyquist(found: Sequence[Margins]) -> Figure:
    """The loci around -1."""
    figure, (axis,) = new_figure(f"Nyquist, broken at {', '.join(found[0].broken.names)}", share=False)
    figure.set_size_inches(6.4, 6.6)
    turn = np.linspace(0.0, 2.0 * np.pi, 200)
    axis.plot(np.cos(turn), np.sin(turn), color="gray", linewidth=0.8)
    for label, style, loop in _lines(found):
        axis.plot(loop.L.real, loop.L.imag, style, label=label)
        for omega, _ in loop.crossovers():
            at = complex(np.interp(omega, loop.omega, loop.L.real), np.interp(omega, loop.omega, loop.L.imag))
            axis.plot(at.real, at.imag, "o", color=axis.lines[-1].get_color(), markersize=4)
            axis.annotate(f"{hertz(omega):.3g} Hz", (at.real, at.imag), fontsize=8, xytext=(6, 4),
                          textcoords="offset points")  # fmt: skip
    axis.plot(-1.0, 0.0, "+", color="tab:red", markersize=12, markeredgewidth=2)
    axis.set_aspect("equal")
    axis.set_xlim(-1.0 - 0.6 * NEAR, 0.5 * NEAR)
    axis.set_ylim(-0.55 * NEAR, 0.55 * NEAR)
    axis.set_xlabel("real part of L [1]")
    axis.set_ylabel("imaginary part of L [1]")
    if sum(len(m.loops) for m in found) > 1:
        axis.legend(fontsize=8)
    return figure


def _lines(found: Sequence[Margins]) -> list[tuple[str, str, Loop]]:
    """Every locus with its label and style."""
    lines = []
    for k, margins in enumerate(found):
        for j, loop in enumerate(margins.loops):
            parts = [f"t = {margins.at:g} s"] if len(found) > 1 else []
            parts += [f"locus {j + 1}"] if len(margins.loops) > 1 else []
            lines.append((", ".join(parts), STYLES[k % len(STYLES)], loop))
    return lines
