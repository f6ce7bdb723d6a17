"""The integration of vehicle and thrusters over one internal step."""

from math import exp, sqrt

from .motion import rates
from .propulsion import thrust_of, thruster_wrench


def runge_kutta(
    dt: float, x: "float[:]", thrust_state: "float[:]", stage: "float[:]", k: "float[:]", increment: "float[:]",
    R: "float[:]", v_water: "float[:]", force: "float[:]", tau_control: "float[:]", tau_disturb: "float[:]",
    tau_external: "float[:]", u_thruster: "float[:]", v_c: "float[:]", B: "float[:,:]", M: "float[:,:]",
    M_inv: "float[:,:]", added_mass: "float[:]", D: "float[:,:]", lever: "float[:]", net_buoyancy: float,
    k_T_forward: float, k_T_reverse: float, thruster_lag: float,
) -> None:
    """One classical Runge-Kutta step of x with nu_r in x[7..12]; the thrusters' lag is solved exactly beside it."""
    half_decay = 0.0
    decay = 0.0
    if thruster_lag > 0.0:
        half_decay = exp(-0.5 * dt / thruster_lag)
        decay = exp(-dt / thruster_lag)
    for i in range(18):
        stage[i] = x[i]
        increment[i] = 0.0
    for s in range(4):
        reached = half_decay
        weight = 2.0
        if s == 0:
            reached = 1.0
            weight = 1.0
        if s == 3:
            reached = decay
            weight = 1.0
        thruster_wrench(tau_control, B, thrust_state, u_thruster, k_T_forward, k_T_reverse, reached)
        rates(
            k, stage, R, v_water, force, tau_control, tau_disturb, tau_external, v_c, M, M_inv, added_mass, D, lever,
            net_buoyancy)
        ahead = 0.5 * dt
        if s == 2:
            ahead = dt
        for i in range(18):
            increment[i] = increment[i] + weight * k[i]
            stage[i] = x[i] + ahead * k[i]
    for i in range(18):
        x[i] = x[i] + dt / 6.0 * increment[i]
    length = sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6])
    for i in range(3, 7):
        x[i] = x[i] / length
    for j in range(8):
        steady = thrust_of(u_thruster[j], k_T_forward, k_T_reverse)
        thrust_state[j] = decay * thrust_state[j] + (1.0 - decay) * steady
