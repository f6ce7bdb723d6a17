"""FMUs are built once for all workers of a session; what is unpacked and compiled stays in pytest's cache."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
import sketches
from compiled_once import remember_libraries
from filelock import FileLock
from helpers import FIXTURES, Measured, build_fixture
from hypothesis import settings
from long_tests import MARKERS, leave_evidence, mark_sampled
from rovbrush.components.build import COMPONENTS, HERE, build
from rovbrush.components.native.compile import PLATFORMS
from rovbrush.orchestrator.loop.machine.compiled import compiled_loop, is_compiled
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.files import writing
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.tables import Run, require_complete
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble
from sketches import spoken_of
from warm_starts import start_warm

Rows = dict[str, tuple[float | str, str]]
MEASURED = pytest.StashKey[Rows]()
LONG = ("system", "packaging", "orchestrator/paper", "orchestrator/studies")  # folders
FIXTURE_NAMES = (*sorted(path.parent.name for path in FIXTURES.glob("*/fmu.py")), "plain")


def pytest_configure(config: pytest.Config) -> None:
    """Tests begin alike wherever they are started, and leave nothing in the user's folders."""
    settings.register_profile("rovbrush", deadline=None)  # no test fails because the machine is slow
    settings.load_profile("rovbrush")
    for marker in MARKERS:
        config.addinivalue_line("markers", marker)
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # Python is started two thousand times
    sys.dont_write_bytecode = False
    signal.signal(signal.SIGINT, signal.default_int_handler)  # `nohup`, `make test &`: ignored, and that is inherited
    kept = getattr(config, "cache", None)
    home = Path(kept.mkdir("home")) if kept is not None else Path(tempfile.mkdtemp(prefix="home_"))
    cache = home / "cache" / "rovbrush"
    if not str(cache).isascii():  # where FMUs cannot be unpacked
        cache = Path(tempfile.mkdtemp(prefix="cache_"))
    os.environ |= {
        "HOME": str(home),
        "XDG_CACHE_HOME": str(home / "cache"),
        "XDG_CONFIG_HOME": str(home / "config"),
        "XDG_DATA_HOME": str(home / "data"),
        "XDG_STATE_HOME": str(home / "state"),
        "MPLCONFIGDIR": str(home / "matplotlib"),
        "ROVBRUSH_CACHE": str(cache),
        "OPENBLAS_NUM_THREADS": "1",  # of each worker and each program: they share the cores anyway
    }
    for name in ("ROVBRUSH_FMUS", "NUMBA_CACHE_DIR"):
        os.environ.pop(name, None)
    remember_libraries()
    start_warm()


@pytest.hookimpl(tryfirst=True)  # before `-m` chooses
def pytest_collection_modifyitems(items: list[pytest.Item], config: pytest.Config) -> None:
    """Long tests and what they share come first: at the end no worker waits for one of them."""
    mark_sampled(items)
    leave_evidence(items, config)
    top = Path(__file__).parent
    items.sort(key=lambda item: not any(item.path.is_relative_to(top / long) for long in LONG))


def made_once(factory: pytest.TempPathFactory, name: str, make: Callable[[Path], object]) -> Path:
    """A folder that `make` has filled, once for all workers of this session."""
    common = factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        common = common.parent
    folder, done = common / name, common / f"{name}.made"
    with FileLock(common / f"{name}.lock"):
        if not done.exists():
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir()
            make(folder)
            done.touch()
    return folder


@pytest.fixture(autouse=True)
def sketched(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures of runs in this process, a second of CPU each, are drawn where a test's file speaks of them only."""
    if not spoken_of(request.path):
        monkeypatch.setattr(writing, "_overview", sketches.overview)
        monkeypatch.setattr(writing, "_figure", sketches.figure)


@pytest.fixture(scope="session")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with all FMUs: the project's components and the fixtures."""

    def make(folder: Path) -> None:
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            built: list[Future[Any]] = [] if is_compiled() else [pool.submit(compiled_loop)]  # not by every worker
            built += [pool.submit(build, HERE / name, folder) for name in COMPONENTS]
            built += [pool.submit(build_fixture, name, folder) for name in FIXTURE_NAMES]
            for task in built:
                task.result()

    return made_once(tmp_path_factory, "fmus", make)


@pytest.fixture(scope="session")
def loop_library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the loop's libraries as they are in a wheel, for ROVBRUSH_LOOP."""
    platforms = tuple(name for name, p in PLATFORMS.items() if any(map(shutil.which, p.compilers)))
    if "linux64" not in platforms:
        pytest.skip("no C compiler: the loop's library cannot be linked")

    def make(folder: Path) -> None:
        command = [sys.executable, "-m", "release.loop", str(folder), *platforms]
        subprocess.run(command, cwd=HERE.parent, check=True, capture_output=True)

    return made_once(tmp_path_factory, "loop_library", make)


@pytest.fixture(scope="session")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the native FMUs, fmi2/ and fmi3/, with binaries for the platforms that have a compiler here."""
    platforms = tuple(name for name, p in PLATFORMS.items() if any(map(shutil.which, p.compilers)))
    if "linux64" not in platforms:
        pytest.skip("no C compiler: native FMUs cannot be built")

    def make(folder: Path) -> None:
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(lambda name: build(HERE / name, folder, 0, platforms), COMPONENTS))

    return made_once(tmp_path_factory, "native_fmus", make) / "native"


@pytest.fixture(scope="session")
def shipped(request: pytest.FixtureRequest) -> Path:
    """A folder with the components' FMUs, for tests of whole systems: native ones, which take a fifth of the time and
    give the same bits (tests/fmus/native/test_native_equality.py), or Python FMUs where nothing compiles C."""
    if any(map(shutil.which, PLATFORMS["linux64"].compilers)):
        folder: Path = request.getfixturevalue("native")
        return folder / "fmi2"
    folder = request.getfixturevalue("fmus")
    return folder


@pytest.fixture(scope="session")
def measured(request: pytest.FixtureRequest) -> Measured:
    """`measured(claim, value, bound)` puts a number into the report; of several for one claim the largest stays."""
    rows = request.config.stash.setdefault(MEASURED, {})

    def record(claim: str, value: float | str, bound: str) -> None:
        _keep_largest(rows, claim, value if isinstance(value, str) else float(value), bound)

    return record


def _keep_largest(rows: Rows, claim: str, value: float | str, bound: str) -> None:
    known = rows.get(claim, (value, bound))[0]
    if not isinstance(value, str) and not isinstance(known, str) and abs(known) > abs(value):
        value = known
    rows[claim] = (value, bound)


def pytest_sessionfinish(session: pytest.Session) -> None:
    """A worker hands in what it measured."""
    if hasattr(session.config, "workeroutput"):
        session.config.workeroutput["measured"] = session.config.stash.get(MEASURED, {})


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    """The controller gathers it."""
    rows = node.config.stash.setdefault(MEASURED, {})
    for claim, (value, bound) in getattr(node, "workeroutput", {}).get("measured", {}).items():
        _keep_largest(rows, claim, value, bound)


@pytest.fixture(scope="session")
def nominal_plan(shipped: Path) -> Plan:
    """The nominal system, planned and run once for all tests of the whole system."""
    return planned(assemble("nominal", {}, fmus=shipped))


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
        for claim, (value, bound) in sorted(config.stash.get(MEASURED, {}).items())
    ]
    if not rows:
        return
    table = [("claim", "measured", "bound"), *rows]
    widths = [max(len(row[column]) for row in table) for column in range(2)]
    terminalreporter.section("measured numbers")
    for claim, value, bound in table:
        terminalreporter.write_line(f"{claim:<{widths[0]}}  {value:>{widths[1]}}  {bound}")
