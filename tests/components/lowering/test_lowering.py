"""What kernels may use: the lowered text does what the text does, in Python, under Numba and as C, line by line."""

from __future__ import annotations

import importlib.util
import inspect
import os
import re
from pathlib import Path
from types import ModuleType
from typing import Any

import numba
import numpy as np
import pytest
from pyccel import epyccel
from rovbrush.components.declare.record import Packed, value
from rovbrush.components.lowering.lowered import Lowered, lowered
from rovbrush.components.python.kernels import compiled
from sample_kernel import Arguments, lower_text, plain

SYMBOLIC = "-Wl,-Bsymbolic"  # the C library has a function `step` of its own
TEXTS = {
    "scalars of all kinds": """
        def step(h: float, p: Parameters, u: Inputs, x: State, y: Outputs) -> None:
            if p.on and p.n > 2:
                x.a += u.u_1 * h * p.k  # Eq. 1
            y.first = x.a - x.b
    """,
    "arrays of parameters, inputs, state, outputs and scratch": """
        def step(h: float, p: Parameters, u: Inputs, x: State, y: Outputs, s: Scratch) -> None:
            for i in range(p.n):
                s.work[i] = p.zeta[i] * u.v[i]
                x.eta[i, 1] = x.eta[i, 0] + s.work[i]
                y.three[i] = x.eta[i, 1] * h
            y.three[2] -= 1.0
            y.last = y.three[1] + y.three[p.n - 1]
    """,
    "a record handed on is written where it lies": """
        def inner(x: State, p: Parameters) -> None:
            x.b = x.a * p.k

        def middle(x: State, p: Parameters) -> float:
            inner(x, p)
            return x.b + x.a

        def step(h: float, p: Parameters, u: Inputs, x: State, y: Outputs) -> None:
            y.first = middle(x, p) + u.u_1
            x.a = x.b - h
    """,
    "a record in a record": """
        def press(t: Tip, k: float) -> None:
            t.F_n = k * t.moment
            for i in range(3):
                t.r[i] = t.r[i] + t.F_n
                t.A[1, i] = t.A[0, i] * t.r[i]
            t.A[0, 2] = k

        def reach(t: Tip) -> float:
            return t.F_n + t.moment

        def step(h: float, p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
            press(x.tip, p.k)
            press(s.spare, h)
            y.first = reach(x.tip)
            y.last = reach(s.spare)
    """,
    "a record of rows": """
        def shift(t: Table, k: float) -> None:
            for i in range(4):
                t.second[i] = t.first[i] + k * t.alone
            t.first[2] = t.alone
            t.alone = k + t.second[3]

        def step(h: float, x: State, y: Outputs) -> None:
            shift(x.rows, h)
            y.first = x.a + h
    """,
    "a packed record as one array": """
        def doubled(v: Vector, n: int) -> None:
            for i in range(n):
                v[i] = 2.0 * v[i]

        def step(p: Parameters, x: State, y: Outputs, s: Scratch) -> None:
            doubled(x.tip, 11)
            doubled(s.work, 4)
            y.first = p.k
            doubled(y, 5)
    """,
    "a record made by its class and by a function": """
        def rates(a: float, b: float, p: Parameters) -> Rates:
            return Rates(da=p.k * b, db=-a)

        def reduced(r: Rates, by: float) -> Rates:
            made = Rates(r.da / by, r.db / by)
            return made

        def step(h: float, p: Parameters, x: State, y: Outputs) -> None:
            r = rates(x.a, x.b, p)
            r.da += 1.0
            r = reduced(r, 3.0)
            x.a += h * r.da
            x.b += h * r.db
            y.first = r.da + r.db
    """,
    "a record made anew from itself reads the old one": """
        def step(h: float, x: State, y: Outputs) -> None:
            r = Rates(x.a, x.b)
            for i in range(3):
                r = Rates(
                    da=r.db + h,  # the old one
                    db=r.da * 2.0,
                )
            y.first = r.da
            y.last = r.db
    """,
    "whole numbers and truths in a record": """
        def counted(n: int, limit: float) -> Counted:
            found = 0
            for i in range(n):
                if i * 1.0 < limit:
                    found += 1
            return Counted(found, found > 1)

        def step(p: Parameters, y: Outputs) -> None:
            c = counted(p.n, p.k)
            y.first = c.count * 1.0
            if c.yes:
                y.last = 1.0
    """,
    "several values, while, break and a choice": """
        def both(a: float) -> tuple[float, float]:
            return a + 1.0, a - 1.0

        def step(h: float, x: State, y: Outputs) -> None:
            x.a, y.last = both(x.b)
            left = 3.0
            while left > 0.0:
                left -= h
                if left < 1.0:
                    break
                if left > 2.0:
                    continue
                y.three[0] += left
            y.first = x.a if x.a > 0.0 else -x.a
    """,
    "lines that go on": """
        def far(
            a: float,
            p: Parameters,
            t: Tip,
        ) -> float:
            return (
                a
                + p.k * t.F_n
            )

        def step(
            h: float,
            p: Parameters, x: State,
            y: Outputs,
        ) -> None:
            y.first = far(
                h,
                p,
                x.tip,
            )
    """,
}  # fmt: skip


def called(functions: Any, lowered_text: Lowered) -> Arguments:
    """The arguments after a call of the lowered `step`."""
    arguments = Arguments()
    given = arguments.named()
    functions.step(*[given[name] for name in lowered_text.arguments["step"]])
    return arguments


@pytest.mark.parametrize("text", TEXTS.values(), ids=list(TEXTS))
def test_lowered_text_does_what_the_text_does(text: str, tmp_path: Path) -> None:
    expected = Arguments()
    functions = plain(text)
    given = expected.records()
    functions["step"](*[given[name] for name in inspect.signature(functions["step"]).parameters])
    made = lower_text(text)
    under_numba = module_of(made.text, tmp_path)
    for name, function in inspect.getmembers(under_numba, inspect.isfunction):
        setattr(under_numba, name, numba.njit(function))
    in_c = epyccel(made.text, language="c", folder=str(tmp_path), flags="-ffp-contract=off", wrapper_flags=SYMBOLIC)
    for life in (module_of(made.text, tmp_path), under_numba, in_c):
        seen = called(life, made)
        for name, array in expected.arrays.items():
            np.testing.assert_array_equal(seen.arrays[name], array, err_msg=f"{life}: {name}")
    assert any(np.any(array != Arguments().arrays[name]) for name, array in expected.arrays.items())


def module_of(text: str, folder: Path) -> ModuleType:
    path = folder / f"kernel_{len(list(folder.iterdir()))}.py"
    path.write_text(text)
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("text", TEXTS.values(), ids=list(TEXTS))
def test_statements_stay_on_their_lines(text: str) -> None:
    made = lower_text(text).parts[0].text
    written = inspect.cleandoc(text).splitlines()
    seen = inspect.cleandoc(made).splitlines()
    assert len(seen) == len(written)
    for before, after in zip(written, seen, strict=True):
        words = before.split("(")[0].split("=")[0].split()
        if words and words[0] in ("def", "for", "while", "if", "return", "break", "continue"):
            assert after.split()[0] == words[0]


def test_only_fields_that_are_used_are_passed() -> None:
    made = lower_text("""
        def inner(p: Parameters, x: State) -> float:
            return p.k * x.a

        def step(p: Parameters, x: State, y: Outputs) -> None:
            y.first = inner(p, x)
    """)
    assert made.arguments == {"inner": ["k", "a"], "step": ["k", "state", "y"]}


def test_text_without_records_stays_as_it_is() -> None:
    text = 'def step(h: float, y: "float[:]") -> None:\n    y[0] = h  # as ever\n'
    assert lower_text(text).text == text.replace('"', "'") + "\n"


def test_an_error_of_numba_points_at_the_line_of_the_source(tmp_path: Path) -> None:
    (tmp_path / "pointing").mkdir()
    text = (
        '"""A kernel."""\n\n\ndef step(h: float, n: int) -> float:\n    """Too much."""\n    return h + "no number"\n'
    )
    (tmp_path / "pointing" / "kernel.py").write_text(text)
    spec = importlib.util.spec_from_file_location("pointing.kernel", tmp_path / "pointing" / "kernel.py")
    assert spec is not None and spec.loader is not None
    kernel = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(kernel)
    with pytest.raises(numba.core.errors.TypingError) as caught:
        compiled(kernel).step(1.0, 2)
    path = os.path.relpath(tmp_path / "pointing" / "kernel.py")  # as Numba shows it, from where it runs
    assert f'File "{path}", line 6' in re.sub(r"\x1b\[\d+m", "", str(caught.value))
    assert 'return h + "no number"' in str(caught.value)
    assert lowered(kernel).place(6) == (tmp_path / "pointing" / "kernel.py", 6)


def test_records_in_plain_python_refuse_what_they_do_not_have() -> None:
    x = Arguments().records()["x"]
    with pytest.raises(AttributeError, match="State has no field c"):
        x.c = 1.0

    class Pair(Packed):
        a: float = value("1", "one")
        b: float = value("1", "other")

    with pytest.raises(TypeError, match="Pair is made of a, b, in this order"):
        Pair(b=1.0, a=2.0)
