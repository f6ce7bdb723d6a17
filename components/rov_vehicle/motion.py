"""Equations of motion (Eqs. 18, 19) in the frame that moves with the water, and their integration."""

from math import exp, sqrt

from ..library.integration import runge_kutta_stage
from ..library.rotation import turned_back
from ..library.vectors import add_scaled, clear, copy, cross_add, join
from .frames import rotation
from .momentum import gyroscopic, impulses, momenta
from .parameters import Parameters
from .propulsion import near_hull, thruster_wrench, thrusts
from .records import Inputs, Motion, Scratch, State
from .tool import tool_wrench


def rates(k: Motion, z: Motion, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """The right-hand side: rates k of the motion z, whose velocity is that through the water, nu_r."""
    rotation(s.R, z)
    if p.wrench_along_normal:
        tool_wrench(u, p, x, s)
    if p.hull_loss > 0.0:
        near_hull(z, p, x, s)
    kinematics(k, z, u, s)
    water(k, z, p, x, s)
    # The moment of weight and buoyancy.
    cross_add(s.moment, x.lever[0], x.lever[1], x.lever[2], s.R[2, 0], s.R[2, 1], s.R[2, 2])
    for i in range(3):
        s.load_force[i] = s.force[i] + s.F_control[i] + u.F_external[i]
        s.load_moment[i] = s.moment[i] + s.M_control[i] + u.M_external[i]
    coriolis(z, x, s)
    gyroscopic(z, s)
    for i in range(3):
        s.force[i] = s.force[i] + s.F_control[i] + s.F_disturb[i] + u.F_external[i]
        s.moment[i] = s.moment[i] + s.M_control[i] + s.M_disturb[i] + u.M_external[i] + s.M_gyro[i]
    join(s.tau, s.force, s.moment)
    for i in range(6):
        nu_dot = 0.0
        for j in range(6):
            nu_dot += x.M_inv[i, j] * s.tau[j]  # Eq. 19
        k.nu[i] = nu_dot
    powers(k, z, u, p, s)
    impulses(k, z, u, p, s)


def kinematics(k: Motion, z: Motion, u: Inputs, s: Scratch) -> None:
    """Rates of position and attitude (Eq. 18)."""
    for i in range(3):
        s.v_water[i] = turned_back(s.R, i, u.v_c)
        k.position[i] = s.R[i, 0] * z.v[0] + s.R[i, 1] * z.v[1] + s.R[i, 2] * z.v[2] + u.v_c[i]  # Eq. 18
    p = z.omega[0]
    q = z.omega[1]
    r = z.omega[2]
    # Eq. 18 for the attitude: q_dot = 1/2 q (x) (0, omega).
    k.q[0] = 0.5 * (-z.q[1] * p - z.q[2] * q - z.q[3] * r)
    k.q[1] = 0.5 * (z.q[0] * p + z.q[2] * r - z.q[3] * q)
    k.q[2] = 0.5 * (z.q[0] * q + z.q[3] * p - z.q[1] * r)
    k.q[3] = 0.5 * (z.q[0] * r + z.q[1] * q - z.q[2] * p)


def water(k: Motion, z: Motion, p: Parameters, x: State, s: Scratch) -> None:
    """Damping and net buoyancy: -D nu_r - g of Eq. 19, and the power lost."""
    P_damping = 0.0
    for i in range(3):
        D_v = (p.D_force[i] + p.D_force_quadratic[i] * abs(z.v[i])) * z.v[i]
        D_omega = (p.D_moment[i] + p.D_moment_quadratic[i] * abs(z.omega[i])) * z.omega[i]
        P_damping = P_damping + D_v * z.v[i] + D_omega * z.omega[i]
        # W - B acts along world z, which is the last row of R in the body frame.
        s.force[i] = -D_v - s.R[2, i] * x.net_buoyancy
        s.moment[i] = -D_omega
        # Force of the water on the vehicle, without the acceleration and Coriolis terms yet.
        s.hydrodynamic[i] = -D_v
    k.W_damping = P_damping


def coriolis(z: Motion, x: State, s: Scratch) -> None:
    """Take C nu_r = (omega x a, v_r x a + omega x b) off, with the momenta a (linear) and b (angular) of M nu_r."""
    momenta(z, x, s)
    cross_add(s.force, s.a[0], s.a[1], s.a[2], z.omega[0], z.omega[1], z.omega[2])
    cross_add(s.moment, s.a[0], s.a[1], s.a[2], z.v[0], z.v[1], z.v[2])
    cross_add(s.moment, s.b[0], s.b[1], s.b[2], z.omega[0], z.omega[1], z.omega[2])


def powers(k: Motion, z: Motion, u: Inputs, p: Parameters, s: Scratch) -> None:
    """Rates of the works; that of the moving water is its velocity times the hydrodynamic force."""
    cross_add(
        s.hydrodynamic, p.added_mass[0] * z.v[0], p.added_mass[1] * z.v[1], p.added_mass[2] * z.v[2], z.omega[0],
        z.omega[1], z.omega[2])
    P_current = 0.0
    P_thruster = 0.0
    P_tool = 0.0
    P_external = 0.0
    for i in range(3):
        P_current += s.v_water[i] * (s.hydrodynamic[i] - p.added_mass[i] * k.v[i])
        over_ground = z.v[i] + s.v_water[i]
        P_thruster = P_thruster + s.F_control[i] * over_ground + s.M_control[i] * z.omega[i]
        P_tool = P_tool + s.F_disturb[i] * over_ground + s.M_disturb[i] * z.omega[i]
        P_external = P_external + u.F_external[i] * over_ground + u.M_external[i] * z.omega[i]
    k.W_current = P_current
    k.W_thruster = P_thruster
    k.W_tool = P_tool
    k.W_external = P_external


def runge_kutta(dt: float, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """One classical Runge-Kutta step of the motion through the water; the thrusters' lag is solved exactly.

    It begins and ends with the thrusters' wrench in F_control and M_control.
    """
    half_decay = 0.0
    decay = 0.0
    if p.thruster_lag > 0.0:
        half_decay = exp(-0.5 * dt / p.thruster_lag)
        decay = exp(-dt / p.thruster_lag)
    copy(24, s.stage, x.motion)
    clear(24, s.increment)
    for stage in range(4):
        weight = 2.0
        if stage == 1:
            thruster_wrench(half_decay, x, s)
        if stage == 0:
            weight = 1.0
        if stage == 3:
            thruster_wrench(decay, x, s)
            weight = 1.0
        rates(s.k, s.stage, u, p, x, s)
        ahead = 0.5 * dt
        if stage == 2:
            ahead = dt
        runge_kutta_stage(24, x.motion, s.k, weight, ahead, s.increment, s.stage)
    add_scaled(24, x.motion, x.motion, dt / 6.0, s.increment)
    normalize(x.motion)
    thrusts(decay, x, s)


def normalize(z: Motion) -> None:
    """Give the quaternion the length 1."""
    length = sqrt(z.q[0] * z.q[0] + z.q[1] * z.q[1] + z.q[2] * z.q[2] + z.q[3] * z.q[3])
    for i in range(4):
        z.q[i] = z.q[i] / length
