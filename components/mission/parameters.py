"""Parameters of a cleaning pass: its path, its times, the force to press with, and the fouling on the hull."""

from __future__ import annotations

from dataclasses import dataclass

from ..declare.interface import parameter, tunable


@dataclass(frozen=True)
class Parameters:
    """One straight pass along a plane hull."""

    T_s: float = parameter(0.02, "s", "sampling period of the set-points", "assumed (50 Hz)", minimum=1e-4, maximum=1.0)
    along: tuple[float, ...] = parameter(
        (-1.0, 0.0, 0.0), "1", "unit vector along the pass, world frame: against x_t, as the paper's v_rov", "assumed",
        -1.0, 1.0
    )
    into_hull: tuple[float, ...] = parameter(
        (0.0, 0.0, 1.0), "1", "unit vector into the hull, world frame", "assumed", -1.0, 1.0
    )
    t_start: float = parameter(1.0, "s", "time at which the approach begins", "assumed", minimum=0.0, maximum=1e4)
    standoff: float = parameter(
        0.05, "m", "distance from the start to first touch, along into_hull", "assumed", minimum=0.0, maximum=100.0
    )
    depth: float = parameter(
        0.0022, "m", "penetration of the position set-point", "that of F_n on the clean hull", -1.0, 1.0
    )
    v_approach: float = parameter(0.02, "m/s", "speed of the approach", "assumed", minimum=1e-4, maximum=2.0)
    t_settle: float = parameter(
        3.0, "s", "time at the hull before the pass, and after it", "assumed", minimum=0.0, maximum=1e4
    )
    length: float = parameter(1.0, "m", "length of the pass", "assumed", minimum=0.0, maximum=1e3)
    v_clean: float = parameter(0.05, "m/s", "speed of the pass", "Table 3 (v_ROV)", minimum=1e-4, maximum=2.0)
    t_release: float = parameter(
        1.0, "s", "time in which the force goes back to 0 before leaving", "assumed", minimum=0.0, maximum=1e4
    )
    v_leave: float = parameter(0.05, "m/s", "speed of leaving", "assumed", minimum=1e-4, maximum=2.0)
    leave: float = parameter(0.1, "m", "distance from the hull at the end", "assumed", minimum=0.0, maximum=100.0)
    F_n: float = tunable(
        40.0, "N", "force to press into the hull with: within the thrusters' authority", "assumed", 0.0, 1e4
    )
    fouling_place: tuple[float, ...] = parameter(
        (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7), "m", "places on the pass, rising", "assumed", -1e3, 1e3
    )
    fouling_scale: tuple[float, ...] = parameter(
        (1.0,) * 8, "1", "friction scale at these places, linear in between", "assumed", minimum=0.0, maximum=20.0
    )


NOMINAL = Parameters()
