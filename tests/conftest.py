"""FMUs are built once per session; what they unpack and compile stays in pytest's cache for the next one."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from helpers import FIXTURES, Measured, build_fixture
from rovbrush.components.build import COMPONENTS, HERE, build
from rovbrush.components.native.compile import PLATFORMS
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.tables import Run, require_complete
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble

MEASURED = pytest.StashKey[dict[str, tuple[float | str, str]]]()
FIXTURE_NAMES = (*sorted(path.parent.name for path in FIXTURES.glob("*/fmu.py")), "plain")


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
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        built = [pool.submit(build, HERE / name, folder) for name in COMPONENTS]
        built += [pool.submit(build_fixture, name, folder) for name in FIXTURE_NAMES]
        for task in built:
            task.result()
    return folder


@pytest.fixture(scope="session")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the native FMUs, fmi2/ and fmi3/, with binaries for the platforms that have a compiler here."""
    platforms = tuple(name for name, p in PLATFORMS.items() if any(map(shutil.which, p.compilers)))
    if "linux64" not in platforms:
        pytest.skip("no C compiler: native FMUs cannot be built")
    folder = tmp_path_factory.mktemp("native_fmus")
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(lambda name: build(HERE / name, folder, 0, platforms), COMPONENTS))
    return folder / "native"


@pytest.fixture(scope="session")
def measured(request: pytest.FixtureRequest) -> Measured:
    """`measured(claim, value, bound)` puts a number into the report; of several for one claim the largest stays."""
    rows = request.config.stash.setdefault(MEASURED, {})

    def record(claim: str, value: float | str, bound: str) -> None:
        known = rows.get(claim, (value, bound))[0]
        if not isinstance(value, str) and not isinstance(known, str) and abs(known) > abs(value):
            value = known
        rows[claim] = (value if isinstance(value, str) else float(value), bound)

    return record


@pytest.fixture(scope="session")
def nominal_plan(fmus: Path) -> Plan:
    """The nominal system, planned and run once for all tests of the whole system."""
    return planned(assemble("nominal", {}, fmus=fmus))


@pytest.fixture(scope="session")
def nominal(nominal_plan: Plan) -> Run:
    return require_complete(simulate(nominal_plan))


@pytest.fixture(scope="session")
def signals(nominal: Run) -> Signals:
    return Signals(nominal)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """The report: every number that a test measured, beside what is claimed of it."""
    rows = [
        (claim, value if isinstance(value, str) else f"{value:.6g}", bound)
        for claim, (value, bound) in config.stash.get(MEASURED, {}).items()
    ]
    if not rows:
        return
    table = [("claim", "measured", "bound"), *rows]
    widths = [max(len(row[column]) for row in table) for column in range(2)]
    terminalreporter.section("measured numbers")
    for claim, value, bound in table:
        terminalreporter.write_line(f"{claim:<{widths[0]}}  {value:>{widths[1]}}  {bound}")
