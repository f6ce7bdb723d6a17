"""FMUs for Windows for tests: what `native_build` makes for this machine, with libraries that mingw-w64 makes."""

from __future__ import annotations

import os
import shutil
import subprocess
import time
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path

import clock_build
import exchange_build
import pytest
from compiled_once import compiled_once
from filelock import FileLock
from native_build import NATIVE
from rovbrush.orchestrator.fmu.files.windows import FOLDERS, runs_windows, wine
from rovbrush.orchestrator.participant.windows.build import COMPILERS
from rovbrush.orchestrator.studies.bench.fmus.native import HEADERS
from rovbrush.orchestrator.studies.bench.fmus.native import SOURCES as SHARED

LACKING = [] if runs_windows() else ["Linux on x86-64"]
LACKING += [
    name for name, found in (("wine64", wine("win64")), ("mingw-w64", shutil.which(COMPILERS["win64"]))) if not found
]


def made_folder() -> None:
    """Let wine make its folder once, before several processes would at the same time."""
    folder = Path(os.environ.get("WINEPREFIX") or Path.home() / ".wine")
    folder.parent.mkdir(parents=True, exist_ok=True)
    with FileLock(f"{folder}.lock"):
        if not (folder / "system.reg").is_file():
            environment = os.environ | {"WINEDLLOVERRIDES": "mscoree,mshtml=", "WINEDEBUG": "-all", "DISPLAY": ""}
            command = [str(wine("win64")), "wineboot", "-i"]
            subprocess.run(command, env=environment, capture_output=True, check=False, timeout=300)
            for _ in range(300):  # it is written when the server of wine ends
                if (folder / "system.reg").is_file():
                    break
                time.sleep(0.1)


if not LACKING:
    made_folder()
needs_wine = pytest.mark.skipif(bool(LACKING), reason=f"FMUs for Windows need {' and '.join(LACKING)}")
SOURCES = {"feedthrough2": ["feedthrough2.c"], "feedthrough3": ["feedthrough3.c", "unused3.c"], "first": ["first.c"],
           "moody": ["moody.c"]}  # fmt: skip


def for_windows(
    fmu: Path, target: Path, sources: Sequence[Path], defines: Mapping[str, object] | None = None,
    platform: str = "win64", keep: bool = False,
) -> Path:  # fmt: skip
    """A copy of an FMU of this machine with a library of the same C sources for Windows; `keep`: beside its own."""
    with zipfile.ZipFile(fmu) as archive:
        entries = {name: archive.read(name) for name in archive.namelist()}
    third = b'fmiVersion="3' in entries["modelDescription.xml"]
    options = ["-Dpause()=usleep(1000)", *(f"-D{key}={value}" for key, value in (defines or {}).items())]  # no POSIX
    command = [COMPILERS[platform], "-O2", "-shared", "-static-libgcc", "-s", f"-I{HEADERS}", f"-I{SHARED}", *options]

    def compile_to(made: Path) -> None:
        subprocess.run([*command, *map(str, sources), "-o", str(made)], check=True, capture_output=True)

    library = compiled_once(command, sources, compile_to)
    with zipfile.ZipFile(target, "w") as archive:
        for name, content in entries.items():
            if keep or not name.startswith("binaries/"):
                archive.writestr(name, content)
        archive.writestr(f"binaries/{FOLDERS[platform][third]}/{fmu.stem}.dll", library)
    return target


def feedthrough_for_windows(native: Path, target: Path, platform: str = "win64", keep: bool = False) -> Path:
    """`feedthrough2` or `feedthrough3`, which `native` is."""
    sources = [NATIVE / name for name in SOURCES[native.stem]]
    return for_windows(native, target, sources, platform=platform, keep=keep)


def clocked_for_windows(folder: Path, target: Path) -> Path:
    """Every FMU of `clock_build`, which are in `folder`, with a library for win64 only."""
    for model in clock_build.MODELS:
        sources = [clock_build.EVENTS / f"{model}.c", clock_build.EVENTS / "unused.c"]
        defines = {"COUNTER": 1, "RESOLUTION": 60, "CALCULATED": 0}
        for_windows(folder / f"{model}.fmu", target / f"{model}.fmu", sources, defines)
    return target


def exchange_for_windows(fmu: Path, folder: Path, version: int) -> Path:
    """An FMU that `exchange_build` made, with a library for win64 only."""
    defines = {"FMI": version, **({"STRIKER": 1} if fmu.stem == "striker" else {})}
    return for_windows(fmu, folder / fmu.name, [exchange_build.MODELS_BY_NAME[fmu.stem].source], defines)
