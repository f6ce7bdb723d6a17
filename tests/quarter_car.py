"""The quarter car by matrix exponentials: the undivided system, and its two units with inputs held over steps."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from scipy.linalg import expm

REFERENCE = json.loads((Path(__file__).parent / "reference" / "quarter_car.json").read_text())
M_C, M_W, K_C, K_W, ROAD = (REFERENCE[key] for key in ("m_c", "m_w", "k_c", "k_w", "road_step_m"))


def exact(times: np.ndarray, d_c: float = REFERENCE["d_c"]) -> dict[str, np.ndarray]:
    """z_c, v_c, z_w, v_w of the undivided system."""
    A = np.zeros((5, 5))  # z_c, v_c, z_w, v_w, 1
    A[0, 1] = A[2, 3] = 1.0
    A[1, :4] = np.array([-K_C, -d_c, K_C, d_c]) / M_C
    A[3] = np.array([K_C, d_c, -K_C - K_W, -d_c, K_W * ROAD]) / M_W
    values, vectors = np.linalg.eig(A)
    start = np.linalg.solve(vectors, np.array([0.0, 0.0, 0.0, 0.0, 1.0]))
    states = (np.exp(np.outer(times, values)) * start) @ vectors.T
    return dict(zip(("z_c", "v_c", "z_w", "v_w"), states.real.T, strict=False))


def energy_made_by_holding(step: float, steps: int, d_c: float = REFERENCE["d_c"]) -> float:
    """Energy [J] that appears in chassis, springs, wheel and damper when both inputs are held over every step.

    Each unit is solved exactly over a step; the dissipation by Gauss-Legendre quadrature of 24 nodes per step, far
    below rounding for steps of some milliseconds.
    """
    A = np.zeros((5, 5))  # height of the chassis as the wheel knows it, z_w, v_w; held v_c; 1
    A[0, 3] = A[1, 2] = 1.0
    A[2] = np.array([K_C, -K_C - K_W, -d_c, d_c, K_W * ROAD]) / M_W
    nodes, weights = np.polynomial.legendre.leggauss(24)
    to_nodes = [expm(A * step * (x + 1.0) / 2.0) for x in nodes]
    whole = expm(A * step)
    wheel, z_c, v_c, lost = np.array([0.0, 0.0, 0.0, 0.0, 1.0]), 0.0, 0.0, 0.0
    force = 0.0
    for _ in range(steps):
        wheel[3] = v_c
        slips = np.array([v_c - (P @ wheel)[2] for P in to_nodes])
        lost += d_c * float(weights @ slips**2) * step / 2.0
        wheel = whole @ wheel
        a = -force / M_C
        z_c, v_c = z_c + step * v_c + step * step * a / 2.0, v_c + step * a
        force = K_C * (wheel[0] - wheel[1]) + d_c * (wheel[3] - wheel[2])
    stored = M_C * v_c**2 + K_C * (wheel[0] - wheel[1]) ** 2 + M_W * wheel[2] ** 2 + K_W * (wheel[1] - ROAD) ** 2
    return float(stored / 2.0 + lost - K_W * ROAD**2 / 2.0)
