"""How long a system of another tool is run and how often its components communicate, as its files or FMUs say."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import gcd, lcm

from ..clock import duration, instant, require_span, seconds_text
from ..fmu.fmu import Fmu
from .one_fmu import STEPS, STOP, stated_time, whole_part


def stop_of(stated: str, start: Fraction, fmus: Mapping[str, Fmu], name: str, remarks: list[str]) -> Fraction:
    """The stop time that is stated, else the longest of the FMUs' experiments, else 1 s after the start.

    Raises InputError for one that is not after the start.
    """
    if stated:
        end = instant(stated, f"{name}: stop time")
        require_span(start, end)
        return end
    own = [time for fmu in fmus.values() if (time := _own(fmu, "stopTime"))]
    later = [time for time in own if time > start]
    found = max(later, default=start + STOP)
    whose = "its FMUs' experiments end then" if later else "theirs is before the start" if own else "so do its FMUs"
    remarks.append(
        f'{name} states no stop time and is run for {seconds_text(found)} ({whose}); --stop "10 s" gives it another'
    )
    return found


def periods_of(
    fmus: Mapping[str, Fmu], stated: Mapping[str, str], span: Fraction, remarks: list[str]
) -> dict[str, Fraction]:
    """The period of each component: the `stated` one, else the FMU's experiment's, else the shortest of the others,
    else a 500th of the run, which is `span` s long.

    Raises InputError for a time that is none.
    """
    found, open_ = dict[str, Fraction](), list[str]()
    for name, fmu in fmus.items():
        text = stated.get(name)
        own = duration(text, f"component {name}: period") if text else _own(fmu, "stepSize")
        if own is None or (not text and own > span):
            open_.append(name)
        else:
            found[name] = own if text else whole_part(own, span)
    if open_:
        period = min(found.values(), default=span / STEPS)
        remarks.append(
            f'nothing states a step for {", ".join(open_)}: every {seconds_text(period)} is taken; --step "1 ms" or '
            f'--period {open_[0]}="1 ms" gives another'
        )
        found |= dict.fromkeys(open_, period)
    return {name: found[name] for name in fmus}


def whole_stop(start: Fraction, stop: Fraction, periods: Iterable[Fraction], remarks: list[str]) -> Fraction:
    """The first instant at or after the stop at which all components of fixed steps, with these periods, have one."""
    pairs = [period.as_integer_ratio() for period in periods]
    common = Fraction(lcm(*(a for a, _ in pairs)), gcd(*(b for _, b in pairs))) if pairs else stop - start
    later = start - (start - stop) // common * common
    if later == stop:
        return stop
    remarks.append(f"{seconds_text(stop)} is no whole number of steps: the run goes on to {seconds_text(later)}")
    return later


def _own(fmu: Fmu, key: str) -> Fraction | None:
    """A time of an FMU's default experiment; None for none."""
    return stated_time(getattr(fmu.description.defaultExperiment, key, None))
