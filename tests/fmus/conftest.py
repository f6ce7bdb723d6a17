"""Windows programs under wine, where wine is installed."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from rovbrush.components.native.compile import PLATFORMS
from windows_build import made_folder

Wine = Callable[..., "subprocess.CompletedProcess[str]"]


@pytest.fixture(scope="session")
def wine(tmp_path_factory: pytest.TempPathFactory) -> Wine:
    """`wine(program, *words)` runs a Windows program; what has no compiler or no wine for it is skipped."""
    if not shutil.which("wine"):
        pytest.skip("wine is not installed: the win64 binaries are not run")
    if not any(map(shutil.which, PLATFORMS["win64"].compilers)):
        pytest.skip("mingw-w64 is not installed: there are no win64 binaries")
    folder = tmp_path_factory.mktemp("wine")
    made_folder()  # wine's own, which all tests share: to make one takes ten seconds
    environment = {**os.environ, "WINEDEBUG": "-all", "DISPLAY": ""}

    def run(program: Path, *words: str) -> subprocess.CompletedProcess[str]:
        # Into files: wine's own processes keep a pipe open for seconds after the program has ended.
        command = ["wine", str(program), *words]
        with (folder / "out").open("w+") as out, (folder / "err").open("w+") as err:
            ended = subprocess.run(command, env=environment, stdout=out, stderr=err, timeout=120, check=False)
            out.seek(0), err.seek(0)
            return subprocess.CompletedProcess(command, ended.returncode, out.read(), err.read())

    return run
