"""The program of an exported system: what its rows are called, and what it does with numbers that are too large."""

from __future__ import annotations

import csv
import subprocess
from dataclasses import replace
from pathlib import Path

from emit_cases import run_of_system, tables_of
from helpers import edited, read_system
from native_build import needs_gcc
from rovbrush.orchestrator.emit.folder import write_c
from rovbrush.orchestrator.results.files.csv import rate_files

pytestmark = needs_gcc


def test_columns_are_headed_as_those_of_the_run_and_texts_are_left_out(carried: Path, tmp_path: Path) -> None:
    """With units; a whole number beyond the largest signed one keeps its sign, and no address is taken for a text."""
    values = {"=UInt64_in": 2**63 + 5, "=String_in": "one"}
    system = read_system(tmp_path, carried, {"a": ("feedthrough3", "1 ms", values)}, [], stop="2 ms")
    wanted = ("a.UInt64_out", "a.String_out", "a.Boolean_out", "a.Float64_out")
    system = replace(system, record=wanted)
    tables_of(system, tmp_path / "c", "-O0 -w")
    (tmp_path / "run").mkdir()
    rate_files(run_of_system(system), tmp_path / "run")
    heads = {}
    for folder in ("c/rows", "run"):
        with (tmp_path / folder / "every_1_ms.csv").open(encoding="utf-8") as file:
            heads[folder], *rows = csv.reader(file)
        column = heads[folder].index("a.UInt64_out")
        assert {row[column] for row in rows} == {str(2**63 + 5)}
    assert heads["c/rows"][0] == heads["run"][0] == "time [s]"
    assert set(heads["run"]) - set(heads["c/rows"]) == {"a.String_out"}
    assert "a.Float64_out [1]" in heads["c/rows"]
    assert "not among the rows, which are numbers: a.String_out" in write_c(system, tmp_path / "c")


def test_numbers_that_are_too_large_are_refused(carried: Path, tmp_path: Path) -> None:
    system = read_system(tmp_path, carried, {"a": ("feedthrough3", "1 ms")}, [], stop="1 ms")
    tables_of(system, tmp_path / "c", "-O0 -w", "a.Float64_in=1e-320")
    for word in ("a.Float64_in=1e400", "a.Int64_in=9223372036854775808", "a.Int8_in=-99999999999999999999"):
        command = [str(tmp_path / "c" / "case__run"), word]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 2
        assert "the number is too large" in done.stderr


def test_resources_lie_beside_the_program_wherever_it_is_called_from(carried: Path, tmp_path: Path) -> None:
    edited(carried / "mass.fmu", tmp_path / "mass.fmu", {"resources/data.txt": b"1"})
    write_c(read_system(tmp_path, tmp_path, {"a": ("mass", "1 ms")}, [], stop="5 ms"), tmp_path / "c")
    source = tmp_path / "c" / "components" / "mass" / "answers.c"
    asked = '{ fprintf(stderr, "[%s]\\n", resources);'
    text = source.read_text()
    head, _, tail = text.partition("fmi2Instantiate(")
    parameters, _, body = tail.partition("{")
    given = parameters.split(",")[3].split()[-1]
    source.write_text(
        f"#include <stdio.h>\n{head}fmi2Instantiate({parameters}{asked.replace('resources', given)}{body}"
    )
    subprocess.run(["make", "CC=gcc -O0 -w"], cwd=tmp_path / "c", check=True, capture_output=True)
    command = [str(tmp_path / "c" / "case__run"), "--speed"]
    done = subprocess.run(command, cwd="/", capture_output=True, text=True, check=True)
    assert f"[file://{tmp_path}/c/resources/mass/resources]" in done.stderr
