"""`rovbrush bench`: parts, how long they take, and the systems on which growth is measured."""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

import pytest
from native_build import needs_gcc
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.studies.bench import folders
from rovbrush.orchestrator.studies.bench.against import loop_seconds
from rovbrush.orchestrator.studies.bench.bench import PARTS, Asked, bench
from rovbrush.orchestrator.studies.bench.runs import growth, solvers
from rovbrush.orchestrator.system.file.reader import load_system


def test_all_parts_are_measured_but_the_comparison_that_needs_an_interpreter() -> None:
    assert set(Asked().chosen()) == set(PARTS) - {"against", "fmus"}
    assert Asked(("growth", "start")).chosen() == ("start", "growth")
    assert Asked(("growth",), python=Path(sys.executable)).chosen() == ("growth", "against")
    with pytest.raises(InputError, match="no such part; did you mean 'growth'"):
        Asked(("grwth",)).chosen()
    with pytest.raises(InputError, match="against which"):
        Asked(("against",)).chosen()
    assert Asked(("growth",), folder=Path("fmus")).chosen() == ("growth", "fmus")
    with pytest.raises(InputError, match="give the folder of the other FMUs"):
        Asked(("fmus",)).chosen()
    assert all(part.quick < part.full for part in PARTS.values())


@needs_gcc
def test_growth_is_measured_on_systems_of_the_stated_size(tmp_path: Path) -> None:
    sizes = {}
    for what in growth.SIZES:
        path = tmp_path / "system.toml"
        path.write_text(growth.text(tmp_path, what, 12))
        system = load_system(str(path))
        inputs = sum(len(c.inputs) for c in system.components.values())
        sizes[what] = (len(system.connections), len(system.components), inputs)
    assert sizes == {"connections": (12, 2, 0), "FMUs": (12, 12, 0), "stated inputs": (0, 1, 12)}


@needs_gcc
def test_bench_says_how_long_it_will_take_and_what_share_is_done(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(growth, "SIZES", {"connections": (4, 8), "FMUs": (2, 4)})
    said: list[str] = []
    shares: list[float] = []
    found = bench(Asked(("growth",)), tmp_path / "rows.json", said.append, shares.append)
    assert said == ["1 part, about 40 s on two cores: growth"]
    assert shares == sorted(shares) and shares[-1] == 1.0 and len(shares) > 3
    rows = found.parts["growth"]
    assert [(r["grows"], r["size"]) for r in rows] == [("connections", 4), ("connections", 8), ("FMUs", 2), ("FMUs", 4)]
    assert all(r["reader_s"] > 0 and r["plan_s"] > 0 and r["peak_memory_MB"] > 1 for r in rows)
    assert json.loads((tmp_path / "rows.json").read_text()) == [{"part": "growth", **row} for row in rows]
    quick = bench(Asked(("growth",), quick=True)).parts["growth"]
    assert [(r["grows"], r["size"]) for r in quick] == [("connections", 8), ("FMUs", 4)]


def test_another_installation_that_cannot_answer_is_an_error_that_names_it(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"--against .*nowhere cannot be started"):
        loop_seconds(tmp_path / "nowhere", "nominal", "fmus")
    with pytest.raises(RunError, match="no system 'nothing'"):
        loop_seconds(Path(sys.executable), "nothing", str(tmp_path))


@needs_gcc
def test_the_solver_of_a_group_takes_the_steps_of_the_same_solver_driven_from_c(tmp_path: Path) -> None:
    """What they cost is the machine's; that both do the same work, and begin anew at jumps, is ours."""
    library = solvers._library(tmp_path)
    fmu = solvers._opened(tmp_path, "oscillator", solvers.oscillator())
    ours, in_c = solvers.Case(fmu, "cvode", 1e-6), solvers.Case(fmu, "cvode", 1e-6, library)
    ours.group.replace_cvode(exact=False)  # as the driver in C has it
    begun = ours.calls()
    for case in (ours, in_c):
        case.go(0, 500)
    assert ours.first_state == pytest.approx(in_c.first_state, rel=1e-9)
    assert ours.calls() - begun == pytest.approx(in_c.calls(), rel=0.02)
    for case in (ours, in_c):
        case.close()
    errors = solvers.jumps(fmu, library, 500)
    assert errors["cvode [error]"] == pytest.approx(errors["cvode in C, restarted [error]"], rel=0.05)


def test_fmus_are_compared_with_those_of_another_folder(fmus: Path, tmp_path: Path) -> None:
    other = tmp_path / "other"
    other.mkdir()
    shutil.copy(fmus / "constant_speed.fmu", other)
    rows = bench(Asked(("fmus",), quick=True, fmus=fmus, folder=other)).parts["fmus"]
    assert [row["fmu"] for row in rows] == ["constant_speed.fmu"]
    assert rows[0]["rounds"] == folders.QUICK and rows[0]["kB_ratio"] == 1.0
    for key in ("us_per_call", "first_s"):
        assert rows[0][f"{key}_here"] > 0.0
        assert rows[0][f"{key}_ratio"] == rows[0][f"{key}_here"] / rows[0][f"{key}_there"]
    with pytest.raises(InputError, match="no FMU of a shipped system is in both"):
        bench(Asked(("fmus",), quick=True, fmus=fmus, folder=tmp_path))
