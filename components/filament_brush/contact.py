"""Contact of a tip with the hull: normal force (Eq. 7) and friction (Eq. 9)."""

from math import sqrt

from ..library.friction import stribeck
from .parameters import Parameters
from .records import Constants, Friction, Normal


def normal_force(Delta: float, Delta_dot: float, p: Parameters) -> Normal:
    """Normal force F_n >= 0, its elastic part and the contact damping, for Delta > 0."""
    ramp = 1.0
    if Delta < p.Delta_s:
        u = Delta / p.Delta_s
        ramp = u * u * (3.0 - 2.0 * u)
    F_e = p.k_c * Delta * sqrt(Delta)
    F_n = max(0.0, F_e + p.c_c * ramp * Delta_dot)  # Eq. 7
    return Normal(F_n, F_e, damping=p.c_c * ramp)


def contact_energy(Delta: float, p: Parameters) -> float:
    """Elastic energy of the contact, the integral of k_c Delta^1.5 (Eq. 7)."""
    energy = 0.0
    if Delta > 0.0:
        energy = 0.4 * p.k_c * Delta * Delta * sqrt(Delta)
    return energy


def friction_coefficient(v_s: float, p: Parameters, c: Constants) -> Friction:
    """F_f/F_n of Eq. 9 on the fouled hull, and a bound on its slope."""
    mu, slope = stribeck(v_s, c.mu_s, c.mu_c, p.v_0, p.k_v, p.v_eps)
    return Friction(mu, slope)
