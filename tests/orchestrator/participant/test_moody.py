"""What an FMU does to the process that it runs in: written to its pipes, left half-said, changed for all, or ended."""

from __future__ import annotations

import os
import signal
import threading
import time
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from helpers import column, python, read_system, system_text
from native_build import FREE3, feedthrough3, moody, needs_gcc
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.isolated import parent
from rovbrush.orchestrator.participant.isolated.parent import STARTING, IsolatedInstance
from rovbrush.orchestrator.participant.surroundings import Surroundings, exact
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = [
    needs_gcc,
    pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS"),
    pytest.mark.sampled(4),
]


def plan(folder: Path, isolate: bool = True, timeout: str = "60 s", stop: str = "9 ms", **actions: str) -> Plan:
    """A moody FMU `m` driven by a good one, in a process of its own or not."""
    moody(folder / "good.fmu")
    moody(folder / "moody.fmu", **actions)
    text = system_text(
        {"g": ("good", "1 ms", {"=u": 1.0}), "m": ("moody", "1 ms")}, ["g.x -> m.u"], stop, algorithm="jacobi"
    )
    if isolate:
        text = text.replace("[components.m]\n", f'[components.m]\nisolation = "process"\ntimeout = "{timeout}"\n')
    path = folder / "case.toml"
    path.write_text(text, encoding="utf-8")
    return make_plan(load_system(str(path), folder))


def run(folder: Path, **keys: str | bool) -> Run:
    return simulate(plan(folder, **keys))  # type: ignore[arg-type]


FOREIGN = {
    "a few bytes": 'scribble("\\1\\0\\0\\0Fx", 6)',
    "a head with another checksum": "unsigned h[6] = {0x52764263u, 9, 5, 0, 0x46, 0}; scribble(h, 21)",
    "a line of text": 'scribble("a message that goes astray\\n", 27)',
}


@pytest.mark.parametrize("bytes_", FOREIGN.values(), ids=FOREIGN.keys())
def test_foreign_bytes_on_the_pipe_are_never_an_answer(bytes_: str, tmp_path: Path) -> None:
    found = run(tmp_path, ON_STEP=f"if (m->steps == 5) {{ {bytes_}; }}")
    assert "component m: its process sent what is no answer" in found.failure
    assert "in the step to t = 0.005 s" in found.failure and found.end == 0.004
    t, x = column(found, "m.x")
    assert t[-1] == 0.004
    want = column(run(tmp_path), "m.x")[1]
    assert x.tobytes() == want[: len(x)].tobytes()


def test_an_answer_that_never_ends_is_waited_for_no_longer_than_the_timeout(tmp_path: Path) -> None:
    """A head that is right, with a long message to follow."""
    head = "unsigned h[4] = {0x52764263u, 0, 1u << 20, 0}; scribble(h, 16); for (;;) pause()"
    found = run(tmp_path, timeout="1 s", ON_STEP=f"if (m->steps == 5) {{ {head}; }}")
    assert "component m: its process did not answer within 1 s and was ended" in found.failure
    assert found.end == 0.004


def test_a_closed_pipe_is_an_error_that_says_so(tmp_path: Path) -> None:
    found = run(tmp_path, ON_STEP="if (m->steps == 5) { for (int i = 3; i < 1024; i++) close(i); for (;;) pause(); }")
    assert "component m: its process closed the connection to the master and was ended" in found.failure


@pytest.mark.parametrize("action", ["close(i)", 'if (write(i, "xxxxxxxx", 8) < 0) continue'])
def test_code_that_closes_or_fills_the_first_descriptors_does_no_harm(action: str, tmp_path: Path) -> None:
    found = run(tmp_path, ON_STEP=f"if (m->steps == 5) for (int i = 3; i < 64; i++) {{ {action}; }}")
    assert not found.failure
    assert column(found, "m.x")[1].tobytes() == column(run(tmp_path), "m.x")[1].tobytes()


@pytest.mark.parametrize("call", ["ON_TERMINATE", "ON_FREE"])
def test_a_crash_in_the_end_is_named_and_the_rows_are_kept(call: str, tmp_path: Path) -> None:
    with Session(plan(tmp_path, **{call: "raise(SIGSEGV)"})) as session:
        session.advance()
        found = session.run()
    assert not found.failure and found.end == 0.009 and len(found.tables[0]) == 10
    assert session.ended_badly.startswith("component m: its process crashed with SIGSEGV")
    assert session.ended_badly.splitlines()[0].endswith("in the call `terminate or free`")
    assert session.ended_badly in found.notes


def test_the_command_line_ends_with_1_and_the_results_for_a_crash_in_the_end(tmp_path: Path) -> None:
    plan(tmp_path, ON_TERMINATE="raise(SIGSEGV)")
    out = tmp_path / "out"
    done = python(
        "import sys; from rovbrush.orchestrator.cli.main import main; main()", "run", str(tmp_path / "case.toml"),
        "--fmus", str(tmp_path), "--out", str(out), timeout=300.0,
    )  # fmt: skip
    assert done.returncode == 1 and "error: component m: its process crashed with SIGSEGV" in done.stderr
    assert (out / "result.nc").is_file() and (out / "manifest.json").is_file()


def test_a_refused_termination_is_named_too(tmp_path: Path) -> None:
    with Session(plan(tmp_path, isolate=False, ON_TERMINATE="return fmi2Error")) as session:
        session.advance()
    assert session.ended_badly.startswith("component m: cannot terminate (fmi2Error)")


# --- Ctrl-C while a call goes on ---


@pytest.mark.parametrize("pause", [0, 500, 5000])  # us between the two
def test_an_exception_while_an_isolated_fmu_works_is_never_a_good_step(pause: int, tmp_path: Path) -> None:
    """A second Ctrl-C raises inside the callback that the compiled loop has called."""
    want = column(run(tmp_path, stop="1 s"), "m.x")[1]
    press = (
        f"if (m->steps == 30) {{ kill(getppid(), SIGINT); usleep({pause}); kill(getppid(), SIGINT); usleep(20000); }}"
    )
    with Session(plan(tmp_path, timeout="30 s", stop="1 s", ON_STEP=press)) as session:
        with suppress(KeyboardInterrupt):
            session.advance()
        found = session.run()
    assert session.failure == "" or "interrupted by the user" in session.failure or "second Ctrl-C" in session.failure
    x = column(found, "m.x")[1]
    assert 29 <= len(x) < 1001 and x.tobytes() == want[: len(x)].tobytes()


def test_answers_given_up_are_dropped(tmp_path: Path) -> None:
    """Ctrl-C while a value is read by hand: the next value is its own."""
    fmu = moody(tmp_path / "moody.fmu", ON_GET="if (*r == 0) { kill(getppid(), SIGINT); usleep(300000); }")
    instance = IsolatedInstance(Fmu.open(fmu), "m", 30.0)
    instance.begin(1.0)
    instance.exit_initialization()
    with pytest.raises(KeyboardInterrupt):
        instance.get("x")
        time.sleep(1.0)
    assert [instance.get(name) for name in ("k", "u", "k")] == [1.0, 0.0, 1.0]
    assert instance.close() == ""


def test_ctrl_c_during_initialization_is_obeyed(tmp_path: Path) -> None:
    slow = plan(tmp_path, isolate=False, ON_ENTER="kill(getpid(), SIGINT)")
    with pytest.raises(KeyboardInterrupt):
        Stepping(slow)
    assert "interrupted by the user at t = 0 s" in simulate(slow).failure


# --- time limits ---


def test_what_a_python_fmu_compiles_is_not_counted_against_a_call(fmus: Path) -> None:
    instance = IsolatedInstance(Fmu.open(fmus / "wave.fmu"), "w", 2.0)
    assert instance.limit == STARTING
    instance.begin(1.0)
    instance.exit_initialization()
    assert instance.limit == STARTING
    instance.step(0.0, 1e-3)
    assert instance.limit == 2.0
    instance.close()


def test_an_fmu_in_c_has_its_timeout_from_the_beginning(tmp_path: Path) -> None:
    instance = IsolatedInstance(Fmu.open(moody(tmp_path / "moody.fmu", ON_ENTER="pause()")), "m", 1.0)
    with pytest.raises(FmuError, match=r"did not answer within 1 s and was ended in the call `enter initialization`"):
        instance.begin(1.0)
    instance.close()


def test_a_process_lives_as_long_as_its_master_whichever_thread_made_it(tmp_path: Path) -> None:
    fmu, made = Fmu.open(moody(tmp_path / "moody.fmu")), []
    thread = threading.Thread(target=lambda: made.append(IsolatedInstance(fmu, "m", 30.0)))
    thread.start()
    thread.join()
    made[0].begin(1.0)
    made[0].exit_initialization()
    assert made[0].get("k") == 1.0
    made[0].close()


# --- what is changed for the whole process ---


def test_a_changed_working_directory_is_restored_and_named(tmp_path: Path) -> None:
    before = Path.cwd()
    found = run(tmp_path, isolate=False, ON_STEP='if (m->steps == 5 && chdir("/")) return fmi2Error')
    assert not found.failure and Path.cwd() == before
    assert [note.split(" before ")[0] for note in found.notes] == [
        "a component in this process (g, m) changed the working directory to /"
    ]


@pytest.mark.parametrize("mode", ["FE_UPWARD", "FE_DOWNWARD", "FE_TOWARDZERO"])
def test_a_changed_rounding_mode_is_restored_and_named(mode: str, tmp_path: Path) -> None:
    found = run(tmp_path, isolate=False, ON_STEP=f"if (m->steps == 5) fesetround({mode})")
    assert exact() and not found.failure
    assert any("changed how floating-point numbers are rounded" in note for note in found.notes)


@pytest.mark.parametrize("call", ["ON_SETUP", "ON_ENTER", "ON_EXIT", "ON_TERMINATE", "ON_FREE"])
def test_so_is_what_is_changed_before_and_after_the_loop(call: str, tmp_path: Path) -> None:
    before = Path.cwd()
    found = run(tmp_path, isolate=False, **{call: 'fesetround(FE_UPWARD); if (chdir("/")) return'
                                            + (" fmi2Error" if call != "ON_FREE" else "")})  # fmt: skip
    assert exact() and Path.cwd() == before and len(found.notes) == 2


@pytest.mark.sampled(10)
@pytest.mark.parametrize("call", ["ON_SETUP", "ON_ENTER", "ON_EXIT", "ON_STEP", "ON_TERMINATE", "ON_FREE"])
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP", "SIGPIPE", "SIGCHLD"])
def test_signals_that_an_fmu_takes_are_given_back_and_named(name: str, call: str, tmp_path: Path) -> None:
    """Of what is ignored already, as Python does with SIGPIPE and `nohup` with SIGHUP, the default."""
    other = "SIG_DFL" if signal.getsignal(getattr(signal, name)) == signal.SIG_IGN else "SIG_IGN"
    moody(tmp_path / "moody.fmu", **{call: f"signal({name}, {other})"})
    system = read_system(tmp_path, tmp_path, {"a": ("moody", "1 ms", {"=u": 1.0})}, stop="5 ms")
    found = simulate(make_plan(system))
    assert not found.failure and Surroundings().restore() == []
    assert found.notes[0].startswith(f"component a changed what becomes of the signals {name}")
    assert getattr(signal, name) in Surroundings().handlers


def test_ctrl_c_ends_a_run_whose_fmu_ignores_it(tmp_path: Path) -> None:
    moody(tmp_path / "moody.fmu", ON_ENTER="signal(SIGINT, SIG_IGN)", ON_STEP="if (m->steps == 3) raise(SIGINT)")
    system = read_system(tmp_path, tmp_path, {"a": ("moody", "1 ms", {"=u": 1.0})}, stop="10 s")
    found = simulate(make_plan(system))
    assert found.failure.startswith("interrupted by the user at t = 0.00")


def test_the_component_is_known_where_it_is_alone(tmp_path: Path) -> None:
    moody(tmp_path / "moody.fmu", ON_STEP="fesetround(FE_UPWARD)")
    system = read_system(tmp_path, tmp_path, {"a": ("moody", "1 ms", {"=u": 1.0})}, stop="5 ms")
    assert simulate(make_plan(system)).notes[0].startswith("component a changed how floating-point numbers are rounded")


def test_nothing_is_said_of_fmus_that_leave_things_alone(tmp_path: Path) -> None:
    assert run(tmp_path, isolate=False).notes == [] and run(tmp_path).notes == []
    assert Surroundings().restore() == []


@pytest.mark.parametrize("isolate", [False, True])
def test_what_a_getter_does_not_write_stays_as_it_was(isolate: bool, tmp_path: Path) -> None:
    """Not what another call has left in the memory that is shared with a process."""
    found = run(tmp_path, isolate=isolate, ON_GET="if (m->steps > 3) return fmi2OK")
    assert not found.failure
    for name in ("m.x", "m.y"):
        values = column(found, name)[1]
        assert values[3:].tolist() == [values[3]] * len(values[3:]) and values[3] > values[2]


@pytest.mark.parametrize("isolation", ["none", "process"])
@pytest.mark.parametrize("interpreted", [False, True])
def test_what_a_step_does_not_report_is_nothing(isolation: str, interpreted: bool, tmp_path: Path) -> None:
    """Of an FMI 3.0 FMU that leaves the flags of fmi3DoStep alone, as some do."""
    feedthrough3(tmp_path / "f.fmu", SILENT=1)
    of = {"f": {"isolation": isolation}}
    system = read_system(tmp_path, tmp_path, {"f": ("f", "1 ms", FREE3)}, stop="10 ms", of=of)
    found = simulate(make_plan(system), interpreted)
    assert not found.failure and len(found.tables[0]) == 11


def test_memory_shared_with_a_process_is_given_back(tmp_path: Path) -> None:
    fmu = Fmu.open(moody(tmp_path / "moody.fmu"))

    def mapped() -> int:
        return Path("/proc/self/maps").read_text().count("rw-s")

    first = mapped()
    for _ in range(3):
        parent.IsolatedInstance(fmu, "m", 30.0).close()
    assert mapped() == first


def test_results_in_a_process_of_its_own_are_the_same_bits(tmp_path: Path) -> None:
    runs = [run(tmp_path, isolate=isolate) for isolate in (False, True)]
    assert all(np.array_equal(a, b) for a, b in zip(runs[0].tables, runs[1].tables, strict=True))
