"""Numerical integration."""

from math import sqrt

from ..declare.record import Vector


def gauss_legendre(nodes: Vector, weights: Vector) -> None:
    """The five points of Gauss and Legendre in -1 .. 1, and their weights."""
    a = sqrt(10.0 / 7.0)
    b = sqrt(70.0)
    nodes[0] = 0.0
    nodes[1] = sqrt(5.0 - 2.0 * a) / 3.0
    nodes[2] = -nodes[1]
    nodes[3] = sqrt(5.0 + 2.0 * a) / 3.0
    nodes[4] = -nodes[3]
    weights[0] = 128.0 / 225.0
    weights[1] = (322.0 + 13.0 * b) / 900.0
    weights[2] = weights[1]
    weights[3] = (322.0 - 13.0 * b) / 900.0
    weights[4] = weights[3]
