"""Integration of FMUs for Model Exchange: what a step costs beside the same CVODE driven from C; inputs that jump."""

from __future__ import annotations

import ctypes
import math
import subprocess
import time
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from ....errors import RunError
from ....fmu.fmu import Fmu
from ....fmu.kinds import MODEL_EXCHANGE
from ....integration import cells
from ....integration.memory import call, number, whole
from ....integration.settings import Method, SolverSettings
from ....integration.stiff.libraries import is_there
from ....integration.stiff.sundials import Cvode, address
from ....participant.model_exchange.group import Group
from ....participant.model_exchange.instance import Fmi2Member
from ..fmus.exchange import Model, chain, exchange_fmu, oscillator
from ..fmus.native import SOURCES, compiler

CELLS = 1000  # of the rod
STEP = 0.01  # s
INPUT = 5  # value reference of the oscillator's input
FIELDS = ("SetTime", "SetContinuousStates", "GetDerivatives", "SetReal")
SUNDIALS = ("N_VGetArrayPointer", "CVode", "CVodeSetStopTime", "CVodeReInit")


class Driver(ctypes.Structure):
    """As in fmus/cvode_driver.c."""

    _fields_ = (
        *((name, ctypes.c_void_p) for name in (*FIELDS, *SUNDIALS, "instance", "cvode", "states")),
        ("n", ctypes.c_long), ("calls", ctypes.c_long),
    )  # fmt: skip


class Case:
    """An instance in a group, and its steps by one of the two drivers."""

    def __init__(self, fmu: Fmu, method: Method, tolerance: float, library: Any = None) -> None:
        self.member = Fmi2Member(fmu, fmu.path.stem)
        self.group = Group([self.member], (), SolverSettings(method=method, tolerance=tolerance, step=STEP))
        self.member.join(self.group)
        self.member.set_up(None)
        self.member.enter_initialization()
        self.member.exit_initialization()
        self.member.first_event()
        self.library, self.driver = library, Driver()
        if library is None:
            return
        g, d = self.group.pointer, self.driver
        functions = {"right_hand_side": ctypes.cast(library.right_hand_side, ctypes.c_void_p).value or 0}
        self.cvode = Cvode(g, self.group.settings, self.group.bands, False, functions, ctypes.addressof(d))
        for name in FIELDS:
            setattr(d, name, self.member.address(f"fmi2{name}"))
        for name in SUNDIALS:
            setattr(d, name, address(name))
        d.instance, d.cvode, d.states = self.member.pointer, whole(g + cells.CVODE), whole(g + cells.CV_STATES)
        d.n = whole(g + cells.STATES)

    def go(self, first: int, count: int, inputs: np.ndarray | None = None, restart: bool = False) -> float:
        """So many steps from a number on; the seconds that they take."""
        begin = time.perf_counter()
        if self.library is not None:
            given = None if inputs is None else ctypes.c_void_p(inputs.ctypes.data)
            flag = self.library.drive(
                ctypes.byref(self.driver), ctypes.c_long(first), ctypes.c_long(count), ctypes.c_double(STEP), given,
                ctypes.c_uint(INPUT), ctypes.c_int(restart),
            )  # fmt: skip
        elif inputs is not None:
            for k in range(first, first + count):
                self.member.set("u", float(inputs[k]))
                self.group.step(k * STEP, STEP, final=True)
            flag = int(self.group.failed)
        else:
            flag = _steps()(self.member.address("fmi2DoStep"), self.member.pointer, first, count, STEP)
        if flag:
            raise RunError(f"the steps of {self.member.name} fail: {flag}")
        return time.perf_counter() - begin

    def calls(self) -> int:
        """Evaluations of the right-hand side so far."""
        return int(self.driver.calls) if self.library is not None else whole(self.group.pointer + cells.EVALUATIONS)

    @property
    def first_state(self) -> float:
        return number(whole(self.group.pointer + cells.X))

    def close(self) -> None:
        if self.library is not None:
            self.cvode.free()
        self.member.close()


def steps(function: int, instance: int, first: int, count: int, length: float) -> int:
    """fmi2DoStep, over and over."""
    worst = 0
    for k in range(first, first + count):
        worst |= call(function, instance, k * length, length, 1)
    return worst


@cache
def _steps() -> Any:
    import numba

    return numba.njit(steps)


def _library(folder: Path) -> Any:
    """The driver in C. Raises RunError where there is no compiler."""
    gcc, target = compiler(), folder / "cvode_driver.so"
    if gcc is None:
        raise RunError("no C compiler found; install gcc")
    command = [gcc, "-O2", "-fPIC", "-shared", str(SOURCES / "cvode_driver.c"), "-o", str(target)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RunError(f"cvode_driver.c cannot be compiled: {done.stderr.strip()}")
    return ctypes.CDLL(str(target))


def _opened(folder: Path, name: str, model: Model, **defines: object) -> Fmu:
    return Fmu.open(exchange_fmu(folder / f"{name}.fmu", model, 2, defines)).of_kind(MODEL_EXCHANGE)


def solver_rows(folder: Path, quick: bool) -> Iterator[tuple[float, dict[str, Any]]]:
    """Rows, each with the share that is done. Raises RunError where there is no compiler."""
    library = _library(folder) if is_there() else None
    small = _opened(folder, "oscillator", oscillator())
    rounds = 8 if quick else 40
    yield 0.3, {"model": "oscillator, 2 states", **_beside(small, library, 1000, 5 * rounds, "step")}
    rod = _opened(folder, "chain", chain(CELLS), N=CELLS)
    yield 0.7, {"model": f"rod, {CELLS} states, band", **_beside(rod, library, 5, rounds, "evaluation")}
    if library is not None:
        yield 1.0, {"model": "oscillator, an input that jumps at every step", **jumps(small, library)}


def _beside(fmu: Fmu, library: Any, count: int, rounds: int, each: str) -> dict[str, Any]:
    """The same steps by every driver, in turn; the least time of all rounds."""
    cases = {}
    if each == "step":
        cases = {"dormand-prince": Case(fmu, "dormand-prince", 1e-6), "rk4": Case(fmu, "rk4", 1e-6)}
    if library is not None:
        cases |= {"cvode": Case(fmu, "cvode", 1e-6), "cvode in C": Case(fmu, "cvode", 1e-6, library)}
        cases["cvode"].group.replace_cvode(exact=False)  # as the driver in C has it
    least = dict.fromkeys(cases, math.inf)
    try:
        for k in range(rounds):
            for name, case in cases.items():
                before = case.calls()
                spent = case.go(k * count, count)
                least[name] = min(least[name], spent / (count if each == "step" else max(case.calls() - before, 1)))
    finally:
        for case in cases.values():
            case.close()
    found: dict[str, Any] = {f"{name} [us/{each}]": 1e6 * spent for name, spent in least.items()}
    if library is not None:
        found["cvode to C"] = least["cvode"] / least["cvode in C"]
    return found


def jumps(fmu: Fmu, library: Any, count: int = 2000) -> dict[str, Any]:
    """The error of the first state at the end of so many steps, by solvers that begin anew at jumps or do not."""
    inputs = np.array([10.0 * math.sin(12.9898 * k) for k in range(count)])
    ends = {}
    for name, method, tolerance, anew in (
        ("exact", "dormand-prince", 1e-13, None), ("dormand-prince", "dormand-prince", 1e-6, None),
        ("cvode", "cvode", 1e-6, None), ("cvode in C, restarted", "cvode", 1e-6, True),
        ("cvode in C, not restarted", "cvode", 1e-6, False),
    ):  # fmt: skip
        case = Case(fmu, method, tolerance, None if anew is None else library)  # type: ignore[arg-type]
        try:
            case.go(0, count, inputs, bool(anew))
            ends[name] = case.first_state
        except RunError:
            ends[name] = math.nan  # CVODE gives up
        finally:
            case.close()
    return {f"{name} [error]": abs(end - ends["exact"]) for name, end in ends.items() if name != "exact"}
