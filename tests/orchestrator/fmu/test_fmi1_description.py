"""What an FMI 1.0 description says, in the words that all versions share."""

from __future__ import annotations

from pathlib import Path

import pytest
from first_fmi import ALONE, first_fmu
from native_build import needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.fmu.attributes import items_of, parse_value
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.fmu.tolerant import rules
from rovbrush.orchestrator.units import conversion

pytestmark = needs_gcc


@pytest.fixture(scope="module")
def first(tmp_path_factory: pytest.TempPathFactory) -> Fmu:
    return Fmu.open(first_fmu(tmp_path_factory.mktemp("fmi1") / "first.fmu"))


def changed(tmp_path: Path, **changes: str) -> Fmu:
    """With the element of a variable written anew."""
    return Fmu.open(first_fmu(tmp_path / "first.fmu", changes={old: new for old, new in changes.values()}))


def test_a_description_as_the_standard_has_it_breaks_no_rule(first: Fmu) -> None:
    assert not first.notes
    assert (first.version, first.description.fmiVersion, first.description.modelName) == (1, "1.0", "first")


def test_causality_and_variability_are_those_of_later_versions(first: Fmu) -> None:
    found = {name: (v.causality, v.variability, v.initial) for name, v in first.variables.items()}
    assert found["u"][:2] == ("input", "continuous")
    assert found["y"] == ("output", "continuous", "calculated")
    assert found["gain"] == ("parameter", "fixed", "exact")
    assert found["bad_at"] == ("parameter", "fixed", "exact")  # causality none
    assert found["calls"] == ("calculatedParameter", "fixed", "calculated")  # no start value
    assert found["v"] == ("local", "continuous", "exact")
    assert found["same_x"] == ("local", "continuous", "calculated")
    assert found["n_out"][:2] == ("output", "discrete")  # no variability: an Integer is not continuous


@pytest.mark.parametrize(
    ("attributes", "value", "expected"),
    [
        ('variability="parameter"', '<Real start="1" fixed="false"/>', ("calculatedParameter", "fixed", "approx")),
        ('variability="parameter" causality="input"', "<Real/>", ("parameter", "fixed", "exact")),
        ('variability="constant"', '<Real start="2"/>', ("local", "constant", "exact")),
        ('variability="constant" causality="input"', '<Real start="2"/>', ("local", "constant", "exact")),
        ('causality="output"', '<Real start="2"/>', ("output", "continuous", "exact")),
        ('causality="output"', '<Real start="2" fixed="false"/>', ("output", "continuous", "approx")),
        ('causality="output" variability="parameter"', "<Real/>", ("output", "discrete", "calculated")),
        ('causality="output" variability="constant"', '<Real start="2"/>', ("output", "constant", "exact")),
    ],
)
def test_what_a_variable_is_follows_from_its_start_value(
    attributes: str, value: str, expected: tuple[str, str, str], tmp_path: Path
) -> None:
    old = '<ScalarVariable name="x0" valueReference="4" variability="parameter"><Real start="0" unit="rad"/>'
    new = f'<ScalarVariable name="x0" valueReference="4" {attributes}>{value}'
    fmu = changed(tmp_path, x0=(old, new))
    v = fmu.variables["x0"]
    assert (v.causality, v.variability, v.initial) == expected
    assert not fmu.notes


def test_declared_types_give_unit_range_and_items(first: Fmu) -> None:
    u = first.variables["u"]
    assert (u.unit, u.min, u.max, u.quantity) == ("rad/s", "-100", "100", "AngularVelocity")
    assert items_of(first.variables["mode_in"]) == {"off": 1, "on": 2, "test": 3}
    assert parse_value(first.variables["mode_in"], "test", "mode_in") == 3
    with pytest.raises(InputError, match="out of range: -100 to 100 rad/s are allowed"):
        parse_value(u, 101.0, "u")


def test_display_units_mean_what_the_description_says(first: Fmu) -> None:
    gain, offset = conversion(first.unit_called("U/min", "u"), first.unit("u"), "u")
    assert gain == pytest.approx(0.10471975511965977, rel=1e-14) and offset == 0.0
    assert conversion(first.unit_called("Grad", "v"), "K", "v") == (1.0, 273.15)


def test_direct_dependencies_are_those_of_the_value_whatever_its_name(first: Fmu) -> None:
    stated = first.feedthrough(unstated=False)
    assert stated["y"] == {"u"} and stated["n_out"] == stated["minus_n"] == {"n_in"}
    assert stated["x"] == stated["minus_x"] == stated["z"] == frozenset()
    assert first.feedthrough()["z"] == set(first.names("input"))  # says nothing


def test_nothing_can_be_read_before_all_is_set(first: Fmu) -> None:
    assert set(first.feedthrough(initial=True).values()) == {frozenset(first.names("input"))}


def test_what_it_can_do_is_read(tmp_path: Path, first: Fmu) -> None:
    assert first.can_vary_step and not first.can_save_state and first.recommended_step is None
    once = first_fmu(tmp_path / "once.fmu", flags='canBeInstantiatedOnlyOncePerProcess="true"')
    assert Fmu.open(once).interface.canBeInstantiatedOnlyOncePerProcess
    fixed = first_fmu(tmp_path / "fixed.fmu", ALONE.replace('StepSize="true"', 'StepSize="false"'))
    assert not Fmu.open(fixed).can_vary_step


@pytest.mark.parametrize(
    ("old", "new", "rule", "words"),
    [
        ('alias="negatedAlias"><Integer/>', 'alias="negatedAlias"><Boolean/>', rules.ALIAS, "minus_n"),
        ("<Name>n_in</Name>", "<Name>gone</Name>", rules.NOWHERE, "'gone' in DirectDependency of n_out"),
        ('fmiVersion="1.0"', 'fmiVersion="1.0.1"', rules.VERSION, "taken for 1.0"),
        ('declaredType="Speed" start="0"', 'declaredType="Fast" start="0"', rules.TYPE, "'Fast' of u"),
        ('variability="parameter"><Real start="1" min="0"/>', 'variability="fixed"><Real start="1" min="0"/>',
         rules.SCHEMA, "The value 'fixed' is not an element of the set"),
    ],
)  # fmt: skip
def test_what_breaks_the_standard_is_noted(old: str, new: str, rule: rules.Rule, words: str, tmp_path: Path) -> None:
    fmu = changed(tmp_path, it=(old, new))
    noted = {note.rule: note for note in fmu.notes}
    assert words in ", ".join(noted[rule].places), [note.found for note in fmu.notes]
