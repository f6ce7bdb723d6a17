"""The model description of FMUs made with pythonfmu: valid, complete, and true of dependencies."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pint
import pytest
from fmpy.validation import validate_fmu
from pythonfmu_instance import H, bounded, declared, every_component
from rovbrush.components.declare.interface import Variable
from rovbrush.components.python.component import component_class
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.here.fmi2 import Fmi2Instance as Instance
from rovbrush.orchestrator.units import parse_unit


@every_component
def test_fmpy_finds_nothing_to_complain_about(name: str, fmus: Path) -> None:
    assert validate_fmu(str(fmus / f"{name}.fmu")) == []


def test_the_command_line_of_fmpy_validates(fmus: Path) -> None:
    run = subprocess.run(
        [sys.executable, "-m", "fmpy", "validate", str(fmus / "dc_motor.fmu")],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0 and "No problems found" in run.stdout, run.stdout + run.stderr


@pytest.mark.parametrize("name", ["gain", "integrator", "wave", "faulty"])
def test_fmpy_finds_nothing_to_complain_about_in_unusual_interfaces(name: str, fmus: Path) -> None:
    """No inputs, no state, arrays, whole numbers, switches."""
    assert validate_fmu(str(fmus / f"{name}.fmu")) == []


@every_component
def test_the_xml_holds_the_declaration_in_full(name: str, fmus: Path) -> None:
    xml = declared(fmus / f"{name}.fmu")
    scalars = {s.get("name"): s for s in xml.iter("ScalarVariable")}
    units = {u.get("name") for u in xml.iter("Unit")}
    variables: tuple[Variable, ...] = component_class(name).variables()
    assert list(scalars) == [element for v in variables for element in v.element_names]
    for v in variables:
        for element, start in zip(v.element_names, v.start, strict=True):
            scalar, typed = scalars[element], scalars[element][0]
            assert typed.tag == v.kind
            assert scalar.get("causality") == v.causality and v.description in scalar.get("description")
            fixed = ("tunable",) if v.tunable else ("fixed",)
            assert scalar.get("variability") in {"parameter": fixed, "calculatedParameter": ("fixed",)}.get(
                v.causality, ("continuous", "discrete")
            )
            assert scalar.get("initial") == {"parameter": "exact", "input": None}.get(v.causality, "calculated")
            if v.kind == "Real":
                assert typed.get("unit") == v.unit and v.unit in units
            if v.causality in ("parameter", "input"):
                assert {"true": 1.0, "false": 0.0}.get(typed.get("start")) == start or float(
                    typed.get("start")
                ) == start
            else:
                assert typed.get("start") is None
            for bound, value in (("min", v.minimum), ("max", v.maximum)):
                written = typed.get(bound)
                assert (written is None) == (abs(value) == np.inf or v.kind == "Boolean") and (
                    written is None or float(written) == value
                )


def test_start_values_keep_all_digits(fmus: Path) -> None:
    starts = {s.get("name"): s[0].get("start") for s in declared(fmus / "gain.fmu").iter("ScalarVariable")}
    assert starts["offset"] == "0.30000000000000004"
    assert [starts["count"], starts["on"], starts["weights[2]"]] == ["3", "true", repr(1 / 3)]


@every_component
def test_units_have_the_dimensions_that_pint_gives_them(name: str, fmus: Path) -> None:
    """The exponents in the XML are checked against an independent source."""
    registry = pint.UnitRegistry()
    base = {"kg": "kilogram", "m": "meter", "s": "second", "A": "ampere", "rad": "dimensionless"}
    for unit in declared(fmus / f"{name}.fmu").iter("Unit"):
        if len(unit) == 0:
            continue  # a power that is not whole cannot be written
        expected = registry.Quantity(1.0, str(parse_unit(unit.get("name")))).to_base_units()
        seen = registry.Quantity(1.0, "dimensionless")
        for symbol, exponent in unit[0].attrib.items():
            seen = seen * registry.Quantity(1.0, base[symbol]) ** int(exponent)
        assert (seen / expected).to("dimensionless").magnitude == pytest.approx(1.0, rel=1e-12), unit.get("name")


@every_component
def test_model_structure_lists_outputs_unknowns_and_dependencies(name: str, fmus: Path) -> None:
    xml = declared(fmus / f"{name}.fmu")
    names = [s.get("name") for s in xml.iter("ScalarVariable")]
    causality = {s.get("name"): s.get("causality") for s in xml.iter("ScalarVariable")}
    parts = {
        part.tag: {
            names[int(u.get("index")) - 1]: {names[int(k) - 1] for k in (u.get("dependencies") or "").split()}
            for u in part
        }
        for part in xml.find("ModelStructure")
    }
    outputs = [v for v in names if causality[v] == "output"]
    assert list(parts["Outputs"]) == outputs
    assert list(parts["InitialUnknowns"]) == [v for v in names if causality[v] in ("output", "calculatedParameter")]
    for v in component_class(name).outputs:
        inputs = {e for i in component_class(name).inputs if i.name in v.depends for e in i.element_names}
        for element in v.element_names if v.causality == "output" else ():
            assert parts["Outputs"][element] == inputs
            assert parts["InitialUnknowns"][element] >= inputs


@every_component
def test_outputs_at_the_start_answer_only_to_declared_inputs(name: str, fmus: Path) -> None:
    xml = declared(fmus / f"{name}.fmu")
    names = [s.get("name") for s in xml.iter("ScalarVariable")]
    declares = {
        names[int(u.get("index")) - 1]: {names[int(k) - 1] for k in u.get("dependencies").split()}
        for u in xml.find("ModelStructure/InitialUnknowns")
    }
    fmu = Fmu.open(fmus / f"{name}.fmu")
    inputs = [v for v in fmu.names("input") if fmu.variables[v].type == "Real"]

    def values(changed: str) -> dict[str, float]:
        instance = Instance(fmu, "other")
        instance.begin(1.0)
        for v in inputs:
            instance.set(v, bounded(fmu.variables[v], 0.013 if v == changed else 0.01))
        found = {v: float(instance.get(v)) for v in declares}
        instance.close()
        return found

    before = values("")
    for changed in inputs:
        assert {v for v, value in values(changed).items() if value != before[v]} <= {
            v for v in declares if changed in declares[v]
        }, changed


@pytest.mark.sampled(3)
@every_component
def test_outputs_answer_at_once_only_to_declared_inputs(name: str) -> None:
    """After steps have stirred the state, `outputs` is evaluated again with one input changed."""
    component = component_class(name)
    slave = component(instance_name="direct")
    for v in component.inputs:
        slave.memory.views[v.name][:] = np.clip(0.01, v.minimum, v.maximum)
    slave.enter_initialization_mode()
    slave.exit_initialization_mode()
    assert all(slave.do_step(k * H, H) for k in range(40))

    def values() -> np.ndarray:
        slave.stages["outputs"]()
        return slave.memory.y.copy()

    owner = [v for v in component.outputs for _ in v.element_names]
    before = values()
    for changed in component.inputs:
        for k in range(len(changed.start)):
            kept = slave.memory.views[changed.name][k]
            slave.memory.views[changed.name][k] = np.clip(0.013, changed.minimum, changed.maximum)
            moved = {owner[j].name for j in np.flatnonzero(values() != before)}
            slave.memory.views[changed.name][k] = kept
            assert moved <= {v.name for v in component.outputs if changed.name in v.depends}, changed.name


def test_the_fmu_needs_no_tool_and_can_save_and_serialize(fmus: Path) -> None:
    options = declared(fmus / "dc_motor.fmu").find("CoSimulation").attrib
    assert options["needsExecutionTool"] == "false"
    assert options["canGetAndSetFMUstate"] == options["canSerializeFMUstate"] == "true"
    assert options["canBeInstantiatedOnlyOncePerProcess"] == "false"
