"""The test bench finds what is wrong with a foreign FMU, on its interface and in its behaviour, and says so."""

from __future__ import annotations

import re
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import fmpy
import pytest
from helpers import FIXTURES, build_fixture, edited, python
from rovbrush.components.build import COMPONENTS
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.exchange.component_tests.suites import NotApplicableError, suite_of
from rovbrush.orchestrator.exchange.component_tests.verdicts import make_bench

GOOD_MAP = (FIXTURES / "foreign_motor.toml").read_text(encoding="utf-8")
Mapped = Callable[..., Path]


@pytest.fixture(scope="module")
def motor(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build_fixture("foreign_motor", tmp_path_factory.mktemp("foreign"))


@pytest.fixture
def mapped(tmp_path: Path) -> Mapped:
    def write(text: str = GOOD_MAP, fault: int = 0) -> Path:
        path = tmp_path / "map.toml"
        path.write_text(text + f"\n[parameters]\nfault = {fault}\n")
        return path

    return write


def failed(motor: Path, map_path: Path) -> dict[str, str]:
    """The failing tests' claims, by their first words, and what they say."""
    bench = make_bench(motor, "dc_motor", map_path)
    return {verdict.claim: verdict.text for verdict in bench.judge() if verdict.verdict == "failed"}


def test_sound_motor_passes_and_what_it_lacks_is_told(motor: Path, mapped: Mapped) -> None:
    bench = make_bench(motor, "dc_motor", mapped())
    verdicts = list(bench.judge())
    assert not [v for v in verdicts if v.verdict == "failed"]
    lacking = {v.text for v in verdicts if v.verdict == "not applicable"}
    assert {"needs T_motor", "needs W_electrical", "needs current_limit"} <= lacking
    assert "needs an FMU that can save and restore its state" in lacking
    assert sum(v.verdict == "passed" for v in verdicts) >= 12
    assert all(v.text for v in verdicts if v.verdict == "not applicable")


def test_load_that_drives_is_found(motor: Path, mapped: Mapped) -> None:
    found = failed(motor, mapped(fault=1))
    claim = next(c for c in found if "negative slows it down" in c)
    assert "is the sign of T_brush turned round?" in found[claim]


def test_forgotten_sign_in_the_mapping_is_found(motor: Path, mapped: Mapped) -> None:
    found = failed(motor, mapped(GOOD_MAP.replace("sign = -1, ", "")))
    assert any("negative slows it down" in claim for claim in found)


def test_constants_that_are_five_percent_off_are_found_and_break_no_energy_law(motor: Path, mapped: Mapped) -> None:
    found = failed(motor, mapped(fault=2))
    assert any(claim.startswith("Without load omega_m") for claim in found)
    assert not any(claim.startswith(("Passivity", "In the steady state the shaft gets less")) for claim in found)


def test_energy_out_of_nothing_is_found(motor: Path, mapped: Mapped) -> None:
    found = failed(motor, mapped(fault=3))
    for claim in ("In the steady state the shaft gets less", "In the steady state V_in*i - shaft power"):
        assert any(c.startswith(claim) for c in found)


def test_results_that_do_not_repeat_are_found(motor: Path, mapped: Mapped) -> None:
    found = failed(motor, mapped(fault=4))
    assert any(claim.startswith("Two instances with the same inputs agree") for claim in found)


def test_energy_out_of_nothing_is_found_without_any_parameter(motor: Path, mapped: Mapped) -> None:
    ports = "\n".join(line for line in GOOD_MAP.splitlines() if "{" in line or "[" in line)
    bench = make_bench(motor, "dc_motor", mapped(ports, fault=3))
    verdicts = {v.claim: v.verdict for v in bench.judge()}
    assert verdicts[next(c for c in verdicts if c.startswith("A load that the motor carries"))] == "failed"
    sound = make_bench(motor, "dc_motor", mapped(ports))
    assert "failed" not in {v.verdict for v in sound.judge()}


def test_missing_port_fails_and_the_nearest_name_is_offered(fmus: Path, tmp_path: Path) -> None:
    bad = edited(fmus / "dc_motor.fmu", tmp_path / "bad.fmu", {}, {'name="T_brush"': 'name="T_brsh"'})
    comparison = make_bench(bad, "dc_motor", None).comparison
    (failure,) = comparison.failures
    assert failure.ours == "T_brush" and "did you mean 'T_brsh'?" in failure.text and "mapping file" in failure.text
    assert next(row for row in comparison.rows if row.theirs == "T_brsh").finding == "surplus"


@pytest.mark.parametrize(
    ("old", "new", "finding", "words"),
    [
        ('<Real unit="rad/s"/>', '<Real unit="rpm"/>', "converted", "rad/s becomes omega_b [rpm]"),
        ('<Real unit="rad/s"/>', '<Real unit="N.m"/>', "failed", "the units do not fit"),
        ('<Real unit="rad/s"/>', "<Real/>", "noted", "states no unit; taken as rad/s"),
    ],
)
def test_units_are_converted_refused_or_noted(
    old: str, new: str, finding: str, words: str, fmus: Path, tmp_path: Path
) -> None:
    with zipfile.ZipFile(fmus / "dc_motor.fmu") as archive:
        text = archive.read("modelDescription.xml").decode()
    element = re.search(r'<ScalarVariable name="omega_b".*?</ScalarVariable>', text, re.DOTALL)
    assert element is not None and old in element[0]
    units = {'<Unit name="rad/s">': '<Unit name="rpm" /><Unit name="rad/s">'} if "rpm" in new else {}
    bad = edited(fmus / "dc_motor.fmu", tmp_path / "bad.fmu", {}, {element[0]: element[0].replace(old, new), **units})
    row = next(r for r in make_bench(bad, "dc_motor", None).comparison.rows if r.ours == "omega_b")
    assert row.finding == finding and words in row.text


def test_feedthrough_that_the_component_does_not_have_is_noted(fmus: Path) -> None:
    rows = make_bench(fmus / "constant_speed.fmu", "dc_motor", None).comparison.rows
    noted = {row.ours: row.text for row in rows if row.finding == "noted"}
    assert noted["omega_b"] == "V_in acts on it at once: the loop may need iteration"


def test_unknown_component_and_unknown_names_are_one_message(motor: Path, mapped: Mapped) -> None:
    with pytest.raises(InputError, match="did you mean 'dc_motor'"):
        make_bench(motor, "dc_moter", None)
    with pytest.raises(InputError, match="has no variable 'suply'; did you mean 'supply'"):
        make_bench(motor, "dc_motor", mapped(GOOD_MAP.replace('"supply"', '"suply"')))
    with pytest.raises(FmuError, match="does not exist"):
        make_bench(motor.with_name("nowhere.fmu"), "dc_motor", None)


@pytest.mark.parametrize(
    ("flag", "value", "reason"),
    [
        ("canGetAndSetFMUstate", "false", "needs an FMU that can save and restore its state"),
        ("canBeInstantiatedOnlyOncePerProcess", "true", "needs several instances at a time"),
    ],
)
def test_what_an_fmu_cannot_do_is_not_counted_as_passed(
    flag: str, value: str, reason: str, fmus: Path, tmp_path: Path
) -> None:
    old = f'{flag}="{"true" if value == "false" else "false"}"'
    limited = edited(fmus / "dc_motor.fmu", tmp_path / "limited.fmu", {}, {old: f'{flag}="{value}"'})
    verdicts = list(make_bench(limited, "dc_motor", None, tolerance=0.0).judge())
    assert not [v for v in verdicts if v.verdict == "failed"]
    lacking = [v for v in verdicts if v.verdict == "not applicable"]
    assert lacking and all(v.text.startswith(reason) for v in lacking)


def test_steps_of_several_lengths_are_not_asked_of_an_fmu_that_allows_one(fmus: Path, tmp_path: Path) -> None:
    flag = "canHandleVariableCommunicationStepSize"
    rigid = edited(fmus / "dc_motor.fmu", tmp_path / "rigid.fmu", {}, {f'{flag}="true"': f'{flag}="false"'})
    unit = make_bench(rigid, "dc_motor", None).unit
    running = unit.new({"V_in": 12.0})
    running.step(1e-3)
    with pytest.raises(NotApplicableError, match="the FMU allows one length"):
        running.step(2e-3)
    unit.release()


def test_parameter_beyond_their_range_is_not_applicable(fmus: Path, tmp_path: Path) -> None:
    narrow = edited(
        fmus / "dc_motor.fmu", tmp_path / "narrow.fmu", {},
        {'unit="kg.m2" min="1e-09" max="1.0"': 'unit="kg.m2" min="1e-09" max="0.1"'},
    )  # fmt: skip
    lacking = [v.text for v in make_bench(narrow, "dc_motor", None).judge() if v.verdict == "not applicable"]
    assert lacking == ["needs J_m = 1, outside of 1e-09 to 0.1"]


def test_fmus_that_cannot_be_used_give_one_message_that_says_what_to_ask_for(
    fmus: Path, native: Path, tmp_path: Path
) -> None:
    old = edited(fmus / "dc_motor.fmu", tmp_path / "old.fmu", {}, {'fmiVersion="2.0"': 'fmiVersion="1.0"'})
    words = r"is of FMI version 1\.0 and written as a later one; correct fmiVersion, or export it again"
    with pytest.raises(FmuError, match=words):
        make_bench(old, "dc_motor", None)
    library = f"binaries/{fmpy.platform_tuple}/dc_motor{fmpy.sharedLibraryExtension}"
    windows = "binaries/x86_64-windows/dc_motor.dll"  # which wine would run
    bare = edited(native / "fmi3" / "dc_motor.fmu", tmp_path / "bare.fmu", {library: None, windows: None})
    with pytest.raises(FmuError, match=f"has no binary for {fmpy.platform_tuple}; it has "):
        make_bench(bare, "dc_motor", None)


def command(*arguments: str) -> subprocess.CompletedProcess[str]:
    return python("from rovbrush.orchestrator.cli.main import main; main()", "test-component", *arguments)


def test_command_prints_verdicts_within_100_columns_and_returns_them(
    motor: Path, mapped: Mapped, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "100")
    good = command(str(motor), "--as", "dc_motor", "--map", str(mapped()))
    assert good.returncode == 0, good.stderr
    assert "0 failed" in good.stdout and "not applicable" in good.stdout
    assert "not there, so that tests which need them do not apply: " in good.stdout
    assert max(map(len, good.stdout.splitlines())) <= 100
    bad = command(str(motor), "--as", "dc_motor", "--map", str(mapped(fault=1)))
    assert bad.returncode == 1 and "failed" in bad.stdout
    first, _, again = bad.stdout.partition("What failed")
    assert again.count("│ failed") == first.count("│ failed") > 0 and "│ not applicable" not in again
    wrong = command(str(motor), "--as", "dc_motr")
    assert wrong.returncode == 2 and wrong.stderr.startswith("error: no tests are known for a component 'dc_motr'")


def run_pytest(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """pytest in somebody else's repository."""
    return subprocess.run(
        [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *arguments],
        cwd=folder, capture_output=True, text=True, check=False,
    )  # fmt: skip


def test_plugin_collects_the_suite_in_a_repository_without_tests(motor: Path, mapped: Mapped, tmp_path: Path) -> None:
    good = run_pytest(tmp_path, "--fmu", str(motor), "--as", "dc_motor", "--map", str(mapped()), "-rs")
    assert good.returncode == 0, good.stdout
    assert "passed" in good.stdout and "not applicable: needs T_motor" in good.stdout
    bad = run_pytest(
        tmp_path, "--fmu", str(motor), "--as", "dc_motor", "--map", str(mapped(fault=1)), "-v", "-k", "forward"
    )
    assert bad.returncode == 1
    assert "foreign_motor.fmu::dc_motor::test_voltage_turns_the_brush_forward_and_torque_pushes_it FAILED" in bad.stdout
    assert "is the sign of T_brush turned round?" in bad.stdout
    assert "Traceback" not in bad.stdout and "behaviour.py" not in bad.stdout


def test_plugin_runs_beside_other_tests_and_obeys_k(motor: Path, mapped: Mapped, tmp_path: Path) -> None:
    (tmp_path / "test_theirs.py").write_text("def test_own():\n    pass\n")
    options = ("--fmu", str(motor), "--as", "dc_motor", "--map", str(mapped()))
    run = run_pytest(tmp_path, *options, "-k", "own or no_load_speed or interface_fits", "-v")
    assert run.returncode == 0 and "3 passed" in run.stdout, run.stdout
    for half in (("--rovbrush-fmu", str(motor)), ("--rovbrush-as", "dc_motor")):
        run = run_pytest(tmp_path, *half)
        assert run.returncode == 4 and "go together" in run.stderr


def test_plugin_has_names_of_its_own_and_leaves_the_short_ones_to_others(
    motor: Path, mapped: Mapped, tmp_path: Path
) -> None:
    options = ("--rovbrush-fmu", str(motor), "--rovbrush-as=dc_motor", f"--rovbrush-map={mapped()}")
    run = run_pytest(tmp_path, *options, "-k", "interface_fits")
    assert run.returncode == 0 and "1 passed" in run.stdout, run.stdout + run.stderr
    shown = run_pytest(tmp_path, "--help").stdout
    assert "--rovbrush-fmu" in shown and not re.search(r"^ +--(fmu|as|map)\b", shown, re.M)
    (tmp_path / "conftest.py").write_text(
        "def pytest_addoption(parser):\n    for name in ('--fmu', '--as', '--map'):\n        parser.addoption(name)\n\n"
        "def pytest_configure(config):\n    print('theirs is', config.getoption('--map'))\n"
    )
    (tmp_path / "test_theirs.py").write_text("def test_own():\n    pass\n")
    theirs = run_pytest(tmp_path, "--map", "x.txt", "-s")
    assert theirs.returncode == 0 and "theirs is x.txt" in theirs.stdout, theirs.stdout + theirs.stderr


def test_plugin_imports_nothing_heavy() -> None:
    code = "import sys, rovbrush.orchestrator.exchange.pytest_plugin; print(*sorted(sys.modules))"
    loaded = set(python(code).stdout.split())
    assert not loaded & {"numpy", "numba", "scipy", "fmpy", "pythonfmu", "rich", "typer", "rovbrush.components"}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", COMPONENTS)
def test_turned_sign_of_any_variable_that_systems_need_is_found(name: str, native: Path, tmp_path: Path) -> None:
    unfound = []
    for variable in suite_of(name).essential:
        path = tmp_path / f"{variable}.toml"
        path.write_text(f"[variables]\n{variable} = {{ name = '{variable}', sign = -1 }}\n")
        verdicts = make_bench(native / "fmi2" / f"{name}.fmu", name, path).judge()
        if not any(v.verdict == "failed" for v in verdicts):
            unfound.append(variable)
    assert not unfound
