"""Angular momentum of the vehicle about the world origin, the impulses that change it, and the spin of the tool."""

from math import sqrt

from ..declare.record import Matrix, Vector
from ..library.matrices import rows_times
from ..library.rotation import turned_back
from ..library.vectors import cross_add, split
from .parameters import Parameters
from .records import Inputs, Motion, Scratch, State


def momenta(z: Motion, x: State, s: Scratch) -> None:
    """The momenta a (linear) and b (angular) of M nu."""
    for i in range(6):
        momentum = 0.0
        for j in range(6):
            momentum += x.M[i, j] * z.nu[j]
        s.momenta[i] = momentum
    split(s.momenta, s.a, s.b)


def spin(u: Inputs, x: State, s: Scratch) -> None:
    """Spin momentum of the tool, given in the tool frame, in the body frame."""
    for i in range(3):
        s.H[i] = x.R_tool[i, 0] * u.H_x + x.R_tool[i, 1] * u.H_y + x.R_tool[i, 2] * u.H_z


def gyroscopic(z: Motion, s: Scratch) -> None:
    """Moment of a spinning tool on the vehicle that turns it: what H needs to stay with the body."""
    for i in range(3):
        s.M_gyro[i] = 0.0
    # -omega x H: Euler's equation of a gyrostat (Hughes 2004), whose dH/dt is in the moment of the housing.
    cross_add(s.M_gyro, s.H[0], s.H[1], s.H[2], z.omega[0], z.omega[1], z.omega[2])  # Eq. V1


def longest_step(p: Parameters, s: Scratch) -> float:
    """max_step, or a twentieth of the time in which a spinning tool makes the vehicle nutate by a radian."""
    H = sqrt(s.H[0] * s.H[0] + s.H[1] * s.H[1] + s.H[2] * s.H[2])
    smallest = p.I[0] + p.added_inertia[0]
    for i in range(1, 3):
        smallest = min(smallest, p.I[i] + p.added_inertia[i])
    longest = p.max_step
    if H * longest > 0.05 * smallest:  # |H|/I bounds the frequency; fourth order keeps 1e-6 of the momentum
        longest = 0.05 * smallest / H
    return longest


def about_origin(out: Vector, z: Motion, R: Matrix, force: Vector, moment: Vector, world: Vector) -> None:
    """out = R moment + position x R force: of a wrench about the body origin, or of a momentum. `world`: R force."""
    rows_times(world, R, 0, 3, force, 3)
    rows_times(out, R, 0, 3, moment, 3)
    cross_add(out, z.position[0], z.position[1], z.position[2], world[0], world[1], world[2])


def angular_momentum(out: Vector, z: Motion, p: Parameters, x: State, s: Scratch) -> None:
    """Of the body over ground and of the added mass through the water, with z over ground; the spin is not in it."""
    momenta(z, x, s)
    for i in range(3):
        v_water = turned_back(s.R, i, x.current)
        s.a[i] = s.a[i] - p.added_mass[i] * v_water
    about_origin(out, z, s.R, s.a, s.b, s.world)  # Eq. V2


def impulses(k: Motion, z: Motion, u: Inputs, p: Parameters, s: Scratch) -> None:
    """Rates of the angular impulses about the world origin: by the tool, its spin included, and by all else."""
    for i in range(3):
        s.moment[i] = s.M_disturb[i] + s.M_gyro[i]
        s.a[i] = p.added_mass[i] * z.v[i]
    about_origin(s.impulse, z, s.R, s.F_disturb, s.moment, s.world)
    for i in range(3):
        k.J_tool[i] = s.impulse[i]  # Eq. V3
    about_origin(s.impulse, z, s.R, s.load_force, s.load_moment, s.world)
    # The point about which the momentum of the added mass is taken moves through the water.
    rows_times(s.world, s.R, 0, 3, s.a, 3)
    cross_add(s.impulse, u.v_c[0], u.v_c[1], u.v_c[2], s.world[0], s.world[1], s.world[2])
    for i in range(3):
        k.J_other[i] = s.impulse[i]  # Eq. V4
