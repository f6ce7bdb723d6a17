"""What the vehicle does, on its interface: at rest, in motion, against the hull, and with the tool's spin and mass."""

from __future__ import annotations

from ...testing.suite import Excitation, suite
from ..fmu import RovVehicle
from . import at_rest, hull, motion, spin, thrusters, tool_mass

EXCITATION = Excitation(
    5e-3, 60,
    {"u_thruster": (0.1, 1.2), "F_x": (-60.0, 50.0), "F_z": (-120.0, 90.0), "M_y": (-9.0, 8.0), "H_y": (5.0, 4.0),
     "V_thruster": (14.0, 2.0), "v_c": (0.2, 0.3), "F_external": (2.0, 9.0), "M_external": (0.0, 1.5)},
    {"attitude_start": (0.3, -0.4, 2.0), "rates_start": (0.1, 0.5, -0.2)},
)  # fmt: skip
ESSENTIAL = f"u_thruster F_x F_z M_y {' '.join(motion.POSE)} {' '.join(motion.VELOCITY)} delta delta_dot v_rov"
SUITE = suite(RovVehicle, ESSENTIAL, EXCITATION, at_rest, hull, motion, spin, thrusters, tool_mass)
