"""Vectors of three components, and of six that consist of two such: force and moment, velocity and rate."""

from math import sqrt

from ..declare.record import Vector


def dot(a: Vector, b: Vector) -> float:
    """Scalar product of the first three components of two vectors."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def shorten(v: Vector, longest: float) -> None:
    """Shorten a vector to the length `longest`."""
    length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    if length > longest:
        for i in range(3):
            v[i] = v[i] * longest / length


def join(both: Vector, first: Vector, second: Vector) -> None:
    """Six components of two vectors of three."""
    for i in range(3):
        both[i] = first[i]
        both[3 + i] = second[i]


def split(both: Vector, first: Vector, second: Vector) -> None:
    """Two vectors of three of six components."""
    for i in range(3):
        first[i] = both[i]
        second[i] = both[3 + i]


def cross_add(out: Vector, a_x: float, a_y: float, a_z: float, b_x: float, b_y: float, b_z: float) -> None:
    """out += a x b."""
    out[0] = out[0] + a_y * b_z - a_z * b_y
    out[1] = out[1] + a_z * b_x - a_x * b_z
    out[2] = out[2] + a_x * b_y - a_y * b_x


def copy(size: int, to: Vector, v: Vector) -> None:
    """The same values elsewhere."""
    for i in range(size):
        to[i] = v[i]


def clear(size: int, v: Vector) -> None:
    """All values 0."""
    for i in range(size):
        v[i] = 0.0


def add_scaled(size: int, out: Vector, a: Vector, factor: float, b: Vector) -> None:
    """out = a + factor b; out may be a."""
    for i in range(size):
        out[i] = a[i] + factor * b[i]
