"""The server that loads an FMU's library under wine: C sources of this package, compiled by mingw-w64 once."""

from __future__ import annotations

import hashlib
import shutil
import subprocess
from pathlib import Path

from ...cache import cache
from ...errors import FmuError
from ...fmu.files.windows import how_to_install

SOURCES = Path(__file__).parent / "server"
COMPILERS = {"win64": "x86_64-w64-mingw32-gcc", "win32": "i686-w64-mingw32-gcc"}
OPTIONS = ("-std=gnu11", "-O2", "-Wall", "-D__USE_MINGW_ANSI_STDIO=1", "-static", "-s", "-Wl,--no-insert-timestamp")
PATIENCE = 120.0  # s


def server(platform: str) -> Path:
    """The program for win64 or win32, compiled unless it has been. Raises FmuError where it cannot be."""
    digest = hashlib.sha256("\0".join(OPTIONS).encode())
    sources = sorted(SOURCES.glob("*.[ch]"))
    for source in sources:
        digest.update(source.read_bytes())
    entry = cache.place("servers", f"{platform}_{digest.hexdigest()[:24]}")
    program = entry / "server.exe"
    if not program.is_file():
        _compile(platform, [source for source in sources if source.suffix == ".c"], program)
    cache.mark_used(entry)
    return program


def available() -> list[str]:
    """The platforms for which there is a compiler."""
    return [platform for platform, compiler in COMPILERS.items() if shutil.which(compiler)]


def _compile(platform: str, sources: list[Path], program: Path) -> None:
    compiler = shutil.which(COMPILERS[platform])
    if compiler is None:
        raise FmuError(f"{COMPILERS[platform]} is missing, which makes what loads the FMU; {how_to_install(platform)}")
    with cache.workspace() as work:
        made = work / "server.exe"
        try:
            done = subprocess.run(
                [compiler, *OPTIONS, *map(str, sources), "-o", str(made)], cwd=work, stdin=subprocess.DEVNULL,
                capture_output=True, text=True, timeout=PATIENCE, check=False,
            )  # fmt: skip
        except (OSError, subprocess.TimeoutExpired) as error:
            raise FmuError(f"the server for {platform} cannot be compiled: {error}") from error
        if done.returncode:
            raise FmuError(f"the server for {platform} cannot be compiled by {compiler}:\n{done.stderr.strip()}")
        program.parent.mkdir(mode=0o700, exist_ok=True)
        made.replace(program)
