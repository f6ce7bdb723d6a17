"""Native FMU files: reproducible, small, valid, with sources that others can compile; what stops a build says so."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import fmpy
import numpy as np
import pytest
from driven import DrivenFmu
from fmpy.build import build_platform_binary
from fmpy.validation import validate_fmu
from helpers import FIXTURES, Measured
from rovbrush.components.build import COMPONENTS, HERE, build
from rovbrush.components.errors import BuildError
from rovbrush.components.native.compile import PLATFORMS, available
from rovbrush.components.native.translate import plain_c

VERSIONS = ("fmi2", "fmi3")


@pytest.mark.sampled(8)
@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("name", COMPONENTS)
def test_native_fmu_is_valid_and_small(name: str, version: str, native: Path, measured: Measured) -> None:
    fmu = native / version / f"{name}.fmu"
    assert validate_fmu(str(fmu)) == []
    with zipfile.ZipFile(fmu) as archive:
        size = sum(
            entry.compress_size for entry in archive.infolist() if not entry.filename.startswith("documentation/")
        )
    measured(f"{name}, native {version}: size without documentation [kB]", size / 1000, "300")
    assert size <= 300_000


def test_two_builds_are_byte_identical(native: Path, tmp_path: Path) -> None:
    platforms = tuple(name for name, p in PLATFORMS.items() if any(map(shutil.which, p.compilers)))
    for path in build(HERE / "dc_motor", tmp_path / "a folder of another name", 0, platforms):
        assert path.read_bytes() == (native / path.parent.name / path.name).read_bytes()


@pytest.mark.evidence
@pytest.mark.skipif(not shutil.which("cmake"), reason="cmake is not installed")
@pytest.mark.parametrize("version", VERSIONS)
def test_another_tool_compiles_the_sources_to_the_same_results(version: str, native: Path, tmp_path: Path) -> None:
    fmu = native / version / "dc_motor.fmu"
    place = PLATFORMS["linux64"].fmi2 if version == "fmi2" else PLATFORMS["linux64"].fmi3
    copy = Path(fmpy.extract(str(fmu), str(tmp_path / "theirs")))
    shutil.rmtree(copy / "binaries")
    (tmp_path / "build").mkdir()
    build_platform_binary(copy, tmp_path / "build")
    assert (copy / "binaries" / place / "dc_motor.so").is_file()
    results = []
    for driven in (DrivenFmu(fmu, tmp_path / "ours", {}), DrivenFmu(fmu, copy, {})):
        driven.start({"V_in": 12.0, "T_brush": -5.0})
        rows = np.tile([12.0, -5.0], (200, 1))
        results.append(driven.run(rows, {"V_in": slice(0, 1), "T_brush": slice(1, 2)}, 1e-3))
    assert np.array_equal(*results)


@pytest.mark.evidence
def test_filaments_can_be_shown_by_the_native_brush_too(tmp_path: Path) -> None:
    pytest.importorskip("pyccel")
    if not any(map(shutil.which, PLATFORMS["linux64"].compilers)):
        pytest.skip("no C compiler")
    native = build(HERE / "filament_brush", tmp_path, 3, ("linux64",))[0]
    python = build(HERE / "filament_brush", tmp_path, 3)[0]
    seen = []
    for name, path in (("native_life", native), ("python_life", python)):
        driven = DrivenFmu(path, tmp_path / name, {})
        driven.start({"omega_b": 15.0, "delta": 0.005})
        for k in range(20):
            driven.slave.doStep(k * 1e-3, 1e-3)
        variables = driven.description.modelVariables
        seen.append(driven.slave.getReal([v.valueReference for v in variables if v.name.startswith("filament_")]))
    assert len(seen[0]) == 12 and any(seen[0])
    assert seen[0] == seen[1]


def test_a_component_without_arrays_has_a_native_fmu_too(fmus: Path, tmp_path: Path) -> None:
    if not any(map(shutil.which, PLATFORMS["linux64"].compilers)):
        pytest.skip("no C compiler")
    native = build(FIXTURES / "gain", tmp_path, 0, ("linux64",))
    rows, seen = np.array([[1.0], [2.5], [-3.0]]), []
    for k, path in enumerate([fmus / "gain.fmu", *native]):
        driven = DrivenFmu(path, tmp_path / f"life{k}", {"k": 2.0})
        driven.start({"u": 1.0})
        state = driven.slave.getFMUState()
        first = driven.run(rows, {"u": slice(0, 1)}, 1e-3)
        driven.slave.setFMUState(state)
        assert np.array_equal(driven.run(rows, {"u": slice(0, 1)}, 1e-3), first)
        seen.append(first)
    assert np.array_equal(seen[0], seen[1]) and np.array_equal(seen[0], seen[2])


def test_missing_compiler_is_named_with_the_package_that_brings_it(tmp_path: Path) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PATH", str(tmp_path))
        with pytest.raises(BuildError, match=r"no compiler for win64 .*apt install gcc-mingw-w64-x86-64.*--platform"):
            build(HERE / "dc_motor", tmp_path, 0, ("win64",))
    assert not list(tmp_path.rglob("*.fmu"))


def test_a_platform_without_a_compiler_is_left_out_and_named_but_the_last_one_is_an_error() -> None:
    found = {"gcc": "/usr/bin/gcc", "x86_64-linux-gnu-gcc": "/usr/bin/gcc"}
    said: list[str] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("shutil.which", found.get)
        assert available(("linux64", "win64"), said.append) == ("linux64",)
        assert len(said) == 1 and "no compiler for win64" in said[0]
        found.clear()
        with pytest.raises(BuildError, match="no compiler for linux64"):
            available(("linux64", "win64"), said.append)
    with pytest.raises(BuildError, match="no platform 'win32'"):
        available(("win32",), said.append)


def test_missing_pyccel_is_named_with_the_extra_that_brings_it(tmp_path: Path) -> None:
    (tmp_path / "pyccel").mkdir()
    (tmp_path / "pyccel" / "__init__.py").write_text("raise ModuleNotFoundError(\"No module named 'pyccel'\")")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", str(tmp_path))
        with pytest.raises(BuildError, match=r'pip install "rovbrush\[native\]"'):
            build(HERE / "dc_motor", tmp_path, 0, ("linux64",))


def test_unknown_platform_is_an_error_of_the_command(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "rovbrush.orchestrator", "build", "--native", "--platform", "darwin64", "--fmus"]
    run = subprocess.run([*command, str(tmp_path)], capture_output=True, text=True, env={**os.environ}, check=False)
    assert run.returncode != 0
    assert "no platform 'darwin64'; there are linux64, win64" in run.stderr
    assert "Traceback" not in run.stderr


def test_translation_refuses_what_has_no_plain_form() -> None:
    with pytest.raises(BuildError, match="no plain form"):
        plain_c("double f(void)\n{\n    return double_max(3, a, b, c);\n}\n")


def test_array_accesses_become_plain() -> None:
    text = "(*cspan_at(&x, INT64_C(0))) = (*cspan_at(&K, r, f((*cspan_at(&p, 1))))) + g(cspan_at(&h, i));"
    assert plain_c(text) == "x[0] = AT(K, r, f(p[1])) + g(&h[i]);\n"


def test_constants_of_a_kernels_file_keep_their_values() -> None:
    text = (
        "double SMALL;\nint64_t ROUNDS;\nint64_t State_x;\nbool initialised = 0;\n"
        "void kernel__init(void)\n{\n    if (!initialised)\n    {\n        State_x = INT64_C(0);\n"
        "        SMALL = 1e-06;\n        ROUNDS = INT64_C(60);\n        initialised = 1;\n    }\n}\n"
        "double f(void)\n{\n    return SMALL;\n}\n"
    )
    assert plain_c(text, {"State_x"}) == (
        "static const double SMALL = 1e-06;\nstatic const int64_t ROUNDS = 60;\n"
        "static double f(void)\n{\n    return SMALL;\n}\n"
    )


def test_changed_token_is_refused_with_a_reason(native: Path, tmp_path: Path) -> None:
    fmu = native / "fmi2" / "dc_motor.fmu"
    folder = Path(fmpy.extract(str(fmu), str(tmp_path / "fmu")))
    description = folder / "modelDescription.xml"
    text = description.read_text()
    token = text.split('guid="')[1].split('"')[0]
    description.write_text(text.replace(token, "{other}"))
    with pytest.raises(Exception, match=r"(?i)instantiate"):
        DrivenFmu(fmu, folder, {})
