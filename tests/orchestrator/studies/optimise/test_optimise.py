"""Optima that are known, under constraints; the same points for any number of workers; what cannot be is said."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from helpers import rovbrush
from rovbrush.orchestrator import InputError, RunError, load
from rovbrush.orchestrator.studies.optimise.optimise import Optimum, optimise, require_feasible
from rovbrush.orchestrator.studies.sweep.options import Options

BOX = ["f.x1=-1.5:1.5", "f.x2=-1.5:1.5"]
IN_DISC = {"minimise": "rosenbrock", "subject_to": ["disc <= 1"], "generations": 12, "population": 10,
           "polishing": 40}  # fmt: skip


@pytest.fixture(scope="module")
def found(known: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Optimum, Path]:
    folder = tmp_path_factory.mktemp("optimum")
    return optimise(str(known), folder, Options(BOX, workers=1), **IN_DISC), folder  # type: ignore[arg-type]


def test_the_constrained_optimum_is_found(found: tuple[Optimum, Path]) -> None:
    """Of (1 - x)^2 + 100 (y - x^2)^2 in the unit disc: on its edge, where the gradients are parallel."""
    optimum, _ = found
    x, y = (float(v) for v in optimum.best.values)  # type: ignore[arg-type]
    assert x**2 + y**2 == pytest.approx(1.0, abs=1e-3)
    gradient = (-2 * (1 - x) - 400 * x * (y - x**2), 200 * (y - x**2))
    across = (gradient[0] * y - gradient[1] * x) / (abs(gradient[0]) + abs(gradient[1]))
    assert abs(across) < 0.2 and optimum.best.figures["rosenbrock"] == pytest.approx(0.0457, abs=2e-3)
    assert require_feasible(optimum) is None  # type: ignore[func-returns-value]


def test_what_it_leaves_is_the_optimum(found: tuple[Optimum, Path], known: Path) -> None:
    optimum, folder = found
    content = json.loads((folder / "optimise.json").read_text(encoding="utf-8"))
    assert content["feasible"] and content["runs"] == len(optimum.trials)
    assert {name: entry["value"] for name, entry in content["parameters"].items()} == optimum.values
    model = load(known, parameters=folder / "optimum.toml")
    parameters = model.system.components["f"].parameters
    assert {f"f.{name}": parameters[name] for name in ("x1", "x2")} == optimum.values
    assert model.run().summary["rosenbrock"] == optimum.best.figures["rosenbrock"]
    assert (folder / "optimise.png").read_bytes().startswith(b"\x89PNG")


def test_the_system_runs_with_what_was_found_over_its_own_values_and_set(
    known: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """x1 is stated in the system's file, x3 in the set that it names; both go into the figures of the optimum."""
    known.with_name("mine.toml").write_text("[f]\nx3 = 0.7\n", encoding="utf-8")
    text = known.read_text(encoding="utf-8").replace('period = "1 ms"', 'period = "1 ms"\nparameters = { x1 = 0.9 }')
    path = known.with_name("based.toml")
    path.write_text(f'parameters = "mine"\n{text}', encoding="utf-8")
    some = {"generations": 1, "population": 5, "polishing": 0}
    made = optimise(str(path), tmp_path / "out", Options(["f.x1=0.2:0.5"], workers=1), "disc", **some)  # type: ignore[arg-type]
    words = ("run", path, "--parameters", tmp_path / "out/optimum.toml", "--out", tmp_path / "run")
    assert rovbrush(monkeypatch, *words) == 0
    summary = json.loads((tmp_path / "run/summary.json").read_text(encoding="utf-8"))
    assert {name: summary[name] for name in made.best.figures} == dict(made.best.figures)
    assert load(path).run().summary["ishigami"] != summary["ishigami"]
    assert load(path, parameters=tmp_path / "out/optimum.toml").system.components["f"].parameters["x3"] == 0.7


def test_the_points_are_the_same_for_any_number_of_workers_and_are_not_computed_again(
    found: tuple[Optimum, Path], known: Path, tmp_path: Path
) -> None:
    optimum, folder = found
    other = optimise(str(known), tmp_path, Options(BOX, workers=2), **IN_DISC)  # type: ignore[arg-type]
    assert [(t.values, t.figures) for t in other.trials] == [(t.values, t.figures) for t in optimum.trials]
    before = (folder / "points.jsonl").read_bytes()
    again = optimise(str(known), folder, Options(BOX, workers=1), **IN_DISC)  # type: ignore[arg-type]
    assert again.best == optimum.best and (folder / "points.jsonl").read_bytes() == before


def test_the_greatest_is_the_least_of_its_negative(known: Path, tmp_path: Path) -> None:
    options = Options(["f.x1=0.5:1", "f.x2=0:0.25"])
    optimum = optimise(str(known), tmp_path, options, maximise="disc", generations=8, population=8, polishing=20)
    assert optimum.best.figures["disc"] == pytest.approx(1.0 + 0.25**2, rel=1e-3)
    assert optimum.at_end() == {"f.x1": "upper", "f.x2": "upper"}


def test_constraints_that_nothing_satisfies_are_told_with_the_nearest_point(known: Path, tmp_path: Path) -> None:
    options = Options(["f.x1=1:2", "f.x2=1:2"])
    optimum = optimise(str(known), tmp_path, options, minimise="rosenbrock", subject_to=["disc <= 1"], generations=3,
                       population=8)  # fmt: skip
    with pytest.raises(RunError, match=r"satisfies all constraints; the nearest one .*disc <= 1 is broken by"):
        require_feasible(optimum)
    assert (tmp_path / "optimise.json").exists() and not (tmp_path / "optimum.toml").exists()


@pytest.mark.parametrize(
    ("options", "asked", "message"),
    [
        ({}, {}, "give one of --minimise and --maximise"),
        ({}, {"minimise": "disc", "maximise": "g"}, "give one of --minimise and --maximise"),
        ({}, {"minimise": "cost"}, "cost"),
        ({}, {"minimise": "disc", "subject_to": ["g"]}, 'write "figure <= value"'),
        ({}, {"minimise": "disc", "subject_to": ["g <= much"]}, "is no number"),
        ({}, {"minimise": "disc", "subject_to": ["h <= 1"]}, "h"),
        ({"vary": []}, {"minimise": "disc"}, "nothing to vary"),
        ({"vary": ["f.x9=0:1"]}, {"minimise": "disc"}, "x9"),
        ({"vary": ["f.x1=1:0"]}, {"minimise": "disc"}, "an empty range"),
        ({"random": 5}, {"minimise": "disc"}, "chooses its points"),
        ({}, {"minimise": "disc", "population": 3}, "5 points at least"),
    ],
)  # fmt: skip
def test_bad_requests_are_one_clear_error(
    options: dict[str, Any], asked: dict[str, Any], message: str, known: Path, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=message):
        optimise(str(known), tmp_path / "out", Options(**{"vary": BOX, **options}), **asked)
    assert not (tmp_path / "out").exists()


def test_points_of_another_search_are_refused(found: tuple[Optimum, Path], known: Path) -> None:
    with pytest.raises(InputError, match="different"):
        optimise(str(known), found[1], Options(BOX), minimise="disc", population=10)
