"""An FMU in a process of its own gives the same bits, and its end is an error of the run and nothing more."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import column, read_system, system_text
from native_build import FAULTS2, FREE2, FREE3, WIRES2, WIRES3, built, needs_gcc
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.isolated.parent import IsolatedInstance
from rovbrush.orchestrator.participant.opening import load
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = [needs_gcc, pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")]
TIMEOUT = '"1 s"'


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


def isolated(folder: Path, fmus: Path, names: str, *args: Any, timeout: str = "", **keys: Any) -> Run:
    """The run of a system, arguments as for `system_text`, with the components `names` in their own processes."""
    text = system_text(*args, **keys)
    for name in names:
        extra = 'isolation = "process"\n' + (f"timeout = {timeout}\n" if timeout else "")
        text = text.replace(f"[components.{name}]\n", f"[components.{name}]\n{extra}")
    path = folder / f"isolated_{names}.toml"
    path.write_text(text, encoding="utf-8")
    return simulate(make_plan(load_system(str(path), fmus)))


def same(a: Run, b: Run) -> bool:
    return all(x.tobytes() == y.tobytes() for x, y in zip(a.tables, b.tables, strict=True))


@pytest.mark.parametrize(
    ("fmu", "free", "wires"), [("feedthrough2", FREE2, WIRES2), ("feedthrough3", FREE3, WIRES3)], ids=["fmi2", "fmi3"]
)
def test_results_are_the_same_bit_by_bit(
    fmu: str, free: dict[str, Any], wires: list[str], native: Path, tmp_path: Path
) -> None:
    case = ({"a": (fmu, "1 ms", free), "b": (fmu, "2 ms")}, wires)
    here = isolated(tmp_path, native, "", *case, stop="20 ms")
    there = isolated(tmp_path, native, "ab", *case, stop="20 ms")
    assert not here.failure and not there.failure and same(here, there)


def test_a_python_fmu_gives_the_same_bits_too(fmus: Path, tmp_path: Path) -> None:
    case = (
        {"w": ("wave", "1 ms", {"a": 2.0, "w": 90.0}), "i": ("integrator", "2 ms", {"x_start": 1.0})}, ["w.y -> i.u"],
    )  # fmt: skip
    runs = [isolated(tmp_path, fmus, names, *case, stop="50 ms") for names in ("", "w", "wi")]
    assert not runs[2].failure and same(runs[0], runs[1]) and same(runs[0], runs[2])


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("crash", "its process crashed with SIGSEGV"),
        ("exit", "its process ended by itself with exit code 3"),
        ("hang", "its process did not answer within 1 s and was ended"),
        ("error", "returned fmi2Error"),
        ("fatal", "returned fmi2Fatal"),
        ("discard", "returned fmi2Discard in the step to t = 0.005 s; it reached t = 0.0125 s"),
    ],
)
def test_what_ends_the_process_is_an_error_of_the_run(fault: str, words: str, native: Path, tmp_path: Path) -> None:
    parts = {
        "w": ("feedthrough2", "1 ms", FREE2),
        "bad": ("feedthrough2", "1 ms", {"fault": FAULTS2[fault], "bad_at": 0.0045}),
    }
    text = system_text(parts, [w.replace("a.", "w.").replace("b.", "bad.") for w in WIRES2], stop="10 ms")
    path = tmp_path / "case.toml"
    path.write_text(
        text.replace("[components.bad]\n", f'[components.bad]\nisolation = "process"\ntimeout = {TIMEOUT}\n'),
        encoding="utf-8",
    )
    run = simulate(make_plan(load_system(str(path), native)))
    assert run.failure.startswith("component bad") and words in run.failure
    assert "in the step to t = 0.005 s" in run.failure and run.end == 0.004
    t, y = column(run, "bad.y")
    assert t[-1] == 0.004 and np.all(y == 1.5)


def test_states_travel_between_here_and_there(native: Path) -> None:
    fmu = Fmu.open(native / "feedthrough2.fmu")
    there, here = IsolatedInstance(fmu, "there", 10.0), load(fmu, "here")
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
        there.close()
        here.close()
    assert there.child.process.poll() == 0


def test_a_process_never_outlives_its_master(native: Path, tmp_path: Path) -> None:
    code = (
        "import sys, time; from pathlib import Path; from rovbrush.orchestrator.fmu.fmu import Fmu;"
        "from rovbrush.orchestrator.participant.isolated.parent import IsolatedInstance;"
        "i = IsolatedInstance(Fmu.open(Path(sys.argv[1])), 'i', 60.0);"
        "print(i.child.process.pid, flush=True); time.sleep(60)"
    )
    master = subprocess.Popen([sys.executable, "-c", code, str(native / "feedthrough2.fmu")], stdout=subprocess.PIPE)
    assert master.stdout is not None
    child = int(master.stdout.readline())
    master.send_signal(signal.SIGKILL)
    master.wait()
    master.stdout.close()
    deadline = time.monotonic() + 30.0
    while Path(f"/proc/{child}").exists() and "Z" not in Path(f"/proc/{child}/stat").read_text().split()[2]:
        assert time.monotonic() < deadline, "the process of the FMU is still there"
        time.sleep(0.05)


@pytest.mark.parametrize(
    ("lines", "words"),
    [
        ('isolation = "proces"', "unknown isolation 'proces'; did you mean 'process'?"),
        ('timeout = "1 s"', 'timeout needs isolation = "process"'),
        ('isolation = "process"\ntimeout = "soon"', "is not a time"),
    ],
)
def test_wrong_keys_are_refused(lines: str, words: str, native: Path, tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    text = system_text({"a": ("feedthrough2", "1 ms", FREE2)})
    path.write_text(text.replace("[components.a]\n", f"[components.a]\n{lines}\n"), encoding="utf-8")
    with pytest.raises(InputError) as error:
        load_system(str(path), native)
    assert words in str(error.value)


def test_an_fmu_that_changes_after_reading_is_refused(native: Path, tmp_path: Path) -> None:
    fmu = tmp_path / "f.fmu"
    fmu.write_bytes((native / "feedthrough2.fmu").read_bytes())
    system = read_system(tmp_path, tmp_path, {"a": ("f", "1 ms", FREE2)})
    fmu.write_bytes((native / "feedthrough3.fmu").read_bytes())
    with pytest.raises(FmuError, match=r"f\.fmu has changed since the system was read"):
        IsolatedInstance(system.components["a"].fmu, "a", 10.0)
