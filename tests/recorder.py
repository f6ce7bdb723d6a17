"""The host in C of `fixtures/host/recorder.c`, for this machine and for Windows: the outputs of an FMU, bit for bit."""

from __future__ import annotations

import os
import shutil
import subprocess
import zipfile
from pathlib import Path

import numpy as np
from compiled_once import kept_folder
from fmpy import read_model_description
from rovbrush.orchestrator.fmu.files.windows import wine
from rovbrush.orchestrator.studies.bench.fmus.native import HEADERS

HOST = Path(__file__).parent / "fixtures" / "host"
PLACES = {"linux": {"2.0": "linux64", "3.0": "x86_64-linux"}, "windows": {"2.0": "win64", "3.0": "x86_64-windows"}}
COMPILERS = {"linux": "gcc", "windows": "x86_64-w64-mingw32-gcc"}
ENDINGS = {"linux": ".so", "windows": ".dll"}


def recorder(version: str, platform: str) -> Path:
    """The host's program."""
    folder = kept_folder()
    folder.mkdir(parents=True, exist_ok=True)
    made = folder / f"recorder{version[0]}_{platform}_{os.getpid()}.exe"
    if not made.is_file():
        compiler = shutil.which(COMPILERS[platform])
        assert compiler is not None
        third = ["-DFMI3"] if version == "3.0" else []
        last = ["-ldl"] if platform == "linux" else []
        command = [compiler, "-O1", *third, str(HOST / "recorder.c"), f"-I{HEADERS}", "-o", str(made), *last]
        subprocess.run(command, check=True, capture_output=True)
    return made


def recorded(
    fmu: Path, platform: str, step: float, steps: int, every: int = 1, library: Path | None = None
) -> dict[str, np.ndarray]:
    """The outputs of type double by name, at the start and behind every `every` steps.

    `library`: in the place of the FMU's own.
    """
    description = read_model_description(str(fmu))
    version = description.fmiVersion
    work = fmu.parent / f"{fmu.stem}_{platform}"
    with zipfile.ZipFile(fmu) as archive:
        archive.extractall(work)
    identifier = description.coSimulation.modelIdentifier
    own = work / "binaries" / PLACES[platform][version] / f"{identifier}{ENDINGS[platform]}"
    outputs = {
        v.name: v.valueReference
        for v in description.modelVariables
        if v.causality == "output" and v.type in ("Real", "Float64")
    }
    (work / "references").write_text("\n".join(map(str, outputs.values())))
    command = [str(recorder(version, platform)), str(library or own), description.guid]
    command += [(work / "resources").as_uri() if version == "2.0" else str(work / "resources")]
    command += [repr(step), str(steps), str(every), "references", "rows"]
    if platform == "windows":
        command.insert(0, str(wine("win64")))
    environment = os.environ | {"WINEDEBUG": "-all"}
    done = subprocess.run(command, cwd=work, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{done.returncode}: {done.stderr[-2000:]}"
    rows = np.fromfile(work / "rows").reshape(-1, len(outputs))
    return dict(zip(outputs, rows.T, strict=True))
