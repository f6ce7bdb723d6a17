"""The virtual environment of `make run` and `make test`: by uv, or by pip alone where uv cannot be had or fails.

`python -m release.environment FOLDER EXTRA [VERSIONS]` makes FOLDER, with pip in it, and installs the checkout there,
editable, with an extra; VERSIONS such as `lowest-direct` are chosen by uv alone (`make lowest`). uv takes a quarter of
pip's time; it is that of the machine or one that pip fetches for this once. It does not know pip's configuration, so
that is handed on; where a setting has no like in uv, pip installs. Nothing but the standard library is needed here.
"""

from __future__ import annotations

import ast
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

ROOT = Path(__file__).parent.parent
# pip's settings: what they are for uv, and what stands between several.
SAME = {
    "index-url": ("UV_DEFAULT_INDEX", " "), "extra-index-url": ("UV_INDEX", " "), "find-links": ("UV_FIND_LINKS", ","),
    "trusted-host": ("UV_INSECURE_HOST", " "), "constraint": ("UV_CONSTRAINT", " "), "cert": ("SSL_CERT_FILE", ""),
    "proxy": ("ALL_PROXY", ""),
}  # fmt: skip
FOR_PIP_ALONE = {  # how it shows and keeps things
    "break-system-packages", "cache-dir", "config-file", "default-timeout", "disable-pip-version-check", "format",
    "log", "no-cache-dir", "no-color", "no-input", "no-python-version-warning", "no-warn-script-location",
    "prefer-binary",
    "progress-bar", "quiet", "require-virtualenv", "resume-retries", "retries", "root-user-action", "timeout",
    "upgrade", "use-feature", "user", "verbose",
}  # fmt: skip


class NoUvError(Exception):
    """Why uv does not install."""


def main(folder: Path, extra: str, versions: str = "") -> None:
    """Make the environment, or complete it; `versions`: which uv is to choose where it is not the newest."""
    try:
        by_uv(folder, extra, versions)
    except NoUvError as why:
        if versions:
            sys.exit(f"only uv chooses the versions {versions}: {why}")
        print(f"installing by pip, which takes longer: {why}", flush=True)
        by_pip(folder, extra)


def by_pip(folder: Path, extra: str) -> None:
    """As anybody would by hand. Ends the process where that fails."""
    for command in (
        [sys.executable, "-m", "venv", str(folder)],
        [*pip(python_of(folder)), "install", "--quiet", "--editable", f"{ROOT}[{extra}]"],
    ):
        if code := subprocess.run(command, check=False).returncode:
            sys.exit(code)


def by_uv(folder: Path, extra: str, versions: str = "") -> None:
    """Raises NoUvError where it cannot be had, or fails: then `by_pip` says what is wrong, if anything is."""
    environment = settings(configured(), os.environ)
    with tempfile.TemporaryDirectory() as temporary:
        uv = shutil.which("uv") or fetched(Path(temporary))
        if not python_of(folder).exists():
            run([uv, "venv", "--quiet", "--seed", "--python", sys.executable, str(folder)], environment)
        where = ["--python", str(python_of(folder))]
        if sys.dont_write_bytecode:  # else the first import writes it, of what is imported
            where.append("--compile-bytecode")
        where += ["--resolution", versions] if versions else []
        run([uv, "pip", "install", "--quiet", *where, "--editable", f"{ROOT}[{extra}]"], environment)


def fetched(folder: Path) -> str:
    """uv, by pip, into a folder of its own."""
    if subprocess.run([*pip(), "install", "--quiet", "--target", str(folder), "uv"], capture_output=True).returncode:
        raise NoUvError("there is no uv, and pip cannot fetch it")
    return str(folder / "bin" / "uv")


def run(command: list[str], environment: Mapping[str, str]) -> None:
    """Run uv; NoUvError with its last words where it fails."""
    try:
        done = subprocess.run(command, env=dict(environment), capture_output=True, text=True, check=False)
    except OSError as error:
        raise NoUvError(f"uv cannot be run: {error.strerror}") from error
    if done.returncode:
        lines = [" ".join(line.split()) for line in done.stderr.splitlines() if line.strip()]
        raise NoUvError(f"uv failed: {' '.join(lines[:2])[:300] or f'code {done.returncode}'}")


def configured() -> dict[str, list[str]]:
    """pip's configuration from its files and from the environment, in which a value may be several words."""
    done = subprocess.run([*pip(), "config", "list"], capture_output=True, text=True, check=False)
    if done.returncode:
        raise NoUvError("this Python has no pip that says how it is configured")
    return read(done.stdout)


def read(text: str) -> dict[str, list[str]]:
    """What `pip config list` prints; the section `install` counts more than `global`, the environment most."""
    order = {"global": 0, "install": 1, ":env:": 2}
    rows = []
    for line in text.splitlines():
        key, found, value = line.partition("=")
        section, _, name = key.strip().rpartition(".")
        if found and section in order:
            rows.append((order[section], name.lower().replace("_", "-"), ast.literal_eval(value).split()))
    return {name: words for _, name, words in sorted(rows)}


def settings(found: Mapping[str, list[str]], environment: Mapping[str, str]) -> dict[str, str]:
    """The environment for uv: pip's settings, unless uv has its own. Raises NoUvError for one that uv lacks."""
    others = sorted(name for name in found if name not in SAME and name not in FOR_PIP_ALONE)
    if others:
        raise NoUvError(f"uv has nothing like pip's setting {others[0]}")
    handed = {SAME[name][0]: SAME[name][1].join(words) for name, words in found.items() if name in SAME}
    chosen = {"UV_INDEX_STRATEGY": "unsafe-best-match", "UV_PYTHON_DOWNLOADS": "never"}
    return {**chosen, **handed, **environment}


def pip(python: str | Path = sys.executable) -> list[str]:
    """The command."""
    return [str(python), "-m", "pip", "--disable-pip-version-check"]


def python_of(folder: Path) -> Path:
    """The interpreter of an environment."""
    return folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


if __name__ == "__main__":
    main(Path(sys.argv[1]), *sys.argv[2:])
