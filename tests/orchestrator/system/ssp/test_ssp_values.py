"""Values that parameter sets of other tools hold: of what, by which names, in which units."""

from __future__ import annotations

from pathlib import Path

import pytest
from cells_fmu import cells, scalar
from native_build import needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.ssp.files import rules
from ssp_files import (
    Read,
    bindings,
    component,
    connection,
    connectors,
    document,
    inline,
    real,
    system,
    write_ssp_file,
)  # fmt: skip

WIRE = connection("a.y", "b.u")


def broken(found: System) -> list[object]:
    return [note.rule for note in found.breaches]


def bound(*entries: str) -> str:
    return system(component("a", "gain", bindings(*entries)))


def test_a_value_of_a_driven_input_is_its_drivers_affair(read: Read) -> None:
    """SSP gives start values to inputs that are connected too; the connection decides."""
    inner = component("b", "gain", bindings(inline(real("u", "1") + real("k", "2"))))
    found = read(document(system(component("a", "gain") + inner, WIRE)))
    assert (found.components["b"].inputs, found.components["b"].parameters) == ({}, {"k": 2.0}) and not found.breaches


def test_values_of_what_the_fmu_computes_are_noted_and_not_set(read: Read) -> None:
    found = read(document(bound(inline(real("y", "1") + real("k", "3")))))
    assert found.components["a"].parameters == {"k": 3.0} and broken(found) == [rules.NOT_SETTABLE]


@pytest.mark.parametrize(
    "entry", ['<ssm:MappingEntry source="" target="k"/>', '<ssm:MappingEntry source="x" target=""/>']
)
def test_an_entry_of_a_mapping_without_a_source_or_a_target_is_noted(entry: str, read: Read) -> None:
    mapping = entry + '<ssm:MappingEntry source="x" target="offset"/>'
    found = read(document(bound(inline(real("x", "1.5") + real("k", "3"), mapping))))
    assert found.components["a"].parameters == {"offset": 1.5} and broken(found) == [rules.EMPTY]


@pytest.mark.parametrize("mapping", ['<ssd:ParameterMapping source=""/>', "<ssd:ParameterMapping/>"])
def test_a_mapping_of_nothing_leaves_names_as_they_are(mapping: str, read: Read) -> None:
    entry = inline(real("k", "3")).replace("</ssd:ParameterBinding>", f"{mapping}</ssd:ParameterBinding>")
    found = read(document(bound(entry)))
    assert found.components["a"].parameters == {"k": 3.0} and rules.EMPTY in broken(found)


def test_an_empty_source_of_a_binding_is_its_content(read: Read) -> None:
    entry = inline(real("k", "3")).replace("<ssd:ParameterBinding ", '<ssd:ParameterBinding source="" ')
    assert read(document(bound(entry))).components["a"].parameters == {"k": 3.0}


KILOPOUND = '<ssc:Unit name="kilopound"><ssc:BaseUnit kg="1" m="1" s="-2" factor="4448.2216152605"/></ssc:Unit>'


def test_units_of_an_inline_set_are_its_own(read: Read) -> None:
    own = inline(real("offset", "2", "kilopound")).replace(
        "</ssv:Parameters>", f"</ssv:Parameters><ssv:Units>{KILOPOUND}</ssv:Units>"
    )
    assert read(document(bound(own))).components["a"].parameters == {"offset": pytest.approx(8896.443230521, rel=1e-15)}


def test_a_unit_that_nothing_defines_leaves_the_value_as_it_is(read: Read) -> None:
    found = read(document(bound(inline(real("offset", "2", "furlogs")))))
    assert found.components["a"].parameters == {"offset": 2.0} and broken(found) == [rules.UNDEFINED_UNIT]


def test_an_empty_unit_is_none(read: Read) -> None:
    stated = connectors(y="output").replace("></ssd:Connector>", '><ssc:Real unit=""/></ssd:Connector>')
    found = read(document(system(component("a", "gain", stated) + component("b", "gain"), WIRE)))
    assert found.connections[0].gain == 1.0 and not found.breaches


def test_an_element_whose_name_has_dots_is_found_by_it(read: Read) -> None:
    top = system(
        component("left", "gain") + component("left.one", "gain"), head=bindings(inline(real("left.one.k", "4")))
    )
    found = read(document(top)).components
    assert (found["left"].parameters, found["left_one"].parameters) == ({}, {"k": 4.0})


def test_a_transformation_in_a_units_that_is_not_the_fmus_is_an_error(read: Read) -> None:
    stated = component("b", "gain", connectors(u="input|percent"))
    wire = connection("a.y", "b.u", '<ssc:LinearTransformation factor="2"/>')
    with pytest.raises(InputError, match=r"connector u is in percent, the FMU's variable in 1 .*line"):
        read(document(system(component("a", "gain") + stated, wire)))


@needs_gcc
@pytest.mark.parametrize(
    ("kind", "text", "value"),
    [
        ("Enumeration", "on", 7),
        ("Enumeration", "7", 7),
        ("Integer", "7", 7),
        ("Enumeration", "three", 7),
        ("String", "on", 7),
    ],
)
def test_items_of_enumerations_by_name(kind: str, text: str, value: int, tmp_path: Path) -> None:
    """By the FMU's items, or by those of the enumeration that the file names."""
    cells(
        tmp_path / "plain.fmu",
        [scalar("y", 100), scalar("mode", 3, "parameter", "Enumeration", declaredType="Mode", start="1")],
    )
    named = ' name="Steps"' if text == "three" else ""
    values = f'<ssv:Parameter name="mode"><ssv:{kind} value="{text}"{named}/></ssv:Parameter>'
    items = '<ssc:Enumeration name="Steps"><ssc:Item name="three" value="7"/></ssc:Enumeration>'
    steps = f"<ssd:Enumerations>{items}</ssd:Enumerations>"
    top = document(system(component("a", "plain", bindings(inline(values)))), experiment="").replace(
        "</ssd:SystemStructureDescription>", f"{steps}</ssd:SystemStructureDescription>"
    )
    found = load_system(str(write_ssp_file(tmp_path / "case.ssp", tmp_path, top, ("plain",))))
    assert found.components["a"].parameters == {"mode": value}


@needs_gcc
def test_an_input_for_which_nobody_has_a_value_takes_zero_and_is_noted(tmp_path: Path) -> None:
    cells(
        tmp_path / "bare.fmu",
        [scalar("u", 0, "input"), scalar("v", 1, "input"), scalar("y", 100)],
        'stopTime="0.1" stepSize="0.01"',
    )
    top = document(system(component("a", "bare") + component("b", "bare"), WIRE))
    found = load_system(str(write_ssp_file(tmp_path / "case.ssp", tmp_path, top, ("bare",))))
    assert [c.inputs for c in found.components.values()] == [{"u": 0.0, "v": 0.0}, {"v": 0.0}]
    assert rules.NO_START in broken(found) and not simulate(make_plan(found)).failure
