"""Sensors: samples of the truth with their errors, which arrive later and hold until the next.

Symbols are those of README.md, names and units those of records.py.
"""

from math import ceil, floor

from ..declare.record import Vector
from ..library.sampling import first_sample
from .arrival import last_before, show_instant, show_now, show_sample
from .parameters import Parameters
from .records import Channels, Inputs, Outputs, Scratch, State
from .samples import take_due, take_now, without_noise
from .settings import into_vectors
from .truth import find_truth


def setup(p: Parameters, x: State, s: Scratch) -> None:
    """The settings as vectors."""
    into_vectors(p, x, s)


def initialize(t: float, u: Inputs, p: Parameters, x: State, s: Scratch) -> None:
    """Until the first sample arrives, the sensors show the truth of the start, without noise."""
    find_truth(u, p, s)
    begin(t, s.truth, x)


def begin(t: float, truth: Vector, x: State) -> None:
    """No sample has been taken."""
    c = 0
    for k in range(7):
        x.first[k] = 0.0
        if x.period[k] > 0.0:
            x.first[k] = first_sample(t, x.period[k])
        x.next[k] = x.first[k]
        x.before[k] = x.first[k] - 1.0
        for _ in range(int(x.channels[k])):
            x.start[c] = without_noise(k, c, truth[c], x)
            c = c + 1


def tell(shown: Channels, p: Parameters, y: Outputs) -> None:
    """Write what has arrived, with the common gain."""
    y.u_m = p.gain * shown.u
    y.v_m = p.gain * shown.v
    y.w_m = p.gain * shown.w
    y.x_n_m = p.gain * shown.x_n
    y.y_n_m = p.gain * shown.y_n
    y.z_n_m = p.gain * shown.z_n
    y.phi_m = p.gain * shown.phi
    y.theta_m = p.gain * shown.theta
    y.psi_m = p.gain * shown.psi
    y.p_m = p.gain * shown.p
    y.q_m = p.gain * shown.q
    y.r_m = p.gain * shown.r
    for i in range(3):
        y.f_m[i] = p.gain * shown.f[i]
        y.F_tool_m[i] = p.gain * shown.F_tool[i]
        y.M_tool_m[i] = p.gain * shown.M_tool[i]


def outputs(t: float, u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """What the sensors show at t, a sample of this instant included."""
    find_truth(u, p, s)
    look(t, s.truth, s.shown, p, x)
    tell(s.shown, p, y)


def look(t: float, truth: Vector, shown: Vector, p: Parameters, x: State) -> None:
    """All channels at t; nothing is taken."""
    c = 0
    for k in range(7):
        if x.period[k] > 0.0:
            newest = floor((t - x.latency[k]) / x.period[k] + 1e-6)
            show_sample(newest * 1.0, k, c, truth, shown, p, x)
        elif x.latency[k] > 0.0:
            show_instant(t, last_before(t - x.latency[k], k, x), k, c, truth, shown, p, x)
        else:
            show_now(k, c, truth, shown, p, x)
        c = c + int(x.channels[k])


def step(t: float, h: float, u: Inputs, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
    """Take the samples that fall into [t, t + h), with the inputs as they are, and show what arrives meanwhile."""
    find_truth(u, p, s)
    go_on(t, h, s.truth, s.shown, p, x)
    tell(s.shown, p, y)


def go_on(t: float, h: float, truth: Vector, shown: Vector, p: Parameters, x: State) -> None:
    """All sensors. One without a period shows what it does at t: inputs are held over the step, and so is this."""
    c = 0
    for k in range(7):
        if x.period[k] > 0.0:
            take_due(t, h, k, c, truth, p, x)
            newest = ceil((t + h - x.latency[k]) / x.period[k] - 1e-6) - 1.0
            show_sample(min(newest, x.next[k] - 1.0), k, c, truth, shown, p, x)
        else:
            if x.latency[k] > 0.0:
                x.before[k] = last_before(t - x.latency[k], k, x)
                show_instant(t, x.before[k], k, c, truth, shown, p, x)
            else:
                show_now(k, c, truth, shown, p, x)
            take_now(t, k, c, truth, p, x)
        c = c + int(x.channels[k])
