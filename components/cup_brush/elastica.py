"""The exact elastica: a straight cantilever under a dead tip force of any direction, tabulated once (Eq. 1 at large y).

In units of the bristle: length L, force E I/L^2. A tip force f stands at the angle beta from the line that presses the
straight bristle in along its axis; the tip is then shortened by e along the axis and lies b beside it. Tables are over
q = sqrt(e) and beta, of q/f and b/q: both are close to linear, from the first touch (f = sqrt(15) q/sin(beta)) through
the Euler load (f = pi^2/4 at beta = 0) to large bends.
"""

from math import asin, cos, pi, sin, sqrt

from ..declare.record import Matrix
from ..library.quadrature import gauss_legendre
from ..library.table import extend, look_up
from .records import Arc, Scratch, State


def arc(theta: float, beta: float, s: Scratch) -> Arc:
    """The elastica whose tangent turns by theta from root to tip, by quadrature over its arc angle phi.

    With k = sin((beta + theta)/2) and sin(phi_0) = sin(beta/2)/k, from theta'' = -f sin(beta + theta):
    sqrt(f) = int dphi/r, r = sqrt(1 - k^2 sin^2 phi), over phi_0 .. pi/2.
    """
    k = sin(0.5 * (beta + theta))
    phi_0 = asin(sin(0.5 * beta) / k)
    w = (0.5 * pi - phi_0) / 16.0
    root_f = 0.0
    along = 0.0
    for panel in range(8):
        for i in range(5):
            sine = k * sin(phi_0 + w * (2 * panel + 1 + s.nodes[i]))
            r = sqrt(1.0 - sine * sine)
            root_f = root_f + w * s.weights[i] / r  # elastica: K(k) - F(phi_0, k)
            along = along + w * s.weights[i] * (1.0 - 2.0 * sine * sine) / r
    along = along / root_f  # elastica: the tip against the force
    across = 2.0 * k * cos(phi_0) / root_f  # elastica: the tip across the force
    return Arc(
        f=root_f * root_f,
        e=1.0 - along * cos(beta) - across * sin(beta),
        b=across * cos(beta) - along * sin(beta),
    )


def bent(q: float, beta: float, s: Scratch) -> Arc:
    """The elastica that is shortened by q^2, by the secant method on q(theta), which is nearly linear."""
    before = 1.94 * q
    theta = 2.0 * q
    a = arc(before, beta, s)
    miss_before = sqrt(a.e) - q
    a = arc(theta, beta, s)
    for _ in range(20):
        miss = sqrt(a.e) - q
        if abs(miss) < 1e-13 or miss == miss_before:
            break
        following = min(theta - miss * (theta - before) / (miss - miss_before), 3.1 - beta)
        before = theta
        miss_before = miss
        theta = following
        a = arc(theta, beta, s)
    return Arc(a.f, a.e, a.b)


def tabulate(x: State, s: Scratch) -> None:
    """Fill the tables: rows q = 0, 0.025 .. 0.7, columns beta = 0, 0.05 .. 1.6, and one more on each side."""
    gauss_legendre(s.nodes, s.weights)
    for j in range(33):
        beta = 0.05 * j
        x.G[1, 1 + j] = sin(beta) / sqrt(15.0)  # elastica: linear bending
        x.H[1, 1 + j] = sqrt(15.0) / 3.0
        for i in range(1, 29):
            q = 0.025 * i
            a = bent(q, beta, s)
            x.G[1 + i, 1 + j] = q / a.f
            x.H[1 + i, 1 + j] = a.b / q
    x.H[1, 1] = 4.0 / pi  # elastica: the buckled column
    extend(x.G, 29, 33)
    extend(x.H, 29, 33)


def compliance(q: float, beta: float, G: Matrix) -> float:
    """q/f."""
    return look_up(G, 40.0 * q, 20.0 * beta, 29, 33)


def sideways(q: float, beta: float, H: Matrix) -> float:
    """b/q."""
    return look_up(H, 40.0 * q, 20.0 * beta, 29, 33)
