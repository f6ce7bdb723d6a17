"""Units mean what the file says that they come from; pint's names count where no file defines anything."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from helpers import edited, read_system
from native_build import FREE2, built, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.system.connection import Connection
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.inputs.series import series_of
from rovbrush.orchestrator.units import Definition, Unit, conversion

pytestmark = needs_gcc
TAU = math.tau
INPUT = 'name="u" valueReference="0" causality="input" variability="continuous"><Real'
OUTPUT = 'name="y" valueReference="1" causality="output" variability="continuous"><Real'
DRIVEN = {key: value for key, value in FREE2.items() if key != "=u"}


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


def with_unit(
    native: Path, path: Path, unit: str, base: str | None, more: str = "", declared: bool = False, shown: str = ""
) -> str:
    """A copy of feedthrough2.fmu whose u and y are in a unit, stated by themselves or by their declared type."""
    inner = "" if base is None else f"<BaseUnit {base}/>"
    units = f'<UnitDefinitions><Unit name="{unit}">{inner}{shown}</Unit></UnitDefinitions>'
    types, own = "<TypeDefinitions>", f' unit="{unit}" {more}'
    if declared:
        types, own = f'<TypeDefinitions><SimpleType name="T"><Real{own}/></SimpleType>', ' declaredType="T"'
    changes = {"<TypeDefinitions>": units + types, INPUT: INPUT + own, OUTPUT: OUTPUT + own}
    return str(edited(native / "feedthrough2.fmu", path, {}, changes))


def connected(native: Path, folder: Path, a: str, b: str) -> Connection:
    parts = {"a": (a, "1 ms", FREE2), "b": (b, "1 ms", DRIVEN)}
    return read_system(folder, native, parts, ["a.y -> b.u"]).connections[0]


RAD = 's="-1" rad="1"'
SPEED, KELVIN = ("rad/s", RAD), ("K", 'K="1"')
CELSIUS = ("degC", 'K="1" offset="273.15"')
PER_MINUTE = ("1/min", f's="-1" factor="{1 / 60!r}"')


@pytest.mark.parametrize(
    ("source", "target", "value", "expected"),
    [
        (("ton", 'kg="1" factor="1000"'), ("kg", 'kg="1"'), 10.0, 10000.0),
        (("hp", 'kg="1" m="2" s="-3" factor="735.49875"'), ("W", 'kg="1" m="2" s="-3"'), 10.0, 7354.9875),
        (("U/min", RAD + ' factor="0.10471975511965977"'), SPEED, 10.0, TAU / 6),
        (("1/min", RAD + ' factor="0.10471975511965977"'), SPEED, 10.0, TAU / 6),
        (("Hz", RAD + f' factor="{TAU!r}"'), SPEED, 2.0, 2 * TAU),
        (("Hz", 's="-1"'), PER_MINUTE, 1.0, 60.0),
        (CELSIUS, KELVIN, 20.0, 293.15),
        (KELVIN, CELSIUS, 0.0, -273.15),
        (("degF", f'K="1" factor="{5 / 9!r}" offset="{273.15 - 160 / 9!r}"'), CELSIUS, 212.0, 100.0),
        (("kn", 'm="1" s="-1" factor="0.51444444"'), ("m/s", 'm="1" s="-1"'), 10.0, 5.1444444),
        (("FS", None), ("FS", None), 3.0, 3.0),
        (("ton", 'kg="1" factor="1000"'), ("ton", 'kg="1" factor="907.18474"'), 1.0, 1000 / 907.18474),
        (("rad/s", 's="-1"'), SPEED, 3.0, 3.0),  # many leave out the exponent of rad
        (("rpm", 's="-1" factor="0.104719755119659"'), SPEED, 60.0, TAU),
        (("rev/min", None), SPEED, 60.0, TAU),  # only a name: pint's
        (("km/h", None), ("m/s", 'm="1" s="-1"'), 36.0, 10.0),
        (("l/min", 'm="3" s="-1" factor="1.6666666666666667e-5"'), ("m3/s", 'm="3" s="-1"'), 60.0, 1e-3),
    ],
)
@pytest.mark.parametrize("declared", [False, True])
def test_a_connection_converts_by_the_definitions_of_the_fmus(
    source: tuple[str, str | None], target: tuple[str, str | None], value: float, expected: float, declared: bool,
    native: Path, tmp_path: Path,
) -> None:  # fmt: skip
    a = with_unit(native, tmp_path / "a.fmu", *source, declared=declared)
    b = with_unit(native, tmp_path / "b.fmu", *target, declared=not declared)
    found = connected(native, tmp_path, a, b)
    assert found.gain * value + found.offset == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("source", "target"),
    [
        (PER_MINUTE, SPEED), (("1/s", 's="-1"'), SPEED), (("1/s", None), ("rad/s", None)),
        (("rpm", None), ("1/s", None)),
        (("rpm", RAD + ' factor="0.10471975511965977"'), ("1/s", 's="-1"')), (("Hz", 's="-1"'), ("rad/s", 's="-1"')),
        (("rev/min", f's="-1" factor="{1 / 60!r}"'), SPEED), (("1/s2", 's="-2"'), ("rad/s2", 's="-2" rad="1"')),
    ],
)  # fmt: skip
def test_what_counts_turns_or_says_not_what_does_not_become_an_angle(
    source: tuple[str, str | None], target: tuple[str, str | None], native: Path, tmp_path: Path
) -> None:
    a = with_unit(native, tmp_path / "a.fmu", *source)
    b = with_unit(native, tmp_path / "b.fmu", *target)
    for ends in ((a, b), (b, a)):
        with pytest.raises(InputError) as error:
            connected(native, tmp_path, *ends)
        for words in ("2 pi apart", "write rpm or rev/s", "units = { NAME =", source[0], target[0]):
            assert words in str(error.value)


@pytest.mark.parametrize(("word", "gain"), [("rpm", TAU / 60), ("rad/min", 1 / 60)])
@pytest.mark.parametrize("unit", [PER_MINUTE, ("U/min", None)])
def test_the_word_that_the_message_asks_for_is_taken(
    word: str, gain: float, unit: tuple[str, str | None], native: Path, tmp_path: Path
) -> None:
    a = with_unit(native, tmp_path / "a.fmu", *unit)
    b = with_unit(native, tmp_path / "b.fmu", *SPEED)
    with pytest.raises(InputError, match=r"units = \{"):
        connected(native, tmp_path, a, b)
    path = tmp_path / "case.toml"
    path.write_text(path.read_text().replace("[components.a]", f'[components.a]\nunits = {{ y = "{word}" }}'))
    assert load_system(str(path), native).connections[0].gain == pytest.approx(gain, rel=1e-12)


def test_a_word_that_contradicts_what_the_fmu_says_is_not_taken(native: Path, tmp_path: Path) -> None:
    a = with_unit(native, tmp_path / "a.fmu", *SPEED)
    connected(native, tmp_path, a, a)
    path = tmp_path / "case.toml"
    path.write_text(path.read_text().replace("[components.a]", '[components.a]\nunits = { y = "rpm" }'))
    with pytest.raises(InputError, match=r"a\.fmu states rad/s itself; remove 'rpm'"):
        load_system(str(path), native)


@pytest.mark.parametrize("declared", [False, True])
def test_a_difference_converts_by_the_factor_alone(declared: bool, native: Path, tmp_path: Path) -> None:
    relative = 'relativeQuantity="true"'
    a = with_unit(native, tmp_path / "a.fmu", *CELSIUS, more=relative, declared=declared)
    b = with_unit(native, tmp_path / "b.fmu", *KELVIN, more=relative, declared=not declared)
    found = connected(native, tmp_path, a, b)
    assert (found.gain, found.offset) == (1.0, 0.0)
    absolute = with_unit(native, tmp_path / "c.fmu", *KELVIN)
    with pytest.raises(InputError, match=r"one is a difference in degC .relativeQuantity., the other a value in K"):
        connected(native, tmp_path, a, absolute)


def test_other_dimensions_are_refused_also_by_declared_types(native: Path, tmp_path: Path) -> None:
    a = with_unit(native, tmp_path / "a.fmu", *SPEED, declared=True)
    b = with_unit(native, tmp_path / "b.fmu", "m", 'm="1"', declared=True)
    with pytest.raises(InputError, match="the units do not fit: rad/s cannot become m"):
        connected(native, tmp_path, a, b)


def test_a_heading_means_what_the_fmu_says_also_in_its_display_units(native: Path, tmp_path: Path) -> None:
    shown = '<DisplayUnit name="pace" factor="2" offset="1"/>'
    fmu = Fmu.open(Path(with_unit(native, tmp_path / "a.fmu", "ton", 'kg="1" factor="1000"', shown=shown)))

    def first(unit: str | None) -> float:
        return float(series_of(fmu, "u", [0.0, 1.0], [3.0, 3.0], unit, "", "x").cells[0])

    assert first(None) == first("ton") == 3.0
    assert first("kg") == pytest.approx(3e-3, rel=1e-15)
    assert first("pace") == pytest.approx(1.0, rel=1e-15)  # shown = 2 value + 1


def test_a_name_alone_is_a_difference_where_the_other_is() -> None:
    kelvin = Definition((0, 0, 0, 0, 1, 0, 0, 0))
    assert conversion("degC", Unit("K", kelvin, relative=True), "x") == pytest.approx((1.0, 0.0))
    assert conversion("degC", Unit("K", kelvin), "x") == pytest.approx((1.0, 273.15))
