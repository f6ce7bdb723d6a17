"""SSPs of other tools become the checked systems that TOML gives."""

from __future__ import annotations

import math
import zipfile
from fractions import Fraction
from pathlib import Path

import pytest
from helpers import edited, last, read_system
from rovbrush.orchestrator.cli.console import print_notes
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from ssp_files import (
    CHAIN,
    GAINS,
    XMLNS,
    Read,
    bindings,
    component,
    connection,
    connectors,
    document,
    inline,
    real,
    system,
    value_set,
    write_ssp_file,
)


def only(found: System) -> tuple[tuple[str, str], tuple[str, str], float, float]:
    """The one connection of a system."""
    (c,) = found.connections
    return c.source, c.target, c.gain, c.offset


def test_a_strangers_ssp_is_the_system_that_toml_gives(read: Read, tmp_path: Path, fmus: Path) -> None:
    found = read(document(CHAIN))
    step = f"{float(found.components['a'].period)!r} s"
    toml = read_system(tmp_path, fmus, {"a": ("gain", step), "b": ("gain", step)}, ["a.y -> b.u"], stop="0.1 s")
    assert found.components.keys() == toml.components.keys()
    for name, expected in toml.components.items():
        assert found.components[name].fmu.digest == expected.fmu.digest
        assert (found.components[name].period, found.components[name].inputs) == (expected.period, expected.inputs)
    assert only(found) == only(toml)
    assert (found.stop, found.name) == (Fraction(1, 10), "stranger")


def test_the_period_is_the_option_else_the_step_size_of_the_fmu(read: Read) -> None:
    assert read(document(CHAIN)).components["a"].period == Fraction(1, 1000)
    assert read(document(CHAIN), step="5 ms").components["a"].period == Fraction(1, 200)


def test_without_any_period_the_shortest_of_the_others_is_taken_else_a_500th_of_the_run(
    tmp_path: Path, fmus: Path
) -> None:
    bare = component("bare", "plain")
    found = load_system(str(write_ssp_file(tmp_path / "a.ssp", fmus, document(system(bare)), ("plain",))))
    assert found.components["bare"].period == Fraction(1, 5000)
    assert "nothing states a step for bare: every 200 us is taken; --step" in found.remarks[0]
    text = document(system(bare + component("a", "gain")))
    found = load_system(str(write_ssp_file(tmp_path / "b.ssp", fmus, text, ("plain", "gain"))))
    assert found.components["bare"].period == found.components["a"].period == Fraction(1, 1000)


def test_the_stop_time_is_the_option_else_that_of_the_file_else_that_of_the_fmus(read: Read) -> None:
    assert read(document(CHAIN), stop="2 s").stop == 2
    found = read(document(CHAIN, experiment=""))
    assert found.stop == 10 and "case.ssp states no stop time and is run for 10 s (its FMUs' exper" in found.remarks[0]
    assert read(document(CHAIN, experiment='stopTime="0.1"')).remarks == ()


def test_a_linear_transformation_is_the_gain_and_offset_of_the_connection(read: Read) -> None:
    linear = '<ssc:LinearTransformation factor="2.5" offset="-1"/>'
    assert only(read(document(system(GAINS, connection("a.y", "b.u", linear)))))[2:] == (2.5, -1.0)


def test_start_and_end_of_a_connection_do_not_state_its_direction(read: Read) -> None:
    assert only(read(document(system(GAINS, connection("b.u", "a.y"))))) == (("a", "y"), ("b", "u"), 1.0, 0.0)


def test_values_go_through_the_connectors_of_nested_systems_and_all_transformations_apply(read: Read) -> None:
    inner = system(
        component("b", "gain"),
        connection("in", "b.u", '<ssc:LinearTransformation factor="3"/>') + connection("b.y", "out"),
        head=connectors(**{"in": "input", "out": "output"}),
        name="inner",
    )
    wires = connection("a.y", "inner.in", '<ssc:LinearTransformation factor="2" offset="1"/>')
    wires += connection("inner.out", "c.u")
    found = read(document(system(component("a", "gain") + inner + component("c", "gain"), wires)))
    by_target = {c.target: c for c in found.connections}
    assert set(found.components) == {"a", "inner_b", "c"}
    into = by_target["inner_b", "u"]
    assert (into.source, into.gain, into.offset) == (("a", "y"), 6.0, 3.0)  # 3 (2 x + 1)
    assert by_target["c", "u"].source == ("inner_b", "y")


def test_units_of_system_connectors_convert_on_the_way(read: Read) -> None:
    """gain.y and gain.u are in 1; a system connector in percent takes 100 times the value and gives it back."""
    inner = system(
        component("b", "gain"), connection("in", "b.u"), head=connectors(**{"in": "input|percent"}), name="inner"
    )
    _, _, gain, offset = only(read(document(system(component("a", "gain") + inner, connection("a.y", "inner.in")))))
    assert math.isclose(gain, 1.0, rel_tol=1e-15) and offset == 0.0
    doubled = '<ssc:LinearTransformation offset="50"/>'  # 50 percent more, in the connector's own unit
    found = read(document(system(component("a", "gain") + inner, connection("a.y", "inner.in", doubled))))
    assert math.isclose(only(found)[3], 0.5, rel_tol=1e-15)


def test_a_unit_is_taken_by_the_definition_of_the_file_where_its_name_says_nothing(read: Read) -> None:
    """`kilopound` of 4448.2216152605 N, for gain.offset in N."""
    units = '<ssc:Unit name="kilopound"><ssc:BaseUnit kg="1" m="1" s="-2" factor="4448.2216152605"/></ssc:Unit>'
    top = system(component("a", "gain", bindings(inline(real("offset", "2", "kilopound")))))
    assert read(document(top, units)).components["a"].parameters == {"offset": pytest.approx(8896.443230521, rel=1e-15)}


def test_suppressed_unit_conversion_leaves_the_transformation_alone(read: Read) -> None:
    inner = system(
        component("b", "gain"),
        connection("in", "b.u", more='suppressUnitConversion="true"'),
        head=connectors(**{"in": "input|percent"}),
        name="inner",
    )
    wire = connection("a.y", "inner.in", more='suppressUnitConversion="true"')
    assert only(read(document(system(component("a", "gain") + inner, wire))))[2:] == (1.0, 0.0)


def test_parameters_of_every_type_are_set_from_a_parameter_set(read: Read) -> None:
    values = real("k", "0.30000000000000004") + real("offset", "2", "kN") + real("weights[2]", "7")
    values += '<ssv:Parameter name="count"><ssv:Integer value="5"/></ssv:Parameter>'
    values += '<ssv:Parameter name="on"><ssv:Boolean value="false"/></ssv:Parameter>' + real("u", "4")
    top = system(component("a", "gain", bindings('<ssd:ParameterBinding source="resources/a.ssv"/>')))
    found = read(document(top), {"resources/a.ssv": value_set(values)}).components["a"]
    assert found.parameters == {"k": 0.1 + 0.2, "offset": 2000.0, "weights[2]": 7.0, "count": 5, "on": False}
    assert found.inputs == {"u": 4.0}


def test_an_array_of_ssp_2_sets_every_element(read: Read) -> None:
    values = value_set(real("weights", "0.5 0.25"), XMLNS, "2.0")
    top = system(component("a", "gain", bindings('<ssd:ParameterBinding source="resources/a.ssv"/>')))
    found = read(document(top, version="2.0"), {"resources/a.ssv": values})
    assert found.components["a"].parameters == {"weights[1]": 0.5, "weights[2]": 0.25}


def test_outer_bindings_go_before_inner_ones_and_later_before_earlier_ones(read: Read) -> None:
    inner = system(
        component("b", "gain", bindings(inline(real("k", "1")))), head=bindings(inline(real("b.k", "2"))), name="inner"
    )
    outer = bindings(inline(real("k", "3"), prefix="inner.b."), inline(real("inner.b.k", "4")))
    assert read(document(system(inner, head=outer))).components["inner_b"].parameters == {"k": 4.0}
    assert read(document(system(inner))).components["inner_b"].parameters == {"k": 2.0}


def test_a_parameter_mapping_renames_transforms_and_drops_what_it_does_not_mention(read: Read) -> None:
    mapping = (
        '<ssm:MappingEntry source="stiffness" target="k"><ssc:LinearTransformation factor="10" offset="1"/>'
        "</ssm:MappingEntry>"
        '<ssm:MappingEntry source="mode" target="count"><ssc:IntegerMappingTransformation>'
        '<ssc:MapEntry source="0" target="4"/></ssc:IntegerMappingTransformation></ssm:MappingEntry>'
    )
    values = real("stiffness", "2") + real("offset", "9")
    values += '<ssv:Parameter name="mode"><ssv:Integer value="0"/></ssv:Parameter>'
    top = system(component("a", "gain", bindings(inline(values, mapping))))
    assert read(document(top)).components["a"].parameters == {"k": 21.0, "count": 4}


def test_parameters_of_a_system_reach_the_components_behind_its_connectors(read: Read) -> None:
    head = connectors(stiffness="parameter", drive="input") + bindings(
        inline(real("stiffness", "5") + real("drive", "2"))
    )
    wires = connection("stiffness", "a.k") + connection("drive", "a.u", '<ssc:LinearTransformation factor="3"/>')
    found = read(document(system(component("a", "gain"), wires, head=head))).components["a"]
    assert (found.parameters, found.inputs) == ({"k": 5.0}, {"u": 6.0})


def test_a_name_that_no_variable_has_is_passed_over_and_told_first_where_one_is_alike(read: Read) -> None:
    values = real("of_another_system", "1") + real("ofset", "1")
    found = read(document(system(component("a", "gain", bindings(inline(values))))))
    assert found.components["a"].parameters == {}
    (remark,) = found.remarks
    assert "parameters ofset (did you mean 'offset'?) (case.ssp/SystemStructure.ssd, line 2), of_another_" in remark


def test_an_ssd_beside_its_fmus_is_read_too(tmp_path: Path, fmus: Path) -> None:
    (tmp_path / "resources").mkdir()
    (tmp_path / "resources" / "gain.fmu").write_bytes((fmus / "gain.fmu").read_bytes())
    (tmp_path / "plant.ssd").write_text(document(CHAIN))
    assert set(load_system(str(tmp_path / "plant.ssd")).components) == {"a", "b"}


def test_a_strangers_ssp_runs(read: Read) -> None:
    """x' = 2 from a gain of 0 with offset 2: x(0.1) = 0.2, up to the rounding of 100 sums."""
    gain = component("a", "gain", bindings(inline(real("k", "0") + real("offset", "2"))))
    found = read(document(system(gain + component("x", "integrator"), connection("a.y", "x.u"))))
    assert last(simulate(make_plan(found)), "x.x") == pytest.approx(0.2, rel=1e-13)


def test_model_exchange_of_an_fmu_that_can_do_both_is_run_in_co_simulation_and_noted(
    tmp_path: Path, fmus: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "both").mkdir()
    both = {"<CoSimulation": '<ModelExchange modelIdentifier="gain"/><CoSimulation'}
    edited(fmus / "gain.fmu", tmp_path / "both" / "gain.fmu", {}, both)
    top = system(
        component("a", "gain", implementation="ModelExchange") + component("b", "gain", implementation="CoSimulation"),
        connection("a.y", "b.u"),
    )
    path = write_ssp_file(tmp_path / "case.ssp", tmp_path / "both", document(top), ("gain",))
    found = load_system(str(path))
    assert found.components["a"].notes == ("a: the SSP wants ModelExchange; the FMU is run in co-simulation",)
    assert found.components["b"].notes == ()
    plain = load_system(str(write_ssp_file(tmp_path / "plain.ssp", fmus, document(CHAIN), ("gain",))))
    assert last(simulate(make_plan(found)), "b.y") == last(simulate(make_plan(plain)), "b.y")
    print_notes(found)
    assert "a: the SSP wants ModelExchange" in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize(
    ("wanted", "notes"),
    [
        ("ModelExchange", ()),
        ("any", ()),
        ("CoSimulation", ("a: the SSP wants CoSimulation; the FMU is run in model exchange",)),
    ],
)
def test_an_fmu_for_model_exchange_alone_is_run_as_one_whatever_is_wanted(
    wanted: str, notes: tuple[str, ...], tmp_path: Path, fmus: Path
) -> None:
    (tmp_path / "alone").mkdir()
    with zipfile.ZipFile(fmus / "gain.fmu") as archive:
        xml = archive.read("modelDescription.xml").decode()
    tag = xml[xml.index("<CoSimulation") : xml.index("/>", xml.index("<CoSimulation")) + 2]
    edited(fmus / "gain.fmu", tmp_path / "alone" / "gain.fmu", {}, {tag: '<ModelExchange modelIdentifier="gain"/>'})
    top = document(system(component("a", "gain", implementation=wanted)))
    found = load_system(str(write_ssp_file(tmp_path / "case.ssp", tmp_path / "alone", top, ("gain",))))
    assert found.components["a"].notes == notes and found.components["a"].fmu.kind == "model-exchange"
