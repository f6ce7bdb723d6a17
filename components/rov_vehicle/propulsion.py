"""Thrusters: allocation, thrust and lag (Eq. 20)."""

from .frames import cross_add


def allocation(
    B: "float[:,:]", thruster_position: "float[:]", thruster_direction: "float[:]", work: "float[:]",
) -> None:
    """B of Eq. 20: column j holds the direction of thruster j and its moment arm, position x direction."""
    for j in range(8):
        k = 3 * j
        for i in range(6):
            work[i] = 0.0
        for i in range(3):
            work[i] = thruster_direction[k + i]
        cross_add(
            work, 3, thruster_position[k], thruster_position[k + 1], thruster_position[k + 2], work[0], work[1],
            work[2])
        for i in range(6):
            B[i, j] = work[i]


def thrust_of(u: float, k_T_forward: float, k_T_reverse: float) -> float:
    """Steady thrust k_T sgn(u) u^2 of a command, which saturates at +-1."""
    s = min(1.0, max(-1.0, u))
    F = k_T_forward * s * s
    if s < 0.0:
        F = -k_T_reverse * s * s
    return F


def thruster_wrench(
    tau_control: "float[:]", B: "float[:,:]", thrust_state: "float[:]", u_thruster: "float[:]", k_T_forward: float,
    k_T_reverse: float, decay: float,
) -> None:
    """B F (Eq. 20) with the thrusts after a time in which the distance to their steady values fell by `decay`."""
    for r in range(6):
        tau_control[r] = 0.0
    for j in range(8):
        steady = thrust_of(u_thruster[j], k_T_forward, k_T_reverse)
        F = decay * thrust_state[j] + (1.0 - decay) * steady
        for r in range(6):
            tau_control[r] = tau_control[r] + B[r, j] * F  # Eq. 20
