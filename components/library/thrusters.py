"""Thruster geometry of the BlueROV2 Heavy and thrust coefficients, shared by vehicle and controller.

Odd numbers are on the starboard side; 1, 2, 5, 6 at the bow; 1-4 horizontal at 45 degrees, 5-8 vertical. A direction is
that of the force on the vehicle for a positive command. Position and direction give the allocation matrix of Eq. 20.
"""

from __future__ import annotations

from math import sqrt

_C = sqrt(0.5)

# Eight rows (x, y, z) in the body frame [m]: ArduSub's VECTORED_6DOF frame with the dimensions of Wu 2018.
POSITIONS: tuple[float, ...] = (
    0.156, 0.111, 0.085,
    0.156, -0.111, 0.085,
    -0.156, 0.111, 0.085,
    -0.156, -0.111, 0.085,
    0.12, 0.218, 0.0,
    0.12, -0.218, 0.0,
    -0.12, 0.218, 0.0,
    -0.12, -0.218, 0.0,
)  # fmt: skip

# Eight rows (x, y, z), unit vectors in the body frame.
DIRECTIONS: tuple[float, ...] = (
    -_C, _C, 0.0,
    -_C, -_C, 0.0,
    _C, _C, 0.0,
    _C, -_C, 0.0,
    0.0, 0.0, 1.0,
    0.0, 0.0, 1.0,
    0.0, 0.0, 1.0,
    0.0, 0.0, 1.0,
)  # fmt: skip

# Forward and reverse k_T [N] of the T200 by supply voltage [V], as fitted to the published thrust table.
K_T: dict[int, tuple[float, float]] = {12: (40.9, 32.2), 16: (58.0, 45.4)}

GEOMETRY_SOURCE = "ArduSub VECTORED_6DOF frame, dimensions of Wu 2018"
K_T_SOURCE = "fitted to the T200 thrust table (Blue Robotics 2019) at 12 V"
