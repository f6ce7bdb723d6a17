"""Systems, runs and results from Python: the same bits and the same errors as on the command line."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import Part, plan_of, python, system_text
from rovbrush.orchestrator import FmuError, InputError, Model, RovbrushError, RunError, load
from rovbrush.orchestrator.loop.machine.compiled import compiled_loop
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import PUBLIC

LOOP: dict[str, Part] = {
    "g": ("gain", "1 ms", {"k": -1.0, "offset": 0.0}),
    "i": ("integrator", "5 ms", {"x_start": 1.0}),
    "f": ("gain", "1 ms", {"=u": 0.5}),
}
WIRES = ["i.x -> g.u", "g.y -> i.u"]
Make = Callable[..., Model]


@pytest.fixture
def make(tmp_path: Path, fmus: Path) -> Make:
    """A model from the text of a system file."""

    def model(*args: Any, load_with: dict[str, Any] | None = None, **keys: Any) -> Model:
        path = tmp_path / "case.toml"
        path.write_text(system_text(*args, **keys), encoding="utf-8")
        return load(path, fmus=fmus, **(load_with or {}))

    return model


def bits(result: Any) -> list[bytes]:
    return [table.tobytes() for table in result.run.tables]


def test_a_run_has_the_bits_of_any_other(make: Make, tmp_path: Path, fmus: Path) -> None:
    run = simulate(plan_of(tmp_path, fmus, LOOP, WIRES, stop="100 ms"))
    model = make(LOOP, WIRES, stop="100 ms")
    assert bits(model.run()) == [table.tobytes() for table in run.tables] == bits(model.run())


def test_set_gives_another_model_with_the_same_plan(make: Make, tmp_path: Path, fmus: Path) -> None:
    base = make(LOOP, WIRES, stop="100 ms")
    before = bits(base.run())
    other = base.set("g.k", np.float64(-2.0)).set({"i.x_start": 3, "f.u": 0.25})
    assert other.plan.cycle is base.plan.cycle and other.system.components["g"].fmu is base.system.components["g"].fmu
    assert float(other.run()["i.x"][0]) == 3.0 and bits(base.run()) == before
    parts = {
        "g": ("gain", "1 ms", {"k": -2.0, "offset": 0.0}), "i": ("integrator", "5 ms", {"x_start": 3.0}),
        "f": ("gain", "1 ms", {"=u": 0.25}),
    }  # fmt: skip
    fresh = simulate(plan_of(tmp_path, fmus, parts, WIRES, stop="100 ms"))
    assert bits(other.run()) == [table.tobytes() for table in fresh.tables]


def test_many_runs_share_one_compilation(make: Make) -> None:
    model = make(LOOP, WIRES, stop="20 ms")
    functions = []
    for k in range(3):
        model.set("g.k", -1.0 - k).run()
        functions.append(compiled_loop().address)
    assert len(set(functions)) == 1 and compiled_loop.cache_info().currsize == 1


def test_a_stop_an_input_a_period_and_a_replacement_can_be_given(make: Make, fmus: Path) -> None:
    model = make(LOOP, WIRES, stop="100 ms")
    assert model.run(stop="20 ms").run.end == 0.02 and model.run(stop=0.015).run.end == 0.015
    ramp = model.run(stop="20 ms", inputs={"f.u": ([0.0, 0.02], [0.0, 2.0])})
    assert float(ramp["f.u"][-1]) == pytest.approx(1.95, rel=1e-12)
    assert model.with_inputs({"f.u": 0.75}).system.components["f"].inputs["u"] == 0.75
    options = {"periods": {"f": "2 ms"}, "replacements": {"i": fmus / "integrator.fmu"}, "stop": "30 ms"}
    changed = make(LOOP, WIRES, stop="100 ms", load_with=options)
    assert changed.plan.clock.periods["f"] == 2 * changed.plan.clock.periods["g"] and changed.run().run.end == 0.03
    chosen = make(LOOP, WIRES, stop="20 ms", load_with={"record": ["i.x"]}).run()
    assert list(chosen.dataset.data_vars) == ["i.x"]
    assert "in place of" in changed.explain() and changed.explain() == explain(changed.plan)


def test_datasets_have_units_descriptions_and_a_time_for_every_rate(make: Make) -> None:
    result = make(LOOP, WIRES, stop="20 ms").run()
    assert list(result.datasets) == ["every_1_ms", "every_5_ms"]
    assert result["i.x"].attrs == {"units": "1", "long_name": "integral of u", "period": "5 ms"}
    assert result["i.x"].dims == ("time",) and result["i.x"].time.attrs["units"] == "s"
    whole = result.dataset
    assert whole["i.x"].dims == ("time_5_ms",) and whole["g.y"].dims == ("time_1_ms",) and whole.attrs["complete"]
    assert whole["time_5_ms"].values.tolist() == [0.0, 0.005, 0.01, 0.015, 0.02]
    assert np.array_equal(whole["i.x"], result["i.x"])
    single = make({"f": LOOP["f"]}, stop="20 ms").run()
    assert single.dataset["f.y"].dims == ("time",)
    with pytest.raises(InputError, match=r"no recorded signal 'i\.xx'; did you mean 'i\.x'\?"):
        result["i.xx"]
    assert repr(result) == "<Result of case to 0.02 s: every_1_ms, every_5_ms>"


def test_results_are_saved_as_by_the_command_line(make: Make, tmp_path: Path, fmus: Path) -> None:
    make(LOOP, WIRES, stop="20 ms", summary={"x": "last i.x"}).run().save(tmp_path / "api")
    arguments = ["run", str(tmp_path / "case.toml"), "--fmus", str(fmus), "--out", str(tmp_path / "cli")]
    subprocess.run([sys.executable, "-m", "rovbrush.orchestrator", *arguments], check=True, capture_output=True)
    for name in ("result.csv", "manifest.json"):
        assert (tmp_path / "api" / name).read_bytes() == (tmp_path / "cli" / name).read_bytes()


@pytest.mark.parametrize(
    ("act", "kind", "message"),
    [
        (lambda m: m.set("g.kk", 1.0), InputError, "set: g.kk is unknown; did you mean 'k'?"),
        (lambda m: m.set("gg.k", 1.0), InputError, "set: no component 'gg' in 'gg.k'; did you mean 'g'?"),
        (lambda m: m.set("g.k", "fast"), InputError, "set: g.k = fast is not a finite number"),
        (lambda m: m.set("i.u", 1.0), InputError, "set: i.u is driven by the connection g.y -> i.u; remove that first"),
        (lambda m: m.run(stop="-1 s"), InputError, "the stop at -1 s is not after the start at 0 s"),
        (lambda m: m.run(stop="soon"), InputError, "stop = 'soon' is not a time"),
        (lambda m: m.run(inputs={"f.v": 1.0}), InputError, "inputs: f.v is no input"),
        (lambda m: m.run(inputs={"f.u": ([0.0], [1.0])}), InputError, "holds 0 s to 0 s, the run goes from 0 s to 20"),
        (lambda m: m.run(inputs={"f.u": ([0.0],)}), InputError, "f.u needs (times, values), not 1 things"),
        (lambda m: m.run(inputs="none.csv"), InputError, "none.csv cannot be read"),
        (lambda m: m.run(every="5 ms"), InputError, "give one with observe"),
        (lambda m: m.run(observe=print, every="1 ms"), InputError, "every = 1 ms is no multiple of 5 ms"),
        (lambda m: m.run(observe=print, signals=["g.z"]), InputError, "no output 'g.z'; did you mean 'g.y'?"),
        (lambda m: load("nominl"), InputError, "no system 'nominl'; did you mean 'nominal'?"),
        (lambda m: load("nominal", fmus="nowhere"), FmuError, "dc_motor.fmu"),
    ],
)
def test_errors_are_those_of_the_command_line(
    act: Callable[[Model], Any], kind: type[RovbrushError], message: str, make: Make
) -> None:
    with pytest.raises(kind) as error:
        act(make(LOOP, WIRES, stop="20 ms"))
    assert message in str(error.value)


def test_what_the_system_wants_reported_is_checked_before_the_run(make: Make) -> None:
    with pytest.raises(InputError, match="summary x"):
        make(LOOP, WIRES, stop="20 ms", summary={"x": "last i.y"}).run()


def test_a_run_that_fails_raises_with_what_was_computed(make: Make, tmp_path: Path, fmus: Path) -> None:
    parts = {"bad": ("faulty", "5 ms", {"raise_at": 0.02})}
    with pytest.raises(RunError) as error:
        make(parts, stop="100 ms").run()
    run = simulate(plan_of(tmp_path, fmus, parts, stop="100 ms"))
    assert str(error.value) == run.failure and len(error.value.result.dataset.time) == len(run.tables[0])
    assert error.value.result.dataset.attrs["complete"] == 0


def test_too_much_energy_made_by_the_coupling_is_an_error_with_the_result(make: Make) -> None:
    bond = {"name": "strut", "effort": "c.F", "flow": "w.v_c", "sign": -1.0, "limit": 1e-9}
    parts = {"w": ("wheel", "5 ms"), "c": ("chassis", "5 ms")}
    with pytest.raises(RunError, match="strut") as error:
        make(parts, ["c.v_c -> w.v_c", "w.F -> c.F"], stop="1 s", bonds=[bond]).run()
    assert not error.value.result.run.failure


def test_an_observer_sees_the_recorded_values_and_changes_nothing(make: Make) -> None:
    model = make(LOOP, WIRES, stop="95 ms")
    seen: list[tuple[float, dict[str, Any]]] = []
    result = model.run(observe=lambda time, values: seen.append((time, values)), every="20 ms", signals=["i.*", "g.y"])
    assert [time for time, _ in seen] == [0.0, 0.02, 0.04, 0.06, 0.08, 0.095]
    x = result["i.x"].sel(time=[time for time, _ in seen])
    assert [values["i.x"] for _, values in seen] == x.values.tolist()
    assert set(seen[0][1]) == {"i.x", "i.held", "i.impulse", "g.y"}
    assert bits(result) == bits(model.run())


def test_without_a_period_an_observer_sees_every_step(make: Make) -> None:
    times: list[float] = []
    make(LOOP, WIRES, stop="20 ms").run(observe=lambda time, values: times.append(time), every=None)
    assert times == [0.0, 0.005, 0.01, 0.015, 0.02]


def test_with_varying_steps_an_observer_is_called_behind_every_period(make: Make) -> None:
    bond = {"name": "strut", "effort": "c.F", "flow": "w.v_c", "sign": -1.0}
    parts = {"w": ("wheel", "2 ms"), "c": ("chassis", "2 ms")}
    model = make(parts, ["c.v_c -> w.v_c", "w.F -> c.F"], stop="1 s", algorithm="ecco", bonds=[bond])
    times: list[float] = []
    result = model.run(observe=lambda time, values: times.append(time), every="100 ms")
    assert times[0] == 0.0 and times[-1] == 1.0 and len(times) == 11
    assert all(0.1 * k <= time < 0.1 * (k + 1) for k, time in enumerate(times[:-1]))
    assert set(times) <= set(result.dataset.time.values.tolist()) and bits(result) == bits(model.run())


def test_what_an_observer_raises_ends_the_run(make: Make) -> None:
    def refuse(time: float, values: dict[str, Any]) -> None:
        if time > 0.007:
            raise ValueError(f"enough at {time}")

    with pytest.raises(ValueError, match=r"enough at 0\.01"):
        make(LOOP, WIRES, stop="20 ms").run(observe=refuse)


def test_importing_the_package_loads_nothing_heavy() -> None:
    done = python("import sys, rovbrush.orchestrator; print({'numba', 'fmpy', 'xarray'} & set(sys.modules))")
    assert done.stdout.strip() == "set()", done.stderr
    done = python("from rovbrush.orchestrator import nothing")
    assert "cannot import name 'nothing'" in done.stderr


def test_the_public_names_and_what_objects_say_of_themselves(fmus: Path) -> None:
    import rovbrush
    from rovbrush import orchestrator

    for package in (rovbrush, orchestrator):
        assert {"load", "Model", "Result", "RunError"} <= set(dir(package))
        assert all(hasattr(package, name) for name in dir(package))
    model = load("test_stand", fmus=fmus, stop="10 ms")
    assert repr(model).startswith("<Model test_stand: ") and "to 10 ms>" in repr(model)
    with model.start() as session:
        session.step()
        assert repr(session) == f"<Session of test_stand at {session.time:.9g} s of 0.01 s>"
        shown = dir(session)
        assert {"get", "set", "step", "time", "result"} <= set(shown) == set(PUBLIC)
        assert all(hasattr(session, name) for name in shown) and not any(name.startswith("_") for name in shown)
        assert all(getattr(type(session), name, None) is not None or hasattr(session, name) for name in shown)
        documented = [getattr(type(session), name) for name in shown if hasattr(type(session), name)]
        assert all(found.__doc__ for found in documented), shown
