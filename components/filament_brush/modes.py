"""Bending modes of a cantilever: shapes (Eq. 3), their numbers, slope integrals and stiffness (Eq. 4)."""

from math import cos, cosh, exp, pi, sin, sinh, sqrt

from ..declare.record import Matrix
from ..library.quadrature import gauss_legendre
from .parameters import Parameters
from .records import Constants, Modes, Scratch, Stage, State, Stiffness


def eigenvalue(r: int) -> float:
    """Root lambda_r of cos(x) cosh(x) = -1 (below Eq. 3), r = 1, 2, ..., by Newton on cos(x) + 1/cosh(x) = 0."""
    x = (r - 0.5) * pi
    for _ in range(12):
        c = cosh(x)
        x = x + (cos(x) + 1.0 / c) / (sin(x) + sinh(x) / (c * c))
    return x


def mode_sigma(lam: float) -> float:
    """sigma_r (below Eq. 3)."""
    return (sinh(lam) - sin(lam)) / (cosh(lam) + cos(lam))


def mode_shape(lam: float, xi: float) -> float:
    """Y_r(x) at xi = x/L from Eq. 3; e^x carries the exact 1 - sigma_r, as below."""
    sigma = mode_sigma(lam)
    one_minus_sigma = (exp(-lam) + cos(lam) + sin(lam)) / (cosh(lam) + cos(lam))
    growing = 0.5 * one_minus_sigma * exp(lam * xi)
    decaying = 0.5 * (1.0 + sigma) * exp(-lam * xi)
    return growing + decaying - cos(lam * xi) + sigma * sin(lam * xi)  # Eq. 3


def mode_slope(lam: float, xi: float) -> float:
    """L Y_r'(x) at xi = x/L from Eq. 3; e^x carries the exact 1 - sigma_r, so that nothing cancels at higher modes."""
    sigma = mode_sigma(lam)
    one_minus_sigma = (exp(-lam) + cos(lam) + sin(lam)) / (cosh(lam) + cos(lam))
    growing = 0.5 * one_minus_sigma * exp(lam * xi)
    decaying = 0.5 * (1.0 + sigma) * exp(-lam * xi)
    return lam * (growing - decaying + sin(lam * xi) + sigma * cos(lam * xi))  # Eq. 3


def mode_table(EI_zz: float, mass: float, p: Parameters, m: Modes) -> None:
    """Numbers of six modes, from the closed forms of Eq. 3 at root and tip; EI_zz and mass per length of a bristle."""
    sign = 1.0
    for r in range(6):
        lam = eigenvalue(r + 1)
        beta = lam / p.L
        sigma = mode_sigma(lam)
        m.lambda_r[r] = lam
        m.omega_r[r] = beta * beta * sqrt(EI_zz / mass)  # below Eq. 4
        m.damping[r] = 2.0 * p.zeta[r] * m.omega_r[r]  # Eq. 4
        m.Y_L[r] = 2.0 * sign
        m.slope_L[r] = 2.0 * sign * sigma * beta
        m.int_Y[r] = 2.0 * sigma / beta
        m.int_xY[r] = 2.0 / (beta * beta)
        m.curvature_0[r] = 2.0 * beta * beta
        m.shear_0[r] = -2.0 * sigma * beta * beta * beta
        sign = -sign


def slope_integrals(r_A: float, A: float, mass: float, p: Parameters, x: State, s: Scratch) -> None:
    """G_rs = int Y_r' Y_s' dx and S_rs = int N Y_r' Y_s' dx/(m L omega_b^2), N the centrifugal tension, at length L.

    r_A: radius of the root; A: section of a bristle; mass: what moves with it, per length.
    """
    for r in range(6):
        for q in range(6):
            x.G_nominal[r, q] = 0.0
            x.S_nominal[r, q] = 0.0
            x.S_root[r, q] = 0.0
    gauss_legendre(s.nodes, s.weights)
    for k in range(96):  # intervals; mode 6 is resolved to rounding
        for j in range(5):
            xi = (k + 0.5 + 0.5 * s.nodes[j]) / 96.0
            weight = 0.5 * s.weights[j] / 96.0
            at = xi * p.L
            tension = r_A * (p.L - at) + 0.5 * (p.L * p.L - at * at)  # N(x) / (rho A omega_b^2)
            slopes_at(xi, x.nominal, p, s)
            for r in range(6):
                for q in range(6):
                    product = weight * p.L * s.slopes[r] * s.slopes[q]
                    x.G_nominal[r, q] = x.G_nominal[r, q] + product
                    x.S_nominal[r, q] = x.S_nominal[r, q] + product * tension * p.rho * A / (mass * p.L)
                    x.S_root[r, q] = x.S_root[r, q] + product * r_A * (p.L - at) * p.rho * A / (mass * p.L)


def slopes_at(xi: float, m: Modes, p: Parameters, s: Scratch) -> None:
    """Y_r' of six modes at xi = x/L."""
    for r in range(6):
        s.slopes[r] = mode_slope(m.lambda_r[r], xi) / p.L


def stiffness(offset: float, k: Stiffness, p: Parameters, c: Constants, m: Modes, S: Matrix) -> float:
    """Fill k at the speed of c; returns a bound on the highest natural frequency [rad/s].

    offset: distance of the filament's axis from the brush axis. c.chi: share of the bristle in the moving mass (the
    water's share feels no centrifugal force).
    """
    highest = 0.0
    for r in range(p.N_m):
        row = 0.0
        for s in range(p.N_m):
            K_rs = c.speed_2 * S[r, s]
            if r == s:
                K_rs = K_rs + m.omega_r[r] * m.omega_r[r] - c.speed_2 * c.chi  # in-plane softening
            k.K[r, s] = K_rs
            row = row + abs(K_rs)
        highest = max(highest, row)  # the largest row sum bounds every eigenvalue
        k.load[r] = -c.speed_2 * c.chi * offset * m.int_Y[r] / c.L
    return sqrt(highest)


def centrifugal_energy(f: Stage, p: Parameters, c: Constants, m: Modes, S: Matrix) -> float:
    """Centrifugal potential of a deflection, over omega_b^2."""
    energy = 0.0
    for r in range(p.N_m):
        energy = energy - c.chi * f.eta[r] * (c.x_t * m.int_Y[r] / c.L + 0.5 * f.eta[r])
        for s in range(p.N_m):
            energy = energy + 0.5 * S[r, s] * f.eta[r] * f.eta[s]
    return c.M * energy


def deflection(f: Stage, p: Parameters, m: Modes) -> float:
    """Deflection y of the tip."""
    y = 0.0
    for r in range(p.N_m):
        y = y + m.Y_L[r] * f.eta[r]  # Eq. 2
    return y


def deflection_ratio(f: Stage, p: Parameters, c: Constants, m: Modes) -> float:
    """|y| of the tip over the length."""
    return abs(deflection(f, p, m)) / c.L
