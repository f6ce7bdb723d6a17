"""A system whose figures of merit are functions known in closed form."""

from __future__ import annotations

from pathlib import Path

import native_build
import pytest
from helpers import system_text

MERITS = ("ishigami", "g", "rosenbrock", "disc", "flat", "length")


@pytest.fixture(scope="session")
def known(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The system file; parameters f.x1 to f.x4, a figure of merit for each function."""
    if native_build.native.compiler() is None:
        pytest.skip("no C compiler: native FMUs cannot be built")
    folder = tmp_path_factory.mktemp("known")
    native_build.functions(folder / "functions.fmu")
    path = folder / "known.toml"
    merits = "".join(f'{name} = "last f.{name}"\n' for name in MERITS)
    path.write_text(system_text({"f": ("functions.fmu", "1 ms")}, stop="1 ms") + f"\n[summary]\n{merits}")
    return path
