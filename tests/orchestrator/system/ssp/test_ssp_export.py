"""A system written as an SSP and read again is the same system, and its run bit by bit the same."""

from __future__ import annotations

import dataclasses
import json
import zipfile
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import clock_build
import exchange_build
import numpy as np
import pytest
from clock_cases import same
from helpers import read_system
from lxml import etree
from native_build import needs_gcc
from rovbrush.orchestrator.cli.main import app
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.file.shipped import shipped_systems
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.ssp.files.document import Document, validate
from rovbrush.orchestrator.system.ssp.write import write_ssp

# Fields that need not survive: where the files are, and what is said of a swap. Every other one must, new ones too.
LEFT_OUT = {"parameter_set", "path", "notes", "where"}
EXPORTED = [name for name in shipped_systems() if name != "ardusub"]  # a part of which is a program elsewhere


def test_a_system_with_a_link_to_an_autopilot_is_no_ssp(native: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"component autopilot is no FMU but a link to an autopilot .* SSP"):
        write_ssp(load_system("ardusub", native / "fmi2"), tmp_path / "a.ssp")
    assert not list(tmp_path.iterdir())


def plain(value: object) -> object:
    """What must survive of a system: all but where its files are, on which lines, and whose set its values are."""
    if isinstance(value, Fmu):
        return value.digest, value.path.name
    if dataclasses.is_dataclass(value):
        names = {field.name for field in dataclasses.fields(value)} - LEFT_OUT
        return {name: plain(getattr(value, name)) for name in sorted(names)}
    if isinstance(value, dict):
        return [(key, plain(item)) for key, item in value.items()]  # with its order
    return tuple(map(plain, value)) if isinstance(value, (tuple, list)) else value


def assert_equal_plans(first: System, second: System) -> None:
    plans = [make_plan(system) for system in (first, second)]
    assert np.array_equal(plans[0].cycle, plans[1].cycle)
    assert plans[0].coefficients.tobytes() == plans[1].coefficients.tobytes()
    assert plans[0].order == plans[1].order
    assert [group.columns for group in plans[0].groups] == [group.columns for group in plans[1].groups]


@pytest.mark.sampled(10)
@pytest.mark.parametrize("version", ["1.0", "2.0"])
@pytest.mark.parametrize("name", EXPORTED)
def test_a_shipped_system_comes_back_from_its_ssp_unchanged(
    name: str, version: str, fmus: Path, tmp_path: Path
) -> None:
    system = load_system(name, fmus)
    again = load_system(str(write_ssp(system, tmp_path / "some_other_name.ssp", version)))
    assert plain(again) == plain(system)
    assert_equal_plans(system, again)


@pytest.mark.sampled(6)
@pytest.mark.parametrize("name", EXPORTED)
def test_a_run_from_the_ssp_is_bitwise_the_run_from_toml(name: str, fmus: Path, tmp_path: Path) -> None:
    """0.2 s: every kind of operation of every plan many times."""
    system = replace(load_system(name, fmus), stop=Fraction(1, 5))
    again = load_system(str(write_ssp(system, tmp_path / "system.ssp")))
    first, second = (simulate(make_plan(s)) for s in (system, again))
    assert not first.failure and not second.failure
    assert [table.tobytes() for table in first.tables] == [table.tobytes() for table in second.tables]


def test_the_same_system_gives_the_same_file_byte_for_byte(fmus: Path, tmp_path: Path) -> None:
    first, second = (write_ssp(load_system("test_stand", fmus), tmp_path / f"{k}.ssp").read_bytes() for k in range(2))
    assert first == second


def test_values_transfers_and_awkward_times_survive(fmus: Path, tmp_path: Path) -> None:
    parameters = {"k": 0.1 + 0.2, "offset": -1e-300, "count": 7, "on": False, "weights": [1 / 3, 5e-324]}
    parts = {"a": ("gain", "1/60 s", {**parameters, "=u": 1e22}), "b": ("integrator", "1/180 s")}
    system = read_system(tmp_path, fmus, parts, ["a.y -> b.u (linear)"], stop="1/3 s", record=["b.*"], order=["b", "a"])
    again = load_system(str(write_ssp(system, tmp_path / "case.ssp")))
    assert plain(again) == plain(system)
    assert again.stop == Fraction(1, 3)


def test_a_conversion_of_units_is_written_as_a_linear_transformation(fmus: Path, tmp_path: Path) -> None:
    system = read_system(tmp_path, fmus, {"a": ("gain", "1 ms", {"=u": 1.0}), "b": ("gain", "1 ms")}, ["a.y -> b.u"])
    converted = replace(system, connections=(replace(system.connections[0], gain=1 / 3, offset=273.15),))
    path = write_ssp(converted, tmp_path / "case.ssp")
    with zipfile.ZipFile(path) as archive:
        root = etree.fromstring(archive.read("SystemStructure.ssd"))
    (connection,) = root.iterfind(".//{*}Connection")
    assert connection.get("suppressUnitConversion") == "true"
    assert dict(connection[0].attrib) == {"factor": repr(1 / 3), "offset": "273.15"}
    assert plain(load_system(str(path))) == plain(converted)


def test_the_export_is_valid_by_the_schemas_and_an_invalid_tree_would_be_found(fmus: Path, tmp_path: Path) -> None:
    path = write_ssp(load_system("nominal", fmus), tmp_path / "nominal.ssp")
    with zipfile.ZipFile(path) as archive:
        archive.extractall(tmp_path / "files")
    Document(tmp_path / "files" / "SystemStructure.ssd", "ssd", "SystemStructureDescription")
    Document(tmp_path / "files" / "resources" / "motor.ssv", "ssv", "ParameterSet")
    root = etree.parse(str(tmp_path / "files" / "SystemStructure.ssd")).getroot()
    root.find(".//{*}Component").attrib.pop("name")
    with pytest.raises(InputError, match=r"no valid SSP file.*name"):
        validate(root, "ssd")


@needs_gcc
def test_the_kind_that_was_chosen_for_an_fmu_of_several_survives(tmp_path: Path) -> None:
    exchange_build.exchange(tmp_path, "lag", both=True)
    parts = {"a": ("lag.fmu", "10 ms"), "b": ("lag.fmu", "10 ms")}
    system = read_system(tmp_path, tmp_path, parts, of={"a": {"kind": "model-exchange"}})
    write_ssp(system, tmp_path / "case.ssp")
    again = load_system(str(tmp_path / "case.ssp"))
    assert [c.fmu.kind for c in again.components.values()] == ["model-exchange", "co-simulation"]
    assert_equal_plans(system, again)


def test_two_fmus_of_one_name_are_both_in_the_file(fmus: Path, tmp_path: Path) -> None:
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "gain.fmu").write_bytes((fmus / "integrator.fmu").read_bytes())
    parts = {"a": ("gain", "1 ms", {"=u": 1.0}), "b": ("other/gain.fmu", "1 ms"), "c": ("gain", "1 ms")}
    system = read_system(tmp_path, fmus, parts, ["a.y -> b.u", "b.x -> c.u"])
    again = load_system(str(write_ssp(system, tmp_path / "case.ssp")))
    assert [c.fmu.digest for c in again.components.values()] == [c.fmu.digest for c in system.components.values()]


def test_a_damaged_annotation_is_an_error_that_says_where(fmus: Path, tmp_path: Path) -> None:
    path = write_ssp(load_system("test_stand", fmus), tmp_path / "case.ssp")
    with zipfile.ZipFile(path) as archive:
        entries = {name: archive.read(name) for name in archive.namelist()}

    def damaged(old: str, new: str) -> str:
        with zipfile.ZipFile(path, "w") as archive:
            for name, content in entries.items():
                archive.writestr(name, content.replace(old.encode(), new.encode()))
        return str(path)

    with pytest.raises(InputError, match=r"the rovbrush.simulation annotation is no JSON.*line \d+"):
        load_system(damaged('{"algorithm"', '{"algorithm'))
    with pytest.raises(InputError, match=r"the annotation of the system cannot hold 'parameters'"):
        load_system(damaged('{"algorithm"', '{"parameters": "/etc/passwd", "algorithm"'))
    with pytest.raises(InputError, match=r"unknown key 'algoritm'; did you mean 'algorithm'\?"):
        load_system(damaged('{"algorithm"', '{"algoritm"'))
    with pytest.raises(InputError, match=r"the annotation of a component cannot hold 'fmu'"):
        load_system(damaged('{"period"', '{"fmu": "x", "period"'))


def test_the_command_writes_an_ssp_that_the_other_commands_take(
    fmus: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, out = str(tmp_path / "stand.ssp"), tmp_path / "results"
    rovbrush("export", "test_stand", "--ssp", "--out", file, "--fmus", str(fmus))
    assert "SSP 1.0" in capsys.readouterr().out
    rovbrush("plan", file)
    assert "system test_stand: motor and brush on a test stand" in capsys.readouterr().out
    rovbrush("run", file, "--set", "motor.R=0.1", "--out", str(out))
    assert json.loads((out / "manifest.json").read_text())["components"]["motor"]["parameters"]["R"] == 0.1
    with pytest.raises(InputError, match="choose one of --ssp, --fmu, --c DIR and --container"):
        rovbrush("export", file)
    with pytest.raises(InputError, match=r"SSP version '3' cannot be written; take 1\.0 or 2\.0"):
        rovbrush("export", file, "--ssp", "--ssp-version", "3", "--out", str(tmp_path / "other.ssp"))


def rovbrush(*arguments: str) -> None:
    app(list(arguments), standalone_mode=False)


CLOCKED = """
format = 2
stop_time = "2 s"
connections = ["a.crossing -> b.sample", "a.count -> b.v", "a.phase -> p.u"]
[components.a]
fmu = "producer.fmu"
period = "100 ms"
[components.b]
fmu = "consumer.fmu"
period = "250 ms"
[components.p]
fmu = "plant.fmu"
period = "10 ms"
[[events]]
name = "off"
at = "1 s"
fault = "bias"
on = "p.u"
value = 0.5
for = "300 ms"
[[events]]
when = "p.x > 0.3"
after = "20 ms"
fault = "hold"
on = "p.u"
"""


@needs_gcc
@pytest.mark.parametrize("version", ["1.0", "2.0"])
def test_connections_of_clocks_and_events_come_back_unchanged(version: str, tmp_path: Path) -> None:
    clock_build.built(tmp_path)
    (tmp_path / "clocked.toml").write_text(CLOCKED, encoding="utf-8")
    system = load_system(str(tmp_path / "clocked.toml"), tmp_path)
    path = write_ssp(system, tmp_path / "out" / "clocked.ssp", version)
    again = load_system(str(path))
    assert system.clock_connections and len(system.events) == 2
    assert plain(again) == plain(system)
    assert_equal_plans(system, again)
    assert same(*(simulate(make_plan(found)) for found in (system, again)))
    structure = zipfile.ZipFile(path).read("SystemStructure.ssd").decode()
    assert 'name="crossing"' not in structure, "a clock is no number: other tools would take it for one"


@needs_gcc
def test_connections_of_clocks_that_are_none_are_told_with_their_place(tmp_path: Path) -> None:
    clock_build.built(tmp_path)
    (tmp_path / "clocked.toml").write_text(CLOCKED, encoding="utf-8")
    path = write_ssp(load_system(str(tmp_path / "clocked.toml"), tmp_path), tmp_path / "clocked.ssp")
    with zipfile.ZipFile(path) as archive:
        entries = {name: archive.read(name) for name in archive.namelist()}
    with zipfile.ZipFile(path, "w") as archive:
        for name, content in entries.items():
            archive.writestr(name, content.replace(b'["a.crossing -&gt; b.sample"]', b'"a.crossing"'))
    with pytest.raises(InputError, match=r"clock_connections .* is no list of 'a.x -> b.y' \(clocked.ssp"):
        load_system(str(path))
