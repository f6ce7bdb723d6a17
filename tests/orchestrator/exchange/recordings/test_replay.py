# ruff: noqa: E501  one row per case
"""Record what crosses a component's boundary, drive an FMU alone with it, and compare."""

from __future__ import annotations

from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.util import read_csv, read_ref_opt_file
from helpers import edited, rovbrush, system_text
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.exchange.recordings.read import read_recording
from rovbrush.orchestrator.exchange.recordings.replay import replay
from rovbrush.orchestrator.exchange.recordings.write import write_boundary
from rovbrush.orchestrator.results.tables import require_complete
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.request import changes_of

PARTS = {
    "w": ("wave", "1 ms", {"c0": 0.3, "a": 2.0, "w": 90.0}),
    "g": ("gain", "3 ms", {"k": -1.7, "offset": 0.01}),
    "x": ("integrator", "1 ms", {"x_start": -0.5}),
}
WIRES = ["w.y -> g.u (mean)", "g.y -> x.u (linear)"]


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory, fmus: Path) -> Path:
    """The recordings of a gain and of an integrator, made by the command; the file records less on its own."""
    folder = tmp_path_factory.mktemp("recorded")
    (folder / "case.toml").write_text(system_text(PARTS, WIRES, stop="300 ms", record=["w.y"]), encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        names = ["--record-boundary", "g", "--record-boundary", "x"]
        assert rovbrush(patch, "run", folder / "case.toml", "--fmus", fmus, "--out", folder, *names) == 0
    return folder


@pytest.mark.parametrize(("name", "fmu"), [("g", "gain"), ("x", "integrator")])
def test_the_same_fmu_repeats_every_bit(name: str, fmu: str, recorded: Path, fmus: Path) -> None:
    verdicts = replay(fmus / f"{fmu}.fmu", recorded, name, rtol=0.0).require_within()
    assert {v.text for v in verdicts} == {"equal"} and len(verdicts) >= 2
    assert all(v.scale > 0 for v in verdicts)


def test_the_files_are_in_the_layout_of_the_cross_check(recorded: Path) -> None:
    """Read by fmpy's own functions: one row per communication point, time first."""
    options = read_ref_opt_file(recorded / "g_ref.opt")
    assert (options["StartTime"], options["StopTime"], options["StepSize"]) == (0.0, 0.3, 0.003)
    inputs, outputs = (read_csv(recorded / f"g_{kind}.csv") for kind in ("in", "ref"))
    assert inputs.dtype.names == ("time", "u") and outputs.dtype.names == ("time", "y", "held")
    assert len(inputs) == len(outputs) == 101
    # `held` is the input of the step that ended, so the file of inputs has it one row earlier.
    assert outputs["held"][1:].tobytes() == inputs["u"][:-1].tobytes()


def test_another_master_replays_the_recording(recorded: Path, fmus: Path) -> None:
    """fmpy's simulation, given the two files and the parameters, meets the reference."""
    recording = read_recording(recorded, "x")
    starts = {name: start.value for name, start in recording.starts.items() if start.causality == "parameter"}
    result = fmpy.simulate_fmu(
        str(fmus / "integrator.fmu"), stop_time=0.3, step_size=0.001, output_interval=0.001, start_values=starts,
        input=read_csv(recorded / "x_in.csv"), output=["x"],
    )  # fmt: skip
    reference = read_csv(recorded / "x_ref.csv")
    # The two masters count time differently, which moves a step's length by its last bits.
    np.testing.assert_allclose(result["x"], reference["x"], rtol=0, atol=1e-12)


def test_a_wrong_parameter_is_found_with_its_time(recorded: Path, fmus: Path, tmp_path: Path) -> None:
    (tmp_path / "map.toml").write_text("[variables]\nx_start = ''\n")
    with pytest.raises(RunError, match=r"outside the tolerance: x;.*--rtol"):
        replay(fmus / "integrator.fmu", recorded, "x", tmp_path / "map.toml").require_within()
    verdicts = replay(fmus / "integrator.fmu", recorded, "x", tmp_path / "map.toml", atol=0.5 + 1e-9).require_within()
    assert {v.output: v.text for v in verdicts}["x"] == "within"
    assert {v.output: v.error for v in verdicts}["x"] == pytest.approx(0.5, rel=1e-12)


def test_other_names_directions_and_units_are_mapped(recorded: Path, fmus: Path, tmp_path: Path) -> None:
    xml = {'name="u"': 'name="rate"', 'name="x"': 'name="level"', 'name="x_start"': 'name="first"'}
    fmu = edited(fmus / "integrator.fmu", tmp_path / "their.fmu", {}, xml)
    (tmp_path / "map.toml").write_text(
        "[variables]\nu = { name = 'rate', sign = -1 }\nx = { name = 'level', sign = -1 }\nheld = { sign = -1 }\n"
        "impulse = { sign = -1 }\nx_start = { name = 'first', sign = -1 }\n"
    )
    assert {v.text for v in replay(fmu, recorded, "x", tmp_path / "map.toml", rtol=0.0).require_within()} == {"equal"}


def test_the_command_returns_the_verdict(
    recorded: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    good = rovbrush(monkeypatch, "replay", fmus / "gain.fmu", recorded, "--name", "g")
    (tmp_path / "map.toml").write_text("[variables]\nk = ''\n")
    bad = rovbrush(monkeypatch, "replay", fmus / "gain.fmu", recorded, "--name", "g", "--map", tmp_path / "map.toml")
    assert (good, bad) == (0, 1)
    written = capfd.readouterr()
    assert "equal" in written.out and "outside" in written.out and "as map.toml says" in written.out
    assert "outside the tolerance: y" in written.err


REFUSED = {
    "several recordings": ({}, "", "", ["holds several recordings: g, x", "--name"]),
    "another name": ({}, "gg", "", ["holds no recording 'gg'", "did you mean 'g'"]),
    "no time": ({"g_in.csv": ("time,u", "t,u")}, "g", "", ["g_in.csv: the first column must be time, it is 't'"]),
    "other times": ({"g_in.csv": ("0.003,", "0.0031,")}, "g", "", ["g_in.csv and g_ref.csv hold different times"]),
    "a word for a number": ({"g_ref.csv": ("0.003,", "0.003,x")}, "g", "", ["g_ref.csv, line 3: y = 'x", "is not a number"]),
    "a missing option": ({"g_ref.opt": ("StepSize", "Stepsize")}, "g", "", ["g_ref.opt: StepSize is missing", "did you mean 'Stepsize'"]),
    "a stop before the end": ({"g_ref.opt": ("StopTime, 0.3", "StopTime, 0.2")}, "g", "", ["StopTime = 0.2 lies before the last row of g_ref.csv, 0.3 s"]),
    "a step that is none": ({"g_ref.opt": ("StepSize, 0.003", "StepSize, -1")}, "g", "", ["g_ref.opt: StepSize = -1; write a finite number"]),
    "a tolerance that is none": ({"g_ref.opt": ("RelTol, 1e-06", "RelTol, nan")}, "g", "", ["g_ref.opt: RelTol = nan; write a finite number"]),
    "other columns": ({"g_parameters.csv": ("name,causality", "name,kind")}, "g", "", ["g_parameters.csv: the columns must be"]),
    "a variable that they lack": ({}, "x", "", ["gain.fmu has no output 'x', 'impulse'", '[variables] x = "their name"']),
    "a causality": ({}, "g", "[variables]\nu = 'held'\nheld = ''\n", ["g.u as 'held' of gain.fmu", "causality output, input is needed"]),
}  # fmt: skip


@pytest.mark.parametrize(("changes", "name", "mapping", "words"), REFUSED.values(), ids=REFUSED.keys())
def test_what_cannot_be_replayed_is_refused(
    changes: dict[str, tuple[str, str]],
    name: str,
    mapping: str,
    words: list[str],
    recorded: Path,
    fmus: Path,
    tmp_path: Path,
) -> None:
    for path in recorded.glob("[gx]_*"):
        text = path.read_text(encoding="utf-8")
        old, new = changes.get(path.name, ("", ""))
        assert old in text
        (tmp_path / path.name).write_text(text.replace(old, new, 1) if old else text, encoding="utf-8")
    (tmp_path / "map.toml").write_text(mapping, encoding="utf-8")
    with pytest.raises(InputError) as refused:
        replay(fmus / "gain.fmu", tmp_path, name, tmp_path / "map.toml" if mapping else None).require_within()
    assert all(word in str(refused.value) for word in words), str(refused.value)


def test_an_empty_folder_says_how_to_make_a_recording(fmus: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="--record-boundary"):
        replay(fmus / "gain.fmu", tmp_path).require_within()


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_a_native_controller_repeats_the_bits_of_the_python_one(
    version: str, native: Path, fmus: Path, tmp_path: Path
) -> None:
    """It samples, and in FMI 3.0 its vectors are arrays."""
    run = require_complete(simulate(planned(assemble("nominal", {}, "200 ms", fmus, boundaries=("controller",)))))
    write_boundary(run, "controller", tmp_path)
    verdicts = replay(native / version / "rov_controller.fmu", tmp_path, rtol=0.0).require_within()
    assert {v.text for v in verdicts} == {"equal"}
    assert {f"u_thruster[{k}]" for k in range(1, 9)} <= {v.output for v in verdicts}


def test_what_a_foreign_fmu_did_in_the_loop_replays_with_its_own_mapping(fmus: Path, tmp_path: Path) -> None:
    """The recording is in our names; what only their FMU has comes from the mapping file again."""
    (tmp_path / "case.toml").write_text(system_text(PARTS, WIRES, stop="300 ms"), encoding="utf-8")
    fmu = edited(
        fmus / "gain.fmu", tmp_path / "their.fmu", {}, {'name="u"': 'name="force"', 'name="k"': 'name="factor"'}
    )
    (tmp_path / "map.toml").write_text(
        "[variables]\nu = ''\nk = ''\ny = { sign = -1 }\n[inputs]\nforce = 3.0\n[parameters]\nfactor = 4.0\n"
    )
    changes = changes_of([f"g={fmu}"], [f"g={tmp_path / 'map.toml'}"], [])
    plan = planned(assemble(str(tmp_path / "case.toml"), {}, "", fmus, changes, boundaries=("g",)))
    write_boundary(require_complete(simulate(plan)), "g", tmp_path)
    verdicts = replay(fmu, tmp_path, mapping=tmp_path / "map.toml", rtol=0.0).require_within()
    assert {v.text for v in verdicts} == {"equal"} and verdicts[0].scale == 12.01


VARIABLE = 'canHandleVariableCommunicationStepSize="true"'
FIXED = {VARIABLE: VARIABLE.replace("true", "false")}


def test_fixed_steps_must_be_those_of_the_recording(recorded: Path, fmus: Path, tmp_path: Path) -> None:
    """The recording of the gain has steps of 3 ms."""
    slow = edited(fmus / "gain.fmu", tmp_path / "slow.fmu", {}, {**FIXED, 'stepSize="0.001"': 'stepSize="0.002"'})
    with pytest.raises(InputError, match=r'slow.fmu has fixed steps .* of 2 ms, .* 0.003 s; .*--period NAME="2 ms"'):
        replay(slow, recorded, "g").require_within()
    same = edited(fmus / "gain.fmu", tmp_path / "same.fmu", {}, {**FIXED, 'stepSize="0.001"': 'stepSize="0.003"'})
    assert {v.text for v in replay(same, recorded, "g", rtol=0.0).require_within()} == {"equal"}


def test_fixed_steps_need_a_recording_of_even_steps(recorded: Path, fmus: Path, tmp_path: Path) -> None:
    fmu = edited(fmus / "gain.fmu", tmp_path / "their.fmu", {}, {**FIXED, 'stepSize="0.001"': 'stepSize="0.003"'})
    for path in recorded.glob("g_*"):
        lines = path.read_text().splitlines(keepends=True)
        (tmp_path / path.name).write_text("".join(lines[:5] + lines[6:] if path.name != "g_ref.opt" else lines))
    with pytest.raises(InputError, match=r"their.fmu has fixed steps .* g_ref.csv has steps of several lengths"):
        replay(fmu, tmp_path, "g").require_within()
