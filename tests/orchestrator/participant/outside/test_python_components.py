"""A Python function, class or compiled function as a component: same numbers, and clear errors with file and line."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from rovbrush.orchestrator.errors import InputError, RovbrushError
from rovbrush.orchestrator.fmu.outside.declared import DeclaredFmu
from rovbrush.orchestrator.participant.outside.python.plain_data import as_bytes, from_bytes
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.result import Result
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.request import Changes

FUNCTION = """
def step(t, h, omega: "rad/s", integral, k: "V.s/rad" = 0.5, ki=1.0) -> {"V": "V", "fast": bool}:
    error = 10.0 - omega
    return k * error + ki * integral, omega > 5.0, integral + h * error
"""
CLASS = """
class Plant:
    def __init__(self):
        self.omega, self.seen = 0.0, []

    def step(self, h, V: "V", tau: "s" = 0.2) -> {"omega": "rad/s", "count": int}:
        self.omega += h / tau * (V - self.omega)
        self.seen.append(self.omega)
        return {"count": len(self.seen), "omega": self.omega}
"""
SYSTEM = """
format = 2
stop_time = "0.5 s"
algorithm = "ALGORITHM"
connections = ["c.V -> p.V", "p.omega -> c.omega"]
[components.c]
python = "c.py:step"
period = "10 ms"
parameters = { k = 0.7 }
declare.states = { integral = 0.25 }
[components.p]
python = "p.py:Plant"
period = "10 ms"
"""


def written(folder: Path, function: str = FUNCTION, plant: str = CLASS, system: str = SYSTEM) -> Path:
    folder.mkdir(exist_ok=True)
    (folder / "c.py").write_text(function)
    (folder / "p.py").write_text(plant)
    (folder / "s.toml").write_text(system.replace("ALGORITHM", "gauss-seidel"))
    return folder / "s.toml"


def planned(path: Path, **changes: Any) -> Plan:
    return make_plan(assemble(str(path), changes=Changes(**changes)))


def ran(plan: Plan, interpreted: bool = True) -> tuple[Result, str]:
    with Session(plan, interpreted=interpreted) as session:
        session.advance()
        run = session.run()
    return Result(run), run.failure


def by_hand(count: int) -> list[float]:
    """The same loop without a master: c, then p, each with the latest values."""
    integral, omega, found = 0.25, 0.0, [0.0]
    for _ in range(count):
        error = 10.0 - omega
        v, integral = 0.7 * error + 1.0 * integral, integral + 0.01 * error
        omega += 0.01 / 0.2 * (v - omega)
        found.append(omega)
    return found


@pytest.mark.parametrize("interpreted", [True, False], ids=["interpreted", "compiled"])
def test_a_function_and_a_class_do_what_they_do_by_hand(tmp_path: Path, interpreted: bool) -> None:
    found, failure = ran(planned(written(tmp_path)), interpreted)
    assert not failure
    assert found["p.omega"].values.tolist() == pytest.approx(by_hand(50), rel=1e-13)
    assert found["p.count"].values.tolist() == list(range(51))
    assert found["c.fast"].values.tolist() == [False, *(w > 5.0 for w in found["p.omega"].values.tolist()[:-1])]


@pytest.mark.parametrize("interpreted", [True, False], ids=["interpreted", "compiled"])
def test_a_compiled_function_gives_the_bits_of_the_plain_one(tmp_path: Path, interpreted: bool) -> None:
    plain, _ = ran(planned(written(tmp_path / "a")))
    compiled = f"from numba import njit\n\n@njit{FUNCTION}"
    plan = planned(written(tmp_path / "b", compiled))
    assert isinstance(fmu := plan.system.components["c"].fmu, DeclaredFmu)
    assert fmu.standard == "compiled Python function"
    found, failure = ran(plan, interpreted)
    assert not failure
    for name in ("c.V", "c.fast", "p.omega"):
        assert found[name].values.tobytes() == plain[name].values.tobytes()


def test_the_loop_calls_machine_code_of_a_compiled_function(tmp_path: Path) -> None:
    """Not a callback into Python: the Python function behind it is taken away, and the run goes on."""
    with Session(planned(written(tmp_path, f"from numba import njit\n\n@njit{FUNCTION}"))) as session:
        model: Any = getattr(session.instances["c"], "model", None)
        model.plain = model.step = model.set = model.get = None
        session.advance()
        assert not session.failure


def test_a_cfunc_is_called_by_its_address(tmp_path: Path) -> None:
    function = """
from numba import cfunc

@cfunc("float64(float64, float64)")
def step(omega, k):
    return k * (10.0 - omega)
"""
    declare = 'declare.inputs.omega = "rad/s"\ndeclare.parameters.k = 0.1\ndeclare.outputs.V = "V"\n'
    system = SYSTEM.replace("declare.states = { integral = 0.25 }\n", declare)
    found, failure = ran(planned(written(tmp_path, function, CLASS, system)), False)
    assert not failure
    assert found["c.V"].values[-1] == 0.7 * (10.0 - found["p.omega"].values[-2])


@pytest.mark.parametrize("compiled", [False, True], ids=["plain", "njit"])
def test_a_checkpoint_goes_on_bit_by_bit(tmp_path: Path, compiled: bool) -> None:
    function = f"from numba import njit\n\n@njit{FUNCTION}" if compiled else FUNCTION
    path = written(tmp_path / "s", function)
    whole, _ = ran(planned(path))
    with Session(planned(path), interpreted=True) as session:
        session.advance(cycles=17)
        write_checkpoint(session, tmp_path)
    with Session(plan := planned(path), interpreted=True) as session:
        read_checkpoint(tmp_path).restore(session)
        session.advance()
        found = Result(session.run())
    for name in ("c.V", "p.omega", "p.count"):
        assert found[name].values.tobytes() == whole[name].values.tobytes()
    (tmp_path / "s" / "c.py").write_text(function + "\n# other\n")
    with (
        Session(planned(path), interpreted=True) as session,
        pytest.raises(InputError, match=r"component c: the FMU has changed, c.py had sha256"),
    ):
        read_checkpoint(tmp_path).restore(session)
    assert plan.system.components["c"].fmu.digest != planned(path).system.components["c"].fmu.digest


def test_an_algorithm_that_goes_back_restores_states(tmp_path: Path) -> None:
    """Iterated steps save and restore: the class counts each step once."""
    path = written(tmp_path)
    path.write_text(SYSTEM.replace("ALGORITHM", "iterated"))
    found, failure = ran(planned(path))
    assert not failure
    assert found["p.count"].values.tolist() == list(range(51))


def test_state_that_is_no_plain_data_is_named(tmp_path: Path) -> None:
    plant = CLASS.replace("self.omega, self.seen = 0.0, []", "self.omega, self.seen, self.of = 0.0, [], {'f': open}")
    with Session(planned(written(tmp_path, plant=plant)), interpreted=True) as session:
        session.advance(cycles=1)
        with pytest.raises(
            RovbrushError, match=r"component p: its state cannot be written to disk: self.of.f is a builtin"
        ):
            write_checkpoint(session, tmp_path)


def test_plain_data_comes_back_exactly() -> None:
    import numpy as np

    data = {"a": (1, 2.5, True, None, "x"), 3: [{"b": -0.0}], "n": np.array([[1.5, 2.0]]), "s": np.float32(0.1)}
    found = from_bytes(as_bytes(data))
    assert repr(found) == repr(data) and type(found["s"]) is np.float32
    with pytest.raises(ValueError):
        from_bytes(b'{"pickle": 1}')


RAISES = {
    "an exception": (
        "def step(omega) -> {'V': 'V'}:\n    return helper(omega)\n\ndef helper(x):\n    return 1.0 / (x - x)\n",
        r"component c: c.py, line 5, in helper: ZeroDivisionError: float division by zero",
    ),
    "too few": (
        "def step(omega) -> {'V': 'V', 'W': 'V'}:\n    return 1.0\n",
        "line 1: step returned 1 value, and it is to return V, W",
    ),
    "too many": ("def step(omega) -> {'V': 'V'}:\n    return 1.0, 2.0\n", "returned 2 values, and it is to return V"),
    "nothing": ("def step(omega) -> {'V': 'V'}:\n    pass\n", "returned V = None, which is not a finite number"),
    "NaN": (
        "def step(omega) -> {'V': 'V'}:\n    return float('nan')\n",
        "returned V = nan, which is not a finite number",
    ),
    "a text": (
        "def step(omega) -> {'V': 'V'}:\n    return '1.0'\n",
        "returned V = '1.0', which is not a finite number",
    ),
    "other names": (
        "def step(omega) -> {'V': 'V'}:\n    return {'v': 1.0}\n",
        "returned a dict of v, and it is to return V",
    ),
    "no Boolean": (
        "def step(omega) -> {'V': 'V', 'on': bool}:\n    return 1.0, 0.5\n",
        "on = 0.5, which is not true or false",
    ),
    "no whole number": ("def step(omega) -> {'V': 'V', 'n': int}:\n    return 1.0, 2.0**40\n", "is not a whole number"),
    "an exception in machine code": (
        "from numba import njit\n\n@njit\ndef step(t, omega) -> {'V': 'V'}:\n"
        "    if t > 0.095:\n        raise ValueError('too late')\n    return t\n",
        "component c: c.py, line 6, in step: ValueError: too late in the step to t = 0.11 s",
    ),
    "NaN in machine code": (
        "from numba import njit\n\n@njit\ndef step(t, omega) -> {'V': 'V'}:\n    return 0.0 * omega / (t - t)\n",
        "component c",
    ),
}
NO_STATE = SYSTEM.replace("declare.states = { integral = 0.25 }\n", "").replace("parameters = { k = 0.7 }\n", "")


@pytest.mark.parametrize("case", RAISES)
def test_what_goes_wrong_in_a_step_ends_the_run_and_keeps_its_rows(tmp_path: Path, case: str) -> None:
    function, words = RAISES[case]
    plan = planned(written(tmp_path, function, CLASS, NO_STATE))
    found, failure = ran(plan, interpreted=False)
    assert re.search(words, failure)
    assert "it gave no reason" not in failure and "Traceback" not in failure
    assert found["p.omega"].values[0] == 0.0


REFUSED = {
    "no such file": ({"c.py:step": "d.py:step"}, FUNCTION, r"component c: there is no file d.py.*\(s.toml, line 7\)"),
    "no such name": ({"c.py:step": "c.py:stp"}, FUNCTION, "c.py has no 'stp'; did you mean 'step'"),
    "no name": ({"c.py:step": "c.py"}, FUNCTION, r"must be a file and a name in it, as in python = "),
    "outside": ({"c.py:step": "../c.py:step"}, FUNCTION, "is not in the system's folder; .*--allow-outside"),
    "bad syntax": ({}, "def step(:\n", r"c.py, line 1: invalid syntax"),
    "raises": ({}, "x = 1\ny = x / 0\n", r"c.py, line 2: ZeroDivisionError: division by zero"),
    "exits": ({}, "raise SystemExit(3)\n", r"c.py, line 1: SystemExit"),
    "no function": ({}, "step = 3\n", "c.py: 'step' is no function and no class, but 3"),
    "a class without step": ({}, "class step: pass\n", "class step has no method step"),
    "stars": ({}, "def step(*u): return 1\n", r"argument \*u has no name that an input could have"),
    "no outputs": (
        {"declare.states = { integral = 0.25 }\n": ""},
        "def step(omega, k=1.0): return 1\n",
        "step has no outputs",
    ),
    "a declared input that it does not take": (
        {"declare.states": 'declare.inputs = { omga = "rad/s" }\ndeclare.states'},
        FUNCTION,
        r"c.py, line 2: step takes no argument 'omga', which is declared; did you mean 'omega'",
    ),
    "a bad unit": ({}, FUNCTION.replace('rad/s"', 'rad/sx"', 1), "rad/sx"),
    "a bad default": ({}, FUNCTION.replace("ki=1.0", "ki=None"), "the default of ki is None"),
    "a bad annotation": ({}, FUNCTION.replace("ki=1.0", "ki: list = 1.0"), "ki is annotated as <class 'list'>"),
    "a reserved name": ({"integral": "h"}, FUNCTION, "t and h are the time and the length of a step"),
    "both": ({'python = "c.py': 'fmu = "x"\npython = "c.py'}, FUNCTION, "fmu and python exclude each other"),
    "isolation": (
        {"parameters = ": 'isolation = "process"\nparameters = '},
        FUNCTION,
        "isolation is for FMUs, and python is none",
    ),
    "twice": (
        {"declare.states = { ": "declare.inputs = { integral = 1.0 }\ndeclare.states = { "},
        FUNCTION,
        "integral is declared twice",
    ),
    "an unknown key": ({"integral = 0.25": "integral = { strat = 1.0 }"}, FUNCTION, "unknown key 'strat'"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_a_component_is_refused_with_its_place(tmp_path: Path, case: str) -> None:
    changes, function, words = REFUSED[case]
    system = SYSTEM
    for old, new in changes.items():
        assert old in system
        system = system.replace(old, new)
    (tmp_path / "c.py").write_text(FUNCTION)
    with pytest.raises(InputError, match=words) as error:
        planned(written(tmp_path / "s", function, CLASS, system))
    assert "component c" in str(error.value) and "s.toml" in str(error.value)


def test_a_file_elsewhere_is_taken_where_its_folder_is_allowed(tmp_path: Path) -> None:
    path = written(tmp_path / "s", system=SYSTEM.replace("c.py:step", "../c.py:step"))
    (tmp_path / "c.py").write_text(FUNCTION)
    with pytest.raises(InputError):
        planned(path)
    assert planned(path, outside=(str(tmp_path),)).system.components["c"].fmu.path.name == "c.py"


def test_what_numba_cannot_compile_is_named(tmp_path: Path) -> None:
    function = "from numba import njit\n\n@njit\ndef step(omega) -> {'V': 'V'}:\n    return open('x')\n"
    with (
        pytest.raises(InputError, match=r"c.py, line [34]: Numba cannot compile step"),
        Session(planned(written(tmp_path, function, CLASS, NO_STATE))),
    ):
        pass


def test_two_runs_share_no_module(tmp_path: Path) -> None:
    """Each run begins with what the file says, whatever an earlier one left in its globals."""
    function = "n = [0]\n\ndef step(omega) -> {'V': 'V'}:\n    n[0] += 1\n    return float(n[0])\n"
    plan = planned(written(tmp_path, function, CLASS, NO_STATE))
    assert ran(plan)[0]["c.V"].values.tolist() == ran(plan)[0]["c.V"].values.tolist()


def test_files_beside_it_are_imported_afresh_and_count_for_the_digest(tmp_path: Path) -> None:
    function = """
from __future__ import annotations
from dataclasses import dataclass
from gains_of_test import GAIN

@dataclass
class Gains:
    k: float = GAIN

def step(omega, k=1.0) -> {"V": "V"}:
    return Gains().k
"""
    path = written(tmp_path, function, CLASS, NO_STATE)
    (tmp_path / "gains_of_test.py").write_text("GAIN = 2.0\n")
    first = planned(path)
    assert ran(first)[0]["c.V"].values[-1] == 2.0
    (tmp_path / "gains_of_test.py").write_text("GAIN = 3.0\n")
    second = planned(path)
    assert ran(second)[0]["c.V"].values[-1] == 3.0
    assert first.system.components["c"].fmu.digest != second.system.components["c"].fmu.digest


@pytest.mark.parametrize("compiled", [False, True], ids=["plain", "njit"])
def test_an_event_sets_a_tunable_parameter(tmp_path: Path, compiled: bool) -> None:
    function = "def step(omega, k=1.0) -> {'V': 'V'}:\n    return k\n"
    function = f"from numba import njit\n\n@njit\n{function}" if compiled else function
    declared = 'declare.parameters.k = { start = 1.5, unit = "V", tunable = true }\n'
    system = NO_STATE.replace('python = "c.py:step"\n', f'python = "c.py:step"\n{declared}')
    system += '[[events]]\nat = "0.1 s"\nset = { "c.k" = 4.0 }\n'
    found, failure = ran(planned(written(tmp_path, function, CLASS, system)), interpreted=False)
    assert not failure
    assert found["c.V"].values.tolist() == [0.0, *[1.5] * 10, *[4.0] * 40]


def test_a_step_that_exits_ends_the_run_and_not_the_process(tmp_path: Path) -> None:
    function = "import sys\n\ndef step(omega) -> {'V': 'V'}:\n    sys.exit(3)\n"
    _, failure = ran(planned(written(tmp_path, function, CLASS, NO_STATE)), interpreted=False)
    assert "component c: c.py, line 4, in step: SystemExit: 3" in failure
