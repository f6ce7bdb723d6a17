"""Cascaded PID at a fixed rate: position -> velocity -> force and attitude -> rate -> moment, then thruster allocation.

command: held thruster commands. memory: [0] number of the next sample (-1 before the first), [1] held brush voltage,
[2] saturated, [3] number of saturated samples, [4..9] requested wrench. Samples are taken at multiples of T_s.
"""

from math import atan2, ceil, cos, sin, sqrt


def quaternion(out: 'float[:]', at: int, phi: float, theta: float, psi: float) -> None:
    """Quaternion of roll, pitch and yaw (body to world, scalar first) in out[at..at+3]."""
    c1 = cos(0.5 * phi)
    s1 = sin(0.5 * phi)
    c2 = cos(0.5 * theta)
    s2 = sin(0.5 * theta)
    c3 = cos(0.5 * psi)
    s3 = sin(0.5 * psi)
    out[at] = c1 * c2 * c3 + s1 * s2 * s3
    out[at + 1] = s1 * c2 * c3 - c1 * s2 * s3
    out[at + 2] = c1 * s2 * c3 + s1 * c2 * s3
    out[at + 3] = c1 * c2 * s3 - s1 * s2 * c3


def attitude_error(e: 'float[:]', work: 'float[:]') -> None:
    """Rotation vector in e[3..5], body frame, that takes the attitude work[0..3] to work[4..7] the short way."""
    a = work[0] * work[4] + work[1] * work[5] + work[2] * work[6] + work[3] * work[7]
    e[3] = work[0] * work[5] - work[1] * work[4] - work[2] * work[7] + work[3] * work[6]
    e[4] = work[0] * work[6] - work[2] * work[4] - work[3] * work[5] + work[1] * work[7]
    e[5] = work[0] * work[7] - work[3] * work[4] - work[1] * work[6] + work[2] * work[5]
    sine = sqrt(e[3] * e[3] + e[4] * e[4] + e[5] * e[5])
    factor = 2.0
    if sine > 1e-12:
        factor = 2.0 * atan2(sine, abs(a)) / sine
    if a < 0.0:
        factor = -factor
    for i in range(3):
        e[3 + i] = factor * e[3 + i]


def to_body(e: 'float[:]', q: 'float[:]') -> None:
    """Turn e[0..2] from the world into the body frame of the quaternion q[0..3]."""
    for_x = e[0]
    for_y = e[1]
    for_z = e[2]
    # v - 2 q0 (q x v) + 2 q x (q x v)
    c_x = q[2] * for_z - q[3] * for_y
    c_y = q[3] * for_x - q[1] * for_z
    c_z = q[1] * for_y - q[2] * for_x
    e[0] = for_x - 2.0 * q[0] * c_x + 2.0 * (q[2] * c_z - q[3] * c_y)
    e[1] = for_y - 2.0 * q[0] * c_y + 2.0 * (q[3] * c_x - q[1] * c_z)
    e[2] = for_z - 2.0 * q[0] * c_z + 2.0 * (q[1] * c_y - q[2] * c_x)


def limit(e: 'float[:]', at: int, largest: float) -> None:
    """Shorten the vector e[at..at+2] to the length `largest`."""
    length = sqrt(e[at] * e[at] + e[at + 1] * e[at + 1] + e[at + 2] * e[at + 2])
    if length > largest:
        for i in range(3):
            e[at + i] = e[at + i] * largest / length


def add_within(
    F: 'float[:]', B_pinv: 'float[:,:]', tau: 'float[:]', first: int, last: int, k_T_forward: float,
    k_T_reverse: float,
) -> float:
    """Add the thrusts of tau[first..last-1] to F, scaled so that every thrust stays in its range; returns the scale."""
    scale = 1.0
    for j in range(8):
        wanted = 0.0
        for i in range(first, last):
            wanted = wanted + B_pinv[j, i] * tau[i]
        # The margin keeps a thruster that is already full from rounding to a hair beyond.
        if F[j] + wanted > k_T_forward and wanted > 1e-12 * k_T_forward:
            scale = min(scale, max(0.0, k_T_forward - F[j]) / wanted)
        if F[j] + wanted < -k_T_reverse and wanted < -1e-12 * k_T_reverse:
            scale = min(scale, max(0.0, k_T_reverse + F[j]) / -wanted)
    for j in range(8):
        for i in range(first, last):
            F[j] = F[j] + scale * B_pinv[j, i] * tau[i]
    return scale


def allocate(
    F: 'float[:]', B_pinv: 'float[:,:]', tau: 'float[:]', attitude_first: bool, k_T_forward: float,
    k_T_reverse: float,
) -> bool:
    """Thrusts F = B^+ tau within their range; True if tau cannot be had in full.

    With `attitude_first` the moments come first and the forces get what is left, one after the other; otherwise every
    thruster is clipped by itself, which at saturation also bends the moments.
    """
    saturated = False
    for j in range(8):
        F[j] = 0.0
    if attitude_first:
        if add_within(F, B_pinv, tau, 3, 6, k_T_forward, k_T_reverse) < 1.0:
            saturated = True
        for i in range(3):
            if add_within(F, B_pinv, tau, i, i + 1, k_T_forward, k_T_reverse) < 1.0:
                saturated = True
    else:
        for j in range(8):
            for i in range(6):
                F[j] = F[j] + B_pinv[j, i] * tau[i]
            if F[j] > k_T_forward or F[j] < -k_T_reverse:
                saturated = True
            F[j] = max(-k_T_reverse, min(k_T_forward, F[j]))
    return saturated


def setup(
    B: 'float[:,:]', B_pinv: 'float[:,:]', work: 'float[:]', thruster_position: 'float[:]',
    thruster_direction: 'float[:]',
) -> None:
    """B of Eq. 20 from the geometry and its pseudoinverse B^T (B B^T)^-1."""
    for j in range(8):
        p_x = thruster_position[3 * j]
        p_y = thruster_position[3 * j + 1]
        p_z = thruster_position[3 * j + 2]
        d_x = thruster_direction[3 * j]
        d_y = thruster_direction[3 * j + 1]
        d_z = thruster_direction[3 * j + 2]
        B[0, j] = d_x
        B[1, j] = d_y
        B[2, j] = d_z
        B[3, j] = p_y * d_z - p_z * d_y
        B[4, j] = p_z * d_x - p_x * d_z
        B[5, j] = p_x * d_y - p_y * d_x
    # Gauss-Jordan on (B B^T | 1) in work[0..35] and work[36..71]; positive definite, so no pivoting.
    for i in range(6):
        for n in range(6):
            work[6 * i + n] = 0.0
            work[36 + 6 * i + n] = 0.0
            for j in range(8):
                work[6 * i + n] = work[6 * i + n] + B[i, j] * B[n, j]
        work[36 + 7 * i] = 1.0
    for i in range(6):
        pivot = work[7 * i]
        for n in range(6):
            work[6 * i + n] = work[6 * i + n] / pivot
            work[36 + 6 * i + n] = work[36 + 6 * i + n] / pivot
        for k in range(6):
            if k != i:
                factor = work[6 * k + i]
                for n in range(6):
                    work[6 * k + n] = work[6 * k + n] - factor * work[6 * i + n]
                    work[36 + 6 * k + n] = work[36 + 6 * k + n] - factor * work[36 + 6 * i + n]
    for j in range(8):
        for i in range(6):
            B_pinv[j, i] = 0.0
            for n in range(6):
                B_pinv[j, i] = B_pinv[j, i] + B[n, j] * work[36 + 6 * n + i]


def initialize(
    integral: 'float[:]', nu_last: 'float[:]', command: 'float[:]', memory: 'float[:]', V_ref: float,
) -> None:
    """Thrusters off until the first sample; the brush voltage is on at once."""
    for i in range(6):
        integral[i] = 0.0
        nu_last[i] = 0.0
        memory[4 + i] = 0.0
    for j in range(8):
        command[j] = 0.0
    memory[0] = -1.0
    memory[1] = V_ref
    memory[2] = 0.0
    memory[3] = 0.0


def sample(
    integral: 'float[:]', nu_last: 'float[:]', command: 'float[:]', memory: 'float[:]', e: 'float[:]', nu: 'float[:]',
    tau: 'float[:]', F: 'float[:]', gains: 'float[:,:]', B: 'float[:,:]', B_pinv: 'float[:,:]', V_ref: float,
    T_s: float, K_windup: float, attitude_first: bool, k_T_forward: float, k_T_reverse: float,
) -> None:
    """One sample of the inner loops: e holds the velocity and rate set-points, nu the measured velocities."""
    for i in range(6):
        acceleration = (nu[i] - nu_last[i]) / T_s
        nu_last[i] = nu[i]
        e[i] = e[i] - nu[i]
        tau[i] = gains[0, i] * e[i] + integral[i] - gains[2, i] * acceleration
        memory[4 + i] = tau[i]
    memory[1] = V_ref
    memory[2] = 0.0
    if allocate(F, B_pinv, tau, attitude_first, k_T_forward, k_T_reverse):
        memory[2] = 1.0
        memory[3] = memory[3] + 1.0
    for i in range(6):
        # Anti-windup by back-calculation: the integral follows what the thrusters can give.
        given = 0.0
        for j in range(8):
            given = given + B[i, j] * F[j]
        integral[i] = integral[i] + T_s * (gains[1, i] * e[i] + K_windup * (given - tau[i]))
    for j in range(8):
        # Inverse of F = k_T sgn(u) u^2.
        command[j] = sqrt(F[j] / k_T_forward) if F[j] >= 0.0 else -sqrt(-F[j] / k_T_reverse)


def outputs(
    y: 'float[:]', u_thruster: 'float[:]', F_ref: 'float[:]', M_ref: 'float[:]', command: 'float[:]',
    memory: 'float[:]',
) -> None:
    """Write what the last sample decided."""
    for j in range(8):
        u_thruster[j] = command[j]
    for i in range(3):
        F_ref[i] = memory[4 + i]
        M_ref[i] = memory[7 + i]
    V_in = memory[1]
    saturated = memory[2]
    saturation_count = memory[3]
    for j in range(8):
        y[j] = u_thruster[j]
    y[8] = V_in
    for i in range(3):
        y[9 + i] = F_ref[i]
    for i in range(3):
        y[12 + i] = M_ref[i]
    y[15] = saturated
    y[16] = saturation_count


def step(
    t: float, h: float, y: 'float[:]', integral: 'float[:]', nu_last: 'float[:]', command: 'float[:]',
    memory: 'float[:]', e: 'float[:]', nu: 'float[:]', tau: 'float[:]', F: 'float[:]', gains: 'float[:,:]',
    work: 'float[:]', u_thruster: 'float[:]', F_ref: 'float[:]', M_ref: 'float[:]', B: 'float[:,:]',
    B_pinv: 'float[:,:]', x_n: float, y_n: float, z_n: float, phi: float, theta: float, psi: float, u: float,
    v: float, w: float, p: float, q: float, r: float, x_ref: float, y_ref: float, z_ref: float, phi_ref: float,
    theta_ref: float, psi_ref: float, V_ref: float, T_s: float, K_position: 'float[:]', K_velocity: 'float[:]',
    K_velocity_i: 'float[:]', K_velocity_d: 'float[:]', K_attitude: 'float[:]', K_rate: 'float[:]',
    K_rate_i: 'float[:]', K_rate_d: 'float[:]', K_windup: float, v_max: float, rate_max: float, attitude_first: bool,
    k_T_forward: float, k_T_reverse: float,
) -> None:
    """Take the samples that fall into [t, t + h), with the inputs as they are; most often one, or none."""
    # A sample belongs to the step that starts at it, whatever the rounding of t.
    margin = 1e-6 * T_s
    nu[0] = u
    nu[1] = v
    nu[2] = w
    nu[3] = p
    nu[4] = q
    nu[5] = r
    for i in range(3):
        gains[0, i] = K_velocity[i]
        gains[0, 3 + i] = K_rate[i]
        gains[1, i] = K_velocity_i[i]
        gains[1, 3 + i] = K_rate_i[i]
        gains[2, i] = K_velocity_d[i]
        gains[2, 3 + i] = K_rate_d[i]
    if memory[0] < 0.0:
        memory[0] = ceil((t - margin) / T_s) * 1.0
        for i in range(6):
            nu_last[i] = nu[i]
    while memory[0] * T_s < t + h - margin:
        quaternion(work, 0, phi, theta, psi)
        quaternion(work, 4, phi_ref, theta_ref, psi_ref)
        e[0] = K_position[0] * (x_ref - x_n)
        e[1] = K_position[1] * (y_ref - y_n)
        e[2] = K_position[2] * (z_ref - z_n)
        limit(e, 0, v_max)
        to_body(e, work)
        attitude_error(e, work)
        for i in range(3):
            e[3 + i] = K_attitude[i] * e[3 + i]
        limit(e, 3, rate_max)
        sample(
            integral, nu_last, command, memory, e, nu, tau, F, gains, B, B_pinv, V_ref, T_s, K_windup, attitude_first,
            k_T_forward, k_T_reverse)
        memory[0] = memory[0] + 1.0
    outputs(y, u_thruster, F_ref, M_ref, command, memory)
