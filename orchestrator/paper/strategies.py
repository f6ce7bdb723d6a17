"""Control strategies beside each other, over the same pass: PID, PID with feedforward, and force along the hull
normal, by a force sensor or by an observer that finds the tool's wrench from motion and thrust.

The force on the hull is judged as its moving mean over WINDOW, which takes out the ripple of the blades (125 Hz and
more) that no thruster can follow. All errors count while the brush touches and the full force is asked for; the error
of position is that along the hull, since the strategies with force control leave the position along the normal free.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from scipy.integrate import cumulative_trapezoid

from ..files import prepare_folder, write_file, write_json
from ..results.files.manifest import plain_value
from ..results.pictures.canvas import captioned, legend_above, new_figure
from ..results.pictures.lines import draw
from ..results.signals import Signal, Signals
from ..results.summary.summary import summarize
from ..results.tables import Run, require_complete
from ..run.planned import planned
from ..run.simulation import simulate
from ..system.assemble import assemble

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MODES = ("PID", "PID + feedforward", "force control", "force, observed")
SYSTEMS = ("hull_pass", "fouling_patch")
WINDOW = 0.05  # s
BAND = 0.1  # of the force set-point
P_FULL = 205.0  # W, electrical power of a T200 at full command and 12 V (Blue Robotics); it rises as thrust^1.5
MM, MRAD, PERCENT = ("mm", 1e3), ("mrad", 1e3), ("%", 100.0)
ROWS: dict[str, tuple[str, tuple[str, float]]] = {
    "force_mean": ("force on the hull, mean", ("N", 1.0)),
    "force_error": ("normal-force error, rms", ("N", 1.0)),
    "force_within": ("time within 10 % of the set-point", PERCENT),
    "position_error": ("position error along the hull, rms", MM),
    "position_error_max": ("position error along the hull, largest", MM),
    "attitude_error": ("attitude error, rms", MRAD),
    "attitude_error_max": ("attitude error, largest", MRAD),
    "saturated": ("samples with saturated thrusters", PERCENT),
    "energy_brush": ("energy of the brush motor", ("kJ", 1e-3)),
    "energy_thrusters": ("energy of the thrusters (estimated)", ("kJ", 1e-3)),
    "contact_time": ("time in contact", ("s", 1.0)),
}


@dataclass(frozen=True)
class Comparison:
    """The merits by system and mode, in SI units; ROWS says how to show them. The files that hold them."""

    merits: dict[str, dict[str, dict[str, float]]]
    paths: list[Path]


def strategies(
    out: Path,
    values: Mapping[str, object],
    fmus: Path | None,
    progress: Callable[[float], None] = lambda _share: None,
) -> Comparison:
    """Run every system with every mode of the controller and write the comparison, as JSON and a figure each.

    `progress` hears what share of the runs is done, 0 to 1.
    """
    prepare_folder(out)
    plans = {
        name: [planned(assemble(name, {**values, "controller.mode": mode}, fmus=fmus)) for mode in range(len(MODES))]
        for name in SYSTEMS
    }
    whole = sum(float(plan.system.stop) for each in plans.values() for plan in each)
    done = 0.0
    found: dict[str, dict[str, dict[str, float]]] = {}
    paths = []
    for name, each in plans.items():
        runs: dict[str, Run] = {}
        for label, plan in zip(MODES, each, strict=True):

            def reached(time: float, done: float = done) -> None:
                progress((done + time) / whole)

            runs[label] = require_complete(simulate(plan, progress=reached))
            done += float(plan.system.stop)
        found[name] = {label: merits(run) for label, run in runs.items()}
        paths.append(write_file(out / f"strategies_{name}.png", comparison_figure(name, runs).savefig))
    settings = {"force_window_s": WINDOW, "force_band": BAND, "P_full_W": P_FULL}
    paths.append(write_file(out / "strategies.json", lambda p: write_json(p, {**settings, "systems": found})))
    return Comparison(found, paths)


def merits(run: Run) -> dict[str, float]:
    """Figures of merit of one pass, in SI units; see the head of this module."""
    signals, summary = Signals(run), summarize(run)
    time = signals["vehicle.delta"].time
    force, wanted = force_on_hull(signals, time), held(signals["mission.F_n_ref"], time)
    counts = (signals["vehicle.delta"].values > 0.0) & (wanted > 0.999 * wanted.max())
    saturated = held(signals["controller.saturated"], time) > 0.5
    error = force - wanted
    position = np.hypot(*(signals[f"vehicle.{a}_n"].values - held(signals[f"mission.{a}_ref"], time) for a in "xy"))
    references = [float(run.plan.system.components["controller"].inputs[f"{a}_ref"]) for a in ("phi", "theta", "psi")]
    angles = [signals[f"vehicle.{a}"].values - r for a, r in zip(("phi", "theta", "psi"), references, strict=True)]
    attitude = np.sqrt(sum(np.square(angle) for angle in angles))
    judged = counts & ~saturated
    return {
        "force_mean": float(force[counts].mean()),
        "force_error": rms(error[counts]),
        "force_within": float(np.mean(np.abs(error[judged]) <= BAND * wanted[judged])),
        "position_error": rms(position[counts]),
        "position_error_max": float(position[counts].max()),
        "attitude_error": rms(attitude[counts]),
        "attitude_error_max": float(attitude[counts].max()),
        "saturated": float(saturated[counts].mean()),
        "energy_brush": float(signals["motor.W_electrical"].values[-1]),
        "energy_thrusters": thruster_energy(signals),
        "contact_time": float(counts.sum() * (time[1] - time[0])),
        "energy_balance": float(summary["energy_balance_relative"]),
    }


def rms(values: np.ndarray) -> float:
    """Root of the mean square."""
    return float(np.sqrt(np.mean(np.square(values))))


def force_on_hull(signals: Signals, time: np.ndarray) -> np.ndarray:
    """-F_z of the brush, averaged over WINDOW around each instant (less at the ends of the run)."""
    signal = signals["brush.F_z"]
    integral = cumulative_trapezoid(signal.values, signal.time, initial=0.0)
    edges = np.clip(np.array([time - WINDOW / 2, time + WINDOW / 2]), signal.time[0], signal.time[-1])
    first, last = np.interp(edges, signal.time, integral)
    result: np.ndarray = -(last - first) / (edges[1] - edges[0])
    return result


def held(signal: Signal, time: np.ndarray) -> np.ndarray:
    """A sampled signal at other instants: the latest value."""
    values: np.ndarray = signal.values[np.searchsorted(signal.time, time + 1e-9, side="right") - 1]
    return values


def thruster_energy(signals: Signals) -> float:
    """Electrical energy [J] of the thrusters, from P_FULL and the power law of a propeller in place, P ~ thrust^1.5."""
    vehicle = signals.run.plan.system.components["vehicle"]
    full = [
        float(vehicle.parameters.get(k, plain_value(vehicle.fmu.variables[k].start)))
        for k in ("k_T_forward", "k_T_reverse")
    ]
    total = 0.0
    for j in range(1, 9):
        thrust = signals[f"vehicle.thrust[{j}]"]
        share = np.where(thrust.values > 0.0, thrust.values / full[0], -thrust.values / full[1])
        total += P_FULL * float(np.trapezoid(share**1.5, thrust.time))
    return total


def comparison_figure(name: str, runs: Mapping[str, Run]) -> Figure:
    """Force, position error along the hull and pitch over time, a line for each strategy."""
    figure, axes = new_figure(f"Strategies over {name}", 3)
    for label, run in runs.items():
        signals = Signals(run)
        time = signals["vehicle.delta"].time
        error = signals["vehicle.x_n"].values - held(signals["mission.x_ref"], time)
        drawn = (force_on_hull(signals, time), 1e3 * error, np.degrees(signals["vehicle.theta"].values))
        for axis, values in zip(axes, drawn, strict=True):
            draw(axis, time, values, label, "-")
    reference = signals["mission.F_n_ref"]
    axes[0].plot(reference.time, reference.values, "k--", linewidth=0.8, label="set-point")
    for axis, label in zip(axes, ("force on the hull [N]", "x_n - x_ref [mm]", "theta [deg]"), strict=True):
        axis.set_ylabel(label)
    legend_above(axes[0])
    axes[-1].set_xlabel("time [s]")
    return captioned(figure, next(iter(runs.values())))
