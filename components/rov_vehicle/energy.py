"""Kinetic and potential energy of the vehicle."""

from ..library.rotation import turned_back
from .parameters import Parameters
from .records import Motion, Scratch, State


def kinetic(z: Motion, p: Parameters, x: State, s: Scratch) -> float:
    """Kinetic energy: rigid body over ground plus added mass through the water, with z over ground."""
    E = 0.0
    for i in range(6):
        for j in range(6):
            E += 0.5 * z.nu[i] * x.M[i, j] * z.nu[j]
    for i in range(3):
        v_r = z.v[i] - turned_back(s.R, i, x.current)
        E += 0.5 * p.added_mass[i] * (v_r * v_r - z.v[i] * z.v[i])
    return E


def potential(z: Motion, x: State, s: Scratch) -> float:
    """Energy of weight and buoyancy, zero with the body origin at depth 0 and the lever level."""
    return x.net_buoyancy * z.position[2] - x.lever[0] * s.R[2, 0] - x.lever[1] * s.R[2, 1] - x.lever[2] * s.R[2, 2]
