"""The recordings in fmus/recordings: what they hold; every built FMU agrees with them, by `replay` and in C."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import ROOT, Measured
from rovbrush.components.build import COMPONENTS
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.exchange.recordings.read import read_recording
from rovbrush.orchestrator.exchange.recordings.replay import replay
from rovbrush.orchestrator.exchange.recordings.shipped import main, record_all

FOLDER = ROOT / "fmus" / "recordings"
# Another C library rounds sin, exp and others differently in the last digit, which the steps carry on; residuals of
# energy are small differences of joules, hence the same bound as an absolute one.
TOLERANCE = 1e-9
RENEW = "run `python -m rovbrush.orchestrator.exchange.recordings.shipped`"
ENDINGS = ("in.csv", "ref.csv", "ref.opt", "parameters.csv")
# What stays as it is: speed and spin of the constant drive, the gyroscopic moment about the spin, the share of modes
# that are off, and what needs another run.
AT_REST = {
    "dc_motor": {"P_gear", "W_gear"},
    "constant_speed": {"omega_b", "H_spin"},
    "filament_brush": {"P_contact", "W_contact", "kinetic_fraction[4]", "kinetic_fraction[5]", "kinetic_fraction[6]"},
    "cup_brush": {"P_damping", "W_damping", "E_kinetic", "E_centrifugal", "E_contact"},  # what such a brush has not
    "rov_vehicle": {"F_disturb[2]", "M_disturb[1]", "M_disturb[3]", "M_gyro[2]"},
    "rov_controller": {"V_in", "saturated", "saturation_count"},
    "tool_frame": {"H_y"},  # cups spin about z_t
    "mission": {"y_ref", "v_ref[2]"},
    "battery": {"empty"},
    "rov_sensors": set(),
    "hull_fouling": set(),
}


def test_there_is_one_short_recording_per_component() -> None:
    assert {p.name for p in FOLDER.iterdir()} == {f"{name}_{ending}" for name in COMPONENTS for ending in ENDINGS}
    assert sum(p.stat().st_size for p in FOLDER.iterdir()) < 300_000


@pytest.mark.parametrize("name", COMPONENTS)
def test_something_happens_to_every_output(name: str) -> None:
    recording = read_recording(FOLDER, name)
    assert {output for output in recording.outputs if not np.ptp(recording.numbers(output))} == AT_REST[name]


@pytest.mark.parametrize("kind", ["python", "fmi2", "fmi3"])
@pytest.mark.parametrize("name", COMPONENTS)
def test_replay_agrees(name: str, kind: str, fmus: Path, native: Path, measured: Measured) -> None:
    folder = fmus if kind == "python" else native / kind
    verdicts = replay(folder / f"{name}.fmu", FOLDER, name, rtol=TOLERANCE, atol=TOLERANCE).require_within()
    assert {v.output for v in verdicts} == set(read_recording(FOLDER, name).outputs)
    worst = max(v.error / v.scale for v in verdicts if v.scale)
    measured("shipped recordings replayed: largest error of an output's magnitude", worst, "1e-9")


def test_the_recordings_are_what_their_command_writes_today(native: Path, tmp_path: Path) -> None:
    record_all(native / "fmi2", tmp_path)
    for name in COMPONENTS:
        kept, made = read_recording(FOLDER, name), read_recording(tmp_path, name)
        assert (made.options, list(made.inputs), list(made.outputs)) == (
            kept.options, list(kept.inputs), list(kept.outputs)
        ), RENEW  # fmt: skip
        given = [{k: s for k, s in r.starts.items() if s.causality == "parameter"} for r in (kept, made)]
        assert given[0] == given[1]
        for old, new in ((kept.inputs, made.inputs), (kept.outputs, made.outputs)):
            for key in old:
                before, after = np.array(old[key], dtype=float), np.array(new[key], dtype=float)
                scale = float(np.max(np.abs(before)))
                np.testing.assert_allclose(after, before, rtol=0, atol=TOLERANCE * (1 + scale), err_msg=RENEW)


def test_the_command_that_renews_them_names_what_it_wrote(
    native: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    main(native / "fmi2", tmp_path)
    assert len(capsys.readouterr().out.splitlines()) == len(COMPONENTS) * len(ENDINGS)
    with pytest.raises(SystemExit) as ending:
        main(tmp_path / "nowhere", tmp_path)
    assert ending.value.code == FmuError.exit_code
    assert "error: FMU" in capsys.readouterr().err
