"""An FMU for Windows on Linux: the same bits as its sources give here, and its end is an error of the run, no more."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from first_fmi import first_fmu
from helpers import column, edited, last, read_system
from native_build import FAULTS2, FREE2, FREE3, NATIVE, WIRES2, WIRES3, built
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.files.windows import wine
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.opening import Starting, load
from rovbrush.orchestrator.participant.windows.instance import WindowsInstance
from rovbrush.orchestrator.participant.windows.memory import FROM_SERVER, TO_SERVER
from rovbrush.orchestrator.participant.windows.process import ServerProcess
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.result import Result
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from windows_build import feedthrough_for_windows, for_windows, needs_wine

pytestmark = needs_wine


@pytest.fixture(scope="module")
def compiled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


@pytest.fixture(scope="module")
def windows(compiled: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with feedthrough2.fmu and feedthrough3.fmu for win64 only."""
    folder = tmp_path_factory.mktemp("windows")
    for name in ("feedthrough2", "feedthrough3"):
        feedthrough_for_windows(compiled / f"{name}.fmu", folder / f"{name}.fmu")
    return folder


def run(folder: Path, *args: Any, **keys: Any) -> Run:
    return simulate(make_plan(read_system(folder, folder, *args, **keys)))


def same(a: Run, b: Run) -> bool:
    """Whether two runs are alike in every bit."""
    tables = [Result(run).datasets for run in (a, b)]
    for name in tables[0] | tables[1]:
        one, other = (found[name] for found in tables)
        if set(one.variables) != set(other.variables):
            return False
        for variable in set(one.variables):
            x, y = one[variable].values, other[variable].values
            if x.tolist() != y.tolist() if x.dtype.kind in "OSUT" else x.tobytes() != y.tobytes():
                return False
    return True


@pytest.mark.parametrize(
    ("fmu", "free", "wires"), [("feedthrough2", FREE2, WIRES2), ("feedthrough3", FREE3, WIRES3)], ids=["fmi2", "fmi3"]
)
def test_results_are_those_of_the_same_sources_here_bit_by_bit(
    fmu: str, free: dict[str, Any], wires: list[str], compiled: Path, windows: Path, tmp_path: Path
) -> None:
    """Every type of variable, arrays and texts, into wine and out of it."""
    runs = [
        run(tmp_path, {"a": (str(a / f"{fmu}.fmu"), "1 ms", free), "b": (str(b / f"{fmu}.fmu"), "2 ms")}, wires,
            stop="20 ms")
        for a, b in ((compiled, compiled), (windows, compiled), (compiled, windows), (windows, windows))
    ]  # fmt: skip
    assert not any(r.failure for r in runs)
    assert all(same(runs[0], r) for r in runs[1:])


@pytest.mark.parametrize("algorithm", ["iterated", "adaptive"])
@pytest.mark.parametrize("fmu", ["feedthrough2", "feedthrough3"])
def test_so_are_those_of_steps_that_are_made_again(
    algorithm: str, fmu: str, compiled: Path, windows: Path, tmp_path: Path
) -> None:
    """The loop saves and restores states under wine."""
    u, y = ("u", "y") if fmu == "feedthrough2" else ("Float64_in", "Float64_out")
    runs = []
    for place in (compiled, windows):
        path = str(place / f"{fmu}.fmu")
        parts = {"a": (path, "1 ms", {f"={u}": 0.5}), "b": (path, "1 ms")}
        runs.append(run(tmp_path, parts, [f"a.{y} -> b.{u}"], stop="20 ms", algorithm=algorithm))
    assert not runs[1].failure and same(*runs)


def test_so_are_those_of_fmi_1(tmp_path: Path) -> None:
    here = first_fmu(tmp_path / "first.fmu")
    there = for_windows(here, tmp_path / "windows.fmu", [NATIVE / "first.c"], {"MODEL": "first"})
    runs = [run(tmp_path, {"a": (str(fmu), "1 ms", {"=u": 0.3})}, stop="20 ms") for fmu in (here, there)]
    assert not runs[1].failure and same(*runs)


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("crash", "its process crashed with an access violation (0xC0000005)"),
        ("exit", "its process ended by itself with exit code 3"),
        ("hang", "its process did not answer within 1 s and was ended"),
        ("error", "returned fmi2Error"),
        ("fatal", "returned fmi2Fatal"),
        ("discard", "returned fmi2Discard in the step to t = 0.005 s; it reached t = 0.0125 s"),
    ],
)
def test_what_ends_its_process_is_an_error_of_the_run(
    fault: str, words: str, compiled: Path, windows: Path, tmp_path: Path
) -> None:
    parts = {
        "w": (str(compiled / "feedthrough2.fmu"), "1 ms", FREE2),
        "bad": (str(windows / "feedthrough2.fmu"), "1 ms", {"fault": FAULTS2[fault], "bad_at": 0.0045}),
    }
    wires = [w.replace("a.", "w.").replace("b.", "bad.") for w in WIRES2]
    of = {"bad": {"isolation": "process", "timeout": "1 s"}}
    found = run(tmp_path, parts, wires, stop="10 ms", of=of)
    assert found.failure.startswith("component bad") and words in found.failure
    assert "in the step to t = 0.005 s" in found.failure and found.end == 0.004
    assert "fault" in found.failure  # what it logged before is there
    t, y = column(found, "bad.y")
    assert t[-1] == 0.004 and np.all(y == 1.5)


def test_states_travel_between_wine_and_here(compiled: Path, windows: Path) -> None:
    there, here = (load(Fmu.open(folder / "feedthrough2.fmu"), "x") for folder in (windows, compiled))
    try:
        for instance in (there, here):
            instance.begin(1.0)
            instance.exit_initialization()
        there.set("u", 4.0)
        kept = there.save()
        content = there.serialize(kept)
        there.set("u", 5.0)
        there.restore(kept)
        assert there.get("u") == 4.0
        here.restore(here.deserialize(content))
        assert here.get("u") == 4.0
        there.restore(there.deserialize(here.serialize(here.save())))
        there.forget(kept)
        assert there.get("u") == 4.0
    finally:
        assert not there.close() and not here.close()
    assert isinstance(there, WindowsInstance) and there.process.process.poll() == 0


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("exit", "its process ended by itself with exit code 3"),
        ("hang", "its process did not answer within 1 s and was ended"),
    ],
)
def test_what_was_there_long_before_it_is_asked_has_started(
    fault: str, words: str, windows: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its first answer comes at once then, and what holds for one that starts does so no more."""
    begin = ServerProcess.__init__

    def begun_and_there(process: ServerProcess, fmu: Fmu) -> None:
        begin(process, fmu)
        last = time.monotonic() + 60.0
        while not process.memory.numbers[2]:  # it sleeps, as nobody asks
            assert time.monotonic() < last and process.process.poll() is None
            time.sleep(0.01)
        process._patience = 10**7  # and is waited for without sleeping

    monkeypatch.setattr(ServerProcess, "__init__", begun_and_there)
    part = (str(windows / "feedthrough2.fmu"), "1 ms", {**FREE2, "fault": FAULTS2[fault], "bad_at": 0.0045})
    found = run(tmp_path, {"bad": part}, stop="10 ms", of={"bad": {"isolation": "process", "timeout": "1 s"}})
    assert words in found.failure and found.end == 0.004


def test_a_state_longer_than_the_shared_memory_goes_in_parts(windows: Path) -> None:
    instance = load(Fmu.open(windows / "feedthrough2.fmu"), "x")
    assert isinstance(instance, WindowsInstance)
    memory, content = instance.process.memory, np.random.default_rng(1).bytes(3_000_001)
    try:
        parts = [(at, content[at : at + 1_000_000]) for at in range(0, len(content), 1_000_000)]
        for at, part in parts:
            memory.put_value(part)
            memory.put_words(at, len(part), len(content))
            assert instance._ask(TO_SERVER) == 0
        back = b""
        for at, part in parts:
            memory.put_words(at, len(part), len(content))
            assert instance._ask(FROM_SERVER) == 0
            back += memory.value(len(part))
        memory.put_words(2_999_999, 10, len(content))
        assert back == content and instance._ask(FROM_SERVER) == 3  # beyond its end
    finally:
        instance.close()


WHERE = """
#include "fmi2Functions.h"
#undef fmi2Instantiate
#define fmi2Instantiate inner
#include "feedthrough2.c"
#undef fmi2Instantiate
fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String place,
                              const fmi2CallbackFunctions *f, fmi2Boolean visible, fmi2Boolean on)
{
    char path[1000], line[100] = "";
    FILE *file;
    snprintf(path, sizeof path, "%s/note.txt", strncmp(place, "file:///", 8) ? "" : place + 8);
    if ((file = fopen(path, "r"))) fgets(line, sizeof line, file), fclose(file);
    f->logger(f->componentEnvironment, name, fmi2Warning, "there", "%s: %s", place, line);
    printf("printed\\n"); fflush(stdout);
    return inner(name, type, guid, place, f, visible, on);
}
"""


def test_it_finds_its_resources_by_a_uri_of_windows(
    compiled: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """And what it prints is printed, what it logs is kept."""
    (tmp_path / "where.c").write_text(WHERE.replace('"feedthrough2.c"', f'"{NATIVE / "feedthrough2.c"}"'))
    fmu = for_windows(compiled / "feedthrough2.fmu", tmp_path / "a.fmu", [tmp_path / "where.c"])
    fmu = edited(fmu, tmp_path / "where.fmu", {"resources/note.txt": b"found"})
    instance = load(Fmu.open(fmu), "x", "warnings")
    assert instance.messages[0].startswith("file:///Z:/") and instance.messages[0].endswith("/resources: found")
    assert instance.logged()[0].startswith("x: Warning [there]: ")
    instance.close()
    assert capfd.readouterr().err == "printed\n"


def test_its_process_never_outlives_its_master(windows: Path) -> None:
    code = (
        "import sys, time; from pathlib import Path; from rovbrush.orchestrator.fmu.fmu import Fmu;"
        "from rovbrush.orchestrator.participant.opening import load;"
        "i = load(Fmu.open(Path(sys.argv[1])), 'i'); i.begin(1.0); i.exit_initialization();"
        "print(i.process.process.pid, flush=True); time.sleep(60)"
    )
    master = subprocess.Popen([sys.executable, "-c", code, str(windows / "feedthrough2.fmu")], stdout=subprocess.PIPE)
    assert master.stdout is not None
    child = int(master.stdout.readline())
    master.send_signal(signal.SIGKILL)
    master.wait()
    master.stdout.close()
    deadline = time.monotonic() + 30.0
    while Path(f"/proc/{child}").exists() and "Z" not in Path(f"/proc/{child}/stat").read_text().rsplit(")")[1]:
        assert time.monotonic() < deadline, "the process of the FMU is still there"
        time.sleep(0.05)


def test_processes_of_several_are_started_before_the_first_is_waited_for(windows: Path, tmp_path: Path) -> None:
    parts = {name: (str(windows / "feedthrough2.fmu"), "1 ms") for name in "abc"}
    system = make_plan(read_system(tmp_path, tmp_path, parts, stop="3 ms")).system
    starting = Starting(system.components.values())
    running = {process.process.pid for process in starting._waiting.values()}
    assert len(running) == 3
    instance = starting.start(system.components["b"])
    assert isinstance(instance, WindowsInstance) and instance.process.process.pid in running
    instance.close()
    starting.close()
    assert not starting._waiting


def test_a_library_of_this_machine_comes_first(compiled: Path, windows: Path, tmp_path: Path) -> None:
    both = feedthrough_for_windows(compiled / "feedthrough2.fmu", tmp_path / "both.fmu", keep=True)
    assert not Fmu.open(both).windows and Fmu.open(both).library.suffix == ".so"
    assert Fmu.open(windows / "feedthrough2.fmu").windows == "win64"


def test_the_plan_says_that_wine_runs_it(windows: Path, tmp_path: Path) -> None:
    plan = make_plan(read_system(tmp_path, tmp_path, {"a": (str(windows / "feedthrough3.fmu"), "1 ms")}, stop="3 ms"))
    assert plan.system.components["a"].apart == "its library is for win64, which wine runs"


@pytest.mark.parametrize("failing", [1, 2, 3])
def test_wine_is_started_again_where_it_did_not_come_up(
    failing: int, windows: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its service ends some seconds behind the last process; one that comes just then ends with code 1."""
    loader, count = tmp_path / "wine64", tmp_path / "starts"
    loader.write_text(
        f'#!/bin/sh\necho x >> {count}\n[ $(wc -l < {count}) -le {failing} ] && exit 1\nexec {wine("win64")} "$@"\n'
    )
    loader.chmod(0o755)
    monkeypatch.setattr("rovbrush.orchestrator.participant.windows.process.require_wine", lambda *_: str(loader))
    given: Any = tmp_path, windows, {"a": ("feedthrough2", "1 ms", FREE2)}
    if failing == 3:
        with pytest.raises(FmuError, match="exit code 1 before it was ready"):
            simulate(make_plan(read_system(*given, stop="10 ms")))
    else:
        assert not simulate(make_plan(read_system(*given, stop="10 ms"))).failure
    assert len(count.read_text().splitlines()) == min(failing + 1, 3)


def test_it_goes_on_from_a_checkpoint_of_another_process(windows: Path, tmp_path: Path) -> None:
    first = load(Fmu.open(windows / "feedthrough3.fmu"), "x")
    first.begin(1.0)
    first.exit_initialization()
    first.set("Float64_in", 4.0)
    content = first.serialize(first.save())
    first.close()
    second = load(Fmu.open(windows / "feedthrough3.fmu"), "x")
    second.begin(1.0)
    second.exit_initialization()
    second.restore(second.deserialize(content))
    assert second.get("Float64_in") == 4.0
    second.close()


BROKEN = {
    "no library": (b"this is no library, but long enough to be looked at as one" * 99, "is no library for Windows"),
    "empty": (b"", "is no library for Windows"),
}


@pytest.mark.parametrize("what", BROKEN)
def test_a_library_that_wine_cannot_load_says_why(what: str, windows: Path, tmp_path: Path) -> None:
    content, words = BROKEN[what]
    fmu = edited(windows / "feedthrough2.fmu", tmp_path / "bad.fmu", {"binaries/win64/feedthrough2.dll": content})
    with pytest.raises(FmuError, match=r"bad\.fmu cannot be instantiated: its library, feedthrough2\.dll") as error:
        load(Fmu.open(fmu), "x")
    assert words in str(error.value)


def test_a_library_that_lacks_another_says_so(compiled: Path, tmp_path: Path) -> None:
    (tmp_path / "gone.c").write_text("__declspec(dllexport) int gone(void) { return 1; }\n")
    (tmp_path / "more.c").write_text("int gone(void); int more(void) { return gone(); }\n")
    gcc = "x86_64-w64-mingw32-gcc"
    subprocess.run([gcc, "-shared", "gone.c", "-o", "gone.dll"], cwd=tmp_path, check=True)
    sources = [NATIVE / "feedthrough2.c", tmp_path / "more.c", tmp_path / "gone.dll"]
    fmu = for_windows(compiled / "feedthrough2.fmu", tmp_path / "lacks.fmu", sources)
    with pytest.raises(FmuError, match="a library that it needs is missing: ask for an FMU that carries it"):
        load(Fmu.open(fmu), "x")
    whole = edited(fmu, tmp_path / "whole.fmu", {"binaries/win64/gone.dll": (tmp_path / "gone.dll").read_bytes()})
    assert not load(Fmu.open(whole), "x").close()


def test_one_that_refuses_its_token_gives_its_reason(windows: Path, tmp_path: Path) -> None:
    fmu = edited(windows / "feedthrough2.fmu", tmp_path / "other.fmu", {})
    r = run(tmp_path, {"a": (str(fmu), "1 ms", {"=u": 2.0})}, stop="3 ms")
    assert last(r, "a.y") == 2.0


@pytest.mark.evidence
@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_each_of_our_components_gives_the_same_bits_under_wine(version: str, native: Path, tmp_path: Path) -> None:
    for path in sorted((native / version).glob("*.fmu")):
        with zipfile.ZipFile(path) as archive:
            linux = {name: None for name in archive.namelist() if "linux" in name and name.startswith("binaries/")}
        theirs = edited(path, tmp_path / path.name, linux)
        assert Fmu.open(theirs).windows and not Fmu.open(path).windows
        runs = [run(tmp_path, {"a": (str(fmu), "1 ms", {})}, stop="50 ms") for fmu in (path, theirs)]
        assert not runs[1].failure and same(*runs), path.stem
