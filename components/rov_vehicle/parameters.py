"""Parameters of the vehicle, its thrusters, its tool mounting and the hull plane, each with unit and source."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..declare.interface import parameter
from ..library.thrusters import DIRECTIONS, GEOMETRY_SOURCE, K_T, K_T_SOURCE, POSITIONS

WU = "Wu 2018"
T200 = "T200 performance data (Blue Robotics, September 2019)"
NO_TOOL = "none: the paper gives the tool no mass"


@dataclass(frozen=True)
class Parameters:
    """BlueROV2 Heavy; the defaults are the set of Wu 2018 with the net buoyancy of the paper's Table 2.

    Vectors are in the body frame (forward, starboard, down) from the body origin unless said otherwise.
    """

    m: float = parameter(11.5, "kg", "mass", "Table 2", minimum=0.1, maximum=1e4)
    W: float = parameter(112.8, "N", "weight", WU, minimum=0.0, maximum=1e5)
    net_buoyancy: float = parameter(0.3, "N", "buoyancy minus weight, B - W", "Table 2", minimum=-1e4, maximum=1e4)
    I: tuple[float, ...] = parameter(
        (0.16, 0.16, 0.16), "kg.m2", "moments of inertia about the body origin: xx, yy, zz", WU, 1e-4, 1e4
    )
    I_products: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0), "kg.m2", "off-diagonal elements of the inertia matrix: xy, xz, yz", WU, -1e4, 1e4
    )
    r_g: tuple[float, ...] = parameter((0.0, 0.0, 0.02), "m", "centre of gravity", WU, -10.0, 10.0)
    r_b: tuple[float, ...] = parameter((0.0, 0.0, 0.0), "m", "centre of buoyancy", WU, -10.0, 10.0)
    added_mass: tuple[float, ...] = parameter(
        (5.5, 12.7, 14.57), "kg", "added mass, positive: surge, sway, heave", WU, minimum=0.0, maximum=1e4
    )
    added_inertia: tuple[float, ...] = parameter(
        (0.12, 0.12, 0.12), "kg.m2", "added inertia, positive: roll, pitch, yaw", WU, minimum=0.0, maximum=1e4
    )
    D_force: tuple[float, ...] = parameter(
        (4.03, 6.22, 5.18), "N.s/m", "linear damping: surge, sway, heave", WU, minimum=0.0, maximum=1e5
    )
    D_moment: tuple[float, ...] = parameter(
        (0.07, 0.07, 0.07), "N.m.s/rad", "linear damping: roll, pitch, yaw", WU, minimum=0.0, maximum=1e5
    )
    D_force_quadratic: tuple[float, ...] = parameter(
        (18.18, 21.66, 36.99), "N.s2/m2", "quadratic damping: surge, sway, heave", WU, minimum=0.0, maximum=1e5
    )
    D_moment_quadratic: tuple[float, ...] = parameter(
        (1.55, 1.55, 1.55), "N.m.s2/rad2", "quadratic damping: roll, pitch, yaw", WU, minimum=0.0, maximum=1e5
    )
    m_tool: float = parameter(
        0.0, "kg", "mass of the tool: brush, motor, mounting; its weight is m_tool W/m", NO_TOOL, 0.0, 1e4
    )
    r_g_tool: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0), "m", "centre of gravity of the tool, from r_tool", NO_TOOL, -10.0, 10.0
    )
    I_tool: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0), "kg.m2", "moments of inertia of the tool about its centre of gravity", NO_TOOL, 0.0, 1e4
    )
    I_products_tool: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0), "kg.m2", "off-diagonal elements of that inertia matrix: xy, xz, yz", NO_TOOL, -1e4, 1e4
    )
    buoyancy_tool: float = parameter(0.0, "N", "weight of the water that the tool displaces", NO_TOOL, 0.0, 1e5)
    r_b_tool: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0), "m", "centre of buoyancy of the tool, from r_tool", NO_TOOL, -10.0, 10.0
    )
    thruster_position: tuple[float, ...] = parameter(
        POSITIONS, "m", "eight rows (x, y, z)", GEOMETRY_SOURCE, -10.0, 10.0
    )
    thruster_direction: tuple[float, ...] = parameter(
        DIRECTIONS, "1", "eight rows (x, y, z): unit force at a positive command", GEOMETRY_SOURCE, -1.0, 1.0
    )
    k_T_forward: float = parameter(K_T[12][0], "N", "thrust at command +1", K_T_SOURCE, minimum=0.0, maximum=1e4)
    k_T_reverse: float = parameter(K_T[12][1], "N", "thrust at command -1", K_T_SOURCE, minimum=0.0, maximum=1e4)
    thruster_lag: float = parameter(
        0.02, "s", "time constant of the thrust, 0 = at once", "T200 step: 63 % at 20 ms", minimum=0.0, maximum=10.0
    )
    thruster_delay: float = parameter(
        0.0, "s", "time until a command acts: bus and speed controller", "none", minimum=0.0, maximum=1.0
    )
    thruster_dead_band: float = parameter(
        0.0, "1", "smaller commands give no thrust", "none; T200: 0.09 at 12 V, 0.07 at 16 V", minimum=0.0, maximum=0.9
    )
    thrust_table: bool = parameter(
        False, "1", "thrust from the table below, at V_thruster; false: k_T sgn(u) u^2", "false: Eq. 20"
    )
    table_u: tuple[float, ...] = parameter(
        (-1.0, -0.5, -0.25, 0.25, 0.5, 0.75, 1.0), "1", "commands of the thrust table, rising", T200, -1.0, 1.0
    )
    F_12V: tuple[float, ...] = parameter(
        (-28.48, -10.01, -3.11, 3.87, 12.54, 24.15, 36.42), "N", "thrust at these commands, 12 V", T200, -1e4, 1e4
    )
    F_16V: tuple[float, ...] = parameter(
        (-39.91, -14.10, -4.72, 5.92, 17.88, 33.54, 51.44), "N", "thrust at these commands, 16 V", T200, -1e4, 1e4
    )
    dead_band_12V: float = parameter(0.09, "1", "dead band of the table at 12 V", T200, minimum=0.0, maximum=0.9)
    dead_band_16V: float = parameter(0.07, "1", "dead band of the table at 16 V", T200, minimum=0.0, maximum=0.9)
    i_12V: tuple[float, ...] = parameter(
        (17.03, 12.94, 8.9, 5.635, 3.3, 1.55, 0.5, 0.05, 0.0, 0.075, 0.5, 1.55, 3.3, 5.745, 8.9, 12.825, 16.91),
        "A",
        "current of a thruster at commands from -1 to 1 in steps of 1/8, 12 V",
        T200,
        minimum=0.0,
        maximum=1e4,
    )
    i_ratio_16V: float = parameter(
        1.41, "1", "current at 16 V over that at 12 V", "24 A and 17 A at full command; elsewhere assumed", 0.0, 10.0
    )
    hull_loss: float = parameter(
        0.0, "1", "share of the thrust lost by a thruster at the hull; 0 = none", "none", minimum=0.0, maximum=1.0
    )
    hull_loss_length: float = parameter(
        0.1, "m", "distance over which that loss falls to 37 %", "assumed: a thruster's diameter", 1e-3, 100.0
    )
    r_tool: tuple[float, ...] = parameter(
        (0.15, 0.0, 0.3),
        "m",
        "centre of the brush axis",
        "assumed: under the frame; x picked from a scan, where Table 3's wrench leaves it upright",
        -10.0,
        10.0,
    )
    R_tool_body: tuple[float, ...] = parameter(
        (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
        "1",
        "rotation from tool to body frame by rows; its columns are x_t, y_t, z_t. Default: brush under the vehicle",
        "assumed",
        -1.0,
        1.0,
    )
    wrench_along_normal: bool = parameter(
        False,
        "1",
        "F_z acts along the hull's normal, F_x and v_rov along the hull; false: along z_t and x_t",
        "false: Eq. 21",
    )
    R_brush: float = parameter(0.15, "m", "brush radius", "Table 2", minimum=1e-3, maximum=10.0)
    hull_point: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.445), "m", "a point of the hull plane, world frame", "assumed", -1e4, 1e4
    )
    hull_normal: tuple[float, ...] = parameter(
        (0.0, 0.0, -1.0), "1", "unit normal of the hull plane into the water, world frame", "assumed", -1.0, 1.0
    )
    position_start: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0), "m", "initial position in the world: north, east, down", "assumed", -1e4, 1e4
    )
    attitude_start: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0), "rad", "initial roll, pitch, yaw", "assumed", -6.3, 6.3
    )
    velocity_start: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0), "m/s", "initial velocity over ground, body frame", "assumed", -100.0, 100.0
    )
    rates_start: tuple[float, ...] = parameter(
        (0.0, 0.0, 0.0), "rad/s", "initial angular velocity, body frame", "assumed", -100.0, 100.0
    )
    max_step: float = parameter(2.5e-3, "s", "largest internal step", "assumed", minimum=1e-6, maximum=0.02)


def about_origin(
    I_g: tuple[float, ...], m: float, r_g: tuple[float, ...]
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Parallel-axis theorem: `I` and `I_products` about the body origin from the moments about r_g."""
    x, y, z = r_g
    moments = (I_g[0] + m * (y * y + z * z), I_g[1] + m * (x * x + z * z), I_g[2] + m * (x * x + y * y))
    return moments, (-m * x * y, -m * x * z, -m * y * z)


NOMINAL = Parameters()

# Weight and buoyancy as Wu gives them, for comparison with other implementations.
WU_2018 = replace(NOMINAL, net_buoyancy=2.0)

# von Benzon et al. 2022, An Open-Source Benchmark Simulator, JMSE 10(12) 1898: g = 9.82 m/s2, 13.4 litres of water.
_BENZON_I, _BENZON_I_PRODUCTS = about_origin((0.26, 0.23, 0.37), 13.5, (0.0, 0.0, 0.0))
BENZON_2022 = replace(
    NOMINAL,
    m=13.5,
    W=13.5 * 9.82,
    net_buoyancy=1000.0 * 9.82 * 0.0134 - 13.5 * 9.82,
    I=_BENZON_I,
    I_products=_BENZON_I_PRODUCTS,
    r_g=(0.0, 0.0, 0.0),
    r_b=(0.0, 0.0, -0.01),
    added_mass=(6.36, 7.12, 18.68),
    added_inertia=(0.189, 0.135, 0.222),
    D_force=(13.7, 0.0, 33.0),
    D_moment=(0.0, 0.8, 0.0),
    D_force_quadratic=(141.0, 217.0, 190.0),
    D_moment_quadratic=(1.19, 0.47, 1.5),
)
