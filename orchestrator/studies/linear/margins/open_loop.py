"""An open loop by its frequency response, and how far the closed one is from instability.

Nyquist's plane with -1 as the critical point: negative feedback, whatever signs the loop itself has. Of a loop that is
broken at several places at once these are its characteristic loci, the eigenvalues of L (MacFarlane and Postlethwaite
1977): their margins are of a delay, or a gain, common to all of these places.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Loop:
    """An open loop: frequencies [rad/s], rising, and its complex values there."""

    omega: np.ndarray
    L: np.ndarray

    def crossovers(self) -> list[tuple[float, float]]:
        """Where |L| is 1: frequency [rad/s] and the angle from -1 to L [rad], in -pi..pi; negative: L is behind -1."""
        size, angle = np.log(np.abs(self.L)), np.unwrap(np.angle(-self.L))
        found = []
        for k in np.flatnonzero(np.sign(size[1:]) != np.sign(size[:-1])):
            share = size[k] / (size[k] - size[k + 1])
            omega = float(np.exp(np.log(self.omega[k]) + share * np.log(self.omega[k + 1] / self.omega[k])))
            at = angle[k] + share * (angle[k + 1] - angle[k])
            found.append((omega, float((at + np.pi) % (2.0 * np.pi) - np.pi)))
        return found

    def reversals(self) -> list[tuple[float, float]]:
        """Where L is a negative number: frequency [rad/s] and the factor that brings it to -1."""
        real, imag = self.L.real, self.L.imag
        found = []
        for k in np.flatnonzero(np.sign(imag[1:]) != np.sign(imag[:-1])):
            share = imag[k] / (imag[k] - imag[k + 1])
            crossing = real[k] + share * (real[k + 1] - real[k])
            if crossing < 0.0:
                omega = float(self.omega[k] + share * (self.omega[k + 1] - self.omega[k]))
                found.append((omega, float(-1.0 / crossing)))
        return found

    @property
    def phase_margin(self) -> float:
        """The smallest angle [rad] between L and -1 where |L| is 1; pi if it is nowhere."""
        return min((abs(angle) for _, angle in self.crossovers()), default=np.pi)

    @property
    def delay_margin(self) -> float:
        """The shortest further delay [s] that brings L to -1; infinite if |L| is nowhere 1."""
        return self.delay_crossing[1]

    @property
    def delay_crossing(self) -> tuple[float, float]:
        """Where L comes to -1 by the shortest further delay: frequency [rad/s], nan if it is nowhere, and delay [s]."""
        delays = [((angle % (2.0 * np.pi)) / omega, omega) for omega, angle in self.crossovers()]
        delay, omega = min(delays, default=(np.inf, np.nan))
        return omega, delay

    @property
    def gain_margin(self) -> float:
        """The smallest factor above 1 that brings L to -1; infinite if there is none among the frequencies."""
        return min((factor for _, factor in self.reversals() if factor > 1.0), default=np.inf)

    @property
    def gain_reduction(self) -> float:
        """The largest factor below 1 that brings L to -1; 0 if there is none: less gain does no harm then."""
        return max((factor for _, factor in self.reversals() if factor < 1.0), default=0.0)

    @property
    def distance(self) -> float:
        """The least distance from L to -1, which is 1 over the peak of the sensitivity."""
        return float(np.min(np.abs(1.0 + self.L)))


def loci(matrices: np.ndarray) -> np.ndarray:
    """Eigenvalues (frequencies, q) of matrices (frequencies, q, q), each column following one of them."""
    from scipy.optimize import linear_sum_assignment

    found = np.linalg.eigvals(matrices)
    for k in range(1, len(found)):
        apart = np.abs(found[k - 1][:, None] - found[k][None, :])
        found[k] = found[k][linear_sum_assignment(apart)[1]]
    return found
