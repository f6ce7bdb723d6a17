"""Parameters of the cup brush."""

from __future__ import annotations

from dataclasses import dataclass

from ..declare.interface import parameter


@dataclass(frozen=True)
class Parameters:
    """One brush; the defaults have all tufts of Table 2 on one circle."""

    L: float = parameter(0.08, "m", "bristle length", "Table 2", minimum=1e-3, maximum=1.0)
    d: float = parameter(0.8e-3, "m", "bristle diameter", "Table 2", minimum=1e-5, maximum=0.02)
    E: float = parameter(2.5e9, "Pa", "Young's modulus (nylon-6)", "Table 2", minimum=1e5, maximum=1e12)
    rho: float = parameter(1140.0, "kg/m3", "bristle density", "Table 2", minimum=100.0, maximum=2e4)
    R_brush: float = parameter(
        0.15, "m", "radius of the circle on which the tips of a row of radius 1 slide", "Table 2", 2e-3, 2.0
    )
    row_radius: tuple[float, ...] = parameter(
        (1.0, 0.85, 0.7, 0.55, 0.4, 0.3, 0.2, 0.1), "1", "radii of eight rows over R_brush", "assumed", 0.0, 5.0
    )
    row_tufts: tuple[float, ...] = parameter(
        (50.0,) + (0.0,) * 7, "1", "tufts in each row, evenly spread (n of Table 2 in the first)", "Table 2", 0.0, 1e3
    )
    bristles_per_tuft: float = parameter(
        487.0, "1", "bristles in a tuft", "calibrated to Table 3", minimum=1e-3, maximum=1e6
    )
    delta_0: float = parameter(
        0.005, "m", "penetration at which tips slide on the radii of their rows (0: radii are those of the roots)",
        "section 6.4", minimum=0.0, maximum=0.3,
    )
    alpha: float = parameter(
        0.0, "rad", "cant of the bristles along their circle; positive trails for omega_b > 0", "assumed", 0.0, 0.6
    )
    mu_s: float = parameter(0.6, "1", "static friction coefficient", "Table 2", minimum=0.0, maximum=3.0)
    mu_c: float = parameter(0.4, "1", "Coulomb friction coefficient", "Table 2", minimum=0.0, maximum=3.0)
    v_0: float = parameter(0.05, "m/s", "Stribeck velocity", "assumed", minimum=1e-4, maximum=10.0)
    k_v: float = parameter(
        0.0426, "s/m", "viscous friction coefficient", "calibrated to Table 3", minimum=0.0, maximum=10.0
    )
    v_eps: float = parameter(
        0.02, "m/s", "sliding velocity over which the sign function is smoothed", "assumed", minimum=1e-4, maximum=1.0
    )
    friction_law: int = parameter(
        0, "1", "0: Eq. 9 smoothed over v_eps; 1: the same with its largest dry value mu_s, at v_eps", "assumed", 0, 1
    )
    c_c: float = parameter(
        0.1, "N.s/m", "damping of a pressed tuft along the hull normal", "assumed: zeta = 0.02 at 5 mm", 0.0, 1e5
    )
    Delta_s: float = parameter(
        1e-4, "m", "penetration over which damping rises to c_c", "assumed", minimum=0.0, maximum=0.05
    )
    Delta_eps: float = parameter(
        5e-8, "m", "penetration below which the normal force starts linearly", "assumed", minimum=1e-12, maximum=0.01
    )
    rho_w: float = parameter(1025.0, "kg/m3", "density of sea water", "assumed", minimum=0.0, maximum=2000.0)
    nu_w: float = parameter(1.2e-6, "m2/s", "kinematic viscosity of sea water", "assumed: 15 degrees", 1e-8, 1e-3)
    pack_drag: float = parameter(
        0.0, "1", "torque of the water over that on a disc and, around the bristles, a rough cylinder (0: none)",
        "von Karman 1921, Theodorsen and Regier 1944; 1 is their law", minimum=0.0, maximum=100.0,
    )
    pack_roughness: float = parameter(
        0.0094, "m", "height of that cylinder's roughness", "assumed: half the gap between tufts at the tips", 0.0, 0.1
    )
    h_max: float = parameter(1e-3, "s", "largest micro-step", "section 3.6", minimum=1e-6, maximum=1e-2)
    theta_b_0: float = parameter(0.0, "rad", "brush angle at the start", "assumed", minimum=-1e3, maximum=1e3)


NOMINAL = Parameters()
