"""Numerical integration."""

from math import cos, pi, sqrt

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


def gauss_points(size: int, nodes: Vector, weights: Vector) -> None:
    """As many points of Gauss and Legendre in -1 .. 1, rising, and their weights, by Newton on the polynomial."""
    for i in range(size):
        x = -cos(pi * (i + 0.75) / (size + 0.5))
        slope = 1.0
        for _ in range(8):
            before = 1.0
            value = x
            for k in range(2, size + 1):
                after = ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k
                before = value
                value = after
            slope = size * (x * value - before) / (x * x - 1.0)
            x = x - value / slope
        nodes[i] = x
        weights[i] = 2.0 / ((1.0 - x * x) * slope * slope)
