"""Thruster allocation (Eq. 20): the matrix B, its pseudoinverse, and thrusts within their range."""


def allocation(B: "float[:,:]", thruster_position: "float[:]", thruster_direction: "float[:]") -> None:
    """B of Eq. 20: column j holds the direction of thruster j and its moment arm, position x direction."""
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


def pseudoinverse(B: "float[:,:]", B_pinv: "float[:,:]", work: "float[:]") -> None:
    """B^+ = B^T (B B^T)^-1."""
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


def add_within(
    F: "float[:]", B_pinv: "float[:,:]", tau: "float[:]", first: int, last: int, k_T_forward: float, k_T_reverse: float,
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
    F: "float[:]", B_pinv: "float[:,:]", tau: "float[:]", attitude_first: bool, k_T_forward: float, k_T_reverse: float,
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
