"""What FMI 3.0 says of clocks, binaries and early returns is kept as it is written, and shown."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import edited, rovbrush
from native_build import built, needs_gcc
from rovbrush.orchestrator.cli.console import console
from rovbrush.orchestrator.fmu.contents import contents_of
from rovbrush.orchestrator.fmu.fmu import Fmu

pytestmark = needs_gcc

CLOCKS = (
    '<Clock name="tick" valueReference="300" causality="input" intervalVariability="constant" '
    'intervalDecimal="0.0166666666666666666666" declaredType="Frame"/>'
    '<Clock name="alarm" valueReference="301" causality="input" intervalVariability="countdown" priority="2"/>'
)
TYPES = (
    '<TypeDefinitions><ClockType name="Frame" intervalVariability="constant" shiftDecimal="0.5" priority="1"/>'
    '<BinaryType name="Picture" mimeType="image/png" maxSize="1000"/>'
)


@pytest.fixture(scope="module")
def clocked(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("clocked")
    made = built(folder) / "feedthrough3.fmu"
    return edited(made, folder / "clocked.fmu", {}, {
        "<TypeDefinitions>": TYPES, '<Float64 name="time"': f'{CLOCKS}<Float64 name="time"',
        '<Binary name="blob"': '<Binary name="blob" declaredType="Picture" maxSize="64"',
        '<Int8 name="Int8_in"': '<Int8 clocks="300" name="Int8_in"',
        'canGetAndSetFMUState="true"': 'canGetAndSetFMUState="true" mightReturnEarlyFromDoStep="true" '
        'providesIntermediateUpdate="true" hasEventMode="true"',
        '<Float64 name="Float64_in"': '<Float64 intermediateUpdate="true" name="Float64_in"',
    })  # fmt: skip


def test_attributes_of_clocks_and_binaries_are_their_own_then_those_of_their_type(clocked: Path) -> None:
    fmu = Fmu.open(clocked)
    assert fmu.details["tick"] == {
        "intervalVariability": "constant", "intervalDecimal": "0.0166666666666666666666", "shiftDecimal": "0.5",
        "priority": "1",
    }  # fmt: skip
    assert fmu.details["alarm"] == {"intervalVariability": "countdown", "priority": "2"}
    assert fmu.details["blob"] == {"mimeType": "image/png", "maxSize": "64"}
    assert fmu.details["Float64_in"] == {"intermediateUpdate": "true"}
    assert not [note for note in fmu.notes if "mimeType" in note.found or "Frame" in note.found], fmu.notes


def test_info_shows_clocks_with_their_intervals_and_what_is_clocked(
    clocked: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(console, "width", 300)
    assert rovbrush(monkeypatch, "info", clocked, "--all") == 0
    said = capsys.readouterr().out
    assert "intervalVariability = constant; intervalDecimal = 0.0166666666666666666666" in said
    assert "clocked by tick" in said and "maxSize = 64" in said


def test_info_says_that_an_fmu_may_return_early_and_update_in_between(clocked: Path) -> None:
    found = contents_of(Fmu.open(clocked))["capabilities"]
    assert found["mightReturnEarlyFromDoStep"] and found["providesIntermediateUpdate"] and found["hasEventMode"]
    assert "recommendedIntermediateInputSmoothness" not in found
