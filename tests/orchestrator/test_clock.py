"""Time is exact: rational periods, whole ticks, and errors that say what would fit."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rovbrush.orchestrator.clock import duration, make_clock, seconds_text, whole_stops
from rovbrush.orchestrator.errors import InputError


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        (0.005, Fraction(1, 200)), ("5 ms", Fraction(1, 200)), ("250us", Fraction(1, 4000)),
        ("1/60 s", Fraction(1, 60)), (10, Fraction(10)),
        ("1e-3", Fraction(1, 1000)), ("2.5e2 ns", Fraction(1, 4 * 10**6)), (0.1, Fraction(1, 10)),
    ],
)  # fmt: skip
def test_durations_are_read_exactly(text: object, seconds: Fraction) -> None:
    assert duration(text, "period") == seconds


@pytest.mark.parametrize(
    "text",
    [
        "",
        "ms",
        "5 min",
        "-1 ms",
        "0",
        0,
        "1/0 s",
        True,
        "nan",
        float("inf"),
        float("nan"),
        "5 5",
        "1e",
        [1],
        None,
        "1//2",
        "1e30000000 s",
        "1e300 s",
        "1e-999",
        "9" * 5000,
    ],
)
def test_what_is_no_positive_time_is_refused_with_its_name(text: object) -> None:
    with pytest.raises(InputError, match="component a: period"):
        duration(text, "component a: period")


def test_a_number_of_thousands_of_digits_is_no_time() -> None:
    with pytest.raises(InputError, match="a very large number"):
        duration(10**5000, "period")


@given(st.fractions(min_value=Fraction(1, 10**9), max_value=10**4, max_denominator=10**9))
def test_a_time_as_text_reads_back_as_the_same_time(value: Fraction) -> None:
    assert duration(seconds_text(value), "period") == value


def test_a_sixtieth_of_a_second_lives_with_a_millisecond() -> None:
    clock = make_clock({"a": Fraction(1, 60), "b": Fraction(1, 1000)}, Fraction(10))
    assert clock.seconds(clock.periods["a"]) == Fraction(1, 60)
    assert clock.seconds(clock.hyperperiod) == Fraction(1, 20)
    assert clock.stop * clock.seconds(1) == 10
    # The instant of step 600 is 10 s to the last bit, where a sum of rounded steps is not.
    assert clock.time(600 * clock.periods["a"]) == 10.0 != sum([1 / 60] * 600)


def test_three_and_five_milliseconds_have_a_tick_of_one() -> None:
    clock = make_clock({"a": Fraction(3, 1000), "b": Fraction(5, 1000)}, Fraction(3))
    assert (clock.periods, clock.hyperperiod, clock.stop) == ({"a": 3, "b": 5}, 15, 3000)
    assert [clock.time(k) for k in (3, 5, 15)] == [0.003, 0.005, 0.015]


@pytest.mark.parametrize(
    ("period", "start", "stop", "words"),
    [
        ("0.003", "0", "1", "999 ms or 1.002 s"),
        ("1/60", "0", "1/8", "7/60 s or 2/15 s"),
        ("2", "0", "1", "2 s"),
        ("0.3", "-1", "0", "-100 ms or 200 ms"),
    ],
)
def test_stops_that_suit_a_period_are_named(period: str, start: str, stop: str, words: str) -> None:
    assert whole_stops([Fraction(period)], Fraction(start), Fraction(stop)) == words


def test_stops_that_are_named_suit_every_period_at_once() -> None:
    periods = {"a": Fraction(3, 1000), "b": Fraction(5, 1000)}
    assert whole_stops(periods.values(), Fraction(0), Fraction(2)) == "1.995 s or 2.01 s"
    for stop in ("1.995", "2.01"):
        assert make_clock(periods, Fraction(stop)).rest == 0


@given(
    st.fractions(min_value=-10, max_value=10, max_denominator=10**3),
    st.fractions(min_value=Fraction(1, 10**3), max_value=10, max_denominator=10**3),
    st.fractions(min_value=Fraction(1, 10**3), max_value=1, max_denominator=10**3),
)
def test_every_instant_from_any_start_is_the_nearest_double(start: Fraction, span: Fraction, period: Fraction) -> None:
    clock = make_clock({"a": period}, start + span, start)
    whole = int(span / period)
    if whole:
        assert clock.cycles == whole and clock.seconds(clock.rest) == span - whole * period
    else:
        assert clock.seconds(clock.hyperperiod) == span and (clock.cycles, clock.rest) == (1, 0)
    for k in range(min(whole, 5) + 1):
        assert clock.time(k * clock.periods["a"]) == float(start + k * period)
    assert clock.time(clock.stop) == float(start + span)


def test_periods_without_a_countable_tick_are_refused() -> None:
    periods = {f"c{p}": Fraction(1, p) for p in (9_999_991, 9_999_973, 9_999_971)}
    with pytest.raises(InputError, match="no common tick"):
        make_clock(periods, Fraction(1))


@given(
    st.lists(st.fractions(min_value=Fraction(1, 10**4), max_value=1, max_denominator=10**4), min_size=1, max_size=4),
    st.integers(1, 10**6),
)
def test_every_accepted_clock_is_exact(periods: list[Fraction], factor: int) -> None:
    named = {f"c{k}": p for k, p in enumerate(periods)}
    stop = factor * periods[0]
    try:
        clock = make_clock(named, stop)
    except InputError:
        return
    assert all(clock.seconds(clock.periods[name]) == p for name, p in named.items())
    assert clock.seconds(clock.stop) == stop
    assert clock.time(clock.stop) == float(stop)
    # In the loop the same quotient is formed by doubles: both terms must be exact there.
    assert clock.stop * clock.numerator < 2**53 and clock.denominator < 2**53
