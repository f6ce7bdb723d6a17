"""How far the bending model can be trusted: the exact elastica under a transverse tip load beside the model's statics.

With load number a = P L^2/(E I_zz) and tip slope theta, k^2 = (1 + sin theta)/2 and sin phi = 1/(k sqrt 2) (Bisshopp
and Drucker 1945): sqrt(a) = K(k) - F(phi, k), w/L = 1 - 2/sqrt(a) (E(k) - E(phi, k)), u/L = 1 - sqrt(2 sin theta/a).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

from .beam import shape, slope_integrals
from .references import elastica_tip_load

LIMITS = (0.01, 0.05, 0.10)


@dataclass(frozen=True)
class Bending:
    """Exact and modelled tips over the load number, all (k,) and in units of L: w across, u along the beam.

    `u` is the exact beam's where its deflection is the model's.
    """

    load: np.ndarray
    w: np.ndarray
    u: np.ndarray
    model_w: np.ndarray
    model_u: np.ndarray

    @property
    def deflection_error(self) -> np.ndarray:
        """Of the deflection at equal load; linear bending with or without foreshortening."""
        result: np.ndarray = self.model_w / self.w - 1.0
        return result

    @property
    def linear_tip_error(self) -> np.ndarray:
        """Distance of the linear beam's tip from the exact curve's point of equal deflection, over the deflection."""
        result: np.ndarray = self.u / self.model_w
        return result

    @property
    def foreshortened_tip_error(self) -> np.ndarray:
        """The same for the beam with foreshortening."""
        result: np.ndarray = np.abs(self.u - self.model_u) / self.model_w
        return result

    @property
    def shortening_error(self) -> np.ndarray:
        """Of the foreshortening at equal deflection."""
        result: np.ndarray = np.abs(self.model_u / self.u - 1.0)
        return result


def elastica(theta: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Load number, w/L and u/L of the exact beam for tip slopes theta [rad] in 0 .. pi/2, each (k,)."""
    m = 0.5 * (1.0 + np.sin(theta))  # k^2
    phi = np.arcsin(1.0 / np.sqrt(2.0 * m))
    root = ellipk(m) - ellipkinc(phi, m)
    w = 1.0 - 2.0 / root * (ellipe(m) - ellipeinc(phi, m))
    return root**2, w, 1.0 - np.sqrt(2.0 * np.sin(theta)) / root


def bending(lam: np.ndarray) -> Bending:
    """The model with the eigenvalues `lam`: eta_r = a L Y_r(L)/lam_r^4, s = eta^T G eta/2."""
    exact_load, w, u = elastica(np.linspace(0.01, 1.5, 3000))
    load = np.linspace(0.04, 2.4, 600)  # the model's deflection stays within the exact one's range
    tip = np.array([shape(value, np.ones(1))[0] for value in lam])
    eta = load[:, None] * tip / lam**4
    model_w, model_u = eta @ tip, 0.5 * np.einsum("kr,rs,ks->k", eta, slope_integrals(lam), eta)
    return Bending(load, np.interp(load, exact_load, w), np.interp(model_w, w, u), model_w, model_u)


def leaves_at(error: np.ndarray, deflection: np.ndarray, limit: float) -> float:
    """The model's |y(L)|/L at which an error first reaches `limit`; infinite if it never does."""
    beyond = np.flatnonzero(np.abs(error) >= limit)
    if len(beyond) == 0:
        return np.inf
    k = int(beyond[0])
    if k == 0:
        return float(deflection[0])
    return float(np.interp(limit, np.abs(error[k - 1 : k + 1]), deflection[k - 1 : k + 1]))


def reference_error() -> float:
    """Largest difference in w/L and u/L between the formulas here and the published table."""
    table = elastica_tip_load()
    load, w, u = elastica(np.linspace(0.02, 1.5, 20000))
    apart = (np.interp(table[:, 0], load, w) - table[:, 1], np.interp(table[:, 0], load, u) - table[:, 2])
    return float(np.max(np.abs(apart)))
