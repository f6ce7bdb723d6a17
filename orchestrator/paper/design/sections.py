"""What the designer's page shows, section by section: tables of texts, ready for the templates and for design.json."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ...system.assemble import assemble
from ..margins.limits import delay_limit
from ..margins.open_loop import BEGIN, LENGTH, open_loop
from ..margins.table import BRUSHES, varied
from ..strategies import merits
from ..thrust_budget import CURRENTS, Budget
from .origins import Number, numbers
from .spread import LIMIT, Spread
from .task import Task, force_error

Rows = list[tuple[str, ...]]

ANSWERS = {  # figures of merit of the system: what they are called, their unit here and its factor
    "F_z_mean": ("force on the hull, mean", "N", -1.0),
    "F_x_mean": ("force along the hull, mean", "N", 1.0),
    "T_brush_mean": ("torque of the brush, mean", "N.m", 1.0),
    "omega_b_mean": ("brush speed, mean", "rad/s", 1.0),
    "delta_mean": ("penetration, mean", "mm", 1e3),
    "pitch_rms": ("pitch, rms", "mrad", 1e3),
    "i_mean": ("current of the brush motor, mean", "A", 1.0),
    "P_mean": ("electrical power of the brush motor, mean", "W", 1.0),
    "u_peak": ("largest command of a thruster", "1", 1.0),
    "saturated_samples": ("samples with saturated thrusters", "1", 1.0),
    "max_deflection_ratio": ("largest deflection of a bristle over its length", "1", 1.0),
}
SENSORS = (  # what is measured, the sensor and the quantity as the parameters of rov_sensors name them
    ("velocity (DVL)", "dvl", "dvl"),
    ("position north and east", "position", "position"),
    ("depth", "depth", "depth"),
    ("attitude", "attitude", "attitude"),
    ("rates (gyro)", "gyro", "gyro"),
    ("specific force (accelerometer)", "accelerometer", "accelerometer"),
    ("tool force", "force", "force"),
    ("tool moment", "force", "moment"),
)
GEOMETRY = ("thruster_position", "thruster_direction")  # of the controller: no gains
ASKED = {"phase": 40.0, "phase, twice as stiff": 20.0, "delay": 0.03}  # deg and s: what a loop in contact should have


@dataclass(frozen=True)
class Brush:
    """The tool: what it says of itself, and its numbers."""

    description: str
    numbers: list[Number]
    motor: list[Number]


def short(task: Task, tools: list[Budget], found: Spread | None) -> Rows:
    """The answer in a few lines: what is asked, what answers it."""
    given = {number.name: number for number in numbers(task, "controller")}
    mode = given["mode"]
    strategy = next(
        (part for part in mode.meaning.split("; ") if part.startswith(f"{mode.value}:")), f"mode {mode.value}"
    )
    chosen = [
        f"{n.name} = {n.value} {n.unit}".removesuffix(" 1")
        for n in given.values()
        if n.origin.endswith(".toml") and n.name != "mode"
    ]
    loads = [task.case.signals[f"controller.u_thruster[{k}]"] for k in range(1, 9)]
    begin, end = task.case.window
    largest = max(float(np.max(np.abs(u.values[(u.time >= begin) & (u.time <= end)]))) for u in loads)
    measured = [f"{what}: {rate}, {delay} late, noise {noise}" for what, rate, delay, noise, *_ in sensors(task)]
    return [
        ("Which brush", f"{brush(task).description}. It is pressed in by {1e3 * task.figures['delta_mean']:.2f} mm."),
        ("Which strategy and gains", f"{strategy}. {', '.join(chosen)}."),
        ("Which sensors", f"{'; '.join(measured) or 'the truth, at the sampling period of the controller'}."),
        (
            "How much thrust",
            f"The thrusters' largest command under way is {largest:.2f} of full.{reserve(task, tools)}",
        ),
        ("How sure", verdict(found) if found is not None else "No points were asked for."),
    ]


def answers(task: Task, found: Spread | None) -> Rows:
    """Quantity, unit, the run of the task, and the error bar: 5 to 95 % of the points."""
    summary = task.figures
    rows: Rows = []

    def row(what: str, unit: str, value: float, values: np.ndarray | None) -> None:
        bar = ("", "")
        if found is not None and values is not None:
            low, _, high = found.bar(values)
            bar = (f"{min(low, high):.4g}", f"{max(low, high):.4g}")
        rows.append((what, unit, f"{value:.4g}", *bar))

    error = float(force_error(np.array(summary["F_z_mean"]), np.array(summary["F_z_rms"]), task.force))
    row(
        "force error, rms with ripple, of what is asked for",
        "%",
        100.0 * error,
        None if found is None else 100.0 * found.error,
    )
    row(
        "time in contact while under way",
        "%",
        100.0 * summary["contact_share"],
        None if found is None else 100.0 * found.contact,
    )
    for key, (what, unit, factor) in ANSWERS.items():
        if key in summary:
            values = None if found is None or key not in found.figures else factor * found.figures[key]
            row(what, unit, factor * summary[key], values)
    return rows


def tracking(task: Task) -> Rows:
    """How well the run of the task does, by the measures of `rovbrush strategies`: quantity, value."""
    seen = merits(task.case.run)
    return [
        ("force error, rms, averages over 50 ms", f"{seen['force_error']:.3g} N"),
        ("time within 10 % of the force", f"{100.0 * seen['force_within']:.3g} %"),
        ("position error along the hull, rms", f"{1e3 * seen['position_error']:.3g} mm"),
        ("attitude error, rms", f"{1e3 * seen['attitude_error']:.3g} mrad"),
        ("energy of the brush motor", f"{1e-3 * seen['energy_brush']:.3g} kJ"),
        ("energy of the thrusters, estimated", f"{1e-3 * seen['energy_thrusters']:.3g} kJ"),
    ]


def brush(task: Task) -> Brush:
    """The tool."""
    said = task.case.run.plan.system.parameter_set
    return Brush(str(said) if said else "the FMU's defaults", numbers(task, "brush"), numbers(task, "motor"))


def gains(task: Task) -> list[Number]:
    """What the controller is tuned with."""
    return [number for number in numbers(task, "controller") if number.name not in GEOMETRY]


def margins(task: Task, fmus: Path | None) -> Rows:
    """What the loop of the force leaves, with the brush as it is and one twice as stiff: brush, then texts."""
    length = f"{BEGIN + LENGTH:g} s"
    asked = assemble(task.study.system, task.study.values, length, fmus)
    mode, rows = int(task.case.parameter("controller.mode")), list[tuple[str, ...]]()
    for brush, factor in BRUSHES.items():
        system = varied(asked, mode, factor)
        loop, stiffness = open_loop(system)
        late = f"{1e3 * delay_limit(system):.0f}" if "sensors" in system.components else ""
        phase = ASKED["phase"] if factor == 1.0 else ASKED["phase, twice as stiff"]
        rows.append((
            brush, f"{1e-3 * stiffness:.1f}", f"{np.degrees(loop.phase_margin):.0f}", f"{phase:g}",
            f"{1e3 * loop.delay_margin:.0f}", f"{1e3 * ASKED['delay']:g}", f"{loop.gain_margin:.1f}", late,
        ))  # fmt: skip
    return rows


def sensors(task: Task) -> Rows:
    """Per sensor: samples per second, delay, noise, bias, quantum, lost samples; none where the truth is passed on."""
    component = task.component("rov_sensors")
    if not component:
        return []
    value = {number.name: number for number in numbers(task, component)}

    def text(name: str) -> str:
        found = value[name]
        return f"{found.value} {found.unit}" if found.unit != "1" else found.value

    return [
        (what, text(f"rate_{sensor}"), text(f"delay_{sensor}"), text(f"noise_{quantity}"), text(f"bias_{quantity}"),
         text(f"quantum_{quantity}"), text(f"dropout_{sensor}"), value[f"rate_{sensor}"].origin)
        for what, sensor, quantity in SENSORS
    ]  # fmt: skip


def verdict(found: Spread) -> str:
    """The result of the points in a sentence."""
    held, count = int(np.sum(found.held)), len(found.error)
    lost = int(np.sum(found.contact < 1.0))
    beyond = int(np.sum(found.error > LIMIT))
    return (
        f"{held} of {count} points hold: {lost} lose contact while under way, {beyond} have a force error above "
        f"{100 * LIMIT:g} % rms, {len(found.failures)} stopped with an error."
    )


def budget(task: Task, tools: list[Budget]) -> dict[str, Any]:
    """Largest normal force by tool and current, and how many times the task's force it is in the strongest current."""
    currents = [f"in {current:g} m/s [N]" for current in CURRENTS]
    rows = [
        (tool.tool, f"{tool.held:.1f}", *(f"{tool.largest[current]:.1f}" for current in CURRENTS),
         f"{tool.largest[CURRENTS[-1]] / task.force:.2f}", tool.commands[0])
        for tool in tools
    ]  # fmt: skip
    heading = ["tool", "pressed with in its run [N]", *currents, f"the last over the task's {task.force:g} N", "run"]
    return {"heading": heading, "rows": rows}


def reserve(task: Task, tools: list[Budget]) -> str:
    """What the thrusters could hold with the task's own tool, in a sentence; empty if it is not among the tools."""
    own = next((tool for tool in tools if f"rovbrush run {task.study.system}" == tool.commands[0]), None)
    if own is None:
        return ""
    most = own.largest[CURRENTS[-1]]
    return f" They could hold {most:.0f} N in {CURRENTS[-1]:g} m/s, {most / task.force:.1f} times what is asked."
