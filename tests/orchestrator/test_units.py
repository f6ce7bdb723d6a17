"""Unit strings as FMUs write them: what they mean, and that strange ones are an error at once."""

from __future__ import annotations

import pytest
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.units import conversion


@pytest.mark.parametrize(
    ("source", "target", "gain"),
    [
        ("Nm", "N.m", 1.0),  # not the textile unit of that name
        ("kNm", "N.m", 1e3),
        ("m/s/s", "m/s2", 1.0),
        ("J/kg/K", "J/(kg.K)", 1.0),
        ("J/kg.K", "J/(kg.K)", 1.0),
        ("N.m/(rad/s)", "N.m.s", 1.0),
        ("(m/s)2", "m2/s2", 1.0),
        ("W/(m2.K)", "W.m-2.K-1", 1.0),
        ("V/Hz0.5", "V.s0.5", 1.0),
        ("m^2", "m**2", 1.0),
        ("-", "1", 1.0),
        ("", "%", 100.0),
        ("rev/min", "rpm", 1.0),
        ("kilogram * meter / second ** 2", "N", 1.0),  # as pint writes it
        ("1 / second", "1/s", 1.0),
    ],
)
def test_spellings_of_a_unit_mean_the_same(source: str, target: str, gain: float) -> None:
    assert conversion(source, target, "x") == pytest.approx((gain, 0.0), rel=1e-12)


@pytest.mark.parametrize(("source", "target"), [("m/s/s", "m"), ("Nm", "m"), ("C", "degC"), ("J/kg/K", "J.K/kg")])
def test_units_of_other_dimensions_are_refused(source: str, target: str) -> None:
    with pytest.raises(InputError, match="the units do not fit"):
        conversion(source, target, "x")


def test_a_logarithmic_unit_is_refused_where_it_would_need_more_than_gain_and_offset() -> None:
    with pytest.raises(InputError, match="dB and 1 are not proportional"):
        conversion("dB", "1", "x")


@pytest.mark.parametrize(
    "unit",
    [
        "9**9**9**9", "m**9**9**9", "m(9)(9)", "2.m", "1e400", "m" * 65, "m1 " * 21 + "!", "(" * 40, "__import__('os')",
        "m99999999", "/", "..", "m;s",
    ],
)  # fmt: skip
def test_what_is_no_unit_is_refused_without_being_computed(unit: str) -> None:
    with pytest.raises(InputError, match="is not understood"):
        conversion(unit, "1", "x")
