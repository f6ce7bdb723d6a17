"""What is varied has the type of its variable: real numbers are drawn as such in FMI 3.0 too, whole ones exactly."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest
import xarray
from native_build import NUMBERS3, built, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.studies.sweep.design.design import Design, make_design, vary_entries
from rovbrush.orchestrator.studies.sweep.options import Options
from rovbrush.orchestrator.studies.sweep.sweep import sweep
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

pytestmark = needs_gcc
REALS = ("Float64", "Float32")
WHOLES = tuple(name for name in NUMBERS3 if name not in REALS)
BIG = 2**53 + 1  # an item of the enumeration, and no double


@pytest.fixture(scope="module")
def fmu(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native")) / "feedthrough3.fmu"


@pytest.fixture(scope="module")
def system(fmu: Path) -> System:
    return load_system(str(fmu))


def values(system: System, vary: str, **keys: object) -> tuple[object, ...]:
    return design(system, vary, **keys).axes[0].values


def design(system: System, vary: str, **keys: object) -> Design:
    return make_design(system, vary_entries([vary]), **keys)  # type: ignore[arg-type]


@pytest.mark.parametrize("sampler", ["random", "latin", "sobol"])
@pytest.mark.parametrize("kind", REALS)
def test_real_numbers_are_drawn_for_every_floating_type(kind: str, sampler: str, system: System) -> None:
    drawn = values(system, f"{kind}_in=0:1", count=8, sampler=sampler)
    assert len(set(drawn)) == 8 and all(isinstance(v, float) and 0.0 < v < 1.0 for v in drawn)


@pytest.mark.parametrize("sampler", ["random", "latin", "sobol"])
@pytest.mark.parametrize("kind", WHOLES)
def test_whole_numbers_are_drawn_for_every_integer_and_reach_both_ends(kind: str, sampler: str, system: System) -> None:
    drawn = values(system, f"{kind}_in=1:3", count=64, sampler=sampler)
    assert set(drawn) == {1, 2, 3} and all(isinstance(v, int) for v in drawn)


@pytest.mark.parametrize(
    ("vary", "expected"),
    [
        ("Int64_in=9007199254740993:9007199254740997:3", (BIG, BIG + 2, BIG + 4)),
        ("UInt64_in=18446744073709551613:18446744073709551615:3", (2**64 - 3, 2**64 - 2, 2**64 - 1)),
        ("Int8_in=-128:127:2", (-128, 127)),
        ("Int16_in=1:1000:4:log", (1, 10, 100, 1000)),
        ("Boolean_in=false:true:2", (False, True)),
        ("Boolean_in=true,false", (True, False)),
        ("Enumeration_in=off,big", (1, BIG)),
        ("Enumeration_in=off:big:2", (1, BIG)),
        ("String_in=C:/a,b", ("C:/a", "b")),
    ],
)
def test_values_of_a_grid_are_exact_in_their_own_type(vary: str, expected: tuple[object, ...], system: System) -> None:
    seen = values(system, vary)
    assert seen == expected and [type(v) for v in seen] == [type(v) for v in expected]


def test_large_whole_numbers_are_drawn_from_their_whole_range(system: System) -> None:
    drawn = np.array(values(system, f"UInt64_in={2**63}:{2**64 - 1}", count=64), dtype=np.uint64)
    assert len(set(drawn.tolist())) == 64 and drawn.min() >= 2**63 and np.any(drawn % np.uint64(1024))
    spread = values(system, "UInt64_in=1:1000000:log", count=400)
    assert 0.3 < np.mean(np.array(spread) <= 1000) < 0.7, "half of them in the lower half of the decades"


def test_an_enumeration_is_drawn_among_its_items(system: System) -> None:
    assert set(values(system, "Enumeration_in=off:big", count=32)) == {1, BIG}
    assert set(values(system, "Enumeration_in=off:big", count=32, sampler="sobol")) == {1, BIG}


def test_ends_of_a_grid_are_what_was_written(system: System) -> None:
    low, high = 1.0 / 3.0, 2.0 / 3.0
    seen = values(system, f"Float64_in={low!r}:{high!r}:3")
    assert (seen[0], seen[1], seen[2]) == (low, 0.5, high)


def test_values_and_ends_may_have_a_unit(fmus: Path) -> None:
    brush = load_system(str(fmus / "filament_brush.fmu"))
    assert values(brush, "delta=3 mm:7mm:3") == (0.003, 0.005, 0.007)
    assert values(brush, "delta=3 mm,0.004") == (0.003, 0.004)


@pytest.mark.parametrize(
    ("vary", "message"),
    [
        ("Int8_in=0:10:4", "4 values from 0 to 10 are no whole numbers; 3 values are"),
        ("Int8_in=0.5:3.5:4", r"'0\.5' is no whole number"),
        ("Int8_in=0:1000:11", r"Int8_in = 200 is out of range: -128 to 127 are allowed"),
        ("Enumeration_in=off:bigg:2", "'bigg' is no item of the enumeration; did you mean 'big'"),
        ("Enumeration_in=off,2", "2 is none of the items of the enumeration: off"),
        ("Boolean_in=0:2:3", "'2' is not true or false"),
        ("blob=00,ff", "it is of type Binary, which is not varied"),
        ("time=1,2", "of causality independent and cannot be set"),
        ("Float64_in=1 mm:2 mm:3", "states no unit for it; give the number alone"),
        ("Float64_im=1:2:3", "did you mean 'feedthrough3.Float64_in'"),
    ],
)
def test_what_a_variable_cannot_be_is_one_clear_error(vary: str, message: str, system: System) -> None:
    with pytest.raises(InputError, match=message):
        design(system, vary)


def test_a_sweep_of_an_fmu_alone_gathers_the_last_value_of_every_output(fmu: Path, tmp_path: Path) -> None:
    options = Options(["Enumeration_in=off,big"], {"UInt8_in": "7"}, "10 ms", workers=1)
    result = sweep(str(fmu), tmp_path, options).require_all()
    assert result["UInt8_out_last"].values.tolist() == [7.0, 7.0] and "String_out_last" not in result
    with xarray.open_dataset(tmp_path / "sweep.nc", decode_cf=False) as stored:
        axis = stored["feedthrough3.Enumeration_in"]
        assert axis.values.tolist() == [1, BIG] and axis.attrs["flag_meanings"] == "off big"


def test_a_sweep_file_may_name_an_fmu_and_its_variables_without_a_prefix(fmu: Path, tmp_path: Path) -> None:
    lines = [f'system = "{fmu}"', 'stop_time = "10 ms"', "[vary]", "Int32_in = [-1, 5]", "[summary]"]
    (tmp_path / "s.toml").write_text("\n".join([*lines, 'n = "max Int32_out"', 'm = "peak Float64_out"']))
    result = sweep(str(tmp_path / "s.toml"), tmp_path, Options(workers=1)).require_all()
    assert result.n.values.tolist() == [-1.0, 5.0] and set(result.data_vars) == {"n", "m", "error"}


def test_whole_numbers_stay_whole_beyond_the_digits_of_a_float(fmu: Path, tmp_path: Path) -> None:
    lines = [f'system = "{fmu}"', 'stop_time = "10 ms"', "[vary]", f"Int64_in = [{BIG}, {BIG + 2}]", "[summary]"]
    (tmp_path / "s.toml").write_text("\n".join([*lines, 'n = "last Int64_out"', 'x = "mean Int64_out"']))
    result = sweep(str(tmp_path / "s.toml"), tmp_path / "out", Options(workers=1)).require_all()
    assert result.n.values.tolist() == [BIG, BIG + 2]
    rows = list(csv.DictReader((tmp_path / "out" / "sweep.csv").read_text().splitlines()))
    assert [row["n [1]"] for row in rows] == [str(BIG), str(BIG + 2)] and rows[0]["x [1]"] == repr(float(BIG))


def test_what_is_set_and_varied_by_two_names_is_an_error(fmu: Path, tmp_path: Path) -> None:
    for vary, given in (("Int8_in", "feedthrough3.Int8_in"), ("feedthrough3.Int8_in", "Int8_in")):
        with pytest.raises(InputError, match=r"--set feedthrough3\.Int8_in: it is varied"):
            sweep(str(fmu), tmp_path / "out", Options([f"{vary}=1,2"], {given: "3"}, "10 ms", workers=1))
    (tmp_path / "p.csv").write_text("Int8_in\n1\n")
    with pytest.raises(InputError, match=r"--set feedthrough3\.Int8_in: it is varied"):
        sweep(str(fmu), tmp_path / "out", Options((), {"Int8_in": "3"}, "10 ms", points=tmp_path / "p.csv"))


def test_a_figure_of_merit_of_a_text_is_refused_before_anything_is_run(fmu: Path, tmp_path: Path) -> None:
    lines = [f'system = "{fmu}"', 'stop_time = "10 ms"', "[vary]", "Int32_in = [-1, 5]", "[summary]"]
    (tmp_path / "s.toml").write_text("\n".join([*lines, 's = "last String_out"']))
    with pytest.raises(InputError, match=r"summary s = .*: 'feedthrough3\.String_out' is a text; name a number"):
        sweep(str(tmp_path / "s.toml"), tmp_path / "out", Options(workers=1))
    assert not (tmp_path / "out").exists()
