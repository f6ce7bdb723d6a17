"""The arithmetic of operations on cells, told once: machine code and C are made of it.

`z[a]`...: cells by the columns of an operation; `c[0]`...: coefficients, of which column k is the first; `n`: the whole
number in cell a. Each line is that of `run.run`: the same arithmetic in the same order.
"""

from __future__ import annotations

import ast
from functools import cache

from .operations import (
    ACCUMULATE,
    COPY,
    LEDGER,
    LINEAR,
    MEAN,
    MIX,
    MOVE,
    NUMBER,
    PUSH,
    QUADRATIC,
    RISE,
    WORK,
)

FORMULAS = {
    COPY: "z[b] = c[0] * z[a] + c[1]",
    MOVE: "z[b] = z[a]",
    PUSH: "z[b] = z[a]",
    LINEAR: "z[b] = c[0] * (z[a] + c[2] * (z[a] - z[p])) + c[1]",
    ACCUMULATE: "z[b] = z[b] + c[0] * (z[p] + z[a])",
    RISE: "z[b] = z[b] + c[0] * (z[a] - z[p])",
    MEAN: "tail = c[2] * z[a] + c[3] * z[p]; z[b] = c[0] * (z[q] + tail) + c[1]; z[q] = -tail",
    NUMBER: "z[b] = c[0] * n + c[1]",
    WORK: "z[b] = z[b] + z[q] * (c[0] * z[p] + c[1] * z[a]) * c[2]",
    LEDGER: "total = z[a] - z[p]; z[b] = total - z[q]; z[q] = total",
    QUADRATIC: "slope = z[a] - z[p]; curvature = z[a] - 2.0 * z[p] + z[q]; "
    "value = z[a] + c[2] * slope + c[3] * curvature; z[b] = c[0] * value + c[1]",
    MIX: "value = c[0] * z[b] + c[1] * z[a]; z[b] = value + c[2] * z[p] + c[3]",
}


@cache
def parsed(code: int) -> tuple[ast.Assign, ...]:
    """The lines of an operation: each a cell, or a name that later lines use, and what it becomes."""
    lines = ast.parse(FORMULAS[code]).body
    assert all(isinstance(line, ast.Assign) and len(line.targets) == 1 for line in lines)
    return tuple(line for line in lines if isinstance(line, ast.Assign))


@cache
def arithmetic(code: int) -> int:
    """How many operations on floating-point numbers it takes."""
    return sum(isinstance(n, ast.BinOp | ast.UnaryOp) for line in parsed(code) for n in ast.walk(line.value))
