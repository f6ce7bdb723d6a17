"""What machine code takes for granted of arrays: that writing to one leaves the others as they are, where it does."""

from __future__ import annotations

import ast
import ctypes

import numpy as np
import pytest
from rovbrush.components.python.machine.apart import apart
from rovbrush.components.python.machine.module import machine_text
from rovbrush.components.python.machine.objects import Loaded, object_of

LINES = """
def summed(a: 'float[:]', b: 'float[:]', c: 'float[:]') -> None:
    for i in range(4):
        c[0] = c[0] + a[i] * b[i]
def shifted(a: 'float[:]', b: 'float[:]') -> None:
    for i in range(3):
        b[i + 1] = a[i]
        a[i] = a[i] + b[i + 1]
def through(a: 'float[:]', b: 'float[:]', c: 'float[:]') -> None:
    shifted(a, b)
    shifted(b, c)
def step(x: 'float[:]', y: 'float[:]', z: 'float[:]') -> None:
    {}
"""
CASES = {
    "each apart": ("shifted(x, y)", set()),
    "one twice, only read": ("summed(x, x, z)", set()),
    "one twice, written through the other": ("summed(x, z, z)", {"summed.b", "summed.c"}),
    "one twice, both written": ("shifted(x, x)", {"shifted.a", "shifted.b"}),
    "one twice, further down": ("through(x, y, x)", {"through.a", "through.c"}),
    "one twice, two calls down": ("through(x, x, z)", {"through.a", "through.b", "shifted.a", "shifted.b"}),
    "twice here and once there": ("shifted(x, y)\n    shifted(z, z)", {"shifted.a", "shifted.b"}),
}
ENTRY = ["lent(values[0:4])", "lent(values[4:8])", "lent(other)"]


def together(line: str, entry: list[str]) -> set[str]:
    functions = {node.name: node for node in ast.parse(LINES.format(line)).body if isinstance(node, ast.FunctionDef)}
    arrays = {f"{name}.{one.arg}" for name, node in functions.items() for one in node.args.args}
    return arrays - {f"{name}.{one}" for name, one in apart(functions, [("step", entry)])}


@pytest.mark.parametrize("what", CASES)
def test_an_array_that_is_given_twice_and_written_is_not_apart(what: str) -> None:
    line, expected = CASES[what]
    assert together(line, ENTRY) == expected


@pytest.mark.parametrize(
    ("entry", "expected"),
    [
        (ENTRY, set()),
        (["lent(values[0:5])", "lent(values[4:8])", "lent(other)"], {"step.x", "step.y", "shifted.a", "shifted.b"}),
        (["lent(other)", "lent(values[4:8])", "lent(values)"], {"step.y", "step.z"}),
        (["lent(other)", "lent(other)", "lent(values)"], {"step.x", "step.y", "shifted.a", "shifted.b"}),
    ],
)
def test_parts_of_an_instances_arrays_are_apart_where_they_do_not_overlap(entry: list[str], expected: set[str]) -> None:
    assert together("shifted(x, y)", entry) == expected


@pytest.mark.parametrize("what", CASES)
def test_the_numbers_are_pythons_whatever_is_given_twice(what: str) -> None:
    text = LINES.format(CASES[what][0])
    values, other = np.array([1.0, 2.0, 4.0, 8.0, 0.5, 0.25, 3.0, 7.0]), np.array([0.1, 0.2, 0.3, 0.4])
    by_python = values.copy(), other.copy()
    namespace: dict[str, object] = {}
    exec(text, namespace)
    namespace["step"](by_python[0][:4], by_python[0][4:], by_python[1])  # type: ignore[operator]
    code = Loaded(object_of(machine_text(text, {"step": ENTRY}, {"values": 1, "other": 1})))
    table = np.array([[values.ctypes.data, 8, 0], [other.ctypes.data, 4, 0]], dtype=np.int64)
    ctypes.PYFUNCTYPE(ctypes.c_int64, ctypes.c_int64)(code.address("step"))(table.ctypes.data)
    assert (values.tolist(), other.tolist()) == (by_python[0].tolist(), by_python[1].tolist())
