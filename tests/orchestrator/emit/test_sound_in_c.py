"""Exported C under sanitizers, and what strangers meet first: names, values given, folders, short runs."""

from __future__ import annotations

import os
import re
import subprocess
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest
from emit_cases import Masses, differing, run_of_system, tables_of
from fmpy import read_model_description
from helpers import edited, read_system
from native_build import FREE3, needs_gcc
from recorder import HOST
from rovbrush.orchestrator.emit import archive
from rovbrush.orchestrator.emit.code.names import cell_identifiers, number, system_identifier
from rovbrush.orchestrator.emit.code.own_names import own_names
from rovbrush.orchestrator.emit.export import export_fmu
from rovbrush.orchestrator.emit.folder import write_c
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.system.model import System

pytestmark = needs_gcc
SANITIZED = ["-g", "-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=undefined"]


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Libraries for Linux only, not optimized."""
    monkeypatch.setattr(archive, "for_windows", lambda: None)
    monkeypatch.setattr(archive, "OPTIONS", tuple(option for option in archive.OPTIONS if option != "-O3"))


def types(folder: Path, carried: Path) -> System:
    """Two FMUs of FMI 3.0 with variables of every type."""
    wires = [f"a.{v[1:-3]}_out -> b.{v[1:]}" for v in FREE3 if v not in ("=String_in", "=t_in", "=Int8_in")]
    parts = {"a": ("feedthrough3", "1 ms", FREE3), "b": ("feedthrough3", "2 ms")}
    return read_system(folder, carried, parts, wires, stop="8 ms", algorithm="jacobi")


@pytest.mark.parametrize("case", ["masses", "types"])
def test_no_sanitizer_finds_anything_in_all_of_an_fmus_life(
    case: str, quick: None, masses: Masses, carried: Path, tmp_path: Path
) -> None:
    """Two instances, states kept, cut and read again, resets, wrong calls; nothing is left when it ends."""
    export_fmu(masses() if case == "masses" else types(tmp_path, carried), tmp_path / "whole.fmu")
    with zipfile.ZipFile(tmp_path / "whole.fmu") as opened:
        opened.extractall(tmp_path / "whole")
    description = read_model_description(str(tmp_path / "whole.fmu"))
    files = re.findall(r'<File name="(.*?)"', (tmp_path / "whole" / "modelDescription.xml").read_text())
    command = ["gcc", "-std=gnu11", *SANITIZED, "-I.", *files, str(HOST / "life2.c"), "-o", "life", "-lm"]
    made = subprocess.run(command, cwd=tmp_path / "whole/sources", capture_output=True, text=True, check=False)
    if "cannot find" in made.stderr and "san" in made.stderr:
        pytest.skip("the compiler has no sanitizers")
    assert made.returncode == 0, made.stderr
    outputs = [v for v in description.modelVariables if v.causality == "output" and v.type == "Real"][:40]
    words = [description.guid, "0.002", "6", *(str(v.valueReference) for v in outputs)]
    done = subprocess.run(
        ["./life", *words], cwd=tmp_path / "whole/sources", capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("good")
    assert "a cannot make a step now" in done.stderr


@pytest.mark.parametrize("stop", ["2 ms", "3 ms"])
def test_a_run_that_is_shorter_than_its_hyperperiod_ends_where_the_run_does(
    stop: str, masses: Masses, tmp_path: Path
) -> None:
    system = masses(stop=stop)
    assert differing(tables_of(system, tmp_path / "c", "-O0 -w"), run_of_system(system)) == []


def test_a_short_run_that_ends_between_instants_is_refused_as_a_program(masses: Masses, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"ends at 2.5 ms, between two instants .*another stop_time"):
        write_c(masses(stop="2.5 ms"), tmp_path / "c")
    assert not (tmp_path / "c").exists()


def test_values_on_the_command_line_are_numbers_or_refused(carried: Path, tmp_path: Path) -> None:
    parts = {"a": ("feedthrough2", "1 ms")}
    system = read_system(tmp_path, carried, parts, [], stop="2 ms")
    system = replace(system, record=("a.on_out", "a.n_out"))
    tables = tables_of(system, tmp_path / "c", "-O0 -w", "a.on_in=true", "a.n_in=-3")
    assert set(tables["every_1_ms.csv"]["a.on_out"]) == {1.0}
    assert set(tables["every_1_ms.csv"]["a.n_out"]) == {-3.0}
    (program,) = (tmp_path / "c").glob("*_run")
    for word, said in (
        ("a.u=fast", "a number is wanted"),
        ("a.n_in=", "a number is wanted"),
        ("a.nn=1", "no variable"),
    ):
        done = subprocess.run([str(program), word], cwd=tmp_path / "c", capture_output=True, text=True, check=False)
        assert done.returncode == 2
        assert said in done.stderr and not done.stdout


@pytest.mark.parametrize("name", ["time", "system", "bool", "Event", "TABLES", "begin_1", "a_F", "fault", "s" * 300])
def test_a_system_may_be_called_like_something_of_c(name: str, carried: Path, tmp_path: Path) -> None:
    system = read_system(tmp_path, carried, {"a": ("mass", "1 ms", {"x0": 0.1})}, [], stop="5 ms")
    system = replace(system, name=name)
    assert differing(tables_of(system, tmp_path / "c", "-O0 -w"), run_of_system(system)) == []


def test_names_of_cells_meet_no_function_and_numbers_are_c() -> None:
    names = cell_identifiers(
        ["M.PI", "T.FLOAT64", "case.step", "length.to", "sent.back", "strtok.r", "case"], [], "case"
    )
    assert names == [
        "cell_M_PI",
        "cell_T_FLOAT64",
        "cell_case_step",
        "length_to_2",
        "cell_sent_back",
        "cell_strtok_r",
        "cell_case",
    ]
    names = cell_identifiers(["begin.1", "held.at", "size.t", "a.b", "a_b", "motor.i"], ["PART_A"], "case")
    assert names == ["cell_begin_1", "held_at_2", "cell_size_t", "a_b", "a_b_2", "motor_i"]
    assert [number(x) for x in (float("nan"), float("-inf"), 0.1)] == ["NAN", "-INFINITY", "0.1"]
    assert [system_identifier(x) for x in ("Time", "hull_pass", "double", "NULL", "Event", "watch", "PART_A")] == [
        "Time_", "hull_pass", "double_", "NULL_", "Event_", "watch_", "PART_A_",
    ]  # fmt: skip
    assert {"Part", "CALL", "T_INT8", "STEP_TICKS", "part_of_step", "row", "seconds"} <= own_names()


def test_cells_may_be_called_like_functions_and_macros_of_the_file_that_they_are_in(
    carried: Path, tmp_path: Path
) -> None:
    """`a.step` in the system `a` beside its function `a_step`, `M.PI` beside that of `math.h`."""
    for name, x, v in (("one", "step", "find"), ("two", "PI", "FLOAT64"), ("three", "to", "back")):
        with zipfile.ZipFile(carried / "mass.fmu") as opened:
            xml = opened.read("modelDescription.xml").decode()
        xml = xml.replace('name="x"', f'name="{x}"').replace('name="v"', f'name="{v}"')
        edited(carried / "mass.fmu", tmp_path / f"{name}.fmu", {"modelDescription.xml": xml.encode()})
    parts = {"a": ("one", "1 ms", {"x0": 0.1}), "M": ("two", "1 ms"), "T": ("two", "2 ms"), "sent": ("three", "1 ms"),
             "length": ("three", "2 ms")}  # fmt: skip
    wires = ["a.step -> M.F (mean)", "M.FLOAT64 -> T.F", "T.PI -> sent.F", "sent.back -> length.F (linear)"]
    system = replace(read_system(tmp_path, tmp_path, parts, wires, stop="8 ms", algorithm="jacobi"), name="a")
    assert differing(tables_of(system, tmp_path / "c", "-O0 -w"), run_of_system(system)) == []


def test_files_of_sources_that_are_alike_when_cleaned_stay_apart(carried: Path, tmp_path: Path) -> None:
    """The file `b_c` of an FMU `a` beside the file `c` of `a_b`; and `x-y` beside `x_y`."""
    for name, file, other in (("a", "b_c.c", "x-y.c"), ("a_b", "c.c", "x_y.c")):
        with zipfile.ZipFile(carried / "mass.fmu") as opened:
            source, xml = opened.read("sources/answers.c"), opened.read("modelDescription.xml").decode()
        listed = f'<File name="{file}"/><File name="{other}"/><File name="{other.replace("-", "_")}"/>'
        xml = re.sub('<File name="answers.c"/>', listed, xml)
        changes: dict[str, bytes | None] = {
            "modelDescription.xml": xml.encode(), "sources/answers.c": None, f"sources/{file}": source,
            f"sources/{other}": b"int first;\n", f"sources/{other.replace('-', '_')}": b"int second;\n",
        }  # fmt: skip
        edited(carried / "mass.fmu", tmp_path / f"{name}.fmu", changes)
    parts = {"p": ("a", "1 ms", {"x0": 0.1}), "q": ("a_b", "1 ms", {"x0": 0.3})}
    system = read_system(tmp_path, tmp_path, parts, ["p.x -> q.F"], stop="8 ms", algorithm="jacobi")
    assert differing(tables_of(system, tmp_path / "c", "-O0 -w"), run_of_system(system)) == []


FOLDERS = """
#include <stdio.h>
#include "case__inside.h"
int main(int count, char **words) {
    static case_ s;
    char path[3000], uri[9000];
    for (int k = 1; k < count; k++) {
        s.resources = words[k];
        case__folder(&s, 0, false, path, sizeof path);
        case__folder(&s, 0, true, uri, sizeof uri);
        printf("%s %s\\n", path, uri);
    }
    return 0;
}
"""


def test_components_find_their_resources_whatever_the_host_says(carried: Path, tmp_path: Path) -> None:
    """A host of FMI 2.0 gives a URI, one of FMI 3.0 a path; components of both are inside."""
    edited(carried / "mass.fmu", tmp_path / "mass.fmu", {"resources/data.txt": b"1"})
    write_c(read_system(tmp_path, tmp_path, {"a": ("mass", "1 ms")}, [], stop="5 ms"), tmp_path / "c")
    (tmp_path / "c" / "folders.c").write_text(FOLDERS)
    subprocess.run(["make", "CC=gcc -O0 -w", "libcase_.a"], cwd=tmp_path / "c", check=True, capture_output=True)
    command = ["gcc", "-I.", "folders.c", "libcase_.a", "-lm", "-o", "folders"]
    subprocess.run(command, cwd=tmp_path / "c", check=True)
    given = ["/x/h\u00fcll/resources", "/x/y/", "file:///x/h%C3%BCll/a%20b", "file:/x", "file:///C:/x%20y", "C:\\x\\y"]
    given += ["file://localhost/x", "FILE:///x", "file://machine/x", "file://C:/x", "file:C:/x", "file:////server/x"]
    given += ["\\\\server\\x", "/100%25/x", "file:///100%/x%2", "file:///a%+5b", "file:///a%00b%2fc"]
    done = subprocess.run(["./folders", *given], cwd=tmp_path / "c", capture_output=True, check=True)
    assert done.stdout.decode().splitlines() == [
        "/x/h\u00fcll/resources/mass/resources/ file:///x/h%C3%BCll/resources/mass/resources",
        "/x/y/mass/resources/ file:///x/y/mass/resources",
        "/x/h\u00fcll/a b/mass/resources/ file:///x/h%C3%BCll/a%20b/mass/resources",
        "/x/mass/resources/ file:///x/mass/resources",
        "C:/x y/mass/resources/ file:///C:/x%20y/mass/resources",
        "C:\\x\\y/mass/resources/ file:///C:/x/y/mass/resources",
        "/x/mass/resources/ file:///x/mass/resources",
        "/x/mass/resources/ file:///x/mass/resources",
        "/x/mass/resources/ file:///x/mass/resources",  # of this machine, whatever it is called
        "C:/x/mass/resources/ file:///C:/x/mass/resources",
        "C:/x/mass/resources/ file:///C:/x/mass/resources",
        "//server/x/mass/resources/ file:////server/x/mass/resources",
        "\\\\server\\x/mass/resources/ file:////server/x/mass/resources",
        "/100%25/x/mass/resources/ file:///100%2525/x/mass/resources",  # a path is none of a URI
        "/100%/x%2/mass/resources/ file:///100%25/x%252/mass/resources",
        "/a%+5b/mass/resources/ file:///a%25%2B5b/mass/resources",
        "/a%00b/c/mass/resources/ file:///a%2500b/c/mass/resources",
    ]
    assert os.sep == "/"
