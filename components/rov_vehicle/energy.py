"""Kinetic and potential energy of the vehicle."""


def kinetic(x: "float[:]", R: "float[:]", current: "float[:]", M: "float[:,:]", added_mass: "float[:]") -> float:
    """Kinetic energy: rigid body over ground plus added mass through the water, with nu over ground in x."""
    E = 0.0
    for i in range(6):
        for j in range(6):
            E = E + 0.5 * x[7 + i] * M[i, j] * x[7 + j]
    for i in range(3):
        v_r = x[7 + i] - (R[i] * current[0] + R[3 + i] * current[1] + R[6 + i] * current[2])
        E = E + 0.5 * added_mass[i] * (v_r * v_r - x[7 + i] * x[7 + i])
    return E


def potential(x: "float[:]", R: "float[:]", lever: "float[:]", net_buoyancy: float) -> float:
    """Energy of weight and buoyancy, zero with the body origin at depth 0 and the lever level."""
    return net_buoyancy * x[2] - lever[0] * R[6] - lever[1] * R[7] - lever[2] * R[8]
