"""The pace that the options of the command line ask for."""

from __future__ import annotations

from ...errors import InputError
from ...system.request import Request
from .pace import Pace


def pace_of(request: Request) -> Pace | None:
    """None for a run that keeps no pace. Raises InputError for options that mean nothing without one, or at all."""
    if not request.real_time:
        given = {"--realtime-policy": request.realtime_policy, "--deadlines": request.deadlines,
                 "--fifo": request.fifo, "--cores": request.cores}  # fmt: skip
        for option, value in given.items():
            if value:
                raise InputError(f"{option} {value} is for a run in real time; add --real-time")
        return None
    policy = request.realtime_policy or "warn"
    return Pace(factor_of(request.real_time), policy, request.deadlines, *place_of(request))  # type: ignore[arg-type]


def place_of(request: Request) -> tuple[int, tuple[int, ...]]:
    """What is asked of the system: the priority of SCHED_FIFO, and processors. Raises InputError for no numbers."""
    cores = tuple(_whole("--cores", part) for part in request.cores.split(",")) if request.cores else ()
    return (_whole("--fifo", request.fifo) if request.fifo else 0), cores


def factor_of(text: str) -> float:
    """Simulated seconds in a second. Raises InputError for what is no number."""
    try:
        return float(text)
    except ValueError:
        raise InputError(
            f"--real-time {text}: a factor is a number, for instance 2 for twice the speed of the clock on the wall"
        ) from None


def _whole(option: str, text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise InputError(f"{option} {text}: write whole numbers, for instance {option} 1") from None
