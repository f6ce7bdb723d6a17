"""`rovbrush bench foreign`: its FMUs behave as exported models do, and its rows are told in times of the bare calls."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

import pytest
from native_build import needs_gcc
from rovbrush.orchestrator import load
from rovbrush.orchestrator.cli.bench_tables.masters import print_foreign, print_systems
from rovbrush.orchestrator.errors import RunError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.studies.bench.fmus.systems import Case
from rovbrush.orchestrator.studies.bench.peers import masters
from rovbrush.orchestrator.studies.bench.runs import foreign


@needs_gcc
def test_a_motor_has_the_variables_of_an_exported_model(tmp_path: Path) -> None:
    fmu = Fmu.open(foreign.motor(tmp_path / "exported.fmu"))
    assert len(fmu.variables) == 2 + len(foreign.OUTPUTS) + 2 + foreign.INNER


@needs_gcc
@pytest.mark.parametrize("logs", [False, True])
def test_motors_in_a_row_turn_and_their_messages_change_nothing(logs: bool, tmp_path: Path) -> None:
    foreign.motors(tmp_path, logs, "100 ms")
    (path,) = tmp_path.glob("*.toml")
    result = load(str(path)).run()
    speed, current = (result[f"m0.{name}"].values for name in ("speed", "current"))
    assert 0.0 < speed[5] < speed[-1] < 12.0 / (0.016 * 27.2484) * 30.0 / 3.141592653589793
    # What is left for the next follows the voltage at once.
    assert result["m0.v_left"].values[-1] == 12.0 - 0.1 * current[-1]


@needs_gcc
def test_oscillators_for_model_exchange_stand_in_a_row(tmp_path: Path) -> None:
    system = foreign.oscillators(tmp_path, 3, "10 ms")
    assert [c.target for c in system.connections] == [("o1", "u"), ("o2", "u")] and system.stop == Fraction(1, 100)


def test_ratios_are_to_the_bare_calls_of_the_same_system() -> None:
    rows = [{"master": "rovbrush", "us_per_macro_step": 3.0}, {"master": "calls alone", "us_per_macro_step": 2.0}]
    assert [row["ratio"] for row in foreign.with_ratios(rows)] == [1.5, 1.0]


@needs_gcc
def test_a_master_that_fails_is_told_and_costs_no_other_row(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def run_host(*_: object) -> None:
        raise RunError("libcosimpy failed on exported (exit code -9)")

    monkeypatch.setattr(masters, "run_host", run_host)
    case = Case("motors", foreign.motors(tmp_path, stop="20 ms"), 5)
    rows = foreign.with_ratios(masters.measured(case, ["libcosimpy"], quick=True))
    told = {(r["master"], r["recording"]): r["us_per_macro_step"] for r in rows}
    assert told["libcosimpy", False] is None and told["libcosimpy", True] is None
    assert all(cost > 0.0 for (master, _), cost in told.items() if master != "libcosimpy") and len(told) == 7
    for printed in (print_foreign, print_systems):
        printed(rows)
        said = capsys.readouterr().out
        assert said.count("failed") == (5 if printed is print_foreign else 3) and said.count("exit code -9") == 1
    json.dumps(rows, allow_nan=False)
