"""FMUs of Model Exchange for Windows: members of the group like any other, whose functions wine runs."""

from __future__ import annotations

import re
from pathlib import Path

import exchange_build
import pytest
from clock_cases import same_tables
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from windows_build import exchange_for_windows, needs_wine

pytestmark = [needs_wine, pytest.mark.sampled(4)]
SYSTEMS = {
    "ball": """
[components.ball]
fmu = "ball.fmu"
period = "10 ms"
""",
    "relay": """
connections = ["lag.x -> relay.y", "relay.on -> lag.on"]
[components.relay]
fmu = "relay.fmu"
period = "10 ms"
parameters = { low = 0.3, high = 0.7 }
[components.lag]
fmu = "lag.fmu"
period = "20 ms"
""",
    "pucks": """
connections = ["struck.x -> striker.x2", "struck.v -> striker.v2", "striker.J -> struck.J", "striker.n -> struck.n"]
[components.striker]
fmu = "striker.fmu"
period = "10 ms"
parameters = { v = 1.0, m2 = 2.0 }
[components.struck]
fmu = "struck.fmu"
period = "10 ms"
parameters = { x = 0.5, m = 2.0 }
""",
    "stick_slip": """
[components.block]
fmu = "stick_slip.fmu"
period = "10 ms"
""",
}
METHODS = {"usual": "", "cvode": 'method = "cvode"', "rk4": 'method = "rk4"\nstep = "1 ms"'}


@pytest.fixture(scope="module", params=[2, 3], ids=["fmi2", "fmi3"])
def fmus(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Folders with the same models for this machine and for Windows."""
    here, windows = (tmp_path_factory.mktemp(f"{name}{request.param}") for name in ("here", "windows"))
    for name in ("ball", "relay", "lag", "striker", "struck", "stick_slip", "moody"):
        exchange_for_windows(exchange_build.exchange(here, name, request.param), windows, request.param)
    return here, windows


def run(folder: Path, fmus: Path, text: str, method: str = "usual", **others: Path) -> Run:
    """`others`: folders of FMUs that are taken elsewhere than in `fmus`, by the name of the FMU."""
    text = re.sub(r'"(\w+)\.fmu"', lambda found: f'"{others.get(found[1], fmus) / found[1]}.fmu"', text)
    path = folder / "system.toml"
    solver = f"[solver]\ntolerance = 1e-8\n{METHODS[method]}\n"
    head, tail = 'format = 2\nstop_time = "2 s"\n', text.index("[components")
    path.write_text(f"{head}{text[:tail]}{solver}{text[tail:]}", encoding="utf-8")
    return simulate(make_plan(load_system(str(path), fmus)))


@pytest.mark.sampled(2)
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", SYSTEMS)
def test_it_gives_the_same_bits_as_the_same_sources_here(
    name: str, method: str, tmp_path: Path, fmus: tuple[Path, Path]
) -> None:
    here, windows = (run(tmp_path, folder, SYSTEMS[name], method) for folder in fmus)
    assert not here.failure and not windows.failure and same_tables(here, windows)
    assert here.notes == windows.notes


def test_one_of_windows_and_one_of_this_machine_are_one_group(tmp_path: Path, fmus: tuple[Path, Path]) -> None:
    here, windows = fmus
    expected = run(tmp_path, here, SYSTEMS["relay"])
    found = run(tmp_path, here, SYSTEMS["relay"], lag=windows)
    assert not found.failure and same_tables(expected, found)
    text = explain(found.plan)
    assert "relay, lag: one group" in text and "which wine runs" in text


MOODY = """
[components.m]
fmu = "moody.fmu"
period = "100 ms"
isolation = "process"
timeout = "2 s"
parameters = {{ fault = {fault} }}
"""


@pytest.mark.parametrize(("fault", "words"), [
    (10, "its process crashed with an access violation"), (11, "its process did not answer within 2 s and was ended"),
])  # fmt: skip
def test_what_ends_wine_in_an_evaluation_is_named_and_rows_are_kept(
    fault: int, words: str, tmp_path: Path, fmus: tuple[Path, Path]
) -> None:
    found = run(tmp_path, fmus[1], MOODY.format(fault=fault))
    assert "component m" in found.failure and words in found.failure
    assert len(found.tables[0]) == 6  # at 0, 0.1 ... 0.5 s


def test_derivatives_that_are_no_numbers_are_named_as_here(tmp_path: Path, fmus: tuple[Path, Path]) -> None:
    found = [run(tmp_path, folder, MOODY.format(fault=1)).failure for folder in fmus]
    assert found[0] == found[1] and "component m" in found[0]
