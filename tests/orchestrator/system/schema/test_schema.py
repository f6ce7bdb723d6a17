"""The keys of the files are declared once: the schema accepts what the reader accepts, and the page is current."""

from __future__ import annotations

import json
import sys
import tomllib
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from rovbrush.orchestrator.cli.main import main
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.algorithms.registry import algorithm_names, settings_tables
from rovbrush.orchestrator.studies.sweep.design.design import SAMPLERS
from rovbrush.orchestrator.studies.sweep.file import SWEEPS
from rovbrush.orchestrator.system.file.shipped import SYSTEMS, shipped_systems
from rovbrush.orchestrator.system.schema.pages import FILES, Algorithms, json_schema, reference

ALGORITHMS = Algorithms(algorithm_names(), settings_tables())
MAPPING = """\
[variables]
V_in = "supply.voltage"
torque = { name = "tau", sign = -1, unit = "N.m" }
W_gear = ""
[inputs]
temperature = 293.15
[parameters]
gains = [1.0, 2.0]
"""


def validator(kind: str) -> Any:
    schema = json_schema(kind, ALGORITHMS)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


@pytest.mark.parametrize("name", shipped_systems())
def test_the_schema_accepts_every_shipped_system(name: str) -> None:
    validator("system").validate(tomllib.loads((SYSTEMS / f"{name}.toml").read_text(encoding="utf-8")))


@pytest.mark.parametrize("path", sorted(SWEEPS.glob("*.toml")), ids=lambda path: path.stem)
def test_the_schema_accepts_every_shipped_sweep(path: Path) -> None:
    validator("sweep").validate(tomllib.loads(path.read_text(encoding="utf-8")))


def test_the_schema_knows_the_base_of_a_parameter_set() -> None:
    validator("parameter").validate({"base": "", "motor": {"R": 0.1}})
    with pytest.raises(jsonschema.ValidationError):
        validator("parameter").validate({"base": 3, "motor": {"R": 0.1}})


def test_the_schema_accepts_a_mapping_and_refuses_a_misspelt_table() -> None:
    validator("mapping").validate(tomllib.loads(MAPPING))
    with pytest.raises(jsonschema.ValidationError):
        validator("mapping").validate(tomllib.loads(MAPPING.replace("[inputs]", "[input]")))


SLIPS = {
    "an unknown key": ('algorithm = "gauss-seidel"', 'algoritm = "jacobi"'),
    "an unknown algorithm": ('algorithm = "gauss-seidel"', 'algorithm = "jacoby"'),
    "a key of a component": ('fmu = "dc_motor"', 'fmu = "dc_motor"\nperid = 1'),
    "a component without a period": ('fmu = "dc_motor"\nperiod = "0.5 ms"', 'fmu = "dc_motor"'),
    "a time that is none": ('stop_time = "10 s"', 'stop_time = "10 minutes"'),
    "a connection without an end": ('"controller.V_in -> motor.V_in"', '"controller.V_in"'),
    "a bond's sign": ('name = "brush shaft"', 'name = "brush shaft"\nsign = 2'),
    "an empty figure of merit": ('F_z_mean = "mean brush.F_z"', 'F_z_mean = ""'),
    "a setting out of range": ('stop_time = "10 s"', 'stop_time = "10 s"\niteration = { tolerance = 0.0 }'),
    "a reference that is text": ("reference = -221.7", 'reference = "x"'),
}


@pytest.mark.parametrize("slip", SLIPS)
def test_the_schema_refuses_what_the_reader_refuses(slip: str) -> None:
    old, new = SLIPS[slip]
    text = (SYSTEMS / "nominal.toml").read_text(encoding="utf-8")
    assert old in text
    with pytest.raises(jsonschema.ValidationError):
        validator("system").validate(tomllib.loads(text.replace(old, new, 1)))


def test_the_reference_page_in_the_repository_is_current() -> None:
    page = (SYSTEMS / "REFERENCE.md").read_text(encoding="utf-8")
    assert page == reference(ALGORITHMS), (
        "make it anew: rovbrush schema --reference --out orchestrator/systems/REFERENCE.md"
    )


def test_every_key_of_every_table_is_described() -> None:
    def described(schema: dict[str, Any]) -> None:
        for key, entry in schema.get("properties", {}).items():
            assert entry.get("description"), key
        for table in schema.get("$defs", {}).values():
            described(table)

    for kind in FILES:
        described(json_schema(kind, ALGORITHMS))


def test_the_designs_of_a_sweep_are_those_that_can_be_drawn() -> None:
    sampled = json_schema("sweep", ALGORITHMS)["$defs"]["SweepTable"]["properties"]["design"]["enum"]
    assert set(sampled) == {"", *SAMPLERS}


def test_the_command_writes_the_schema_of_each_kind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def rovbrush(*arguments: str) -> str:
        monkeypatch.setattr(sys, "argv", ["rovbrush", *arguments])
        with pytest.raises(SystemExit) as ending:
            main()
        assert not ending.value.code
        return capsys.readouterr().out

    for kind in FILES:
        path = tmp_path / "new" / f"{kind}.json"
        rovbrush("schema", kind, "--out", str(path))
        assert json.loads(path.read_text()) == json_schema(kind, ALGORITHMS)
    assert rovbrush("schema", "--reference") == reference(ALGORITHMS)


def test_an_unknown_kind_of_file_is_named() -> None:
    with pytest.raises(InputError, match=r"no file of kind 'sytem'; did you mean 'system'\?"):
        json_schema("sytem", ALGORITHMS)
