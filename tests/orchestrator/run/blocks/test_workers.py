"""Several threads in one run: the same bits, the same errors, and only where they pay."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from time import monotonic

import numpy as np
import pytest
from helpers import rovbrush
from native_build import needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.loop.workers.pool import Pool, Stepped, why_not_here
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.blocks.workers import HANDOVER, chosen, expected, in_words
from rovbrush.orchestrator.run.first_steps import first_steps
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping
from rovbrush.orchestrator.studies.bench.runs.workers import busy, busy_ring
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System
from rovbrush.orchestrator.system.request import Request
from rovbrush.orchestrator.system.workers import with_workers

pytestmark = [needs_gcc, pytest.mark.skipif(bool(why_not_here()), reason=why_not_here())]

STEP_FUNCTION = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_int)


@pytest.fixture
def system(tmp_path: Path) -> System:
    return load_system(str(busy_ring(tmp_path, 300, stop="300 ms")))


def failing(folder: Path, answers: dict[str, str]) -> System:
    """The ring with FMUs that fail at 100 ms."""
    for name, answer in answers.items():
        busy(folder / f"{name}_fails.fmu", 300, FAILS_AT=0.0995, FAILS=answer)
    return load_system(str(busy_ring(folder, 300, stop="300 ms", **{name: f"{name}_fails.fmu" for name in answers})))


def with_threads(system: System, workers: object) -> Run:
    run = simulate(make_plan(replace(system, workers=str(workers))))
    assert not [t for t in threading.enumerate() if t.name.startswith("rovbrush-worker")], "none is left"
    return run


def same(a: Run, b: Run) -> bool:
    return a.failure == b.failure and all(
        np.array_equal(x.view(np.int64), y.view(np.int64)) for x, y in zip(a.tables, b.tables, strict=True)
    )


@pytest.mark.parametrize("workers", [2, 3, 7, "auto"])
def test_results_are_the_same_bits_for_any_number_of_threads(workers: object, system: System) -> None:
    one = with_threads(system, 1)
    assert len(one.tables[0]) == 301 and same(one, with_threads(system, workers))


def test_the_interpreter_gives_these_bits_too(system: System) -> None:
    with Session(make_plan(replace(system, workers="2")), interpreted=True) as session:
        session.advance(cycles=50)
        tables = session.run().tables
    expected_rows = with_threads(system, 1).tables[0][:51]
    assert np.array_equal(tables[0].view(np.int64), expected_rows.view(np.int64))


@pytest.mark.parametrize("answer", ["fmi2Error", "fmi2Discard", "fmi2Fatal"])
@pytest.mark.parametrize("guilty", [("c0",), ("c2",), ("c3", "c1"), ("c0", "c1", "c2", "c3")])
def test_a_failing_step_is_told_as_by_one_thread_the_first_in_the_plan(
    guilty: tuple[str, ...], answer: str, tmp_path: Path
) -> None:
    system = failing(tmp_path, dict.fromkeys(guilty, answer))
    one, more = with_threads(system, 1), with_threads(system, 3)
    assert one.failure.startswith(f"component {min(guilty)} ") and answer in one.failure
    assert same(one, more) and one.end == more.end


def test_a_warning_of_a_step_is_no_failure(tmp_path: Path) -> None:
    system = failing(tmp_path, {"c1": "fmi2Warning"})
    assert not with_threads(system, 2).failure and same(with_threads(system, 1), with_threads(system, 2))


def test_a_run_goes_back_to_a_snapshot_bit_for_bit(system: System) -> None:
    with Stepping(make_plan(replace(system, workers="2"))) as session:
        for _ in range(20):
            session.step()
        snapshot = session.snapshot()
        seen = []
        for _ in range(2):
            session.restore(snapshot)
            for _ in range(30):
                session.step()
            seen.append([session.get(f"c{k}.y") for k in range(4)])
    assert seen[0] == seen[1]
    assert seen[0] == [with_threads(system, 1).tables[0][50][k] for k in columns(system)]


def columns(system: System) -> list[int]:
    (group,) = make_plan(system).groups
    return [group.columns.index((f"c{k}", "y")) for k in range(4)]


def test_python_fmus_in_processes_overlap_with_the_same_bits(fmus: Path, tmp_path: Path) -> None:
    tables = "".join(
        f'[components.{n}]\nfmu = "gain"\nperiod = "1 ms"\nisolation = "process"\ninputs = {{ u = {u} }}\n'
        for n, u in (("a", 1.0), ("b", 2.0))
    )
    path = tmp_path / "apart.toml"
    path.write_text(f'format = 2\nstop_time = "20 ms"\n{tables}')
    system = load_system(str(path), fmus)
    assert same(with_threads(system, 1), with_threads(system, 2))


def test_no_thread_waits_for_a_step_while_another_one_is_not_begun() -> None:
    begun = [threading.Event() for _ in range(4)]
    last_begun: list[bool] = []

    def step(k: int) -> Callable[[int | None, float, float, int], int]:
        def do(instance: int | None, time: float, length: float, final: int) -> int:
            begun[k].set()
            if k == 0:  # the others are posted now; a worker takes one
                until = monotonic() + 20.0
                while not any(event.is_set() for event in begun[1:]) and monotonic() < until:
                    pass
            elif threading.current_thread() is not threading.main_thread():
                last_begun.append(all(event.wait(20.0) for event in begun))
            return 0

        return do

    functions = [STEP_FUNCTION(step(k)) for k in range(4)]
    pool = Pool([[Stepped(2, ctypes.cast(f, ctypes.c_void_p).value or 0, 0) for f in functions]])
    pool.share(1)
    try:
        stubs = [STEP_FUNCTION(address) for address in pool.addresses]
        for order in ([0, 3, 1, 2], [0, 1, 2, 3], [0, 2, 3, 1]):  # whichever it waits for
            for event in begun:
                event.clear()
            assert [stubs[k](None, 0.0, 1e-3, 1) for k in order] == [0] * 4
    finally:
        pool.close()
    assert last_begun and all(last_begun)


def test_steps_of_a_microsecond_stay_on_one_thread_and_long_ones_do_not() -> None:
    assert chosen([[1e-6] * 4], 8) == 1
    assert chosen([[50e-6] * 4], 2) == 2 and chosen([[50e-6] * 4], 8) == 4
    assert chosen([[50e-6, 1e-6]], 8) == 1, "the long one takes as long by itself"
    assert expected([[50e-6] * 4], 2) == pytest.approx(100e-6 + 3 * HANDOVER)
    assert expected([[3e-6, 2e-6, 2e-6], [5e-6, 5e-6]], 1) == pytest.approx(17e-6)
    assert chosen([[50e-6] * 4], 1) == 1


def test_the_plan_says_what_was_measured_and_what_is_expected(system: System) -> None:
    said = first_steps(make_plan(replace(system, workers="auto")))
    assert said.startswith("workers: ") and "c3 " in said and "expected" in said
    words = in_words({("a", "b"): [50e-6, 40e-6]}, 2, 4)
    assert words == "workers: 2 threads of 4 processors (a 50 us, b 40 us: 90 us, 51.5 expected)"


@pytest.mark.parametrize("text", ["0", "two", "-1", "1e3"])
def test_an_option_that_means_nothing_is_an_error(text: str, system: System) -> None:
    with pytest.raises(InputError, match=r"--workers .*write a number of threads, 1 to 256"):
        with_workers(system, text)


def test_the_option_reaches_the_run_and_the_plan(
    system: System, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert Request("x", workers="auto").content()["workers"] == "auto"
    assert rovbrush(monkeypatch, "run", system.path, "--workers", "auto", "--out", tmp_path / "out") == 0
    capsys.readouterr()
    assert rovbrush(monkeypatch, "plan", system.path, "--workers", "auto") == 0
    said = capsys.readouterr().out
    assert "stepped at once: c0, c1, c2, c3" in said and "workers: " in said


def test_where_nobody_asks_nothing_of_it_is_loaded(system: System, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> Callable[..., object]:
        raise AssertionError

    monkeypatch.setattr("rovbrush.orchestrator.run.blocks.blocks.Blocks.begin_workers", refuse)
    assert not simulate(make_plan(system)).failure
