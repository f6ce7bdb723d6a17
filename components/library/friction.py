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


def stribeck_with_peak(
    v_s: float, mu_s: float, mu_c: float, v_0: float, k_v: float, v_eps: float,
) -> tuple[float, float]:
    """F_f/F_n of Eq. 9 that keeps mu_s, and its slope's size: up to mu_s at v_eps, from there on as Eq. 9 from 0.

    Value and slope are continuous; without k_v the largest value is mu_s, exactly.
    """
    speed = abs(v_s)
    if speed < v_eps:
        u = v_s / v_eps
        mu = mu_s * (0.5 * u * (3.0 - u * u))
        slope = 1.5 * mu_s * (1.0 - u * u) / v_eps
    else:
        w = (speed - v_eps) / v_0
        peak = 0.0
        if w * w < 40.0:  # beyond, below rounding
            peak = exp(-w * w)
        mu = mu_s - (mu_s - mu_c) * (1.0 - peak)  # Eq. 9
        slope = 2.0 * abs(mu_s - mu_c) * peak * w / v_0
        if v_s < 0.0:
            mu = -mu
    return mu + k_v * v_s, slope + k_v


def lugre(
    v_s: float, z: float, growth: float, mu_s: float, mu_c: float, v_0: float, sigma_0: float, sigma_1: float,
) -> tuple[float, float, float, float, float]:
    """Dry friction F_f/F_n of microscopic bristles that bend by z (Canudas de Wit et al. 1995).

    growth: (dF_n/dt)/F_n as far as it is positive. New contacts form unbent, and those that part lose what they hold:
    the store F_n sigma_0 z^2/2 never gains more than friction takes, whatever F_n does. sigma_1 falls with speed so
    that sigma_1 v_s stays below 4 g (Barahona and Canudas de Wit 2000), which keeps friction dissipative.

    Returns F_f/F_n, dz/dt, and bounds for the micro-step: on the damping d(F_f/F_n)/dv_s, on the stiffness that the
    tip feels, and on the rate at which z forgets.
    """
    speed = abs(v_s)
    u = v_s * v_s / (v_0 * v_0)
    peak = 0.0
    if u < 40.0:  # beyond, below rounding
        peak = (mu_s - mu_c) * exp(-u)
    g = max(mu_c + peak, 0.01)
    share = sigma_0 * abs(z) / g
    slip = v_s - sigma_0 * speed / g * z  # LuGre
    damping = 4.0 * g * sigma_1 / (4.0 * g + sigma_1 * speed)
    mu = sigma_0 * z + damping * slip  # LuGre
    gain = 1.0 + share * (1.0 + 2.0 * u * abs(peak) / g)
    forgets = sigma_0 * speed / g + growth
    return mu, slip - growth * z, 2.0 * damping * gain, sigma_0 * gain, forgets
