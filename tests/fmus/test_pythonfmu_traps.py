"""One test per way in which an FMU made with pythonfmu can go wrong."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import textwrap
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from fmpy.validation import validate_fmu
from helpers import FIXTURES, last, plan_of, python, run_of
from lxml import etree
from rovbrush.components.build import COMPONENTS, HERE, build
from rovbrush.components.interface import Variable
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmi2_instance import Fmi2Instance as Instance
from rovbrush.orchestrator.fmu import Fmu
from rovbrush.orchestrator.simulation import simulate

H = 1e-3
every_component = pytest.mark.parametrize("name", COMPONENTS)


@contextmanager
def started(path: Path, **values: Any) -> Iterator[Instance]:
    """An instance at time 0."""
    instance = Instance(Fmu.open(path), "test")
    try:
        for key, value in values.items():
            instance.set(key, value)
        instance.call("set up", instance.slave.setupExperiment, None, 0.0, 10.0)
        instance.call("enter", instance.slave.enterInitializationMode)
        instance.call("leave", instance.slave.exitInitializationMode)
        yield instance
    finally:
        instance.close()


def stir(instance: Instance, first: int, steps: int) -> list[list[float]]:
    """Steps with inputs that change all the time; the Real outputs after each."""
    described = instance.fmu.variables
    inputs = [v for v in instance.fmu.names("input") if described[v].type == "Real"]
    outputs = [v for v in instance.fmu.names("output") if described[v].type == "Real"]
    references = [described[v].valueReference for v in outputs]
    history = []
    for k in range(first, first + steps):
        for number, name in enumerate(inputs):
            instance.set(name, bounded(described[name], 0.01 * np.sin(0.3 * k + number)))
        instance.call("step", instance.slave.doStep, k * H, H)
        history.append(instance.slave.getReal(references))
    return history


def bounded(variable: Any, value: float) -> float:
    low = float(variable.min) if variable.min is not None else value
    high = float(variable.max) if variable.max is not None else value
    return min(max(value, low), high)


def declared(path: Path) -> etree._Element:
    with zipfile.ZipFile(path) as archive:
        return etree.fromstring(archive.read("modelDescription.xml"))


# --- module names collide ---


def test_two_versions_of_one_fmu_in_one_process_give_their_own_results(tmp_path: Path, fmus: Path) -> None:
    changed = tmp_path / "new" / "integrator"
    shutil.copytree(FIXTURES / "integrator", changed)
    kernel = changed / "kernel.py"
    kernel.write_text(kernel.read_text().replace("x[0] = x[0] + h * u", "x[0] = x[0] + 2.0 * h * u"))
    build(changed, tmp_path)
    (tmp_path / "old.fmu").write_bytes((fmus / "integrator.fmu").read_bytes())
    part = {"x_start": 1.0, "=u": 3.0}
    parts = {
        "old": (str(tmp_path / "old.fmu"), "10 ms", part),
        "new": (str(tmp_path / "integrator.fmu"), "10 ms", part),
    }
    run = run_of(tmp_path, fmus, parts)
    assert last(run, "old.x") == pytest.approx(4.0, abs=1e-12)
    assert last(run, "new.x") == pytest.approx(7.0, abs=1e-12)


# --- hidden state is not saved ---


@every_component
def test_saved_state_restores_bitwise(name: str, fmus: Path) -> None:
    with started(fmus / f"{name}.fmu") as instance:
        stir(instance, 0, 7)
        state = instance.slave.getFMUState()
        onward = stir(instance, 7, 12)
        instance.slave.setFMUState(state)
        assert stir(instance, 7, 12) == onward
        instance.slave.freeFMUState(state)


@every_component
def test_serialized_state_continues_bitwise_in_another_instance(name: str, fmus: Path) -> None:
    with started(fmus / f"{name}.fmu") as first:
        stir(first, 0, 7)
        state = first.slave.getFMUState()
        content = first.slave.serializeFMUState(state)
        onward = stir(first, 7, 12)
    with started(fmus / f"{name}.fmu") as second:
        stir(second, 0, 3)
        second.slave.setFMUState(second.slave.deSerializeFMUstate(content))
        assert stir(second, 7, 12) == onward


@pytest.mark.parametrize("name", ["gain", "integrator"])
def test_serialized_state_starts_an_instance_that_was_never_initialized(name: str, fmus: Path) -> None:
    with started(fmus / f"{name}.fmu") as first:
        stir(first, 0, 4)
        content = first.slave.serializeFMUState(first.slave.getFMUState())
        onward = stir(first, 4, 4)
    second = Instance(Fmu.open(fmus / f"{name}.fmu"), "second")
    second.slave.setFMUState(second.slave.deSerializeFMUstate(content))
    assert stir(second, 4, 4) == onward
    second.close()


def test_state_saved_before_initialization_brings_back_the_start_values(fmus: Path) -> None:
    instance = Instance(Fmu.open(fmus / "integrator.fmu"), "test")
    instance.set("x_start", 5.0)
    state = instance.slave.getFMUState()
    instance.set("x_start", 6.0)
    assert instance.get("x") == 6.0
    instance.slave.setFMUState(state)
    assert instance.get("x") == 5.0
    instance.close()


# --- exceptions lose their text and crash the process ---


def test_an_exception_in_a_step_names_component_time_and_traceback_and_the_process_lives(
    tmp_path: Path, fmus: Path
) -> None:
    parts = {"good": ("integrator", "1 ms", {"=u": 1.0}), "bad": ("faulty", "5 ms", {"raise_at": 0.0149})}
    run = simulate(plan_of(tmp_path, fmus, parts))
    for expected in ("component bad", "t = 0.015 s", "Traceback", "gave up", "do_step at t = 0.01 s"):
        assert expected in run.failure
    assert [len(table) for table in run.tables] == [15, 3]  # rows until the last instant that all reached
    healthy = run_of(tmp_path, fmus, {**parts, "bad": ("faulty", "5 ms")})
    assert last(healthy, "good.x") == pytest.approx(1.0)


def test_percent_signs_in_messages_arrive_as_they_are(tmp_path: Path, fmus: Path) -> None:
    run = simulate(plan_of(tmp_path, fmus, {"bad": ("faulty", "5 ms", {"raise_at": 0.02})}))
    assert "gave up: 100 % of %s%n broke" in run.failure


def test_an_exception_at_the_start_arrives_with_its_text(tmp_path: Path, fmus: Path) -> None:
    with pytest.raises(FmuError) as error:
        simulate(plan_of(tmp_path, fmus, {"bad": ("faulty", "5 ms", {"fail_at_start": True})}))
    for expected in ("component bad", "no start: 100 % of %s", "Traceback"):
        assert expected in str(error.value)
    run_of(tmp_path, fmus, {"bad": ("faulty", "5 ms")})


def test_a_parameter_out_of_range_is_refused_by_the_fmu_itself(fmus: Path) -> None:
    with (
        pytest.raises(FmuError, match=r"k = 1000000000.0 is out of range: -1e\+06 to 1e\+06 are allowed"),
        started(fmus / "gain.fmu", k=1e9),
    ):
        pass


def test_not_a_number_is_caught_with_component_variable_and_time(tmp_path: Path, fmus: Path) -> None:
    run = simulate(plan_of(tmp_path, fmus, {"bad": ("faulty", "10 ms", {"nan_at": 0.0299})}))
    for expected in ("component bad", "output fragile", "nan", "t = 0.03 s"):
        assert expected in run.failure
    assert len(run.tables[0]) == 3 and np.all(np.isfinite(run.tables[0]))


def test_not_a_number_at_time_zero_is_refused(tmp_path: Path, fmus: Path) -> None:
    with pytest.raises(FmuError, match=r"component bad: output fragile is nan at time 0"):
        simulate(plan_of(tmp_path, fmus, {"bad": ("faulty", "10 ms", {"nan_at": 0.0})}))


@pytest.mark.parametrize(("mode", "status"), [(1, "Fatal"), (2, "Discard")])
def test_a_plain_pythonfmu_failure_leaves_the_process_alive(mode: int, status: str, tmp_path: Path, fmus: Path) -> None:
    inputs = {"=u": 0.0, "=temperature": 0.0, "=speed": 0.0}
    run = simulate(plan_of(tmp_path, fmus, {"p": ("plain", "1 ms", {"mode": mode, **inputs})}))
    assert f"component p returned fmi2{status} in the step to t = 0.006 s" in run.failure
    assert len(run.tables[0]) == 6
    assert mode != 1 or "100 % of %s%n gone" in run.failure
    assert last(run_of(tmp_path, fmus, {"p": ("plain", "1 ms", inputs)}), "p.y") == 1.0


# --- the model description ---


def component_class(name: str) -> Any:
    import importlib

    module = importlib.import_module(f"rovbrush.components.{name}.fmu")
    return next(c for c in vars(module).values() if isinstance(c, type) and c.__module__ == module.__name__)


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
            assert scalar.get("variability") in {"parameter": ("fixed",), "calculatedParameter": ("fixed",)}.get(
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
    import pint
    from rovbrush.orchestrator.units import parse_unit

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


@every_component
def test_outputs_answer_at_once_only_to_declared_inputs(name: str) -> None:
    """After steps have stirred the state, `outputs` is evaluated again with one input changed."""
    component = component_class(name)
    slave = component(instance_name="direct")
    for v in component.inputs:
        slave.views[v.name][:] = np.clip(0.01, v.minimum, v.maximum)
    slave.enter_initialization_mode()
    slave.exit_initialization_mode()
    assert all(slave.do_step(k * H, H) for k in range(40))

    def values() -> np.ndarray:
        function, arguments, _ = slave.bind("outputs")
        function(*arguments)
        return slave.y.copy()

    owner = [v for v in component.outputs for _ in v.element_names]
    before = values()
    for changed in component.inputs:
        for k in range(len(changed.start)):
            kept = slave.views[changed.name][k]
            slave.views[changed.name][k] = np.clip(0.013, changed.minimum, changed.maximum)
            moved = {owner[j].name for j in np.flatnonzero(values() != before)}
            slave.views[changed.name][k] = kept
            assert moved <= {v.name for v in component.outputs if changed.name in v.depends}, changed.name


def test_the_fmu_needs_no_tool_and_can_save_and_serialize(fmus: Path) -> None:
    options = declared(fmus / "dc_motor.fmu").find("CoSimulation").attrib
    assert options["needsExecutionTool"] == "false"
    assert options["canGetAndSetFMUstate"] == options["canSerializeFMUstate"] == "true"
    assert options["canBeInstantiatedOnlyOncePerProcess"] == "false"


# --- the build ---


def test_two_builds_are_byte_identical(tmp_path: Path, fmus: Path) -> None:
    """The second one from another folder, with another hash seed, in another time zone and language."""
    code = "import os; from pathlib import Path; from rovbrush.components.build import build_all"
    code = f"{code}; os.chdir({str(tmp_path)!r}); build_all(Path('out'))"
    run = python(code, PYTHONHASHSEED="77", TZ="Asia/Tokyo", LC_ALL="C")
    assert run.returncode == 0, run.stderr
    for name in COMPONENTS:
        assert (tmp_path / "out" / f"{name}.fmu").read_bytes() == (fmus / f"{name}.fmu").read_bytes(), name


def test_any_change_of_a_source_changes_the_guid(tmp_path: Path, fmus: Path) -> None:
    changed = tmp_path / "new" / "gain"
    shutil.copytree(FIXTURES / "gain", changed)
    (changed / "kernel.py").write_text((changed / "kernel.py").read_text() + "# changed\n")
    assert declared(build(changed, tmp_path)[0]).get("guid") != declared(fmus / "gain.fmu").get("guid")


@every_component
def test_an_fmu_carries_no_path_and_no_user_of_the_machine_it_was_built_on(name: str, fmus: Path) -> None:
    with zipfile.ZipFile(fmus / f"{name}.fmu") as archive:
        for entry in archive.infolist():
            content = archive.read(entry)
            assert not entry.filename.endswith((".pyc", ".nbi", ".nbc"))
            if entry.filename.startswith("binaries/"):
                continue  # as pythonfmu ships them
            for path in (str(HERE.parent), str(Path.home()) + "/", "/tmp/", sys.prefix, str(fmus)):
                assert path.encode() not in content, f"{entry.filename} holds {path}"


@every_component
def test_an_fmu_runs_from_its_own_content(name: str, fmus: Path) -> None:
    """In a process that cannot import the package: neither from the source tree nor from an installation."""
    code = textwrap.dedent("""
        import importlib.abc, sys
        class Refuse(importlib.abc.MetaPathFinder):
            def find_spec(self, name, path=None, target=None):
                if name.split(".")[0] == "rovbrush":
                    raise ImportError(f"{name} is out of reach")
        sys.path[:] = [p for p in sys.path if p]
        sys.meta_path[:] = [Refuse()] + [f for f in sys.meta_path if "editable" not in repr(f).lower()]
        import fmpy
        from fmpy import fmi2
        folder = sys.argv[1]
        described = fmpy.read_model_description(folder)
        fmu = fmi2.FMU2Slave(guid=described.guid, modelIdentifier=described.coSimulation.modelIdentifier,
                             unzipDirectory=folder, instanceName="alone")
        fmu.instantiate()
        fmu.setupExperiment(startTime=0.0)
        fmu.enterInitializationMode()
        fmu.exitInitializationMode()
        for k in range(5):
            fmu.doStep(k * 1e-3, 1e-3)
        outputs = [v for v in described.modelVariables if v.causality == "output" and v.type == "Real"]
        values = fmu.getReal([v.valueReference for v in outputs])
        fmu.terminate()
        own = {n: getattr(m, "__file__", None) for n, m in sys.modules.items() if n.startswith("rovbrush")}
        import json, os
        print(json.dumps({"values": values, "own": own, "pythonfmu": sys.modules["pythonfmu"].__file__}), flush=True)
        os._exit(0)
    """)  # fmt: skip
    folder = Fmu.open(fmus / f"{name}.fmu").folder
    run = python(code, str(folder), timeout=120.0)
    assert run.returncode == 0, run.stdout + run.stderr
    seen = json.loads(run.stdout.splitlines()[-1])
    assert seen["own"] and not any(module.split(".")[0] == "rovbrush" for module in seen["own"])
    assert all(path is None or path.startswith(str(folder)) for path in seen["own"].values())
    assert seen["pythonfmu"].startswith(str(folder)), "pythonfmu itself comes with the FMU"
    with started(fmus / f"{name}.fmu") as here:
        for k in range(5):
            here.slave.doStep(k * H, H)
        outputs = [v for v in here.fmu.names("output") if here.fmu.variables[v].type == "Real"]
        assert [here.get(v) for v in outputs] == seen["values"]


# --- life and death of instances and processes ---


def test_instances_of_one_fmu_are_independent(tmp_path: Path, fmus: Path) -> None:
    parts = {f"i{k}": ("integrator", "10 ms", {"=u": float(k), "x_start": 10.0 * k}) for k in range(5)}
    run = run_of(tmp_path, fmus, parts)
    assert [last(run, f"i{k}.x") for k in range(5)] == pytest.approx([11.0 * k for k in range(5)], abs=1e-12)


def test_instances_can_be_made_and_freed_many_times(fmus: Path) -> None:
    fmu = Fmu.open(fmus / "integrator.fmu")
    for k in range(100):
        instance = Instance(fmu, f"i{k}")
        instance.set("x_start", float(k))
        assert instance.get("x") == k
        instance.close()
    with started(fmus / "integrator.fmu") as instance:
        assert stir(instance, 0, 1)


RUN = """
import sys
from rovbrush.orchestrator.plan import make_plan
from rovbrush.orchestrator.reader import load_system
from rovbrush.orchestrator.simulation import simulate
from pathlib import Path
run = simulate(make_plan(load_system(sys.argv[1], Path(sys.argv[2]))), interpreted=True)
print("END" + run.failure.replace(chr(10), " "))
sys.exit(int(sys.argv[3]))
"""


def test_exit_codes_survive_the_end_of_the_process(tmp_path: Path, fmus: Path) -> None:
    """The library of pythonfmu aborts now and then at exit: twenty processes, with healthy and failing runs."""
    from concurrent.futures import ThreadPoolExecutor

    from helpers import system_text

    inputs = {"=u": 0.0, "=temperature": 0.0, "=speed": 0.0}
    files = []
    for mode in (0, 1):
        path = tmp_path / f"mode{mode}.toml"
        path.write_text(system_text({"p": ("plain", "1 ms", {"mode": mode, **inputs})}, stop="10 ms"))
        files.append(path)
    cases = [(files[k % 4 == 3], (0, 3)[k % 2]) for k in range(20)]
    with ThreadPoolExecutor(2) as pool:
        runs = list(pool.map(lambda case: python(RUN, str(case[0]), str(fmus), str(case[1])), cases))
    assert [run.returncode for run in runs] == [code for _, code in cases], [
        run.stderr for run in runs if run.returncode not in (0, 3)
    ]
    assert all("END" in run.stdout for run in runs)


def test_a_cache_folder_beyond_plain_ascii_is_refused_with_the_mend(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROVBRUSH_CACHE", str(tmp_path / "bürste"))
    with pytest.raises(FmuError, match=r"cache folder .*bürste.*set ROVBRUSH_CACHE"):
        Fmu.open(fmus / "gain.fmu")


def test_an_fmu_in_a_folder_beyond_plain_ascii_runs(fmus: Path, tmp_path: Path) -> None:
    folder = tmp_path / "bürste 刷子"
    folder.mkdir()
    shutil.copy(fmus / "gain.fmu", folder / "gäin.fmu")
    run = run_of(folder, folder, {"g": (str(folder / "gäin.fmu"), "100 ms", {"=u": 2.0, "k": 3.0, "offset": 0.0})})
    assert last(run, "g.y") == 6.0
