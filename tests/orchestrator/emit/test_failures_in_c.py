"""An exported FMU of which a component fails on the way: what is half done is refused, until it is whole again."""

from __future__ import annotations

import os
import re
import subprocess
import zipfile
from pathlib import Path

import pytest
from emit_cases import Masses
from fmpy import read_model_description
from native_build import needs_gcc
from recorder import HOST
from rovbrush.orchestrator.emit import archive
from rovbrush.orchestrator.emit.export import export_fmu

pytestmark = needs_gcc
FAIL = ("EnterInitializationMode", "ExitInitializationMode", "SetFMUstate", "DoStep", "Instantiate", "Terminate",
        "FreeInstance", "SetDebugLogging")  # fmt: skip


def test_what_is_half_done_is_refused_until_it_is_whole_again(
    masses: Masses, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The initialization, a reset, a state that is restored, a step; terminated twice; times that are none."""
    monkeypatch.setattr(archive, "for_windows", lambda: None)
    monkeypatch.setattr(archive, "OPTIONS", tuple(option for option in archive.OPTIONS if option != "-O3"))
    export_fmu(masses(), tmp_path / "whole.fmu")
    with zipfile.ZipFile(tmp_path / "whole.fmu") as opened:
        opened.extractall(tmp_path / "whole")
    description = read_model_description(str(tmp_path / "whole.fmu"))
    number = {v.name: str(v.valueReference) for v in description.modelVariables}
    files = re.findall(r'<File name="(.*?)"', (tmp_path / "whole" / "modelDescription.xml").read_text())
    wrapped = "".join(f",--wrap=force_fmi2{name}" for name in FAIL)
    command = ["gcc", "-std=gnu11", "-g", "-O1", "-w", "-fsanitize=address,undefined", "-I.", *files]
    command += [str(HOST / "failing2.c"), "-o", "failing", "-lm", f"-Wl{wrapped}"]
    made = subprocess.run(command, cwd=tmp_path / "whole/sources", capture_output=True, text=True, check=False)
    if "cannot find" in made.stderr and "san" in made.stderr:
        pytest.skip("the compiler has no sanitizers")
    assert made.returncode == 0, made.stderr
    words = [description.guid, "0.001", number["f.F"], number["f.d"]]
    leaks = os.environ | {"ASAN_OPTIONS": "detect_leaks=0"}  # what has answered Fatal is not freed
    folder = tmp_path / "whole" / "sources"
    done = subprocess.run(["./failing", *words], cwd=folder, env=leaks, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, ""), done.stdout + done.stderr[-3000:]
    assert done.stdout.startswith("good")
