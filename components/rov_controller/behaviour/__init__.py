"""What the controller does, on its interface: loops and sampling, allocation, the tool wrench, the observer."""

from __future__ import annotations

from ...testing.suite import Excitation, suite
from ..fmu import RovController
from . import allocation, force, observer, pid, switching

EXCITATION = Excitation(
    0.01, 80,
    {"x_n": (0.0, 0.3), "z_n": (0.1, 0.6), "phi": (0.0, 0.9), "theta": (0.0, 1.6), "psi": (0.0, 3.1), "u": (0.0, 0.2),
     "q": (0.0, 0.3), "psi_ref": (0.4, 0.3), "V_ref": (11.0, 1.0), "F_tool": (-20.0, 30.0), "M_tool": (-5.0, 4.0),
     "F_n_ref": (40.0, 30.0), "v_ref": (0.0, 0.1)},
    {"mode": 2},
)  # fmt: skip
ESSENTIAL = "x_n y_n z_n phi theta psi u v w p q r u_thruster V_in"
SUITE = suite(RovController, ESSENTIAL, EXCITATION, pid, allocation, force, switching, observer)
