"""A bare FMU as a system: one component, named after its file, run by the FMU's own default experiment."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

from ..clock import duration, instant, require_span, seconds_text
from ..errors import InputError, listed
from ..fmu.fmu import Fmu
from ..toml.file import TomlFile
from .inputs.free_inputs import lacking_starts
from .model import FORMATS

STOP = Fraction(1)  # s, where neither the FMU nor anybody else says how long
STEPS = 500  # of a run, where nobody says how often
ROUNDING = Fraction(1, 10**6)  # relative: by so much a stated step may miss a whole part of the stop


def is_fmu(path: Path) -> bool:
    """Whether a path is that of an FMU, or of the folder of an unpacked one."""
    return path.suffix.lower() == ".fmu" or os.path.isfile(path / "modelDescription.xml")


class FmuFile(TomlFile):
    """The data of a system file that has one FMU in it; `step`, `stop` and `start` come before the FMU's own.

    Raises FmuError for an FMU that cannot be read, InputError for a time that is none.
    """

    def __init__(self, path: Path, step: str = "", stop: str = "", start: str = "") -> None:
        self.path, self.text = path, ""
        fmu = Fmu.open(path)
        self._experiment = fmu.description.defaultExperiment
        self._said: list[str] = []
        begin = (
            instant(start, "--start")
            if start
            else stated_time(getattr(self._experiment, "startTime", None), instant) or Fraction(0)
        )
        own_end = self._stated("stopTime")
        end = instant(stop, "--stop") if stop else own_end
        if end is None or (end <= begin and not stop):
            end = begin + STOP
            why = (
                "states no stop time"
                if own_end is None
                else f"would stop at {seconds_text(own_end)}, before it starts,"
            )
            self._said.append(f'{path.name} {why} and is run for 1 s; --stop "10 s" gives it another')
        require_span(begin, end)
        own = duration(step, "--period") if step else self._own_step(fmu, end - begin)
        if begin:
            of = "" if start else ", as its experiment does"
            self._said.append(f"the run begins at {seconds_text(begin)}{of}")
        component = component_name(path)
        taken = dict(lacking_starts(fmu))
        if taken:
            said = listed(f"{name} = {value if value != '' else json.dumps(value)}" for name, value in taken.items())
            self._said.append(
                f"{path.name} states no start value of inputs: {said}, unless --set or --input gives another"
            )
        if (end - begin) % own and not fmu.can_vary_step:
            end = self._whole(begin, end, own)
        self.notes = {component: tuple(self._said)}
        self.data: dict[str, Any] = {
            "format": FORMATS[-1],
            "description": " ".join((fmu.description.description or "").split()),
            "start_time": _text(begin),
            "stop_time": _text(end),
            "components": {component: {"fmu": str(path.absolute()), "period": _text(own), "inputs": taken}},
        }

    def at(self, needle: str, table: str = "") -> str:
        return f"({self.path.name})"

    def _own_step(self, fmu: Fmu, span: Fraction) -> Fraction:
        """The step of the FMU's experiment, else its fixed internal one, else a 500th of the run."""
        own = stated_step(fmu)
        if own is None or own > span:
            self._said.append(
                f"{self.path.name} states no step{' below its stop' if own else ''} and is asked every "
                f"{seconds_text(span / STEPS)}; --period \"1 ms\" gives it another"
            )  # fmt: skip
            return span / STEPS
        return whole_part(own, span)

    def _whole(self, begin: Fraction, end: Fraction, own: Fraction) -> Fraction:
        """The end of the step in which the run would end."""
        later = begin - (begin - end) // own * own
        self._said.append(f"{seconds_text(end - begin)} is no whole number of steps of {seconds_text(own)}: run to "
                          f"{seconds_text(later)}")  # fmt: skip
        return later

    def _stated(self, name: str) -> Fraction | None:
        """A time of the default experiment; None for none, or for one that is not positive."""
        return stated_time(getattr(self._experiment, name, None))


def component_name(path: Path) -> str:
    """What the only component is called: the file's name, in letters, digits and _."""
    return re.sub(r"\W", "_", path.stem if path.suffix else path.name)


def whole_part(step: Fraction, end: Fraction) -> Fraction:
    """The step that divides the run, where the stated one does up to its rounding."""
    count = round(end / step)
    return end / count if count and abs(end / step - count) <= ROUNDING * count else step


def stated_step(fmu: Fmu) -> Fraction | None:
    """The step of an FMU's default experiment, else its fixed internal one; None where it states neither."""
    experiment = stated_time(getattr(fmu.description.defaultExperiment, "stepSize", None))
    return experiment or stated_time(getattr(fmu.interface, "fixedInternalStepSize", None))


def stated_time(stated: object, read: Callable[[object, str], Fraction] = duration) -> Fraction | None:
    """A time of an experiment; None for none, or for one that `read` does not take, by default a negative one or 0."""
    if stated is None:
        return None
    try:
        return read(str(stated).strip(), "a time")
    except InputError:
        return None


def _text(time: Fraction) -> str:
    return f"{time} s"
