"""FMUs at a server: the same bits as in a process of this machine, whatever crosses, and whatever the FMUs are."""

from __future__ import annotations

import os
import zipfile
from pathlib import Path
from typing import Any

import exchange_build
import pytest
from clock_build import built as clocks_built
from clock_cases import CASES, SCHEDULED, run_case
from clock_cases import same as same_events
from helpers import read_system, run_of
from native_build import FREE2, FREE3, WIRES2, WIRES3, built, needs_gcc
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.elsewhere.connection import Connection
from rovbrush.orchestrator.participant.isolated.parent import IsolatedInstance
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from serving import serving

pytestmark = [needs_gcc, pytest.mark.skipif(os.name != "posix", reason="the servers of the tests need fork")]


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


@pytest.fixture(scope="module")
def clocks(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return clocks_built(tmp_path_factory.mktemp("clocks"))


def same(a: Run, b: Run) -> bool:
    assert not a.failure and not b.failure, (a.failure, b.failure)
    return all(x.tobytes() == y.tobytes() for x, y in zip(a.tables, b.tables, strict=True))


def runs(folder: Path, fmus: Path, parts: dict[str, Any], wires: list[str], where: str, **keys: Any) -> list[Run]:
    """The same system with all components in processes here, and at a server."""
    return [
        run_of(folder, fmus, parts, wires, of={name: {"isolation": isolation} for name in parts}, **keys)
        for isolation in ("process", where)
    ]


@pytest.mark.parametrize(
    ("fmu", "free", "wires"), [("feedthrough2", FREE2, WIRES2), ("feedthrough3", FREE3, WIRES3)], ids=["fmi2", "fmi3"]
)
def test_results_are_those_of_processes_here_bit_by_bit(
    fmu: str, free: dict[str, Any], wires: list[str], native: Path, tmp_path: Path
) -> None:
    """Numbers of every type, texts and arrays; two instances of one FMU at one server."""
    with serving(native / f"{fmu}.fmu") as server:
        parts = {"a": (fmu, "1 ms", free), "b": (fmu, "2 ms")}
        assert same(*runs(tmp_path, native, parts, wires, str(server.address), stop="20 ms"))
        server.says("component a of ")
        assert not [line for line in server.said if "its process" in line]


def test_steps_that_are_repeated_from_saved_states_give_the_same_bits(native: Path, tmp_path: Path) -> None:
    with serving(native / "feedthrough2.fmu") as server:
        parts = {"a": ("feedthrough2", "1 ms", {"=u": 1.5}), "b": ("feedthrough2", "1 ms")}
        keys = {"algorithm": "iterated", "stop": "5 ms"}
        assert same(*runs(tmp_path, native, parts, ["a.y -> b.u"], str(server.address), **keys))


def test_states_travel_between_a_server_and_here(native: Path) -> None:
    fmu = Fmu.open(native / "feedthrough2.fmu")
    with serving(fmu.path) as server:
        there = IsolatedInstance(fmu, "there", 10.0, begin=lambda f, n: Connection(f, n, server.address, ""))
        here = IsolatedInstance(fmu, "here", 10.0)
        try:
            for instance in (there, here):
                instance.begin(1.0)
                instance.exit_initialization()
            there.set("u", 4.0)
            kept = there.save()
            there.set("u", 5.0)
            there.restore(kept)
            here.restore(here.deserialize(there.serialize(kept)))
            assert there.get("u") == here.get("u") == 4.0
            there.forget(kept)
            with pytest.raises(FmuError, match="a state was named that was not saved here"):
                there.restore(4096)
            assert there.get("u") == 4.0
        finally:
            there.close()
            here.close()


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", [*CASES, *SCHEDULED])
def test_events_at_a_server_give_the_same_bits(name: str, tmp_path: Path, clocks: Path) -> None:
    """Event mode, clocks and partitions."""
    case = (CASES | SCHEDULED)[name]
    with serving(*sorted(clocks.glob("*.fmu"))) as server:
        here, there = run_case(case, tmp_path, clocks), run_case(case, tmp_path, clocks, isolation=str(server.address))
        assert not here.failure and not there.failure and same_events(here, there)


def test_model_exchange_at_a_server_gives_the_bits_of_a_process_here(tmp_path: Path) -> None:
    ball = exchange_build.exchange(tmp_path, "ball")
    with serving(ball) as server:
        parts = {"ball": ("ball", "10 ms", {"h": 0.3})}
        assert same(*runs(tmp_path, tmp_path, parts, [], str(server.address), stop="500 ms"))


def test_an_fmu_without_a_library_for_this_machine_is_read_and_planned(native: Path, tmp_path: Path) -> None:
    """What a machine of another kind runs: only its server needs a library that it can load."""
    with (
        zipfile.ZipFile(native / "feedthrough2.fmu") as old,
        zipfile.ZipFile(tmp_path / "theirs.fmu", "w") as new,
    ):
        for entry in old.namelist():
            new.writestr(entry.replace("linux64", "win64").replace(".so", ".dll"), old.read(entry))
    keys = {"a": {"isolation": "tcp://rig.example:7400"}}
    plan = make_plan(read_system(tmp_path, tmp_path, {"a": ("theirs", "1 ms", {"=u": 1.5})}, of=keys))
    assert "at tcp://rig.example:7400" in explain(plan) and not plan.system.components["a"].fmu.windows
