"""Contact of a tip with the hull: normal force (Eq. 7) and friction (Eq. 9)."""

from math import exp, sqrt


def normal_force(
    Delta: float, Delta_dot: float, k_c: float, c_c: float, Delta_s: float,
) -> tuple[float, float, float]:
    """Normal force F_n >= 0, its elastic part and the contact damping (ramped c_c), for Delta > 0."""
    ramp = 1.0
    if Delta < Delta_s:
        u = Delta / Delta_s
        ramp = u * u * (3.0 - 2.0 * u)
    F_e = k_c * Delta * sqrt(Delta)
    F_n = max(0.0, F_e + c_c * ramp * Delta_dot)  # Eq. 7
    return F_n, F_e, c_c * ramp


def contact_energy(Delta: float, k_c: float) -> float:
    """Elastic energy of the contact, the integral of k_c Delta^1.5 (Eq. 7)."""
    energy = 0.0
    if Delta > 0.0:
        energy = 0.4 * k_c * Delta * Delta * sqrt(Delta)
    return energy


def friction_coefficient(
    v_s: float, mu_s: float, mu_c: float, v_0: float, k_v: float, v_eps: float,
) -> tuple[float, float]:
    """F_f/F_n of Eq. 9 with sgn(v) regularised as v/(v^4 + v_eps^4)^(1/4), and a bound on its slope [s/m]."""
    v4 = v_s * v_s * v_s * v_s
    e4 = v_eps * v_eps * v_eps * v_eps
    root = sqrt(sqrt(v4 + e4))
    u = v_s * v_s / (v_0 * v_0)
    peak = 0.0
    if u < 40.0:  # beyond, below rounding
        peak = (mu_s - mu_c) * exp(-u)
    mu = mu_c + peak + k_v * abs(v_s)
    slope = mu * e4 / (root * (v4 + e4)) + k_v + 2.0 * abs(peak) * abs(v_s) / (v_0 * v_0)
    return mu * v_s / root, slope  # Eq. 9
