"""What a system file wants reported is checked before the run: found after it, a slip would cost the results."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import system_text
from native_build import FREE2, built, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.shipped import SYSTEMS, shipped_systems

MORE = """
[[compare]]
label = "F_z"
value = "F_z_mean"
unit = "N"
reference = -221.7
tolerance = 0.01

[[figures]]
kind = "mode_shapes"
file = "shapes.png"
title = "shapes"
component = "brush"
modes = 3
"""

WRONG = {
    "window that is no table": ('{ angle = "brush.theta_b", start = 2.5 }', "5", "window must be a table"),
    "unknown key of the window": ("{ angle = ", "{ angel = ", "unknown key 'angel'; did you mean 'angle'?"),
    "start that is no number": ("start = 2.5", 'start = "x"', "start = 'x' is not a number"),
    "unknown angle": ("brush.theta_b", "brush.theta", "'brush.theta' is not recorded; did you mean 'brush.theta_b'?"),
    "unknown figure of merit": ('value = "F_z_mean"', 'value = "F_zmean"', "did you mean 'F_z_mean'?"),
    "comparison without a reference": ("reference = -221.7", "", "compare F_z: 'reference' is missing"),
    "reference without a ratio": ("reference = -221.7", "reference = 0.0", "compare F_z: reference = 0"),
    "tolerance that is no number": ("tolerance = 0.01", 'tolerance = "1 %"', "tolerance = '1 %' is not a number"),
    "unknown signal of a figure": ('"brush.F_x"', '"brush.F_xx"', "figure forces.png: 'brush.F_xx' is not recorded"),
    "figure outside the results": ('"forces.png"', '"../forces.png"', "plain name that ends in .png"),
    "unknown format": ('"forces.png"', '"forces.xyz"', "plain name that ends in .png"),
    "misspelt key of a figure": ("signals = ", "signal = ", "unknown key 'signal'; did you mean 'signals'?"),
    "unknown kind of figure": ('kind = "mode_shapes"', 'kind = "shapes"', "unknown kind 'shapes'"),
    "more modes than there are": ("modes = 3", "modes = 7", "modes = 7; brush has 6 modes"),
    "component without modes": ('component = "brush"', 'component = "motor"', "motor has 0 modes"),
    "unknown component of a figure": ('component = "brush"', 'component = "brosh"', "did you mean 'brush'?"),
}


@pytest.mark.parametrize("slip", WRONG)
def test_a_slip_in_what_is_to_be_reported_is_found_before_the_run(slip: str, tmp_path: Path, fmus: Path) -> None:
    old, new, hint = WRONG[slip]
    text = (SYSTEMS / "test_stand.toml").read_text(encoding="utf-8") + MORE
    path = tmp_path / "case.toml"
    path.write_text(text, encoding="utf-8")
    planned(assemble(str(path), {}, fmus=fmus))
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")
    with pytest.raises(InputError) as error:
        planned(assemble(str(path), {}, fmus=fmus))
    assert str(error.value).startswith("case.toml: ") and hint in str(error.value)


@pytest.mark.parametrize("name", shipped_systems())
def test_what_the_shipped_systems_report_can_be_made(name: str, fmus: Path) -> None:
    planned(assemble(name, {}, fmus=fmus))


@needs_gcc
@pytest.mark.parametrize("where", ['[summary]\nbad = "last a.s_out"', '[summary]\nwindow = { angle = "a.s_out" }',
                                   '[balance]\nlost = ["a.s_out"]'])  # fmt: skip
def test_a_text_where_a_number_is_wanted_is_found_before_the_run(where: str, tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_text(system_text({"a": ("feedthrough2", "1 ms", FREE2)}) + where)
    with pytest.raises(InputError, match=r"'a\.s_out' is a text"):
        planned(assemble(str(path), fmus=built(tmp_path)))
