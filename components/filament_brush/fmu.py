"""The filament brush as an FMU: names and units only, the equations are in kernel.py and the files it imports."""

from ..interface import Array, calculated, input_, output
from ..slave import ComponentSlave
from . import kernel
from .parameters import Parameters

COLUMNS = tuple(output(f"filament_{x}", unit, f"{text} of filament i") for x, unit, text in (
    ("phi", "rad", "angle from +z_t"), ("F_n", "N", "normal force"), ("F_f", "N", "friction"), ("y", "m", "bending")))
ALL = ("omega_b", "delta", "delta_dot", "v_rov", "friction_scale")


class FilamentBrush(ComponentSlave):
    """Rotating brush of flexible filaments that sweep a hull (Eqs. 1-15)"""

    parameters = Parameters
    kernel = kernel
    default_step = 5e-4
    inputs = (
        input_("omega_b", "rad/s", "brush speed about +y_t"),
        input_("delta", "m", "penetration of the undeformed brush into the hull"),
        input_("delta_dot", "m/s", "rate of delta; within a step delta goes on at this rate"),
        input_("v_rov", "m/s", "speed of the hull past the tool along +x_t"),
        input_("friction_scale", "1", "factor on mu_s and mu_c (fouling)", start=1.0, minimum=0.0),
    )
    outputs = (
        output("F_x", "N", "force on the brush along x_t", ALL),
        output("F_z", "N", "force on the brush along z_t", ALL[:3]),
        output("T_brush", "N.m", "torque on the brush about y_t", ALL),
        output("contact_count", "1", "filaments in contact", ALL[:3]),
        output("deflection_ratio", "1", "largest |y(L)|/L in the last step"),
        output("deflection_ratio_max", "1", "largest |y(L)|/L so far"), output("theta_b", "rad", "brush angle"),
        *(output(f"J_{x}", "N.s", f"time integral of F_{x}") for x in "xz"),
        output("J_T", "N.m.s", "time integral of T_brush"),
        output("F_y_eq11", "N", "sum of base shears, Eq. 11", ALL),
        output("M_b_eq12", "N.m", "sum of base moments, Eq. 12", ALL),
        output("F_z_eq13", "N", "sum of axial forces, Eq. 13", ALL),
        output("T_brush_eq15", "N.m", "torque of Eq. 15", ALL),
        *(output(f"P_{x}", "W", f"power {of}", ALL) for x, of in (("hub", "of the hub"), ("hull", "of the hull"))),
        *(output(f"P_{x}", "W", f"power lost in {x}", ALL) for x in ("damping", "friction", "contact")),
        output("E_kinetic", "J", "kinetic energy relative to the hub"), output("E_strain", "J", "strain energy"),
        output("E_centrifugal", "J", "centrifugal potential", ("omega_b",)),
        output("E_contact", "J", "elastic energy of the contact", ("delta",)),
        *(output(f"W_{x}", "J", f"work of the {x}") for x in ("hub", "hull")),
        *(output(f"W_{x}", "J", f"energy lost in {x}") for x in ("damping", "friction", "contact")),
        output("energy_residual", "J", "energy that the integration created", ("omega_b", "delta")),
        output("micro_steps", "1", "micro-steps of touching filaments so far"),
        output("h_micro_min", "s", "shortest micro-step so far, but for those cut by a communication point"),
        output("kinetic_fraction", "1", "share of each mode in the kinetic energy", size=6),
        calculated("lambda_r", "1", "eigenvalues", 6), calculated("omega_r", "rad/s", "frequencies at rest", 6),
        calculated("R_h", "m", "hub radius"), calculated("J_filaments", "kg.m2", "inertia of the filaments about y_t"),
    )
    arrays = (
        Array("lambda_r", 6), Array("omega_r", 6), Array("modes", (7, 6)), Array("G", (6, 6)), Array("S", (6, 6)),
        *(Array(name, lambda p: (p.n, p.N_m)) for name in ("eta", "eta_dot")), Array("h_next", lambda p: p.n),
        Array("total", 16), Array("K", (7, 6), scratch=True),
        *(Array(name, lambda p: (2 * p.N_m + 1, 2 * p.N_m + 1), scratch=True) for name in "PQA"),
        Array("c", 17, scratch=True), Array("work", (15, 6), scratch=True),
        Array("kinetic_fraction", 6, scratch=True), Array("filament", lambda p: (p.n, 4), True, COLUMNS),
    )
