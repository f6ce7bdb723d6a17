"""Equations of motion (Eqs. 18, 19) in the frame that moves with the water."""

from .frames import cross_add, rotation


def rates(
    k: "float[:]", x: "float[:]", R: "float[:]", v_water: "float[:]", force: "float[:]", tau_control: "float[:]",
    tau_disturb: "float[:]", tau_external: "float[:]", v_c: "float[:]", M: "float[:,:]", M_inv: "float[:,:]",
    added_mass: "float[:]", D: "float[:,:]", lever: "float[:]", net_buoyancy: float,
) -> None:
    """The right-hand side: rates k of x with nu_r in x[7..12]. Scratch: R, v_water (current, body frame), force."""
    rotation(R, x)
    p = x[10]
    q = x[11]
    r = x[12]
    P_damping = 0.0
    for i in range(3):
        v_water[i] = R[i] * v_c[0] + R[3 + i] * v_c[1] + R[6 + i] * v_c[2]
        k[i] = R[3 * i] * x[7] + R[3 * i + 1] * x[8] + R[3 * i + 2] * x[9] + v_c[i]  # Eq. 18
        D_i = (D[0, i] + D[1, i] * abs(x[7 + i])) * x[7 + i]
        D_j = (D[0, 3 + i] + D[1, 3 + i] * abs(x[10 + i])) * x[10 + i]
        P_damping = P_damping + D_i * x[7 + i] + D_j * x[10 + i]
        # -D nu_r - g of Eq. 19; W - B acts along world z, which is R[6..8] in the body frame.
        force[i] = -D_i - R[6 + i] * net_buoyancy
        force[3 + i] = -D_j
        # Hydrodynamic force on the vehicle, without the acceleration and Coriolis terms yet.
        force[6 + i] = -D_i
    # Eq. 18 for the attitude: q_dot = 1/2 q (x) (0, omega).
    k[3] = 0.5 * (-x[4] * p - x[5] * q - x[6] * r)
    k[4] = 0.5 * (x[3] * p + x[5] * r - x[6] * q)
    k[5] = 0.5 * (x[3] * q + x[6] * p - x[4] * r)
    k[6] = 0.5 * (x[3] * r + x[4] * q - x[5] * p)

    # The moment of weight and buoyancy.
    cross_add(force, 3, lever[0], lever[1], lever[2], R[6], R[7], R[8])

    # Momenta a (linear) and b (angular) of M nu_r in force[9..14]; C nu_r = (omega x a, v_r x a + omega x b).
    for i in range(6):
        force[9 + i] = 0.0
        for j in range(6):
            force[9 + i] = force[9 + i] + M[i, j] * x[7 + j]
    cross_add(force, 0, force[9], force[10], force[11], p, q, r)
    cross_add(force, 3, force[9], force[10], force[11], x[7], x[8], x[9])
    cross_add(force, 3, force[12], force[13], force[14], p, q, r)

    for i in range(6):
        force[i] = force[i] + tau_control[i] + tau_disturb[i] + tau_external[i]
    for i in range(6):
        k[7 + i] = 0.0
        for j in range(6):
            k[7 + i] = k[7 + i] + M_inv[i, j] * force[j]  # Eq. 19

    # Power of the water's motion: current velocity times hydrodynamic force.
    cross_add(force, 6, added_mass[0] * x[7], added_mass[1] * x[8], added_mass[2] * x[9], p, q, r)
    P_current = 0.0
    P_control = 0.0
    P_tool = 0.0
    P_external = 0.0
    for i in range(3):
        P_current = P_current + v_water[i] * (force[6 + i] - added_mass[i] * k[7 + i])
        over_ground = x[7 + i] + v_water[i]
        P_control = P_control + tau_control[i] * over_ground + tau_control[3 + i] * x[10 + i]
        P_tool = P_tool + tau_disturb[i] * over_ground + tau_disturb[3 + i] * x[10 + i]
        P_external = P_external + tau_external[i] * over_ground + tau_external[3 + i] * x[10 + i]
    k[13] = P_control
    k[14] = P_tool
    k[15] = P_external
    k[16] = P_current
    k[17] = P_damping
