"""Parameters of the filament brush."""

from __future__ import annotations

from dataclasses import dataclass

from ..declare.interface import parameter, usual


@dataclass(frozen=True)
class Parameters:
    """One brush; the defaults are what `rovbrush calibrate` finds."""

    L: float = parameter(0.08, "m", "filament length", "Table 2", minimum=1e-3, maximum=1.0)
    d: float = parameter(0.8e-3, "m", "filament diameter", "Table 2", minimum=1e-5, maximum=0.02)
    E: float = parameter(2.5e9, "Pa", "Young's modulus (nylon-6)", "Table 2", minimum=1e5, maximum=1e12)
    rho: float = parameter(1140.0, "kg/m3", "filament density", "Table 2", minimum=100.0, maximum=2e4)
    n: int = parameter(50, "1", "number of filaments (bundles)", "Table 2", minimum=1, maximum=5000)
    R_brush: float = parameter(0.15, "m", "radius of the undeformed tips", "Table 2", minimum=2e-3, maximum=2.0)
    mu_s: float = parameter(0.6, "1", "static friction coefficient", "Table 2", minimum=0.0, maximum=3.0)
    mu_c: float = parameter(0.4, "1", "Coulomb friction coefficient", "Table 2", minimum=0.0, maximum=3.0)
    N_m: int = usual(3, "1", "number of bending modes", "section 3.6", minimum=1, maximum=6)
    zeta: tuple[float, ...] = parameter(
        (0.02,) * 6, "1", "modal damping ratio of modes 1 to 6", "section 6.2", minimum=0.0, maximum=0.9
    )
    h_min: float = parameter(
        1e-4, "s", "smallest micro-step that error control asks for", "section 3.6", minimum=1e-7, maximum=1e-2
    )
    h_max: float = parameter(1e-3, "s", "largest micro-step", "section 3.6", minimum=1e-7, maximum=1e-2)
    k_c: float = parameter(
        183190.0, "N/m1.5", "contact stiffness of a bundle", "calibrated to Table 3", minimum=0.0, maximum=1e9
    )
    c_c: float = parameter(
        0.0, "N.s/m", "contact damping of a bundle", "assumed; 0 fits Table 3 best", minimum=0.0, maximum=1e5
    )
    v_0: float = parameter(0.05, "m/s", "Stribeck velocity", "assumed", minimum=1e-4, maximum=10.0)
    k_v: float = parameter(
        0.044149, "s/m", "viscous friction coefficient", "calibrated to Table 3", minimum=0.0, maximum=10.0
    )
    alpha: float = parameter(
        -0.3,
        "rad",
        "cant angle: positive trails, negative is raked forward",
        "assumed, held in the calibration",
        minimum=-1.2,
        maximum=1.2,
    )
    bristles_per_filament: float = parameter(
        18000.0, "1", "bristles in a bundle, N_b", "calibrated to Table 3", minimum=1e-3, maximum=1e7
    )
    v_eps: float = parameter(
        0.02, "m/s", "sliding velocity over which the sign function is smoothed", "assumed", minimum=1e-4, maximum=1.0
    )
    friction_law: int = usual(
        0,
        "1",
        "0: Eq. 9 smoothed over v_eps; 1: the same with its largest dry value mu_s, at v_eps; 2: LuGre",
        "assumed",
        minimum=0,
        maximum=2,
    )
    sigma_0: float = parameter(
        1e4, "1/m", "LuGre: stiffness of the microscopic bristles over F_n", "assumed: 60 um before mu_s", 1.0, 1e7
    )
    sigma_1: float = parameter(
        1.0, "s/m", "LuGre: their damping over F_n", "assumed: a tenth of critical at a loaded tip", 0.0, 1e4
    )
    Delta_s: float = parameter(
        1e-4,
        "m",
        "penetration over which contact damping rises to c_c (0: as Eq. 7)",
        "assumed",
        minimum=0.0,
        maximum=0.05,
    )
    C_a: float = parameter(
        0.0, "1", "added-mass coefficient of the water (0: as the paper)", "section 3", minimum=0.0, maximum=5.0
    )
    rho_w: float = parameter(1025.0, "kg/m3", "density of sea water", "assumed", minimum=0.0, maximum=2000.0)
    nu_w: float = parameter(1.2e-6, "m2/s", "kinematic viscosity of sea water", "assumed: 15 degrees", 1e-8, 1e-3)
    C_d: float = usual(
        0.0, "1", "drag coefficient of a bristle across the flow (0: no drag, as the paper)", "section 6.2", 0.0, 10.0
    )
    shielding: float = parameter(
        1.0, "1", "share of a lone bristle's drag that one in its bundle feels", "assumed", minimum=0.0, maximum=2.0
    )
    co_rotation: float = parameter(
        0.9, "1", "share of the pack's speed that the water within it has", "assumed: balance of torques, README",
        minimum=0.0, maximum=1.0,
    )
    linear_below: float = parameter(
        0.5, "1", "a tip's own speed over the flow's, below which drag off the hull is linear (0: never)", "assumed",
        minimum=0.0, maximum=1e9,
    )
    width: float = parameter(0.3, "m", "length of the brush along its axis", "assumed", minimum=1e-3, maximum=5.0)
    pack_drag: float = usual(
        0.0, "1", "torque of the spinning pack over that of a rough cylinder (0: none, as the paper)",
        "Theodorsen and Regier 1944; 1 is their law", minimum=0.0, maximum=100.0,
    )
    pack_roughness: float = parameter(
        0.0094, "m", "height of that cylinder's roughness", "assumed: half the gap between bundles at the tips",
        minimum=0.0, maximum=0.1,
    )
    C_paddle: float = usual(
        0.0, "1", "drag coefficient of the bundles as paddles, a bound from above (0: none)", "assumed", 0.0, 10.0
    )
    n_strips: int = usual(
        1, "1", "strips across the width, each with its own penetration", "assumed", minimum=1, maximum=50
    )
    hull_curvature: float = parameter(
        0.0, "1/m", "curvature of the hull across the width; convex is positive", "assumed", minimum=-10.0, maximum=10.0
    )
    n_groups: int = usual(
        1, "1", "groups of free length in a bundle, spread evenly", "assumed", minimum=1, maximum=50
    )
    length_spread: float = parameter(
        0.0, "1", "half the range of free lengths over L", "assumed", minimum=0.0, maximum=0.2
    )
    theta_b_0: float = parameter(0.0, "rad", "brush angle at the start", "assumed", minimum=-1e3, maximum=1e3)
    tolerance: float = parameter(
        1e-6, "1", "velocity error allowed per micro-step over omega_1 L", "assumed", minimum=1e-12, maximum=1.0
    )
    foreshortening: bool = usual(True, "1", "tip moves inwards as the filament bends", "section 1.3")
    centrifugal: bool = usual(True, "1", "centrifugal stiffening, softening and load", "section 3.5")
    mode_acceleration: bool = usual(
        True, "1", "base reactions exact in statics (false: Eqs. 11, 12 as printed)", "assumed"
    )


# Fits Table 3 with fewer bristles, but digs in: friction turns the bristles up into the hull.
STEEP_RAKE = Parameters(k_c=1.06678e5, k_v=0.043666, alpha=-0.64, bristles_per_filament=8000.0)
