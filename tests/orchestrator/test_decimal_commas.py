"""A decimal comma is an error that says how the number is written."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import plan_of
from rovbrush.orchestrator.clock import instant
from rovbrush.orchestrator.errors import InputError, point_wanted
from rovbrush.orchestrator.system.inputs.series_file import with_files


@pytest.mark.parametrize(
    ("text", "said"),
    [("0,004", "0.004"), (" -1,5", "-1.5"), ("1,5 s", "1.5 s"), ("1,2,3", "1.2,3"), ("a,b", ""), ("1.5", ""), ("", ""),
     (0.5, ""), (None, ""), ("1," + 9999 * "5", "1." + 78 * "5" + "...")],
)  # fmt: skip
def test_it_is_named_where_it_stands_between_digits(text: object, said: str) -> None:
    assert point_wanted(text) == (f"; a decimal point is wanted: {said}" if said else "")


def test_a_number_of_thousands_of_digits_has_none() -> None:
    assert point_wanted(10**5000) == ""


def test_times_say_so() -> None:
    with pytest.raises(InputError, match=r"--stop = '1,5 s' is not a time; .* a decimal point is wanted: 1\.5 s$"):
        instant("1,5 s", "--stop")


def test_values_say_so(tmp_path: Path, fmus: Path) -> None:
    system = plan_of(tmp_path, fmus, {"a": ("integrator", "10 ms", {"=u": 1.0})}).system
    with pytest.raises(InputError, match=r"a\.u = 0,004 is not a finite number; a decimal point is wanted: 0\.004$"):
        system.with_values({"a.u": "0,004"}, "--set")
    with pytest.raises(InputError, match=r"a\.u = a very large number is not a finite number$"):
        system.with_values({"a.u": 10**5000}, "values")


def test_tables_of_inputs_say_so(tmp_path: Path, fmus: Path) -> None:
    system = plan_of(tmp_path, fmus, {"a": ("integrator", "10 ms", {"=u": 1.0})}).system
    table = tmp_path / "in.csv"
    table.write_text('time,a.u\n0,"1,5"\n', encoding="utf-8")
    with pytest.raises(InputError, match=r"line 2: a\.u = '1,5' is not a number; a decimal point is wanted: 1\.5$"):
        with_files(system, [table])
