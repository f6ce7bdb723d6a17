"""Free flight: filaments that cannot reach the hull within a step share one linear map over it (Eq. 4)."""

from math import sqrt


def multiply(size: int, A: "float[:,:]", B: "float[:,:]", C: "float[:,:]") -> None:
    """C = A B for the leading square blocks."""
    for i in range(size):
        for j in range(size):
            total = 0.0
            for k in range(size):
                total = total + A[i, k] * B[k, j]
            C[i, j] = total


def free_flight(
    h: float, N_m: int, omega_max: float, modes: "float[:,:]", K: "float[:,:]", P: "float[:,:]", Q: "float[:,:]",
    A: "float[:,:]",
) -> None:
    """Fill P with the map of (eta, eta_dot, 1) over h without contact: Runge-Kutta in 2^k equal micro-steps.

    For linear equations the classical Runge-Kutta step is the polynomial 1 + hA + .. + (hA)^4/24; k squarings of it
    give the whole step. omega_max times the micro-step is at most 0.2.
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
        A[N_m + r, N_m + r] = -h_s * modes[0, r]  # Eq. 4
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


def relative_energy(N_m: int, K: "float[:,:]", work: "float[:,:]") -> float:
    """Kinetic, strain and centrifugal energy per modal mass of eta, eta_dot in rows 0, 1 of work."""
    energy = 0.0
    for r in range(N_m):
        pull = -K[6, r]
        for s in range(N_m):
            pull = pull + 0.5 * K[r, s] * work[0, s]
        energy = energy + 0.5 * work[1, r] * work[1, r] + pull * work[0, r]
    return energy


def advance_free(N_m: int, M: float, K: "float[:,:]", P: "float[:,:]", work: "float[:,:]", total: "float[:]") -> None:
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


def tip_speed_bound(N_m: int, K: "float[:,:]", work: "float[:,:]") -> float:
    """Bound on the tip speed of free vibration, rows 0, 1 of work: all energy kinetic, modes in phase, times 1.5."""
    speed = 0.0
    for r in range(N_m):
        speed = speed + 3.0 * sqrt(work[1, r] * work[1, r] + K[r, r] * work[0, r] * work[0, r])
    return speed
