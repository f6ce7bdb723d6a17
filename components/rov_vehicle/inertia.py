"""The mass matrix of Eq. 19."""

from ..library.matrices import invert, of_blocks
from .parameters import Parameters
from .records import Scratch, State


def mass_matrix(p: Parameters, x: State, s: Scratch) -> None:
    """M = M_RB + M_A about the body origin (Eq. 19), and its inverse."""
    for i in range(3):
        for j in range(3):
            s.mass[i, j] = 0.0
        s.mass[i, i] = p.m + p.added_mass[i]
        s.inertia[i, i] = p.I[i] + p.added_inertia[i]
        s.coupling[i, i] = 0.0
    s.inertia[0, 1] = p.I_products[0]
    s.inertia[1, 0] = p.I_products[0]
    s.inertia[0, 2] = p.I_products[1]
    s.inertia[2, 0] = p.I_products[1]
    s.inertia[1, 2] = p.I_products[2]
    s.inertia[2, 1] = p.I_products[2]
    # Coupling -m S(r_g) of translation with rotation.
    s.coupling[0, 1] = p.m * p.r_g[2]
    s.coupling[0, 2] = -p.m * p.r_g[1]
    s.coupling[1, 0] = -p.m * p.r_g[2]
    s.coupling[1, 2] = p.m * p.r_g[0]
    s.coupling[2, 0] = p.m * p.r_g[1]
    s.coupling[2, 1] = -p.m * p.r_g[0]
    of_blocks(x.M, s.mass, s.coupling, s.inertia)
    of_blocks(s.used_up, s.mass, s.coupling, s.inertia)
    invert(s.used_up, x.M_inv, 6)
