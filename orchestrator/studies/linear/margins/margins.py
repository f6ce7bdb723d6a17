"""Margins of loops of a system that runs, broken at connections, sampled as they are.

At the break something is added for a sample, and what then arrives there is watched. Broken at a connection
`a.y -> b.u`, the response is that of what b takes during each sample, in which master, holds and samplers are: with S
from what is added to what b takes, L = 1/S - 1 at z = exp(i omega T). Broken where a free input is added to an output
inside of an FMU, `a.y + a.u` (a force beside the one that a controller commands), the output is continuous and what is
added is held over a sample: with G from what is added to the output and H = (1 - exp(-i omega T))/(i omega T), the
hold, L = -G/(G + H). Both in negative feedback: where L is -1 the loop oscillates.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import ceil

import numpy as np

from ....clock import instant
from ....errors import InputError
from ....plan.plan import make_plan
from ....system.model import System
from ..channels import Channel, channels_of, connections_of, signals_of
from ..linearise import realised
from ..operating import ticks_of
from ..options import Options, hyperperiod_of
from ..points import Point, points
from ..probe import Probe
from ..statespace import Linear
from .delayed import DelayedLoop, InTime, in_time, longest_run
from .open_loop import Loop, loci

FREQUENCIES = 1500
SLOWEST = 0.5  # rad over the length of a response: what it still shows


@dataclass(frozen=True)
class Break:
    """Where loops are broken: what is added, and what is watched for each; `sums`: at free inputs, not connections."""

    names: tuple[str, ...]
    channels: tuple[Channel, ...]
    signals: tuple[str, ...]
    sums: bool


@dataclass(frozen=True)
class Margins:
    """A broken loop at one time: its loci, `closed` (the closed loop from what is added to what is watched)."""

    broken: Break
    closed: Linear
    loops: tuple[Loop, ...]
    response: int  # samples
    in_time: InTime | None = None  # what runs say of the smallest delay margin, where they were asked

    @property
    def at(self) -> float:
        """The time of the operating point [s]."""
        return self.closed.at

    @property
    def least_delay(self) -> Loop:
        """The locus with the smallest delay margin."""
        return min(self.loops, key=lambda loop: loop.delay_margin)

    def content(self) -> dict[str, object]:
        """Ready for JSON: angles in radians, times in seconds."""
        return {
            "at": self.at, "break": list(self.broken.names), "sample": self.closed.dt,
            "loci": [
                {"phase_margin": loop.phase_margin, "gain_margin": loop.gain_margin,
                 "gain_reduction": loop.gain_reduction, "delay_margin": loop.delay_margin,
                 "distance": loop.distance, "crossovers": [omega for omega, _ in loop.crossovers()],
                 "omega": loop.omega.tolist(), "real": loop.L.real.tolist(), "imag": loop.L.imag.tolist()}
                for loop in self.loops
            ],
            "closed": self.closed.content(), **({"verified": self.in_time.content()} if self.in_time else {}),
        }  # fmt: skip


def breaks_of(system: System, names: Sequence[str]) -> Break:
    """What `a.y -> b.u` or `a.y + a.u` mean, arrays element by element. Raises InputError where there is none."""
    if not names:
        example = system.connections[0].label if system.connections else "a.y -> b.u"
        raise InputError(f'--break: name the connection at which the loop is broken, for instance "{example}"')
    channels: list[Channel] = []
    signals: list[str] = []
    kinds = set()
    for name in names:
        kinds.add("->" in name)
        if "->" in name:
            connections_of(system, name, "--break")
            found = channels_of(system, [name], "--break")
            channels += found
            signals += [channel.target for channel in found]
            continue
        output, plus, free = (part.strip() for part in name.partition(" + "))
        if not plus:
            raise InputError(
                f'--break {name}: write a connection, "a.y -> b.u", or an output and the free input that is added to '
                'it inside of its FMU, "a.y + a.u"'
            )
        watched, added = signals_of(system, [output], "--break"), channels_of(system, [free], "--break")
        if len(watched) != len(added):
            raise InputError(f"--break {name}: {output} has {len(watched)} elements, and {free} {len(added)}")
        channels += added
        signals += watched
    if len(kinds) > 1:
        raise InputError("--break: break loops at connections, or at free inputs, not at both at once")
    return Break(tuple(names), tuple(channels), tuple(signals), False in kinds)


def margins(
    system: System, names: Sequence[str], options: Options = Options(),  # noqa: B008
    progress: Callable[[float], None] = lambda _share: None,
) -> list[Margins]:  # fmt: skip
    """The margins at all times of `options.at`, rising. Raises InputError and RunError as `linearise` does, InputError
    for a loop that is broken where there is none."""
    broken = breaks_of(system, names)
    found = points(system, broken.channels, broken.signals, options, not broken.sums, progress)
    return [_margins(system, broken, point, options.order) for point in found]


def verified(
    system: System, found: Sequence[Margins], progress: Callable[[float], None] = lambda _share: None
) -> list[Margins]:
    """What `margins` found of a system, with what runs say of the delay margins there are. Raises RunError."""
    broken, asked = found[0].broken, [k for k, each in enumerate(found) if np.isfinite(each.least_delay.delay_margin)]
    every = round(found[0].closed.dt / float(hyperperiod_of(make_plan(system))))
    longest = max((longest_run(found[k].least_delay) for k in asked), default=0.0)
    longer = replace(system, stop=system.stop + Fraction(ceil(longest)))
    verified = list(found)
    with Probe(longer, broken.channels, broken.signals, every) as probe:
        for count, k in enumerate(asked):
            each, loop = found[k], found[k].least_delay
            probe.session.finish(until_tick=ticks_of(probe.plan.clock, system.start, instant(each.at, "--at")))
            probe.require_alive()
            delayed = DelayedLoop(probe, broken.sums, each.closed.notes["sizes"])
            with probe.keep() as here:
                share = lambda part, count=count: progress((count + part) / len(asked))  # noqa: E731
                omega, margin = loop.delay_crossing
                verified[k] = replace(each, in_time=in_time(delayed, here, margin, omega, share))
                probe.back(here)
    return verified


def _margins(system: System, broken: Break, point: Point, order: int | None) -> Margins:
    added = [channel.name for channel in broken.channels]
    closed = realised(point, added, broken.signals, [c.unit for c in broken.channels], system, order)
    count = len(point.pulses.values)
    omega = np.geomspace(SLOWEST / (count * point.dt), np.pi / point.dt, FREQUENCIES)
    L = open_loop(closed, omega, broken.sums)
    if not np.any(np.abs(L) > 1e-9):
        raise InputError(
            f"--break {', '.join(broken.names)}: nothing comes back of what is added there: no loop goes through it"
        )
    return Margins(broken, closed, tuple(Loop(omega, locus) for locus in loci(L).T), count)


def open_loop(closed: Linear, omega: np.ndarray, sums: bool) -> np.ndarray:
    """L (frequencies, q, q) from the closed loop at its break; see above."""
    found = closed.response(omega)
    identity = np.eye(found.shape[1])
    if not sums:
        loop: np.ndarray = np.linalg.inv(found) - identity
        return loop
    x = 1j * omega * closed.dt
    hold = (1.0 - np.exp(-x)) / x
    broken: np.ndarray = -found @ np.linalg.inv(found + hold[:, None, None] * identity)
    return broken
