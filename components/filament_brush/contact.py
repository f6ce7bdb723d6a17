"""Contact of a tip with the hull: normal force (Eq. 7) and friction (Eq. 9)."""

from math import exp, sqrt

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
    """F_f/F_n with sgn(v) regularised as v/(v^4 + v_eps^4)^(1/4), and a bound on its slope."""
    v4 = v_s * v_s * v_s * v_s
    e4 = p.v_eps * p.v_eps * p.v_eps * p.v_eps
    root = sqrt(sqrt(v4 + e4))
    u = v_s * v_s / (p.v_0 * p.v_0)
    peak = 0.0
    if u < 40.0:  # beyond, below rounding
        peak = (c.mu_s - c.mu_c) * exp(-u)
    mu = c.mu_c + peak + p.k_v * abs(v_s)
    slope = mu * e4 / (root * (v4 + e4)) + p.k_v + 2.0 * abs(peak) * abs(v_s) / (p.v_0 * p.v_0)
    return Friction(mu * v_s / root, slope)  # Eq. 9
