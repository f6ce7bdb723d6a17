"""The command that shows what an installation has, for whoever has to help with it."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
import sys
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from typing import Annotated

import typer

from ...options import app

NEEDED = ("rovbrush", "numpy", "fmpy", "pythonfmu", "h5py", "pint", "msgspec", "lxml",
          "matplotlib", "typer", "rich")  # fmt: skip
EXTRAS = {
    "numba": "Python FMUs, FMUs for Model Exchange, and a loop that is not shipped",
    "scipy": "studies, and loops at the start",
    "xarray": "results as datasets, and sweeps",
    "dask": "sweeps on a cluster",
    "plotly": "the report",
    "pyccel": "native FMUs from kernels",
}
TOOLS = {
    "C compiler": (("gcc", "cc", "clang"), "native FMUs of this platform cannot be built"),
    "for Windows": (("x86_64-w64-mingw32-gcc",), "native FMUs for win64 cannot be built"),
    "wine": (("wine64", "/usr/lib/wine/wine64", "wine"), "FMUs for Windows cannot be run here"),
}
PATIENCE = 10  # s that a tool may take to tell its version

Line = tuple[str, str, str]  # a heading, what was found, and what is wrong with it


@app.command()
def doctor(
    json_: Annotated[bool, typer.Option("--json", help="As JSON.")] = False,
) -> None:
    """Show versions, compilers, wine, the cache, the FMU folder and the platform; exit with 1 if a run would fail."""
    import json

    lines = [*_platform(), *_packages(), *_tools(), *_windows(), *_folders()]
    if json_:
        print(json.dumps({heading: {"found": found, "wrong": wrong} for heading, found, wrong in lines}, indent=1))
    else:
        for heading, found, wrong in lines:
            print(f"{heading:<14} {found}{f'  <- {wrong}' if wrong else ''}")
    if any(wrong for heading, _, wrong in lines if heading in (*NEEDED, "cache", "the loop", "FMUs", "result files")):
        raise typer.Exit(1)


def _platform() -> Iterator[Line]:
    import fmpy

    yield "Python", f"{platform.python_version()} ({sys.executable})", ""
    yield "system", f"{platform.platform()}, {os.cpu_count()} processors", ""
    yield "FMI platform", f"{fmpy.platform} (1.0 and 2.0), {fmpy.platform_tuple} (3.0)", ""


def _packages() -> Iterator[Line]:
    for name in NEEDED:
        found = _version(name)
        yield name, found or "not installed", "" if found else f"python -m pip install {name}"
    for name, use in EXTRAS.items():
        yield name, _version(name) or f"not installed (needed for {use} only)", ""


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""


def _tools() -> Iterator[Line]:
    for heading, (names, without) in TOOLS.items():
        path = next((found for name in names if (found := shutil.which(name))), None)
        if path is None:
            yield heading, f"none ({without})", ""
            continue
        try:
            done = subprocess.run([path, "--version"], capture_output=True, text=True, timeout=PATIENCE, check=False)
            told = next(iter((done.stdout or done.stderr).splitlines()), "")
        except (OSError, subprocess.TimeoutExpired) as error:
            told = f"does not tell its version: {error}"
        yield heading, f"{told} ({path})", ""


def _windows() -> Iterator[Line]:
    from ....fmu.files.windows import FOLDERS, how_to_install, runs_windows, wine
    from ....participant.windows.build import available

    for target in FOLDERS if runs_windows() else ():
        there = wine(target) and target in available()
        yield (
            f"{target} FMUs",
            "run by wine" if there else f"not run, and not tested, here; {how_to_install(target)}",
            "",
        )


def _folders() -> Iterator[Line]:
    from ....cache.cache import cache_folder, entries, limit
    from ....fmu.files.places import fmu_folder, shipped_folder
    from ....loop.machine.compiled import is_compiled, own_hash
    from ....loop.machine.shipped import library, nothing_compiles

    folder, wrong = cache_folder(), ""
    size = sum(entry.size for entry in entries())
    if not os.access(folder, os.W_OK):
        wrong = "it cannot be written; ROVBRUSH_CACHE names another folder"
    yield "cache", f"{folder}, {size / 1e6:.1f} of {limit() / 1e6:.0f} MB", wrong
    loop = "not compiled yet; the first run does that in half a minute"
    if library(own_hash()):
        loop = "compiled, as it came with the package"
    elif find_spec("numba") is None:
        loop = "not compiled, and nothing that compiles it is installed"
    elif is_compiled():
        loop = "compiled"
    yield "the loop", loop, str(nothing_compiles()) if loop.startswith("not compiled, and") else ""
    place = fmu_folder()
    built = len(list(place.glob("*.fmu"))) if place.is_dir() else 0
    shipped, chosen = shipped_folder(), bool(os.environ.get("ROVBRUSH_FMUS"))
    enough = built or (shipped and not chosen)
    yield "FMUs", f"{built} built, in {place}", "" if enough else "rovbrush build"
    if shipped:
        there = len(list(shipped.glob("*.fmu")))
        order = "not used, since ROVBRUSH_FMUS names a folder" if chosen else "those that are built come first"
        yield "shipped FMUs", f"{there} native of rovbrush {version('rovbrush')}, in {shipped}; {order}", ""
