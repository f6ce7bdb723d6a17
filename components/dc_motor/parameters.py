"""Parameters of the brush motor, its gearbox and the inertia it turns, each with unit and source."""

from __future__ import annotations

from dataclasses import dataclass

from ..declare.interface import parameter


@dataclass(frozen=True)
class Parameters:
    """Permanent-magnet DC motor with a planetary gearbox; the defaults are the paper's nominal drive."""

    R: float = parameter(0.08, "Ohm", "terminal resistance", "Table 2", minimum=1e-4, maximum=100.0)
    L_a: float = parameter(50e-6, "H", "armature inductance", "typical of the class", minimum=1e-7, maximum=1.0)
    K_t: float = parameter(0.016, "N.m/A", "torque constant", "Table 2", minimum=1e-5, maximum=10.0)
    K_e: float = parameter(0.016, "V.s/rad", "back-EMF constant", "equal to K_t in SI", minimum=1e-5, maximum=10.0)
    B_m: float = parameter(
        9.6777e-4, "N.m.s/rad", "viscous damping on the motor shaft", "calibrated to Table 3", minimum=0.0, maximum=1.0
    )
    J_m: float = parameter(5e-5, "kg.m2", "rotor inertia", "typical of the class", minimum=1e-9, maximum=1.0)
    J_b: float = parameter(
        0.6,
        "kg.m2",
        "brush inertia on the output shaft: filaments 0.55, hub 0.05",
        "assumed",
        minimum=0.0,
        maximum=100.0,
    )
    gear_ratio_per_stage: float = parameter(
        5.22, "1", "ratio of one planetary stage", "Table 2 (N_g)", minimum=1.0, maximum=1000.0
    )
    gear_stages: int = parameter(
        2, "1", "number of stages; one stage cannot give 16.63 N.m (stall is 12.5 N.m)", "assumed", minimum=1, maximum=6
    )
    rotor_sense: int = parameter(
        1,
        "1",
        "sense in which the rotor turns against the brush: 1 the same, -1 the other, 0 across it",
        "planetary gear, fixed ring",
        minimum=-1,
        maximum=1,
    )
    gear_efficiency: float = parameter(
        1.0, "1", "efficiency of the gearbox in both directions, 1 = lossless", "assumed", minimum=0.05, maximum=1.0
    )
    gear_speed_eps: float = parameter(
        1.0, "rad/s", "motor speed below which the gear loss fades out", "assumed", minimum=1e-2, maximum=100.0
    )
    current_limit: float = parameter(
        0.0, "A", "limit of the drive on the armature current, 0 = none", "assumed", minimum=0.0, maximum=1e4
    )
    i_start: float = parameter(0.0, "A", "initial armature current", "assumed", minimum=-1e4, maximum=1e4)
    omega_b_start: float = parameter(0.0, "rad/s", "initial brush speed", "assumed", minimum=-1e3, maximum=1e3)
    max_step: float = parameter(5e-5, "s", "largest internal step", "assumed", minimum=1e-7, maximum=1e-3)


NOMINAL = Parameters()
