"""Bending modes of a cantilever: shapes (Eq. 3), the table of their values, slope integrals and stiffness (Eq. 4)."""

from math import cos, cosh, exp, pi, sin, sinh, sqrt


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


def mode_slope(lam: float, xi: float) -> float:
    """L Y_r'(x) at xi = x/L from Eq. 3; e^x carries the exact 1 - sigma_r, so that nothing cancels at higher modes."""
    sigma = mode_sigma(lam)
    one_minus_sigma = (exp(-lam) + cos(lam) + sin(lam)) / (cosh(lam) + cos(lam))
    growing = 0.5 * one_minus_sigma * exp(lam * xi)
    decaying = 0.5 * (1.0 + sigma) * exp(-lam * xi)
    return lam * (growing - decaying + sin(lam * xi) + sigma * cos(lam * xi))


def mode_table(
    L: float, EI_zz: float, m: float, zeta: "float[:]", lambda_r: "float[:]", omega_r: "float[:]", modes: "float[:,:]",
) -> None:
    """Fill lambda_r, omega_r and modes for six modes, from the closed forms of Eq. 3 at root and tip."""
    sign = 1.0
    for r in range(6):
        lam = eigenvalue(r + 1)
        beta = lam / L
        sigma = mode_sigma(lam)
        lambda_r[r] = lam
        omega_r[r] = beta * beta * sqrt(EI_zz / m)  # below Eq. 4
        modes[0, r] = 2.0 * zeta[r] * omega_r[r]  # Eq. 4
        modes[1, r] = 2.0 * sign  # Y_r(L)
        modes[2, r] = 2.0 * sign * sigma * beta  # Y_r'(L)
        modes[3, r] = 2.0 * sigma / beta  # int Y_r dx
        modes[4, r] = 2.0 / (beta * beta)  # int x Y_r dx
        modes[5, r] = 2.0 * beta * beta  # Y_r''(0)
        modes[6, r] = -2.0 * sigma * beta * beta * beta  # Y_r'''(0)
        sign = -sign


def gauss_legendre(work: "float[:,:]") -> None:
    """Five points of -1 .. 1 in row 0 of work, their weights in row 1."""
    a = sqrt(10.0 / 7.0)
    b = sqrt(70.0)
    work[0, 0] = 0.0
    work[0, 1] = sqrt(5.0 - 2.0 * a) / 3.0
    work[0, 2] = -work[0, 1]
    work[0, 3] = sqrt(5.0 + 2.0 * a) / 3.0
    work[0, 4] = -work[0, 3]
    work[1, 0] = 128.0 / 225.0
    work[1, 1] = (322.0 + 13.0 * b) / 900.0
    work[1, 2] = work[1, 1]
    work[1, 3] = (322.0 - 13.0 * b) / 900.0
    work[1, 4] = work[1, 3]


def slope_integrals(
    L: float, r_A: float, rho: float, A: float, m: float, lambda_r: "float[:]", G: "float[:,:]", S: "float[:,:]",
    work: "float[:,:]",
) -> None:
    """G_rs = int Y_r' Y_s' dx and S_rs = int N Y_r' Y_s' dx/(m L omega_b^2), N the centrifugal tension; r_A: root."""
    for r in range(6):
        for s in range(6):
            G[r, s] = 0.0
            S[r, s] = 0.0
    gauss_legendre(work)
    for k in range(96):  # intervals; mode 6 is resolved to rounding
        for j in range(5):
            xi = (k + 0.5 + 0.5 * work[0, j]) / 96.0
            weight = 0.5 * work[1, j] / 96.0
            x = xi * L
            tension = r_A * (L - x) + 0.5 * (L * L - x * x)  # N(x) / (rho A omega_b^2)
            for r in range(6):
                work[2, r] = mode_slope(lambda_r[r], xi) / L
            for r in range(6):
                for s in range(6):
                    product = weight * L * work[2, r] * work[2, s]
                    G[r, s] = G[r, s] + product
                    S[r, s] = S[r, s] + product * tension * rho * A / (m * L)


def stiffness(
    speed_2: float, N_m: int, L: float, chi: float, offset: float, omega_r: "float[:]", modes: "float[:,:]",
    S: "float[:,:]", K: "float[:,:]",
) -> float:
    """Fill K at speed omega_b = sqrt(speed_2); returns a bound on the highest natural frequency [rad/s].

    chi: share of the bristle in the moving mass (the water's share feels no centrifugal force).
    """
    highest = 0.0
    for r in range(N_m):
        row = 0.0
        for s in range(N_m):
            K[r, s] = speed_2 * S[r, s]
            if r == s:
                K[r, s] = K[r, s] + omega_r[r] * omega_r[r] - speed_2 * chi  # in-plane softening
            row = row + abs(K[r, s])
        highest = max(highest, row)  # the largest row sum bounds every eigenvalue
        K[6, r] = -speed_2 * chi * offset * modes[3, r] / L
    return sqrt(highest)


def centrifugal_energy(
    N_m: int, L: float, modes: "float[:,:]", S: "float[:,:]", c: "float[:]", work: "float[:,:]",
) -> float:
    """Centrifugal potential of the deflection in row 0 of work, over omega_b^2."""
    energy = 0.0
    for r in range(N_m):
        energy = energy - c[3] * work[0, r] * (c[1] * modes[3, r] / L + 0.5 * work[0, r])
        for s in range(N_m):
            energy = energy + 0.5 * S[r, s] * work[0, r] * work[0, s]
    return c[2] * energy
