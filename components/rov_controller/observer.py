"""A disturbance observer: the wrench that thrust and model leave unexplained, from velocities and commands alone.

In each of six directions M dnu/dt = thrust + w + d with the thrust B F behind its lag, a measured wrench w where there
is one, and d constant but for the correction: a Luenberger observer of (nu, d) with a double pole at omega_observer,
which is the observer of Ohnishi, Shibata and Murakami (1996) with a filter of second order. What the model lacks (drag,
Coriolis, restoring moments, an unknown part of the buoyancy) counts as disturbance.
"""

from math import exp

from ..library.vectors import clear
from .attitude import to_body
from .parameters import Parameters
from .records import Scratch, State


def observe(p: Parameters, x: State, s: Scratch) -> None:
    """One sample on: predict with the mean thrust since the last one, correct by what was measured.

    The errors follow e+ = (1 - l1)(e + g), g+ = g - l2 (e + g) with g = T_s/M of the disturbance's error: both poles
    are at z = exp(-omega_observer T_s) for l1 = 1 - z^2, l2 = (1 - z)^2. In mode 3 d stands for the tool's wrench.
    """
    z = exp(-p.omega_observer * p.T_s)
    keep = 0.0
    lagging = 0.0
    if p.thruster_lag > 0.0:
        keep = exp(-p.T_s / p.thruster_lag)
        lagging = p.thruster_lag / p.T_s * (1.0 - keep)
    clear(6, s.known)
    s.known[2] = -p.net_buoyancy
    to_body(s.known, s.attitude)
    for i in range(6):
        if x.seen == 0.0:
            x.nu_seen[i] = s.nu[i]
        else:
            # The thrust approached what was asked for: its mean over the sample and its value now.
            force = x.given[i] + (x.thrust_seen[i] - x.given[i]) * lagging + s.known[i] + x.d_seen[i]
            x.thrust_seen[i] = x.given[i] + (x.thrust_seen[i] - x.given[i]) * keep
            if p.mode != 3:
                force = force + x.wrench[i]
            predicted = x.nu_seen[i] + p.T_s / p.M_observer[i] * force
            missed = s.nu[i] - predicted
            x.nu_seen[i] = predicted + (1.0 - z * z) * missed  # Ohnishi 1996
            x.d_seen[i] = x.d_seen[i] + (1.0 - z) * (1.0 - z) * p.M_observer[i] / p.T_s * missed  # Ohnishi 1996
        if p.mode == 3:
            x.wrench[i] = x.d_seen[i]
        if p.observed_velocity:
            s.nu[i] = x.nu_seen[i]
    x.seen = 1.0
