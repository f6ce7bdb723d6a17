"""Friction of a tip that slides on the hull."""

from math import exp, sqrt


def stribeck(v_s: float, mu_s: float, mu_c: float, v_0: float, k_v: float, v_eps: float) -> tuple[float, float]:
    """F_f/F_n of Eq. 9 with sgn(v) regularised as v/(v^4 + v_eps^4)^(1/4), and a bound on its slope."""
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
