"""What a description says of clocks, exactly as it is written; what cannot be run says why."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from fmpy.model_description import ModelVariable
from lxml import etree
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.reading.clocks import ClockVariable, read_clocks, require_clocks, seconds_of
from rovbrush.orchestrator.fmu.reading.details import details_of


def clock(attributes: str, types: str = "") -> ClockVariable:
    root: Any = etree.fromstring(
        f"<fmiModelDescription><TypeDefinitions>{types}</TypeDefinitions><ModelVariables>"
        f'<Clock name="c" valueReference="1" {attributes}/></ModelVariables></fmiModelDescription>'
    )
    stated = root.find("ModelVariables/Clock").get("causality")
    variable = ModelVariable(name="c", valueReference=1, type="Clock", causality=stated)
    return read_clocks([variable], details_of(root))["c"]


@pytest.mark.parametrize(
    ("stated", "interval"),
    [
        ('intervalDecimal="0.1"', "1/10"),
        ('intervalDecimal=" 1e-3 "', "1/1000"),
        ('intervalDecimal="0.016666666666666666"', "0.016666666666666666"),
        ('intervalCounter="1" resolution="60"', "1/60"),
        ('intervalDecimal="0.016667" intervalCounter="1" resolution="60"', "1/60"),
        ('intervalDecimal="0.01666667" intervalCounter="2" resolution="120" supportsFraction="true"', "1/60"),
    ],
)
def test_an_interval_is_exactly_what_is_written(stated: str, interval: str) -> None:
    found = clock(f'causality="input" intervalVariability="constant" {stated}')
    assert (found.interval, found.fault, found.known) == (Fraction(interval), "", Fraction(interval))


def test_a_clock_takes_from_its_declared_type_what_it_does_not_state() -> None:
    types = '<ClockType name="T" intervalVariability="fixed" intervalDecimal="0.5" shiftDecimal="0.25" priority="3"/>'
    found = clock('causality="input" declaredType="T" intervalDecimal="0.125"', types)
    assert (found.variability, found.interval, found.shift) == ("fixed", Fraction(1, 8), Fraction(1, 4))
    assert (found.priority, found.settable) == (3, True)


def test_an_alias_of_a_clock_is_the_same_clock() -> None:
    own = ModelVariable(name="c", valueReference=7, type="Clock", causality="input")
    other = ModelVariable(name="other", valueReference=7, type="Clock", causality="input", alias=own)
    found = read_clocks([own, other], {"c": {"intervalVariability": "countdown"}})
    assert (found["other"].reference, found["other"].name, found["other"].variability) == (7, "other", "countdown")


@pytest.mark.parametrize(
    ("stated", "why"),
    [
        ('causality="input" intervalVariability="constant"', "states no interval"),
        ('causality="input" intervalVariability="constant" intervalDecimal="0"', "its interval is 0 s"),
        ('causality="input" intervalVariability="constant" intervalDecimal="-1"', "its interval is -1 s"),
        ('causality="input" intervalVariability="constant" intervalDecimal="1e300"', "states no interval"),
        ('causality="input" intervalVariability="constant" intervalDecimal="nan"', "states no interval"),
        ('causality="input" intervalVariability="often"', "none that FMI 3.0 knows"),
        ('causality="output" intervalVariability="constant" intervalDecimal="1"', "only an input clock"),
        ('causality="input" intervalVariability="fixed" intervalDecimal="1" shiftDecimal="-1"', "before it"),
        ('causality="input" intervalVariability="constant" intervalDecimal="0.020" intervalCounter="1" resolution="60"',
         "contradict each other"),
    ],
)  # fmt: skip
def test_a_clock_that_cannot_be_run_says_why(stated: str, why: str) -> None:
    found = clock(stated)
    assert why in found.fault
    with pytest.raises(FmuError, match=r"FMU x: clock c: .*; export it again"):
        require_clocks("FMU x", {"c": found})


def test_a_time_that_is_told_as_a_double_is_the_decimal_that_it_means() -> None:
    assert (seconds_of(0.1), seconds_of(1e-9)) == (Fraction(1, 10), Fraction(1, 10**9))
    for value in (float("nan"), float("inf")):
        with pytest.raises(ValueError, match="is no time"):
            seconds_of(value)
