"""Underwater vehicle in six degrees of freedom (Eqs. 18-21), its thrusters, tool wrench and tool-to-hull kinematics.

World frame: north, east, down. Body frame: forward, starboard, down. The current is uniform and constant over a step:
the equations hold in the frame that moves with the water, where the velocity is the relative velocity nu_r.
"""

from ..library.integration import equal_steps
from ..library.rotation import quaternion
from ..library.thrust import allocation_matrix
from ..library.vectors import copy, cross_add, join
from .frames import change_frame, euler_angles, rotation
from .inertia import gravity, kinetic, mass_matrix, potential
from .momentum import angular_momentum, longest_step, spin
from .motion import rates, runge_kutta
from .parameters import Parameters
from .propulsion import draw, steady, take_commands, thruster_wrench, thrusts, until_next_command, wrench_of
from .records import Inputs, Motion, Outputs, Scratch, State
from .tool import tool_motion, tool_wrench


def setup(p: Parameters, x: State, s: Scratch) -> None:
    """Allocation matrix B, mass matrix M and its inverse, weight and buoyancy, the tool's mounting."""
    for i in range(3):
        for j in range(3):
            x.R_tool[i, j] = p.R_tool_body[3 * i + j]
    allocation_matrix(x.B, p.thruster_position, p.thruster_direction)
    gravity(p, x, s)
    mass_matrix(p, x, s)


def initialize(u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """Initial pose and velocity, thrusters at rest, no work done."""
    place(x.motion, p, s)
    for i in range(3):
        x.current[i] = u.v_c[i]
    for j in range(8):
        x.thrust[j] = 0.0
        x.command[j] = 0.0
    x.i_thruster = 0.0
    x.count_held = 0.0
    x.first_held = 0.0
    x.clock = 0.0
    rotation(s.R, x.motion)
    x.E_start = kinetic(x.motion, p, x, s) + potential(x.motion, x, s)


def place(z: Motion, p: Parameters, s: Scratch) -> None:
    """The motion at the start."""
    for i in range(3):
        z.position[i] = p.position_start[i]
        z.v[i] = p.velocity_start[i]
        z.omega[i] = p.rates_start[i]
    quaternion(s.q_start, p.attitude_start[0], p.attitude_start[1], p.attitude_start[2])
    for i in range(4):
        z.q[i] = s.q_start[i]
    z.W_thruster = 0.0
    z.W_tool = 0.0
    z.W_external = 0.0
    z.W_current = 0.0
    z.W_damping = 0.0
    for i in range(3):
        z.J_tool[i] = 0.0
        z.J_other[i] = 0.0


def outputs(u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Pose, velocities, thrusts, wrenches, the tool's place and motion against the hull, powers and energies."""
    copy(8, s.F, x.thrust)
    wrench_of(s.F, x, s)
    spin(u, x, s)
    copy(24, s.stage, x.motion)
    change_frame(s.stage, -1.0, u, s)
    tool_wrench(u, p, x, s)
    rates(s.k, s.stage, u, p, x, s)
    write_acceleration(s.k, s.stage, y, s)
    write_powers(s.k, y)
    write_momenta(x.motion, p, x, y, s)
    write_motion(x.motion, y, s)
    for i in range(8):
        y.thrust[i] = s.F[i]
        if p.hull_loss > 0.0:
            y.thrust[i] = s.F_near[i]
    y.i_thruster = x.i_thruster
    for i in range(3):
        y.F_control[i] = s.F_control[i]
        y.M_control[i] = s.M_control[i]
        y.F_disturb[i] = s.F_disturb[i]
        y.M_disturb[i] = s.M_disturb[i]
    tool = tool_motion(x.motion, p, x, s)
    y.delta = tool.delta
    y.delta_dot = tool.delta_dot
    y.v_rov = tool.v_rov
    y.misalignment = tool.misalignment
    y.tilt_x = tool.tilt_x
    y.tilt_y = tool.tilt_y
    y.E_kinetic = kinetic(x.motion, p, x, s)
    y.E_potential = potential(x.motion, x, s)
    write_works(x.motion, y)
    done = y.W_thruster + y.W_tool + y.W_external + y.W_current - y.W_damping
    y.energy_residual = x.E_start + done - y.E_kinetic - y.E_potential


def write_acceleration(k: Motion, z: Motion, y: Outputs, s: Scratch) -> None:
    """That of the body origin over ground, from the rates k of z through the water: the current is constant."""
    for i in range(3):
        s.acceleration[i] = k.v[i]
    cross_add(s.acceleration, z.omega[0], z.omega[1], z.omega[2], z.v[0], z.v[1], z.v[2])
    for i in range(3):
        s.omega_dot[i] = k.omega[i]
    join(s.nu_dot, s.acceleration, s.omega_dot)
    for i in range(6):
        y.nu_dot[i] = s.nu_dot[i]


def write_powers(k: Motion, y: Outputs) -> None:
    """The powers from the rates of the works."""
    y.P_thruster = k.W_thruster
    y.P_tool = k.W_tool
    y.P_damping = k.W_damping


def write_motion(z: Motion, y: Outputs, s: Scratch) -> None:
    """Pose and velocities."""
    y.x_n = z.position[0]
    y.y_n = z.position[1]
    y.z_n = z.position[2]
    angles = euler_angles(s.R, z)
    y.phi = angles.phi
    y.theta = angles.theta
    y.psi = angles.psi
    y.u = z.v[0]
    y.v = z.v[1]
    y.w = z.v[2]
    y.p = z.omega[0]
    y.q = z.omega[1]
    y.r = z.omega[2]
    for i in range(4):
        y.quat[i] = z.q[i]


def write_works(z: Motion, y: Outputs) -> None:
    """The works."""
    y.W_thruster = z.W_thruster
    y.W_tool = z.W_tool
    y.W_external = z.W_external
    y.W_current = z.W_current
    y.W_damping = z.W_damping


def write_momenta(z: Motion, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Angular momentum and impulses about the world origin, and the moment of the spinning tool."""
    angular_momentum(s.impulse, z, p, x, s)
    for i in range(3):
        y.M_gyro[i] = s.M_gyro[i]
        y.L[i] = s.impulse[i]
        y.J_tool[i] = z.J_tool[i]
        y.J_other[i] = z.J_other[i]


def change_current(z: Motion, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """A change of the current changes energy and momentum of the added mass at once: the water does that."""
    rotation(s.R, z)
    z.W_current = z.W_current - kinetic(z, p, x, s)
    angular_momentum(s.L_before, z, p, x, s)
    for i in range(3):
        x.current[i] = u.v_c[i]
    z.W_current = z.W_current + kinetic(z, p, x, s)
    angular_momentum(s.impulse, z, p, x, s)
    for i in range(3):
        z.J_other[i] = z.J_other[i] + (s.impulse[i] - s.L_before[i])


def step(h: float, u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Advance by h, from one change of the commands that act to the next, in equal Runge-Kutta steps."""
    spin(u, x, s)
    change_current(x.motion, u, p, x, s)
    change_frame(x.motion, -1.0, u, s)
    tool_wrench(u, p, x, s)
    take_commands(u, p, x)
    left = h
    while left > 0.0:
        part = until_next_command(left, x)
        advance(part, u, p, x, s)
        left -= part
    change_frame(x.motion, 1.0, u, s)
    outputs(u, p, x, y, s)


def advance(h: float, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """Advance the motion through the water by h with constant commands."""
    draw(h, steady(u, p, x, s), p, x)
    if p.thruster_lag <= 0.0:
        thrusts(0.0, x, s)
    thruster_wrench(1.0, x, s)
    count = equal_steps(h, longest_step(p, s))
    dt = h / count
    for _ in range(count):
        runge_kutta(dt, u, p, x, s)
    x.clock += h
