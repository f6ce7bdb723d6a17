"""Stepping by hand: the bits of a run in one, inputs that count from the next step, and clear ends."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import Part, system_text
from native_build import FREE2, FREE3, built, needs_gcc
from rovbrush.orchestrator import InputError, Model, RunError, Stepping, load

CAR: dict[str, Part] = {"w": ("wheel", "1 ms"), "c": ("chassis", "3 ms")}
CAR_WIRES = ["c.v_c -> w.v_c", "w.F -> c.F"]
EVEN: dict[str, Part] = {"w": ("wheel", "2 ms"), "c": ("chassis", "2 ms")}
BOND = {"name": "strut", "effort": "c.F", "flow": "w.v_c", "sign": -1.0}
ONE: dict[str, Part] = {"i": ("integrator", "2 ms", {"=u": 0.0})}
Make = Callable[..., Model]


@pytest.fixture
def make(tmp_path: Path, fmus: Path) -> Make:
    """A model from the text of a system file."""

    def model(*args: Any, folder: Path = fmus, isolated: str = "", **keys: Any) -> Model:
        path = tmp_path / "case.toml"
        text = system_text(*args, **keys)
        if isolated:
            text = text.replace(f"[components.{isolated}]\n", f'[components.{isolated}]\nisolation = "process"\n')
        path.write_text(text, encoding="utf-8")
        return load(path, fmus=folder)

    return model


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel", "iterated", "ecco"])
@pytest.mark.parametrize("by", [None, "30 ms"])
def test_hand_steps_give_the_bits_of_a_run(algorithm: str, by: str | None, make: Make) -> None:
    parts, keys = (EVEN, {"bonds": [BOND]}) if algorithm == "ecco" else (CAR, {})
    model = make(parts, CAR_WIRES, stop="300 ms", algorithm=algorithm, **keys)
    times = []
    with model.start() as session:
        while session.time < session.stop:
            session.step(by)
            times.append(session.time)
        result = session.result()
    assert [t.tobytes() for t in result.run.tables] == [t.tobytes() for t in model.run().run.tables]
    if by and algorithm != "ecco":
        assert times == [30 * k / 1000 for k in range(1, 11)]
    assert times[-1] == result.run.end == 0.3


def test_what_is_set_counts_from_the_next_step_on(make: Make) -> None:
    with make(ONE, stop="20 ms").start() as session:
        assert session.period == 0.002
        for k in range(10):
            session.set("i.u", float(k))
            assert session.get("i.held") == max(k - 1.0, 0.0)
            session.step()
        assert session.get("i.x") == pytest.approx(0.002 * 45, rel=1e-12)


def test_numbers_of_every_kind_can_be_set(make: Make) -> None:
    with make(ONE, stop="20 ms").start() as session:
        for value in (2, 2.0, np.float64(3.0), np.float32(4.0), np.array(5.0), np.int64(6), "7"):
            session.set("i.u", value)
            session.step()
            assert session.get("i.held") == float(value)


def test_a_value_out_of_range_is_refused_the_first_time_and_later(make: Make) -> None:
    free = {"=delta": 0.005, "=delta_dot": 0.0, "=v_rov": 0.0, "=omega_b": 15.0, "=friction_scale": 1.0, "=tilt_x": 0.0}
    with make({"b": ("filament_brush", "1 ms", free)}, stop="1 s").start() as session:
        for _ in range(2):
            for value in (-1.0, float("nan"), float("inf")):
                with pytest.raises(InputError, match=r"set: b\.friction_scale = (-1|nan|inf)"):
                    session.set("b.friction_scale", value)
            session.set("b.friction_scale", 1.5)


@pytest.mark.parametrize(
    ("name", "message"),
    [("c.F", "is driven by"), ("c.m_c", "only inputs"), ("c.Q", "unknown"), ("d.F", "no component")],
)
def test_what_cannot_be_set_is_refused_every_time(name: str, message: str, make: Make) -> None:
    with make(CAR, CAR_WIRES, stop="300 ms").start() as session:
        for _ in range(2):
            with pytest.raises(InputError, match=message):
                session.set(name, 1.0)


def test_an_input_that_follows_a_table_is_not_set_by_hand(make: Make) -> None:
    model = make(ONE, stop="20 ms").with_inputs({"i.u": ([0.0, 0.02], [1.0, 1.0])})
    with model.start() as session, pytest.raises(InputError, match=r"i\.u follows a table; remove that first"):
        session.set("i.u", 2.0)


@needs_gcc
@pytest.mark.parametrize("isolated", ["", "a"])
@pytest.mark.parametrize(("fmu", "free"), [("feedthrough2", FREE2), ("feedthrough3", FREE3)], ids=["fmi2", "fmi3"])
def test_every_type_and_array_is_set_and_got(
    fmu: str, free: dict[str, Any], isolated: str, make: Make, native: Path
) -> None:
    parts = {"a": (fmu, "1 ms", free)}
    with make(parts, stop="20 ms", folder=native, isolated=isolated).start() as session:
        real, out = ("a.u", "a.y") if fmu == "feedthrough2" else ("a.Float64_in", "a.Float64_out")
        whole, whole_out = ("a.n_in", "a.n_out") if fmu == "feedthrough2" else ("a.Int32_in", "a.Int32_out")
        for k in range(3):
            session.set(real, 0.5 + k)
            session.set(whole, 40 + k)
            if fmu == "feedthrough3":
                session.set("a.a_in", [float(k + j) for j in range(8)])
            session.step()
            assert (session.get(out), session.get(whole_out)) == (0.5 + k, 40 + k)
            if fmu == "feedthrough3":
                assert session.get("a.a_out") == [float(k + j) for j in range(8)]


def test_there_is_no_step_behind_the_stop(make: Make) -> None:
    for by in (None, "2 ms"):
        with make(ONE, stop="20 ms").start(stop="4 ms") as session:
            session.step()
            session.step(by)
            with pytest.raises(RunError, match=r"t = 0\.004 s: there is no whole step before the stop at 4 ms"):
                session.step(by)
            with pytest.raises(RunError, match="there is no whole step"):
                session.step("8 ms")


def test_a_time_that_does_not_fit_is_an_error_that_names_the_period(make: Make) -> None:
    with make(CAR, CAR_WIRES, stop="300 ms").start() as session:
        with pytest.raises(InputError, match="step = 2 ms is no multiple of 3 ms, in which the schedule repeats"):
            session.step("2 ms")
        session.step(0.006)
        assert session.time == 0.006


@pytest.mark.parametrize("by", [None, "20 ms"])
def test_a_failure_is_raised_with_the_result_so_far(by: str | None, make: Make) -> None:
    with make({"bad": ("faulty", "5 ms", {"raise_at": 0.02})}, stop="100 ms").start() as session:
        with pytest.raises(RunError, match="component bad") as error:
            for _ in range(10):
                session.step(by)
        assert len(error.value.result.dataset.time) == 1 + round(session.time / 0.005)
        with pytest.raises(RunError, match="the session has ended: component bad"):
            session.step()


def test_a_closed_session_says_so(make: Make) -> None:
    with make(ONE, stop="20 ms").start() as session:
        session.set("i.u", 1.0)
        session.get("i.x")
        session.step()
    for act in (lambda: session.set("i.u", 1.0), lambda: session.get("i.x"), session.step):
        with pytest.raises(RunError, match="closed"):
            act()
    assert len(session.result().dataset.time) == 2


def test_it_works_without_a_with_block(make: Make) -> None:
    session = make(ONE, stop="20 ms").start()
    session.set("i.u", 1.0)
    session.step()
    session.step("4 ms")
    assert session.get("i.x") == pytest.approx(0.006, rel=1e-12)
    session.close()


def test_ctrl_c_between_steps_is_a_keyboard_interrupt(make: Make) -> None:
    with make(ONE, stop="20 ms").start() as session:
        for act in (session.step, lambda: session.step("4 ms")):
            act()
            with pytest.raises(KeyboardInterrupt):
                os.kill(os.getpid(), signal.SIGINT)
            assert session.get("i.x") == 0.0
        assert session.time == 0.006
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def pressing(make: Make) -> Stepping:
    """Somebody presses Ctrl-C in the step to 6 ms, inside an FMU."""
    parts = {"p": ("plain", "1 ms", {"mode": 5, "=u": 0.0, "=temperature": 0.0, "=speed": 0.0})}
    return make(parts, stop="20 ms").start()


def test_ctrl_c_in_a_single_step_comes_behind_it(make: Make) -> None:
    with pressing(make) as session:
        with pytest.raises(KeyboardInterrupt):
            while session.time < session.stop:
                session.step()
        assert session.time == 0.006 and not session.failure


def test_ctrl_c_in_a_longer_step_ends_the_session_as_it_ends_a_run(make: Make) -> None:
    with pressing(make) as session, pytest.raises(RunError, match=r"interrupted by the user at t = 0\.006 s") as error:
        session.step("10 ms")
    assert len(error.value.result.dataset.time) == 7


def test_ctrl_c_while_the_fmus_are_initialized_is_obeyed(make: Make) -> None:
    parts = {"p": ("plain", "1 ms", {"mode": 4, "=u": 0.0, "=temperature": 0.0, "=speed": 0.0})}
    with pytest.raises(KeyboardInterrupt):
        make(parts, stop="20 ms").start()
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
