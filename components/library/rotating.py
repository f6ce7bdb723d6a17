"""Friction of the water on rotating bodies, as coefficients of 1/2 rho (omega R)^2."""

from math import exp, log, sqrt


def cylinder_friction(Re: float, k_R: float) -> float:
    """C of the torque C 1/2 rho (omega R)^2 2 pi R^2 l on a cylinder of length l in water at rest; Re = omega R^2/nu.

    k_R: height of the roughness (sand) over R, 0 is smooth. Laminar below Re = 100 or so. Theodorsen and Regier (1944)
    for turbulence; their law holds the wall law with 5.5 shifted to 0, the rough one shifts Nikuradse's 8.5 by as much.
    """
    C = 4.0 / max(Re, 1e-9)  # Theodorsen and Regier 1944, laminar
    if Re > 60.0:
        x = 10.0
        for _ in range(16):
            x = -0.6 + 4.07 / log(10.0) * log(Re / x)  # Theodorsen and Regier 1944, x = 1/sqrt(C)
        C = max(C, 1.0 / (x * x))
        if k_R > 0.0:
            x = 2.12 - 4.07 / log(10.0) * log(min(k_R, 0.5))  # Nikuradse 1933
            C = max(C, 1.0 / (x * x))
    return C


def disc_friction(Re: float) -> float:
    """C of the torque C 1/2 rho (omega R)^2 R^3 on both sides of a disc in water at rest; Re = omega R^2/nu."""
    C = 0.0
    if Re > 0.0:
        C = max(3.87 / sqrt(Re), 0.146 * exp(-0.2 * log(Re)))  # von Karman 1921
    return C
