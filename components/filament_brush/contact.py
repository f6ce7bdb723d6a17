"""Contact of a tip with the hull: normal force (Eq. 7) and friction (Eq. 9, or LuGre)."""

from math import sqrt

from ..library.friction import lugre, stribeck, stribeck_with_peak
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


def friction_coefficient(v_s: float, z: float, growth: float, p: Parameters, c: Constants) -> Friction:
    """F_f/F_n on the fouled hull by the law of `friction_law`; z and growth as `lugre` takes them."""
    z_dot = 0.0
    spring = 0.0
    forgets = 0.0
    if p.friction_law == 0:
        mu, slope = stribeck(v_s, c.mu_s, c.mu_c, p.v_0, p.k_v, p.v_eps)
    elif p.friction_law == 1:
        mu, slope = stribeck_with_peak(v_s, c.mu_s, c.mu_c, p.v_0, p.k_v, p.v_eps)
    else:
        dry, z_dot, damping, spring, forgets = lugre(
            v_s, z, growth, p.mu_s, p.mu_c, p.v_0, p.sigma_0, p.sigma_1)
        mu = c.fouling * dry + p.k_v * v_s
        slope = c.fouling * damping + p.k_v
        spring = c.fouling * spring
    return Friction(mu, slope, z_dot, spring, forgets)


def growth_of_contact(Delta: float, Delta_dot: float) -> float:
    """(dF_n/dt)/F_n of Eq. 7 without damping where it is positive; 10 um of roughness bound it at first touch."""
    growth = 0.0
    if Delta_dot > 0.0:
        growth = 1.5 * Delta_dot / max(Delta, 1e-5)
    return growth
