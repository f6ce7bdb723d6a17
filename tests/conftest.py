"""FMUs are built once per session; what they unpack and compile is kept in pytest's cache, so later sessions start fast."""

from __future__ import annotations

import os
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from helpers import FIXTURES, build_fixture
from rovbrush.components.build import COMPONENTS, HERE, build

FIXTURE_NAMES = sorted(path.parent.name for path in FIXTURES.glob("*/fmu.py")) + ["plain"]


@pytest.fixture(scope="session", autouse=True)
def cache_folder(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Tests never unpack into the user's own cache."""
    kept = getattr(request.config, "cache", None)
    folder = Path(kept.mkdir("rovbrush")) if kept is not None else tmp_path_factory.mktemp("cache")
    if not str(folder).isascii():
        folder = tmp_path_factory.mktemp("cache")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ROVBRUSH_CACHE", str(folder))
        yield folder


@pytest.fixture(scope="session")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with all FMUs: the project's components and the fixtures."""
    folder = tmp_path_factory.mktemp("fmus")
    components = [name for name in COMPONENTS if (HERE / name / "fmu.py").is_file() and (HERE / name / "README.md").is_file()]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        built = [pool.submit(build, HERE / name, folder) for name in components]
        built += [pool.submit(build_fixture, name, folder) for name in FIXTURE_NAMES]
        for task in built:
            task.result()
    return folder
