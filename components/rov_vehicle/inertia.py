"""The mass matrix of Eq. 19, weight, buoyancy and the energies that follow, of the vehicle with its tool."""

from ..library.matrices import invert, of_blocks
from ..library.rotation import turned_back
from ..library.vectors import dot
from .parameters import Parameters
from .records import Motion, Scratch, State


def gravity(p: Parameters, x: State, s: Scratch) -> None:
    """Net buoyancy, and the moment of weight and buoyancy per vertical."""
    W_tool = p.m_tool * p.W / p.m
    x.net_buoyancy = p.net_buoyancy + (p.buoyancy_tool - W_tool)
    for i in range(3):
        s.tool_centre[i] = p.r_tool[i] + p.r_g_tool[i]
        r_b_tool = p.r_tool[i] + p.r_b_tool[i]
        vehicle = p.W * p.r_g[i] - (p.W + p.net_buoyancy) * p.r_b[i]
        x.lever[i] = vehicle + (W_tool * s.tool_centre[i] - p.buoyancy_tool * r_b_tool)  # Eq. V5


def mass_matrix(p: Parameters, x: State, s: Scratch) -> None:
    """M = M_RB + M_A about the body origin (Eq. 19), and its inverse."""
    for i in range(3):
        for j in range(3):
            s.mass[i, j] = 0.0
        s.mass[i, i] = p.m + p.added_mass[i] + p.m_tool
        s.inertia[i, i] = p.I[i] + p.added_inertia[i]
        s.first_moment[i] = p.m * p.r_g[i] + p.m_tool * s.tool_centre[i]
        s.coupling[i, i] = 0.0
    s.inertia[0, 1] = p.I_products[0]
    s.inertia[0, 2] = p.I_products[1]
    s.inertia[1, 2] = p.I_products[2]
    add_tool(p, s)
    s.inertia[1, 0] = s.inertia[0, 1]
    s.inertia[2, 0] = s.inertia[0, 2]
    s.inertia[2, 1] = s.inertia[1, 2]
    # Coupling -S(m r_g) of translation with rotation, of vehicle and tool together.
    s.coupling[0, 1] = s.first_moment[2]
    s.coupling[0, 2] = -s.first_moment[1]
    s.coupling[1, 0] = -s.first_moment[2]
    s.coupling[1, 2] = s.first_moment[0]
    s.coupling[2, 0] = s.first_moment[1]
    s.coupling[2, 1] = -s.first_moment[0]
    of_blocks(x.M, s.mass, s.coupling, s.inertia)
    of_blocks(s.used_up, s.mass, s.coupling, s.inertia)
    invert(s.used_up, x.M_inv, 6)


def add_tool(p: Parameters, s: Scratch) -> None:
    """The tool's inertia about the body origin, by the parallel-axis theorem, in the upper triangle."""
    r_r = dot(s.tool_centre, s.tool_centre)
    for i in range(3):
        across = r_r - s.tool_centre[i] * s.tool_centre[i]
        s.inertia[i, i] = s.inertia[i, i] + (p.I_tool[i] + p.m_tool * across)  # Eq. V6
    s.inertia[0, 1] = s.inertia[0, 1] + (p.I_products_tool[0] - p.m_tool * s.tool_centre[0] * s.tool_centre[1])
    s.inertia[0, 2] = s.inertia[0, 2] + (p.I_products_tool[1] - p.m_tool * s.tool_centre[0] * s.tool_centre[2])
    s.inertia[1, 2] = s.inertia[1, 2] + (p.I_products_tool[2] - p.m_tool * s.tool_centre[1] * s.tool_centre[2])


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
