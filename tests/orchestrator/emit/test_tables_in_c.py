"""Inputs that follow tables of times, as C: between their rows and row by row, numbers of every kind."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from emit_cases import differing, run_of_system, tables_of
from helpers import read_system
from native_build import needs_gcc
from rovbrush.orchestrator.system.inputs.series_file import with_inputs

pytestmark = needs_gcc
TIMES = [0.0, 0.003, 0.0045, 0.0045, 0.02]
TABLES = {
    "reals": {"a.u": [1.0, 4.0, -2.0, 5.0, 5.0]},
    "wholes": {"a.n_in": [1, -4, 2, 5, 7], "a.mode_in": [1, 2, 1, 2, 1]},
    "truths": {"a.on_in": [True, False, True, False, True]},
}


@pytest.mark.parametrize("kind", TABLES)
@pytest.mark.parametrize("period", ["1 ms", "4 ms"])
def test_inputs_that_follow_tables_are_those_of_the_run(kind: str, period: str, carried: Path, tmp_path: Path) -> None:
    system = read_system(tmp_path, carried, {"a": ("feedthrough2", period), "b": ("mass", "1 ms")}, stop="10 ms")
    tables: dict[str, Any] = {name: (TIMES, values) for name, values in TABLES[kind].items()}
    system = with_inputs(system, tables)
    shown = tuple(f"a.{name}" for name in ("y", "n_out", "mode_out", "on_out"))
    system = replace(system, record=shown)
    assert differing(tables_of(system, tmp_path / "c", "-O0 -w"), run_of_system(system)) == []
