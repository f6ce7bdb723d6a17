"""What is printed of linear models and of margins."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..errors import counted
from .console import print_table, tell

if TYPE_CHECKING:
    from ..studies.linear.margins.margins import Margins
    from ..studies.linear.statespace import Linear

POLES_SHOWN = 40


def print_model(model: Linear) -> None:
    """How a model was found, and its poles."""
    notes = model.notes
    kind = "continuous" if model.dt == 0.0 else f"sampled every {1e3 * model.dt:.6g} ms"
    tell(
        f"t = {model.at:g} s: {counted(model.order, 'state')}, {counted(len(model.inputs), 'input')}, "
        f"{counted(len(model.outputs), 'output')}, {kind}; "
        f"residual of the operating point {notes.get('residual', 0.0):.2g}"
    )
    if notes["method"] == "pulses":
        print_response(model)
    else:
        ways = "; ".join(f"{name} by {how}" for name, how in notes["by"].items())
        tell(f"  {ways}")
    poles = model.poles
    cells = [
        (
            f"{p.s.real:.6g}", f"{p.s.imag:.6g}", f"{p.frequency:.5g}", f"{p.damping:.4f}",
            f"{p.magnitude:.8f}" if p.z is not None else f"{p.magnitude:.6g}",
        ) for p in poles[:POLES_SHOWN] if p.s.imag >= 0.0
    ]  # fmt: skip
    title = f"Poles at t = {model.at:g} s, pairs once"
    title += f" (the slowest {POLES_SHOWN} of {len(poles)})" if len(poles) > POLES_SHOWN else ""
    magnitude = "|z|" if model.dt else "|s| [rad/s]"
    headings = ("real part\n[1/s]", "imaginary\n[rad/s]", "frequency\n[Hz]", "damping\n[1]", magnitude)
    print_table(title, headings, cells, words=())


def print_response(model: Linear) -> None:
    """Of what responses a model was made, and how well it gives them back."""
    notes = model.notes
    sizes = ", ".join(f"{size:.4g} {unit}" for size, unit in zip(notes["sizes"], model.input_units, strict=True))
    period = f" over {notes['period']:.4g} s" if notes["period"] else ""
    tell(
        f"  pulses of {sizes}, from {notes['starts']} instants{period}, {notes['samples']} samples; the model leaves "
        f"{notes['error']:.2g} of the responses, of which {notes['even']:.2g} is the same for both signs of a pulse"
    )
    for name, step in notes["faster"].items():
        tell(
            f"  warning: {name} is taken every {1e3 * step:.6g} ms, the model sees it every {1e3 * model.dt:.6g} ms "
            f"(in which the schedule repeats): what goes on above {0.5 / model.dt:.4g} Hz is not in it"
        )
    values = notes["singular_values"]
    order = notes["order"]
    near = [f"{v / values[0]:.2g}" for v in values[max(order - 2, 0) : order + 2]] if values else []
    if near:
        first = max(order - 1, 1)
        tell(f"  Hankel singular values {first} to {first + len(near) - 1}, of the first: {', '.join(near)}")


def print_margins(found: Sequence[Margins]) -> None:
    """One row for each locus."""
    from math import degrees, inf, isfinite, pi

    def factor(value: float) -> str:
        return f"{value:.4g}" if isfinite(value) and value > 0.0 else "-"

    cells = []
    for each in found:
        for k, loop in enumerate(each.loops):
            omega = loop.delay_crossing[0]
            cells.append((
                f"{each.at:g}", str(k + 1), f"{degrees(loop.phase_margin):.1f}" if loop.phase_margin < pi else "-",
                factor(loop.gain_margin), factor(loop.gain_reduction),
                f"{1e3 * loop.delay_margin:.4g}" if loop.delay_margin < inf else "-",
                f"{omega / (2 * pi):.4g}" if isfinite(omega) else "-", f"{loop.distance:.3f}",
            ))  # fmt: skip
    headings = ("t\n[s]", "locus", "phase margin\n[deg]", "gain margin\n[1]", "less gain\n[1]", "delay margin\n[ms]",
                "at\n[Hz]", "least distance\nto -1")  # fmt: skip
    print_table(f"Margins of the loop broken at {', '.join(found[0].broken.names)}", headings, cells, words=())
    for each in found:
        print_response(each.closed)
        growing = [p for p in each.closed.poles if p.s.real > 0.0 and p.magnitude > 1.0 + 1e-3]
        if growing:
            tell(
                f"t = {each.at:g} s: the closed loop has poles that grow, the fastest with {growing[-1].s.real:.3g} 1/s"
            )
        if each.in_time:
            print_in_time(each)
    if any(len(each.loops) > 1 for each in found):
        tell("the margins of loci are of a gain, or a delay, common to all places of the break")


def print_in_time(each: Margins) -> None:
    """The delay margin by the model and on runs."""
    from math import isfinite

    found = each.in_time
    assert found is not None
    runs = f"{2 * len(found.trials)} runs from t = {each.at:g} s, to {found.until:.4g} s at most"
    told = f"t = {each.at:g} s: delay margin {1e3 * found.model:.4g} ms by the model"
    if isfinite(found.delay):
        between = f"dies out with {1e3 * found.dies_out:.4g} ms and grows with {1e3 * found.grows:.4g} ms"
        tell(
            f"{told}, {1e3 * found.delay:.4g} ms in the time domain (a kick {between}): "
            f"difference {100.0 * found.difference:+.1f} %; {runs}"
        )
    elif isfinite(found.grows):
        tell(f"{told}; in the time domain a kick grows with {1e3 * found.grows:.4g} ms already; {runs}")
    else:
        tell(f"{told}; in the time domain a kick dies out with {1e3 * found.longest:.4g} ms too; {runs}")
