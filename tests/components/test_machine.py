"""Kernels are compiled straight by LLVM and kept; what that does not know goes to Numba, with the same bits."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import python
from lives import component
from rovbrush.components.build import COMPONENTS
from rovbrush.components.lowering.lowered import lowered
from rovbrush.components.python.machine.kinds import UnknownError
from rovbrush.components.python.machine.module import machine_text
from rovbrush.components.python.machine.objects import Loaded, object_of
from rovbrush.components.python.memory import Memory, places_of
from rovbrush.components.python.stages import STAGES

RUN = """
import sys
from rovbrush.components.python.component import component_class
motor = component_class("dc_motor")(instance_name="motor")
motor.set_real([motor.memory.index["V_in"]], [12.0])
motor.enter_initialization_mode()
motor.exit_initialization_mode()
assert all(motor.do_step(k * 1e-3, 1e-3) for k in range(20))
print("numba" in sys.modules, [value.hex() for value in motor.memory.y.tolist()])
"""
WHOLE = "def step(y: 'float[:]', n: int) -> None:\n    {}\n"


def run(cache: Path, **environment: str) -> str:
    done = python(RUN, timeout=300.0, ROVBRUSH_CACHE=str(cache), **environment)
    assert not done.returncode, done.stderr
    return done.stdout


@pytest.mark.parametrize("name", COMPONENTS)
def test_every_kernel_of_ours_is_known(name: str) -> None:
    declared = component(name)
    memory = Memory(declared.variables(), declared.outputs, declared.arrays)
    memory.allocate(declared.parameters())
    source = lowered(declared.kernel)
    arrays, entries = {"values": 1, "block": 1}, {}
    for stage in (stage for stage in STAGES if hasattr(declared.kernel, stage)):
        entries[stage], others = places_of(memory, source.arguments[stage])
        arrays |= {other: memory.store[other].ndim for other in others}
    assert machine_text(source.text, entries, arrays).count("define i64 @") == 2 * len(entries)


def test_machine_code_is_kept_and_numba_is_not_loaded(tmp_path: Path) -> None:
    first = run(tmp_path / "cache")
    (kept,) = (tmp_path / "cache" / "kernels").rglob("kernel.o")
    written = kept.stat().st_mtime_ns
    assert first.startswith("False") and run(tmp_path / "cache") == first and kept.stat().st_mtime_ns == written


@pytest.mark.parametrize("how", ["damaged", "gone", "nobody writes there"])
def test_without_what_was_kept_the_bits_are_the_same(how: str, tmp_path: Path) -> None:
    first = run(tmp_path / "cache")
    (kept,) = (tmp_path / "cache" / "kernels").rglob("kernel.o")
    content = kept.read_bytes()
    if how == "damaged":
        kept.write_bytes(content[:900] + bytes([content[900] ^ 1]) + content[901:])
        assert run(tmp_path / "cache") == first and kept.read_bytes() == content
        return
    kept.unlink()
    (tmp_path / "file").touch()
    assert run(tmp_path / "file" if how == "nobody writes there" else tmp_path / "cache") == first


def test_numba_gives_the_same_bits_where_it_is_asked_for(tmp_path: Path) -> None:
    ours, numbas = (run(tmp_path, ROVBRUSH_KERNELS=one) for one in ("", "numba"))
    assert ours.split()[0] == "False" and numbas.split()[0] == "True" and ours.split()[1:] == numbas.split()[1:]


@pytest.mark.parametrize(
    "line",
    ["y[0] = 2.0 ** n", "y[0] = n % 2", "y[0] = n // 2", "y[0] = y[0.5]", "raise ValueError(n)", "n = y[0]",
     "y[0] = (n > 1) + 1", "y[0] = n << n", "y[0] = fmod(1.0, 2.0)"],
)  # fmt: skip
def test_what_is_not_known_is_said_so_that_numba_takes_it(line: str) -> None:
    with pytest.raises(UnknownError):
        machine_text(WHOLE.format(line), {"step": ["values", "int(values[0])"]}, {"values": 1})


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("y[-1] = 3.0", [2.0, 3.0]),
        ("y[n - 3] = 3.0", [2.0, 3.0]),  # an index below zero counts from the end
        ("for n in range(5, 0, -2):\n        y[0] = y[0] + n\n    y[1] = n", [11.0, 1.0]),
        ("while True:\n        n += 1\n        if n > 6:\n            break\n    y[1] = n", [2.0, 7.0]),
        ("y[0], y[1] = y[1], y[0]", [-1.0, 2.0]),
        ("y[1] = n / 4 if n > 1 and not n > 5 else -1.0", [2.0, 0.5]),
        ("y[1] = max(1, n, y[0] * 1.5) + min(0.5, n)", [2.0, 3.5]),
        ("y[1] = int(-1.5) + abs(-n) + float(n > 1)", [2.0, 2.0]),
        ("y[1] = (n << 3) ^ (n | 5) & 6 - (n >> 1)", [2.0, 21.0]),
    ],
)
def test_a_statement_does_what_python_says(body: str, expected: list[float]) -> None:
    import ctypes

    import numpy as np

    y = np.array([2.0, -1.0])
    namespace: dict[str, object] = {}
    exec(WHOLE.format(body), namespace)
    by_python = y.copy()
    namespace["step"](by_python, 2)  # type: ignore[operator]
    code = Loaded(object_of(machine_text(WHOLE.format(body), {"step": ["values", "int(values[0])"]}, {"values": 1})))
    table = np.array([[y.ctypes.data, 2, 0]], dtype=np.int64)
    ctypes.PYFUNCTYPE(ctypes.c_int64, ctypes.c_int64)(code.address("step"))(table.ctypes.data)
    assert y.tolist() == by_python.tolist() == expected


USUAL = """
import sys
from rovbrush.components.python.component import component_class
brush = component_class("filament_brush")(instance_name="brush")
for name, value in (("n", 4.0), ("N_m", float(sys.argv[1]))):
    brush.set_real([brush.memory.index[name]], [value])
brush.enter_initialization_mode()
brush.exit_initialization_mode()
brush.set_real([brush.memory.index[name] for name in ("omega_b", "delta")], [15.7, 5e-3])
assert all(brush.do_step(k * 1e-4, 1e-4) for k in range(40))
print([value.hex() for value in brush.memory.y.tolist()])
"""


def test_a_step_for_unusual_parameters_is_compiled_when_it_is_needed_with_the_bits_of_python(tmp_path: Path) -> None:
    def kernels() -> int:
        return len(list((tmp_path / "kernels").rglob("kernel.o")))

    def outputs(modes: str, **environment: str) -> str:
        done = python(USUAL, modes, timeout=300.0, ROVBRUSH_CACHE=str(tmp_path), **environment)
        assert not done.returncode, done.stderr
        return done.stdout

    usual = outputs("3")
    assert kernels() == 1 and outputs("3") == usual and kernels() == 1
    other = outputs("4")
    assert kernels() == 2 and other != usual
    assert [outputs(modes, NUMBA_DISABLE_JIT="1") for modes in ("3", "4")] == [usual, other]
