"""`make first-run`: from nothing to the paper's Table 3 with a wheel, each part timed. No compiler is needed or used.

A fresh virtual environment and an empty home: nothing of rovbrush is installed, unpacked or compiled before. What pip
downloads may come from its cache, which is said; `--no-pip-cache` goes without.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from .sources import ROOT

TABLE = "Paper and simulation"  # the title of Table 3
BOUND = 10.0  # s on two cores, of what follows the installation


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("wheel", nargs="?", type=Path, default=next(iter(sorted((ROOT / "dist").glob("*.whl"))), None))
    parser.add_argument("--no-pip-cache", action="store_true")
    parser.add_argument("--extra", default="", help="an extra to install too, such as all")
    asked = parser.parse_args()
    if asked.wheel is None:
        sys.exit("no wheel in dist/: `make wheel`")
    cache = subprocess.run(
        [sys.executable, "-m", "pip", "cache", "dir"], capture_output=True, text=True, check=True
    ).stdout.strip()  # fmt: skip
    with tempfile.TemporaryDirectory() as temporary:
        print(f"pip's cache: {'none' if asked.no_pip_cache else cache}; {os.cpu_count()} processors", flush=True)
        first_run(asked.wheel.resolve(), Path(temporary), "" if asked.no_pip_cache else cache, asked.extra)


def first_run(wheel: Path, folder: Path, cache: str, extra: str = "") -> None:
    """Install a wheel in a fresh environment below `folder` and run `nominal` there; prints the times."""
    environment = _without_compilers(folder)
    programs = folder / "venv" / ("Scripts" if os.name == "nt" else "bin")
    subprocess.run([sys.executable, "-m", "venv", str(folder / "venv")], check=True)
    before = _size(folder / "venv")
    option = ["--cache-dir", cache] if cache else ["--no-cache-dir"]
    what = f"{wheel}[{extra}]" if extra else str(wheel)
    began = time.perf_counter()
    pip = [str(programs / "python"), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    subprocess.run([*pip, *option, what], check=True, env=environment)
    installed = time.perf_counter()
    print(f"pip install {wheel.name}{f'[{extra}]' if extra else ''}: {installed - began:.1f} s", flush=True)
    print(f"  {(_size(folder / 'venv') - before) / 1e6:.0f} MB installed")
    command = [str(programs / "rovbrush"), "run", "nominal", "--out", str(folder / "results")]
    table = 0.0
    with subprocess.Popen(command, stdout=subprocess.PIPE, env=environment, text=True, cwd=folder) as run:
        assert run.stdout is not None
        for line in run.stdout:
            if line.startswith(TABLE):
                table = time.perf_counter()
            if table:
                print(f"  {line.rstrip()}")
    ended = time.perf_counter()
    if run.returncode:
        sys.exit(f"the run failed with {run.returncode}")
    print(f"from installation to Table 3: {table - installed:.1f} s (wanted: under {BOUND:.0f} s on two cores)")
    print(
        f"from installation to the end of the run: {ended - installed:.1f} s; from pip install: {ended - began:.1f} s"
    )
    began = time.perf_counter()
    subprocess.run(command, check=True, env=environment, cwd=folder, stdout=subprocess.DEVNULL)
    print(f"the same run again: {time.perf_counter() - began:.1f} s")


def _without_compilers(folder: Path) -> dict[str, str]:
    """The environment with an empty home, and a PATH on which there is no compiler."""
    (folder / "home").mkdir()
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("ROVBRUSH", "PYTHON", "XDG", "NUMBA"))}
    kept |= {"HOME": str(folder / "home"), "LOCALAPPDATA": str(folder / "home"), "PATH": str(folder / "venv" / "bin")}
    found = [name for name in ("gcc", "cc", "clang") if shutil.which(name, path=kept["PATH"])]
    assert not found, found
    return kept


def _size(folder: Path) -> int:
    """Bytes of all files in a folder."""
    return sum(path.lstat().st_size for path in folder.rglob("*") if not path.is_dir())


if __name__ == "__main__":
    main()
