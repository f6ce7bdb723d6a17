"""A copy of what the packages are made of, with FMUs built freshly in it: nothing of that is left in the checkout."""

from __future__ import annotations

import shutil
from pathlib import Path

from rovbrush.components.build import COMPONENTS, build_all
from rovbrush.components.native.compile import PLATFORMS

ROOT = Path(__file__).parent.parent
SOURCES = (
    "components", "orchestrator", "fmus/README.md", "fmus/verify.c", "fmus/recordings", "setup.py", "pyproject.toml",
    "MANIFEST.in", "README.md", "LICENSE", "CHANGELOG.md", "CONTRIBUTING.md", "Makefile",
)  # fmt: skip


def copy(folder: Path) -> None:
    """Copy the sources into an empty folder."""
    for name in SOURCES:
        source, target = ROOT / name, folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__", "*.egg-info", ".*"))
        else:
            shutil.copy(source, target)


def build_native(folder: Path) -> None:
    """Native FMUs of all components for all platforms into `folder`/native. Raises BuildError without a compiler."""
    for name in COMPONENTS:
        build_all(folder, (name,), platforms=tuple(PLATFORMS))
        print(f"built {name}", flush=True)
