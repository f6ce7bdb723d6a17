"""Filament brush: modal filaments with contact and friction (Eqs. 1-13) and their sum over the brush (Eqs. 14-15).

Frames and symbols are those of README.md. Tables filled by `setup`, column r - 1 for mode r:
  modes[q, r]: q = 0 2 zeta_r omega_r, 1 Y_r(L), 2 Y_r'(L), 3 int Y_r dx, 4 int x Y_r dx, 5 Y_r''(0), 6 Y_r'''(0)
  G[r, s] = int Y_r' Y_s' dx;  S[r, s] = centrifugal stiffness over omega_b^2 and the modal mass
State: eta, eta_dot [n, N_m], the next micro-step h_next [n], and total: 0 theta_b, 1 J_x, 2 J_z, 3 J_T, 4 W_hub,
  5 W_hull, 6 W_damping, 7 W_friction, 8 W_contact; at the end of the last step 9 E_contact, 10 E_centrifugal over
  omega_b^2, 11 omega_b^2; largest |y|/L 12 in the last step and 13 since the start;
  14 number and 15 shortest of the micro-steps
Scratch: K[r, s] stiffness and K[6, r] load per modal mass; c the constants of a step (see `constants`); P, Q, A the
  map of free flight and its making; filament [n, 4]: phi, F_n, F_f, tip deflection; work rows 0 eta, 1 eta_dot, 2 and
  3 the same at a Runge-Kutta stage, 4..8 accelerations of stages 1..5, 9 G eta, 10..14 the stages' F_f, F_n, moment
  about the brush axis and powers of friction, contact loss and damping
"""

from math import cos, cosh, exp, floor, pi, sin, sinh, sqrt


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


def hub_radius(R_brush: float, L: float, alpha: float) -> float:
    """R_h for which the undeformed tip lies on R_brush."""
    return sqrt(R_brush * R_brush - L * L * sin(alpha) * sin(alpha)) - L * cos(alpha)


def setup(
    L: float, d: float, E: float, rho: float, rho_w: float, C_a: float, R_brush: float, alpha: float,
    zeta: 'float[:]', lambda_r: 'float[:]', omega_r: 'float[:]', modes: 'float[:,:]', G: 'float[:,:]', S: 'float[:,:]',
    work: 'float[:,:]',
):
    """Fill lambda_r, omega_r, modes, G and S for six modes."""
    A = 0.25 * pi * d * d
    EI_zz = E * pi * d * d * d * d / 64.0
    m = (rho + C_a * rho_w) * A
    r_A = hub_radius(R_brush, L, alpha) * cos(alpha)
    sign = 1.0
    for r in range(6):
        lam = eigenvalue(r + 1)
        beta = lam / L
        sigma = mode_sigma(lam)
        lambda_r[r] = lam
        omega_r[r] = beta * beta * sqrt(EI_zz / m)  # below Eq. 4
        modes[0, r] = 2.0 * zeta[r] * omega_r[r]
        modes[1, r] = 2.0 * sign
        modes[2, r] = 2.0 * sign * sigma * beta
        modes[3, r] = 2.0 * sigma / beta
        modes[4, r] = 2.0 / (beta * beta)
        modes[5, r] = 2.0 * beta * beta
        modes[6, r] = -2.0 * sigma * beta * beta * beta
        sign = -sign
        for s in range(6):
            G[r, s] = 0.0
            S[r, s] = 0.0
    # Gauss-Legendre with five points on each of 96 intervals
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
    for k in range(96):
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
    speed_2: float, N_m: int, L: float, chi: float, offset: float, omega_r: 'float[:]', modes: 'float[:,:]',
    S: 'float[:,:]', K: 'float[:,:]',
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
        highest = max(highest, row)
        K[6, r] = -speed_2 * chi * offset * modes[3, r] / L
    return sqrt(highest)


def normal_force(
    Delta: float, Delta_dot: float, k_c: float, c_c: float, Delta_s: float,
) -> 'tuple[float, float, float]':
    """Normal force F_n >= 0, its elastic part and the contact damping s c_c, for Delta > 0 (Eq. 7)."""
    ramp = 1.0
    if Delta < Delta_s:
        u = Delta / Delta_s
        ramp = u * u * (3.0 - 2.0 * u)
    F_e = k_c * Delta * sqrt(Delta)
    F_n = max(0.0, F_e + c_c * ramp * Delta_dot)  # Eq. 7
    return F_n, F_e, c_c * ramp


def friction_coefficient(
    v_s: float, mu_s: float, mu_c: float, v_0: float, k_v: float, v_eps: float,
) -> 'tuple[float, float]':
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
    return mu * v_s / root, slope


def constants(
    omega_b: float, delta_dot: float, v_rov: float, friction_scale: float, L: float, d: float, rho: float,
    rho_w: float, C_a: float, N_m: int, bristles_per_filament: float, R_brush: float, alpha: float, k_c: float,
    c_c: float, Delta_s: float, mu_s: float, mu_c: float, v_0: float, k_v: float, v_eps: float, centrifugal: bool,
    omega_r: 'float[:]', modes: 'float[:,:]', S: 'float[:,:]', K: 'float[:,:]', c: 'float[:]',
):
    """Fill K and c at the present inputs."""
    R_h = hub_radius(R_brush, L, alpha)
    chi = rho / (rho + C_a * rho_w)
    speed_2 = 0.0
    if centrifugal:
        speed_2 = omega_b * omega_b
    c[0] = R_h * cos(alpha) + L  # straight tip along e_a
    c[1] = -R_h * sin(alpha)  # straight tip along e_t
    c[2] = bristles_per_filament * rho * 0.25 * pi * d * d / chi * L  # modal mass M_r of a bundle
    c[3] = chi  # share of the bristle in it
    c[4] = speed_2  # omega_b^2 as far as it acts on the filaments
    c[5] = stiffness(speed_2, N_m, L, chi, R_h * sin(alpha), omega_r, modes, S, K)
    c[6] = omega_b
    c[7] = delta_dot
    c[8] = v_rov
    c[9] = k_c
    c[10] = c_c
    c[11] = Delta_s
    c[12] = friction_scale * mu_s
    c[13] = friction_scale * mu_c
    c[14] = v_0
    c[15] = k_v
    c[16] = v_eps


def free_acceleration(
    p: int, v: int, a: int, N_m: int, modes: 'float[:,:]', K: 'float[:,:]', work: 'float[:,:]',
):
    """Row a of work = eta'' without tip force (Eq. 4) at eta, eta_dot in rows p, v."""
    for r in range(N_m):
        acceleration = K[6, r] - modes[0, r] * work[v, r]  # Eq. 4
        for s in range(N_m):
            acceleration = acceleration - K[r, s] * work[p, s]
        work[a, r] = acceleration


def tip_force(
    p: int, v: int, a: int, N_m: int, sin_psi: float, cos_psi: float, h_plane: float, foreshortening: bool,
    modes: 'float[:,:]', G: 'float[:,:]', c: 'float[:]', work: 'float[:,:]',
) -> 'tuple[float, float]':
    """Add the tip force to eta'' in row a; row a + 6 = forces and powers at eta, eta_dot in rows p, v.

    Returns Delta (a bound from above while out of reach) and the rate lambda [1/s] that limits the micro-step.
    """
    M = c[2]
    omega_b = c[6]
    F_n = 0.0
    F_f = 0.0
    moment = 0.0
    P_friction = 0.0
    P_contact = 0.0
    P_damping = 0.0
    rate = c[5]
    y = 0.0
    y_dot = 0.0
    for r in range(N_m):
        y = y + modes[1, r] * work[p, r]  # Eq. 2 at x = L
        y_dot = y_dot + modes[1, r] * work[v, r]
        P_damping = P_damping + M * modes[0, r] * work[v, r] * work[v, r]
        work[9, r] = 0.0
    Delta = c[0] * cos_psi + (c[1] + y) * sin_psi - h_plane
    if Delta > 0.0 or cos_psi < 0.0:
        shortening = 0.0
        shortening_dot = 0.0
        mobility = 0.0
        for r in range(N_m):
            g = 0.0
            if foreshortening:
                for s in range(N_m):
                    g = g + G[r, s] * work[p, s]
            shortening = shortening + 0.5 * g * work[p, r]
            shortening_dot = shortening_dot + g * work[v, r]
            work[9, r] = g
            mobility = mobility + (modes[1, r] * modes[1, r] + g * g) / M
        x = (c[0] - shortening) * sin_psi - (c[1] + y) * cos_psi
        z = (c[0] - shortening) * cos_psi + (c[1] + y) * sin_psi
        Delta = z - h_plane  # Eq. 8
        if Delta > 0.0:
            Delta_dot = c[7] - omega_b * x - shortening_dot * cos_psi + y_dot * sin_psi
            v_s = omega_b * z - c[8] - shortening_dot * sin_psi - y_dot * cos_psi  # Eq. 10
            F_n, F_e, damping = normal_force(Delta, Delta_dot, c[9], c[10], c[11])
            mu, slope = friction_coefficient(v_s, c[12], c[13], c[14], c[15], c[16])
            F_f = mu * F_n  # Eq. 9
            F_a = -F_f * sin_psi - F_n * cos_psi
            F_t = F_f * cos_psi - F_n * sin_psi
            for r in range(N_m):
                work[a, r] = work[a, r] + (F_t * modes[1, r] - F_a * work[9, r]) / M  # Eqs. 5, 6 by virtual work
            moment = x * F_n - z * F_f
            P_friction = F_f * v_s
            P_contact = (F_n - F_e) * Delta_dot
            rise = 1.5 * c[9] * sqrt(Delta) * (1.0 + abs(mu))
            fall = slope * F_n + damping * (1.0 + abs(mu))
            rate = sqrt(rate * rate + rise * mobility) + fall * mobility
    work[a + 6, 0] = F_f
    work[a + 6, 1] = F_n
    work[a + 6, 2] = moment
    work[a + 6, 3] = P_friction
    work[a + 6, 4] = P_contact
    work[a + 6, 5] = P_damping
    return Delta, rate


def multiply(size: int, A: 'float[:,:]', B: 'float[:,:]', C: 'float[:,:]'):
    """C = A B for the leading square blocks."""
    for i in range(size):
        for j in range(size):
            total = 0.0
            for k in range(size):
                total = total + A[i, k] * B[k, j]
            C[i, j] = total


def free_flight(
    h: float, N_m: int, omega_max: float, modes: 'float[:,:]', K: 'float[:,:]', P: 'float[:,:]', Q: 'float[:,:]',
    A: 'float[:,:]',
):
    """Fill P with the map of (eta, eta_dot, 1) over h without contact: Runge-Kutta in 2^k equal micro-steps.

    All free filaments obey the same linear equations, for which the classical Runge-Kutta step is the polynomial
    1 + hA + .. + (hA)^4/24; k squarings of it give the whole step. omega_max times the micro-step is at most 0.2.
    """
    size = 2 * N_m + 1
    h_s = h
    k = 0
    while h_s * omega_max > 0.2 and k < 60:
        h_s = 0.5 * h_s
        k = k + 1
    for i in range(size):
        for j in range(size):
            A[i, j] = 0.0
            P[i, j] = 0.0
        P[i, i] = 1.0
    for r in range(N_m):
        A[r, N_m + r] = h_s
        A[N_m + r, N_m + r] = -h_s * modes[0, r]
        A[N_m + r, 2 * N_m] = h_s * K[6, r]
        for s in range(N_m):
            A[N_m + r, s] = -h_s * K[r, s]
    for order in range(4):
        multiply(size, A, P, Q)
        for i in range(size):
            for j in range(size):
                P[i, j] = Q[i, j] / (4.0 - order)
            P[i, i] = P[i, i] + 1.0
    for _ in range(k):
        multiply(size, P, P, Q)
        for i in range(size):
            for j in range(size):
                P[i, j] = Q[i, j]


def relative_energy(N_m: int, K: 'float[:,:]', work: 'float[:,:]') -> float:
    """Kinetic, strain and centrifugal energy per modal mass of eta, eta_dot in rows 0, 1 of work."""
    energy = 0.0
    for r in range(N_m):
        pull = -K[6, r]
        for s in range(N_m):
            pull = pull + 0.5 * K[r, s] * work[0, s]
        energy = energy + 0.5 * work[1, r] * work[1, r] + pull * work[0, r]
    return energy


def advance_free(N_m: int, M: float, K: 'float[:,:]', P: 'float[:,:]', work: 'float[:,:]', total: 'float[:]'):
    """Map rows 0, 1 of work over the communication step; all energy lost goes into damping."""
    before = relative_energy(N_m, K, work)
    for r in range(N_m):
        work[2, r] = P[r, 2 * N_m]
        work[3, r] = P[N_m + r, 2 * N_m]
        for s in range(N_m):
            work[2, r] = work[2, r] + P[r, s] * work[0, s] + P[r, N_m + s] * work[1, s]
            work[3, r] = work[3, r] + P[N_m + r, s] * work[0, s] + P[N_m + r, N_m + s] * work[1, s]
    for r in range(N_m):
        work[0, r] = work[2, r]
        work[1, r] = work[3, r]
    total[6] = total[6] + M * (before - relative_energy(N_m, K, work))


def tip_speed_bound(N_m: int, K: 'float[:,:]', work: 'float[:,:]') -> float:
    """Bound on the tip speed of free vibration, rows 0, 1 of work: all energy kinetic, modes in phase, times 1.5."""
    speed = 0.0
    for r in range(N_m):
        speed = speed + 3.0 * sqrt(work[1, r] * work[1, r] + K[r, r] * work[0, r] * work[0, r])
    return speed


def advance_touching(
    psi: float, h: float, h_goal: float, rate: float, Delta: float, h_plane: float, N_m: int, L: float,
    foreshortening: bool, h_min: float, h_max: float, tolerance: float, omega_r: 'float[:]', modes: 'float[:,:]',
    G: 'float[:,:]', K: 'float[:,:]', c: 'float[:]', work: 'float[:,:]', total: 'float[:]',
) -> 'tuple[float, float]':
    """Advance rows 0, 1 of work over h by classical Runge-Kutta in error-controlled micro-steps of this filament.

    h_goal: first micro-step to try; psi, h_plane: axis angle and hull distance at the start, where stage 1 is known.
    The error estimate is the difference to the third-order companion that takes k5, the rate at the end of the step,
    for k4. Impulses and losses are integrated with the same stages. Returns h_goal and Delta at the end.
    """
    v_tolerance = tolerance * omega_r[0] * L
    tau = 0.0
    sin_psi = 0.0
    cos_psi = 0.0
    rate_end = 0.0
    running = True
    while running:
        left = h - tau
        h_s = max(min(h_goal, 2.7 / rate), 1e-9)
        if h_s >= left * (1.0 - 1e-9):
            h_s = left
        elif 2.0 * h_s > left:
            h_s = 0.5 * left
        for r in range(N_m):
            work[3, r] = work[1, r]
        for k in range(5, 8):
            c_h = 0.5 * h_s
            if k == 7:
                c_h = h_s
            if k != 6:
                sin_psi = sin(psi + c[6] * (tau + c_h))
                cos_psi = cos(psi + c[6] * (tau + c_h))
            for r in range(N_m):
                work[2, r] = work[0, r] + c_h * work[3, r]
                work[3, r] = work[1, r] + c_h * work[k - 1, r]
            free_acceleration(2, 3, k, N_m, modes, K, work)
            Delta, rate_end = tip_force(
                2, 3, k, N_m, sin_psi, cos_psi, h_plane - c[7] * (tau + c_h), foreshortening, modes, G, c, work)
        w = h_s / 6.0
        error = 0.0
        for r in range(N_m):
            v_4 = work[3, r]
            work[2, r] = work[0, r] + h_s * (work[1, r] + w * (work[4, r] + work[5, r] + work[6, r]))
            work[3, r] = work[1, r] + w * (work[4, r] + 2.0 * (work[5, r] + work[6, r]) + work[7, r])
            e = omega_r[r] * w * (work[3, r] - v_4)
            error = error + e * e
        free_acceleration(2, 3, 8, N_m, modes, K, work)
        Delta, rate_end = tip_force(
            2, 3, 8, N_m, sin_psi, cos_psi, h_plane - c[7] * (tau + h_s), foreshortening, modes, G, c, work)
        for r in range(N_m):
            e = w * (work[8, r] - work[7, r])
            error = error + e * e
        error = sqrt(error) / v_tolerance
        h_new = 2.0 * h_s
        if error > 0.04:
            h_new = h_s * max(0.9 / sqrt(sqrt(error)), 0.2)
        if h_new < h_min:
            h_new = min(h_min, 1.7 * h_new)  # below h_min for ten times the tolerance
        if h_s * rate_end > 4.0 and h_s > 1e-9:  # contact or sticking began: the step is outside the stability limit
            h_goal = max(2.0 / rate_end, 0.25 * h_s)
        elif (error > 1.0 and h_s > 1.000001 * h_min) or (error > 10.0 and h_s > 1e-9):
            h_goal = h_new
        else:
            if h_s < left:
                total[15] = min(total[15], h_s)
            total[14] = total[14] + 1.0
            if h_new < h_s or h_new > h_goal:
                h_goal = h_new
            h_goal = min(h_goal, h_max)
            total[1] = total[1] - w * (work[10, 0] + 2.0 * (work[11, 0] + work[12, 0]) + work[13, 0])
            total[2] = total[2] - w * (work[10, 1] + 2.0 * (work[11, 1] + work[12, 1]) + work[13, 1])
            total[3] = total[3] + w * (work[10, 2] + 2.0 * (work[11, 2] + work[12, 2]) + work[13, 2])
            total[6] = total[6] + w * (work[10, 5] + 2.0 * (work[11, 5] + work[12, 5]) + work[13, 5])
            total[7] = total[7] + w * (work[10, 3] + 2.0 * (work[11, 3] + work[12, 3]) + work[13, 3])
            total[8] = total[8] + w * (work[10, 4] + 2.0 * (work[11, 4] + work[12, 4]) + work[13, 4])
            y = 0.0
            for r in range(N_m):
                work[0, r] = work[2, r]
                work[1, r] = work[3, r]
                work[4, r] = work[8, r]
                y = y + modes[1, r] * work[0, r]
            for q in range(6):
                work[10, q] = work[14, q]
            rate = rate_end
            total[12] = max(total[12], abs(y) / L)
            running = h_s < left
            tau = tau + h_s
    return h_goal, Delta


def contact_energy(Delta: float, k_c: float) -> float:
    """Elastic energy of the contact, the integral of k_c Delta^1.5 (Eq. 7)."""
    energy = 0.0
    if Delta > 0.0:
        energy = 0.4 * k_c * Delta * Delta * sqrt(Delta)
    return energy


def centrifugal_energy(
    N_m: int, L: float, modes: 'float[:,:]', S: 'float[:,:]', c: 'float[:]', work: 'float[:,:]',
) -> float:
    """Centrifugal potential of the deflection in row 0 of work, over omega_b^2."""
    energy = 0.0
    for r in range(N_m):
        energy = energy - c[3] * work[0, r] * (c[1] * modes[3, r] / L + 0.5 * work[0, r])
        for s in range(N_m):
            energy = energy + 0.5 * S[r, s] * work[0, r] * work[0, s]
    return c[2] * energy


def base_reactions(
    F_a: float, F_t: float, shortening: float, q: float, r_A: float, offset: float, mode_acceleration: bool, N_m: int,
    L: float, EI: float, m: float, omega_r: 'float[:]', modes: 'float[:,:]', work: 'float[:,:]',
) -> 'tuple[float, float, float]':
    """Base shear (Eq. 11), base moment (Eq. 12) and tip deflection from eta, eta_dot, eta'' in rows 0, 1, 4 of work.

    The plain sum is what the paper prints. Mode acceleration sums over modes only what inertia and damping give and
    takes the loads as they are, so that it is exact in statics: (F_a, F_t) at the tip and, along the filament, the
    centrifugal load q (r_A + x, y - offset).
    """
    shear = 0.0
    moment = 0.0
    y = 0.0
    for r in range(N_m):
        shear = shear + EI * modes[6, r] * work[0, r]  # Eq. 11
        moment = moment + EI * modes[5, r] * work[0, r]  # Eq. 12
        y = y + modes[1, r] * work[0, r]  # Eq. 2
    if mode_acceleration:
        shear = -F_t + q * L * offset
        moment = F_t * (L - shortening) - q * 0.5 * L * L * offset
        if shortening > 0.0:
            moment = moment - F_a * y
        for r in range(N_m):
            inertia = m * (work[4, r] + modes[0, r] * work[1, r])
            shear = shear + (inertia - q * work[0, r]) * modes[3, r]
            moment = moment - inertia * modes[4, r] - q * r_A * modes[3, r] * work[0, r]
        if F_t != 0.0:
            y = y + F_t * L * L * L / (3.0 * EI)
            for r in range(N_m):
                y = y - F_t * modes[1, r] * modes[1, r] / (m * L * omega_r[r] * omega_r[r])
    return shear, moment, y


def outputs(
    omega_b: float, delta: float, delta_dot: float, v_rov: float, friction_scale: float, L: float, d: float, E: float,
    rho: float, rho_w: float, C_a: float, N_m: int, n: int, bristles_per_filament: float, R_brush: float,
    alpha: float, k_c: float, c_c: float, Delta_s: float, mu_s: float, mu_c: float, v_0: float, k_v: float,
    v_eps: float, foreshortening: bool, centrifugal: bool, mode_acceleration: bool, lambda_r: 'float[:]',
    omega_r: 'float[:]', modes: 'float[:,:]', G: 'float[:,:]', S: 'float[:,:]', K: 'float[:,:]', c: 'float[:]',
    work: 'float[:,:]', eta: 'float[:,:]', eta_dot: 'float[:,:]', total: 'float[:]', filament: 'float[:,:]',
    kinetic_fraction: 'float[:]', y: 'float[:]',
):
    """Write y and the table `filament` from the state and the inputs."""
    constants(
        omega_b, delta_dot, v_rov, friction_scale, L, d, rho, rho_w, C_a, N_m, bristles_per_filament, R_brush, alpha,
        k_c, c_c, Delta_s, mu_s, mu_c, v_0, k_v, v_eps, centrifugal, omega_r, modes, S, K, c)
    R_h = hub_radius(R_brush, L, alpha)
    M = c[2]
    EI = bristles_per_filament * E * pi * d * d * d * d / 64.0
    sin_alpha = sin(alpha)
    cos_alpha = cos(alpha)
    F_x = 0.0
    F_z = 0.0
    T_brush = 0.0
    contact_count = 0.0
    F_y_eq11 = 0.0
    M_b_eq12 = 0.0
    F_z_eq13 = 0.0
    T_brush_eq15 = 0.0
    P_damping = 0.0
    P_friction = 0.0
    P_contact = 0.0
    E_kinetic = 0.0
    E_strain = 0.0
    E_contact = 0.0
    for r in range(6):
        kinetic_fraction[r] = 0.0
    for i in range(n):
        phi = total[0] + 2.0 * pi * i / n
        psi = phi - alpha
        sin_psi = sin(psi)
        cos_psi = cos(psi)
        for r in range(N_m):
            work[0, r] = eta[i, r]
            work[1, r] = eta_dot[i, r]
        free_acceleration(0, 1, 4, N_m, modes, K, work)
        Delta, _ = tip_force(
            0, 1, 4, N_m, sin_psi, cos_psi, R_brush - delta, foreshortening, modes, G, c, work)
        F_f = work[10, 0]
        F_n = work[10, 1]
        F_x = F_x - F_f
        F_z = F_z - F_n
        T_brush = T_brush + work[10, 2]
        P_friction = P_friction + work[10, 3]
        P_contact = P_contact + work[10, 4]
        P_damping = P_damping + work[10, 5]
        if F_n > 0.0:
            contact_count = contact_count + 1.0
        E_contact = E_contact + contact_energy(Delta, k_c)
        slope = 0.0
        shortening = 0.0
        for r in range(N_m):
            kinetic = 0.5 * M * work[1, r] * work[1, r]
            kinetic_fraction[r] = kinetic_fraction[r] + kinetic
            E_kinetic = E_kinetic + kinetic
            E_strain = E_strain + 0.5 * M * omega_r[r] * omega_r[r] * work[0, r] * work[0, r]
            slope = slope + modes[2, r] * work[0, r]
            shortening = shortening + 0.5 * work[9, r] * work[0, r]
        shear, moment, y_tip = base_reactions(
            -F_f * sin_psi - F_n * cos_psi, F_f * cos_psi - F_n * sin_psi, shortening, M * c[3] * c[4] / L, c[0] - L,
            -c[1], mode_acceleration, N_m, L, EI, M / L, omega_r, modes, work)
        F_y_eq11 = F_y_eq11 + shear
        M_b_eq12 = M_b_eq12 + moment
        F_z_eq13 = F_z_eq13 + F_n * slope - F_f  # Eq. 13
        T_brush_eq15 = T_brush_eq15 + R_brush * shear * (cos_psi * cos_alpha - sin_psi * sin_alpha)  # Eq. 15
        filament[i, 0] = phi - 2.0 * pi * floor((phi + pi) / (2.0 * pi))
        filament[i, 1] = F_n
        filament[i, 2] = F_f
        filament[i, 3] = y_tip
    theta_b = total[0]
    J_x = total[1]
    J_z = total[2]
    J_T = total[3]
    W_hub = total[4]
    W_hull = total[5]
    W_damping = total[6]
    W_friction = total[7]
    W_contact = total[8]
    E_centrifugal = c[4] * total[10]
    # inputs that jump do work at once; it is booked when the next step begins
    jump = E_contact - total[9] + E_centrifugal - total[10] * total[11]
    supplied = W_hub + W_hull + jump - W_damping - W_friction - W_contact
    energy_residual = E_kinetic + E_strain + E_centrifugal + E_contact - supplied
    P_hub = -omega_b * T_brush
    P_hull = F_x * v_rov - F_z * delta_dot
    deflection_ratio = total[12]
    deflection_ratio_max = total[13]
    micro_steps = total[14]
    h_micro_min = total[15]
    J_filaments = n * M * c[3] * (R_h * R_h + R_h * cos(alpha) * L + L * L / 3.0)
    for r in range(6):
        kinetic_fraction[r] = kinetic_fraction[r] / max(E_kinetic, 1e-30)

    y[0] = F_x
    y[1] = F_z
    y[2] = T_brush
    y[3] = contact_count
    y[4] = deflection_ratio
    y[5] = deflection_ratio_max
    y[6] = theta_b
    y[7] = J_x
    y[8] = J_z
    y[9] = J_T
    y[10] = F_y_eq11
    y[11] = M_b_eq12
    y[12] = F_z_eq13
    y[13] = T_brush_eq15
    y[14] = P_hub
    y[15] = P_hull
    y[16] = P_damping
    y[17] = P_friction
    y[18] = P_contact
    y[19] = E_kinetic
    y[20] = E_strain
    y[21] = E_centrifugal
    y[22] = E_contact
    y[23] = W_hub
    y[24] = W_hull
    y[25] = W_damping
    y[26] = W_friction
    y[27] = W_contact
    y[28] = energy_residual
    y[29] = micro_steps
    y[30] = h_micro_min
    for r in range(6):
        y[31 + r] = kinetic_fraction[r]
    for r in range(6):
        y[37 + r] = lambda_r[r]
    for r in range(6):
        y[43 + r] = omega_r[r]
    y[49] = R_h
    y[50] = J_filaments


def initialize(
    n: int, N_m: int, theta_b_0: float, h_min: float, h_max: float, eta: 'float[:,:]', eta_dot: 'float[:,:]',
    h_next: 'float[:]', total: 'float[:]',
):
    """Straight filaments at rest in the turning brush. Energy counts from here; what is pressed in is hull work."""
    for k in range(15):
        total[k] = 0.0
    total[0] = theta_b_0
    total[15] = h_max
    for i in range(n):
        h_next[i] = h_min
        for r in range(N_m):
            eta[i, r] = 0.0
            eta_dot[i, r] = 0.0


def step(
    h: float, omega_b: float, delta: float, delta_dot: float, v_rov: float, friction_scale: float, L: float, d: float,
    E: float, rho: float, rho_w: float, C_a: float, N_m: int, n: int, bristles_per_filament: float, R_brush: float,
    alpha: float, k_c: float, c_c: float, Delta_s: float, mu_s: float, mu_c: float, v_0: float, k_v: float,
    v_eps: float, foreshortening: bool, centrifugal: bool, mode_acceleration: bool, h_min: float, h_max: float,
    tolerance: float, lambda_r: 'float[:]', omega_r: 'float[:]', modes: 'float[:,:]', G: 'float[:,:]',
    S: 'float[:,:]', K: 'float[:,:]', P: 'float[:,:]', Q: 'float[:,:]', A: 'float[:,:]', c: 'float[:]',
    work: 'float[:,:]', eta: 'float[:,:]', eta_dot: 'float[:,:]', h_next: 'float[:]', total: 'float[:]',
    filament: 'float[:,:]', kinetic_fraction: 'float[:]', y: 'float[:]',
):
    """Advance the brush by h at constant omega_b, v_rov and delta_dot; delta goes on from its value at the start."""
    constants(
        omega_b, delta_dot, v_rov, friction_scale, L, d, rho, rho_w, C_a, N_m, bristles_per_filament, R_brush, alpha,
        k_c, c_c, Delta_s, mu_s, mu_c, v_0, k_v, v_eps, centrifugal, omega_r, modes, S, K, c)
    free_flight(h, N_m, c[5], modes, K, P, Q, A)
    J_x = total[1]
    J_z = total[2]
    J_T = total[3]
    E_start = 0.0
    E_end = 0.0
    E_centrifugal = 0.0
    total[12] = 0.0
    for i in range(n):
        psi = total[0] + 2.0 * pi * i / n - alpha
        for r in range(N_m):
            work[0, r] = eta[i, r]
            work[1, r] = eta_dot[i, r]
        free_acceleration(0, 1, 4, N_m, modes, K, work)
        Delta, rate = tip_force(
            0, 1, 4, N_m, sin(psi), cos(psi), R_brush - delta, foreshortening, modes, G, c, work)
        E_start = E_start + contact_energy(Delta, k_c)
        if Delta + h * (abs(omega_b) * R_brush + abs(delta_dot) + tip_speed_bound(N_m, K, work)) < 0.0:
            advance_free(N_m, c[2], K, P, work, total)
        else:
            h_next[i], Delta = advance_touching(
                psi, h, h_next[i], rate, Delta, R_brush - delta, N_m, L, foreshortening, h_min, h_max, tolerance,
                omega_r, modes, G, K, c, work, total)
            E_end = E_end + contact_energy(Delta, k_c)
        E_centrifugal = E_centrifugal + centrifugal_energy(N_m, L, modes, S, c, work)
        y_tip = 0.0
        for r in range(N_m):
            eta[i, r] = work[0, r]
            eta_dot[i, r] = work[1, r]
            y_tip = y_tip + modes[1, r] * work[0, r]
        total[12] = max(total[12], abs(y_tip) / L)
    total[0] = total[0] + omega_b * h
    # work of the hub and of the hull, and of the jumps of omega_b and delta before this step
    total[4] = total[4] - omega_b * (total[3] - J_T) + (c[4] - total[11]) * total[10]
    total[5] = total[5] + v_rov * (total[1] - J_x) - delta_dot * (total[2] - J_z) + E_start - total[9]
    total[9] = E_end
    total[10] = E_centrifugal
    total[11] = c[4]
    total[13] = max(total[12], total[13])
    outputs(
        omega_b, delta + delta_dot * h, delta_dot, v_rov, friction_scale, L, d, E, rho, rho_w, C_a, N_m, n,
        bristles_per_filament, R_brush, alpha, k_c, c_c, Delta_s, mu_s, mu_c, v_0, k_v, v_eps, foreshortening,
        centrifugal, mode_acceleration, lambda_r, omega_r, modes, G, S, K, c, work, eta, eta_dot, total, filament,
        kinetic_fraction, y)
