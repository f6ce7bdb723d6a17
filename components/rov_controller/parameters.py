"""Parameters of the controller: gains as SI wrenches, limits, sampling and thrusters, each with unit and source."""

from __future__ import annotations

from dataclasses import dataclass

from ..declare.interface import parameter, tunable
from ..library.thrusters import DIRECTIONS, GEOMETRY_SOURCE, K_T, K_T_SOURCE, POSITIONS

GAINS = "assumed, from mass, inertia and thruster lag"


@dataclass(frozen=True)
class Parameters:
    """Cascaded PID for the BlueROV2 Heavy; the thrusters are those of the vehicle, by the same defaults."""

    mode: int = tunable(
        0,
        "1",
        "0: PID; 1: PID and feedforward of the tool wrench; 2: force along the hull normal; 3: as 2, with the wrench "
        "that an observer finds from motion and thrust",
        "assumed",
        0,
        3,
    )
    T_s: float = parameter(0.02, "s", "sampling period", "assumed (50 Hz)", minimum=1e-4, maximum=1.0)
    K_position: tuple[float, ...] = tunable(
        (1.0, 1.0, 1.0), "1/s", "velocity set-point per position error: north, east, down", GAINS, 0.0, 100.0
    )
    K_velocity: tuple[float, ...] = tunable(
        (60.0, 80.0, 90.0), "N.s/m", "force per velocity error: surge, sway, heave", GAINS, 0.0, 1e4
    )
    K_velocity_i: tuple[float, ...] = tunable(
        (60.0, 80.0, 90.0), "N/m", "its integral action: surge, sway, heave", GAINS, 0.0, 1e4
    )
    K_velocity_d: tuple[float, ...] = tunable(
        (1.0, 1.0, 1.0), "kg", "force per measured acceleration, against it: surge, sway, heave", GAINS, 0.0, 1e4
    )
    K_attitude: tuple[float, ...] = tunable(
        (4.0, 4.0, 3.0), "1/s", "rate set-point per attitude error: roll, pitch, yaw", GAINS, 0.0, 100.0
    )
    K_rate: tuple[float, ...] = tunable(
        (4.0, 4.0, 4.0), "N.m.s/rad", "moment per rate error: roll, pitch, yaw", GAINS, 0.0, 1e4
    )
    K_rate_i: tuple[float, ...] = tunable(
        (6.0, 6.0, 4.0), "N.m/rad", "its integral action: roll, pitch, yaw", GAINS, 0.0, 1e4
    )
    K_rate_d: tuple[float, ...] = tunable(
        (0.01, 0.01, 0.01), "kg.m2", "moment per measured angular acceleration, against it", GAINS, 0.0, 1e4
    )
    K_windup: float = tunable(
        5.0, "1/s", "rate at which the integrals give up what the thrusters cannot", "assumed", 0.0, 50.0
    )
    K_feedforward: float = tunable(
        1.0, "1", "share of the measured tool wrench that is fed forward", "assumed", minimum=0.0, maximum=1.5
    )
    T_filter: float = parameter(
        0.015, "s", "time constant of the filter on the measured tool wrench", "assumed", minimum=0.0, maximum=10.0
    )
    normal: tuple[float, ...] = parameter(
        (0.0, 0.0, 1.0), "1", "unit vector into the hull, body frame (the tool's z_t)", "assumed", -1.0, 1.0
    )
    hull_normal: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0),
        "1",
        "unit normal of the hull into the water, world frame: force is controlled against it; 0, 0, 0: along `normal`",
        "assumed",
        -1.0,
        1.0,
    )
    contact_force: float = tunable(
        5.0, "N", "force from which force control begins; it ends at half of it", "assumed", minimum=0.0, maximum=1e4
    )
    K_force: float = tunable(0.0, "1", "force per force error along the normal", GAINS, minimum=0.0, maximum=100.0)
    K_force_i: float = tunable(2.0, "1/s", "its integral action", GAINS, minimum=0.0, maximum=1e3)
    K_force_d: float = tunable(
        300.0, "N.s/m", "force per velocity along the normal, against it", GAINS, minimum=0.0, maximum=1e5
    )
    K_force_a: float = tunable(
        0.0, "kg", "force per acceleration along the normal, against it: added mass", GAINS, minimum=0.0, maximum=1e4
    )
    bumpless: bool = parameter(
        False, "1", "the force along the normal goes on without a jump when its control begins and ends", "assumed"
    )
    observed_velocity: bool = parameter(
        False, "1", "the loops use velocities of the observer, not the measured ones", "assumed"
    )
    omega_observer: float = parameter(
        10.0, "rad/s", "double pole of the observer", "assumed: half the inverse of the thruster lag", 0.1, 1e3
    )
    M_observer: tuple[float, ...] = parameter(
        (17.0, 24.2, 26.07, 0.28, 0.28, 0.28),
        "kg",
        "mass and inertia with added mass in the observer's model: surge .. yaw",
        "Wu 2018; add the tool's",
        1e-3,
        1e4,
    )
    net_buoyancy: float = parameter(
        0.0, "N", "buoyancy minus weight of vehicle and tool, in the observer's model", "assumed: trimmed", -1e4, 1e4
    )
    thruster_lag: float = parameter(
        0.02, "s", "time constant of the thrust in the observer's model", "T200 step: 63 % at 20 ms", 0.0, 10.0
    )
    v_max: float = tunable(0.5, "m/s", "limit of the velocity set-point", "assumed", minimum=1e-3, maximum=10.0)
    rate_max: float = tunable(1.0, "rad/s", "limit of the rate set-point", "assumed", minimum=1e-3, maximum=10.0)
    attitude_first: bool = parameter(
        True, "1", "a saturated allocation gives up force before moment; false: clips each thruster", "assumed"
    )
    bounded_least_squares: bool = parameter(
        False,
        "1",
        "a saturated allocation gives the nearest wrench, weighted by the two below; false: as `attitude_first` says",
        "Haerkegaard 2002 (allocation by active sets)",
    )
    weight_moment: float = parameter(
        100.0, "1/m", "weight of a missed moment against a missed length of the force", "assumed: first", 1.0, 1e3
    )
    weight_direction: float = parameter(
        30.0, "1", "weight of a missed force across the requested one, against a missed length", "assumed", 1.0, 1e3
    )
    thruster_position: tuple[float, ...] = parameter(
        POSITIONS, "m", "eight rows (x, y, z), body frame", GEOMETRY_SOURCE, -10.0, 10.0
    )
    thruster_direction: tuple[float, ...] = parameter(
        DIRECTIONS, "1", "eight rows (x, y, z): unit force at a positive command", GEOMETRY_SOURCE, -1.0, 1.0
    )
    k_T_forward: float = parameter(K_T[12][0], "N", "thrust at command +1", K_T_SOURCE, minimum=1e-3, maximum=1e4)
    k_T_reverse: float = parameter(K_T[12][1], "N", "thrust at command -1", K_T_SOURCE, minimum=1e-3, maximum=1e4)


NOMINAL = Parameters()
