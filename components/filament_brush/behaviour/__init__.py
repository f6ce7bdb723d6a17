"""What the brush does, on its interface: at the hull, across its width, with energy and time, and in water."""

from __future__ import annotations

from ...testing.suite import Excitation, suite
from ..fmu import FilamentBrush
from . import across_the_width, at_the_hull, energy, water

EXCITATION = Excitation(
    1e-3, 40,
    {"omega_b": (12.0, 6.0), "delta": (4e-3, 3e-3), "v_rov": (0.05, 0.1), "delta_dot": (0.0, 0.5),
     "friction_scale": (1.0, 0.3)},
    {"n": 8},
)  # fmt: skip
ESSENTIAL = "omega_b delta v_rov F_x F_z T_brush"
SUITE = suite(FilamentBrush, ESSENTIAL, EXCITATION, at_the_hull, across_the_width, energy, water)
