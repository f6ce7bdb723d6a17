"""The arithmetic of operations as C: what `loop/formulas.py` says, bit by bit, and readable."""

from __future__ import annotations

import random

import pytest
from rovbrush.orchestrator.emit.code.operations.formulas import in_c
from rovbrush.orchestrator.loop.formulas import FORMULAS, arithmetic
from rovbrush.orchestrator.loop.operations import LINEAR, MEAN, NUMBER, QUADRATIC, RISE

C = {k: f"c{k}" for k in range(4)}


@pytest.mark.parametrize("code", sorted(FORMULAS))
def test_c_does_the_arithmetic_of_the_formula(code: int) -> None:
    """Sums and products of C are those of Python: both are executed, on numbers of many sizes."""
    lines = in_c(code, lambda column: f"z_{column}", C, "n")
    text = "\n".join(line.strip().removeprefix("const double ") for line in lines if line not in "{}")
    pick = random.Random(code)
    for _ in range(200):
        z = {name: pick.uniform(-1.0, 1.0) * 10.0 ** pick.randrange(-9, 9) for name in "abpq"}
        c = [pick.uniform(-2.0, 2.0) for _ in range(4)]
        n = float(pick.randrange(-(10**12), 10**12))
        theirs = {f"z_{name}": value for name, value in z.items()} | {f"c{k}": value for k, value in enumerate(c)}
        theirs["n"] = n
        exec(text, {}, theirs)
        own = {"z": dict(z), "c": c, "n": n, **{name: name for name in "abpq"}}
        exec(FORMULAS[code], {}, own)
        assert {name: theirs[f"z_{name}"].hex() for name in "abpq"} == {k: v.hex() for k, v in own["z"].items()}


def test_it_reads_as_one_would_write_it() -> None:
    def said(code: int) -> list[str]:
        return in_c(code, lambda column: column, {k: str(k) for k in range(4)}, "n")

    assert said(RISE) == ["b += 0 * (a - p);"]
    assert said(LINEAR) == ["b = 0 * (a + 2 * (a - p)) + 1;"]
    assert said(MEAN)[1] == "    const double tail = 2 * a + 3 * p;"
    assert said(QUADRATIC)[2] == "    const double curvature = a - 2.0 * p + q;"
    assert (arithmetic(LINEAR), arithmetic(MEAN), arithmetic(NUMBER)) == (5, 7, 2)
