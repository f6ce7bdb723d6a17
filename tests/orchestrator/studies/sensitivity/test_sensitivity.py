"""Indices of functions whose indices are known in closed form; what cannot be estimated is said."""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from helpers import rovbrush
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.studies.sensitivity.indices import estimated
from rovbrush.orchestrator.studies.sensitivity.picture import draw
from rovbrush.orchestrator.studies.sensitivity.sensitivity import Sensitivity, sensitivity
from rovbrush.orchestrator.studies.sweep.design.blocks import block_shares
from rovbrush.orchestrator.studies.sweep.options import Options

RANGES = [f"f.x{k}={-math.pi!r}:{math.pi!r}" for k in (1, 2, 3)]
ISHIGAMI = {"S1": (0.3139, 0.4424, 0.0), "ST": (0.5576, 0.4424, 0.2437)}  # Ishigami and Homma 1990, a = 7, b = 0.1
PARTS = [1 / 3 / (1 + c) ** 2 for c in (0.0, 1.0, 4.5)]  # Sobol 1993: variances of the factors of g, whose means are 1
TOTAL = math.prod(1 + v for v in PARTS) - 1
SOBOL_G = {"S1": [v / TOTAL for v in PARTS], "ST": [v * (1 + TOTAL) / (1 + v) / TOTAL for v in PARTS]}


@pytest.fixture(scope="module")
def found(known: Path, tmp_path_factory: pytest.TempPathFactory) -> Sensitivity:
    return sensitivity(str(known), tmp_path_factory.mktemp("sobol"), Options(RANGES), samples=128)


@pytest.mark.evidence
@pytest.mark.parametrize(("figure", "published"), [("ishigami", ISHIGAMI), ("g", SOBOL_G)])
def test_published_indices_lie_in_the_intervals(
    found: Sensitivity, figure: str, published: dict[str, Sequence[float]]
) -> None:
    (indices,) = (i for i in found.indices if i.figure == figure)
    for name, values in published.items():
        for estimate, value in zip(indices.of[name], values, strict=True):
            print(f"{figure} {name}: {value:.4f} in {estimate.low:.4f} to {estimate.high:.4f}")
            assert estimate.low <= value <= estimate.high
    assert indices.order() == [0, 1, 2] and indices.blocks == 128


def test_a_figure_that_never_changes_has_no_indices_and_says_its_value(found: Sensitivity) -> None:
    (flat,) = (i for i in found.indices if i.figure == "flat")
    assert flat.without == "it never changes: 3 at every point" and not flat.of


def test_the_picture_has_a_tornado_with_whiskers_for_each_figure_that_changes(found: Sensitivity) -> None:
    picture = draw(found)
    assert picture is not None
    drawn = {axis.get_xlabel().partition(":")[0]: axis for axis in picture.axes}
    assert set(drawn) == {"ishigami", "g", "rosenbrock", "disc", "length"}
    (g,) = (i for i in found.indices if i.figure == "g")
    assert [label.get_text() for label in drawn["g"].get_yticklabels()] == [found.parameters[k] for k in g.order()]
    total, first = drawn["g"].containers
    assert [bar.get_width() for bar in total] == [g.of["ST"][k].value for k in g.order()]
    whiskers = [segment[:, 0].tolist() for segment in drawn["g"].collections[1].get_segments()]
    assert whiskers == [[g.of["S1"][k].low, g.of["S1"][k].high] for k in g.order()] and len(first) == 3


def test_files_hold_every_number(found: Sensitivity) -> None:
    folder = found.swept.folder
    content = json.loads((folder / "sensitivity.json").read_text())
    entry = content["figures"]["g"]["parameters"]["f.x1"]["ST"]
    (g,) = (i for i in found.indices if i.figure == "g")
    assert (folder / "sensitivity.png").read_bytes().startswith(b"\x89PNG")
    assert entry == {"value": g.of["ST"][0].value, "interval": [g.of["ST"][0].low, g.of["ST"][0].high]}
    assert content["complete"] and content["runs"] == 128 * 5 and content["seed"] == 1
    with (folder / "sensitivity.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert {row["figure"] for row in rows} == {"ishigami", "g", "rosenbrock", "disc", "length"}
    assert float(next(r for r in rows if r["figure"] == "g" and r["index"] == "ST")["value"]) == entry["value"]


def test_points_of_another_method_in_the_folder_are_refused_and_the_same_are_not_computed_again(
    found: Sensitivity, known: Path
) -> None:
    again = sensitivity(str(known), found.swept.folder, Options(RANGES), samples=128)
    assert again.swept.cost is None and again.indices == found.indices
    with pytest.raises(InputError, match="different sweep \\(design: saltelli, now morris"):
        sensitivity(str(known), found.swept.folder, Options(RANGES), "morris", 128)


def test_morris_sees_slopes_whatever_their_sign_and_names_what_does_nothing(known: Path, tmp_path: Path) -> None:
    """Of x1^2 + x2^2 over 0 to 1, paths of steps of 2/3 change each by (1 - 1/9)/(2/3) or (4/9)/(2/3) on average 1."""
    options = Options(["f.x1=0:1", "f.x2=0:-1", "f.x4=0:1"])
    with pytest.raises(InputError, match="an empty range"):
        sensitivity(str(known), tmp_path / "wrong", options, "morris")
    options = Options(["f.x1=0:1", "f.x2=-1:0", "f.x4=0:1"])
    made = sensitivity(str(known), tmp_path, options, "morris", 10, figures=["disc"])
    (disc,) = made.indices
    effects = {name: [e.value for e in estimates] for name, estimates in disc.of.items()}
    assert all(2 / 3 <= value <= 4 / 3 for value in effects["mu_star"][:2])
    assert effects["mu"][0] == pytest.approx(effects["mu_star"][0]) and effects["mu"][1] < 0
    assert effects["mu_star"][2] == 0.0 and made.idle == ("f.x4",)


def test_a_failed_run_costs_its_block_and_the_study_ends_with_an_error(known: Path, tmp_path: Path) -> None:
    options = Options(["f.x1=0:1", "f.x2=0:1", "f.x4=0:1"], {"f.fail_above": 0.95})
    made = sensitivity(str(known), tmp_path, options, samples=32, figures=["disc"])
    (disc,) = made.indices
    assert 0 < disc.lost <= 8 and disc.blocks + disc.lost == 32 and disc.of
    with pytest.raises(RunError, match="points failed"):
        made.swept.require_all()


def test_too_many_incomplete_blocks_are_no_basis() -> None:
    shares = block_shares("saltelli", 2, 8, 1)
    values = shares.sum(axis=1)
    values[::4][:3] = math.nan
    assert estimated("saltelli", "y", "1", values, shares, 1).without.startswith("3 of 8 blocks")


def test_an_interval_wider_than_its_index_asks_for_more_samples_unless_it_cannot_matter() -> None:
    def undecided(count: int, small: float) -> list[int]:
        shares = block_shares("saltelli", 2, count, 0)
        values = np.exp(8.0 * shares[:, 0]) * (1.0 + small * shares[:, 1])
        return estimated("saltelli", "y", "1", values, shares, 0).undecided()

    assert undecided(8, 1.0) and not undecided(1024, 1.0) and not undecided(1024, 1e-3)


@pytest.mark.parametrize("seed", [0, 3])
def test_intervals_follow_from_the_seed(seed: int) -> None:
    shares = block_shares("saltelli2", 3, 16, seed)
    one, other = (estimated("saltelli2", "y", "1", shares @ [1.0, 2.0, 3.0], shares, seed) for _ in range(2))
    assert one == other and len(one.second) == 3


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "nothing to vary"),
        (("--vary", "f.x9=0:1"), "f.x9 is unknown"),
        (("--vary", "f.x1=1:1"), "an empty range"),
        (("--vary", "f.x1=1"), "a single value does not vary"),
        (("--vary", "f.x1=1,1"), "a value is there twice"),
        (("--vary", "f.x1=0:1:log"), "equal ratios need a range above 0"),
        (("--vary", "f.x1=0:1", "--figure", "isigami"), "did you mean 'ishigami'?"),
        (("--vary", "f.x1=0:1", "--figure", "mean f.nothing"), "f.nothing"),
        (("--vary", "f.x1=0:1", "--method", "fast"), "write one of sobol, morris"),
        (("--vary", "f.x1=0:1", "--method", "morris", "--second-order"), "--second-order is of Sobol's indices"),
        (("--vary", "f.x1=0:1", "--samples", "3"), "an interval needs 4"),
        (("--vary", "f.x1=0:1", "--samples", "999999"), "1000000 points at most"),
        (("--vary", "f.x1=1,2,3,4,5", "--method", "morris"), "5 entries it would never take some"),
        (("--vary", "f.x1=0:1", "--set", "f.x1=2"), "it is varied"),
    ],
)
def test_wrong_usage_ends_with_2_before_anything_is_run(
    arguments: tuple[str, ...], message: str, known: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    out = tmp_path / "out"
    assert rovbrush(monkeypatch, "sensitivity", known, *arguments, "--out", out) == 2
    err = capsys.readouterr().err
    assert message in err and "Traceback" not in err and not out.exists()


def test_a_number_of_samples_that_is_no_power_of_2_is_raised_and_said_with_the_number_of_runs(
    known: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ("--vary", "f.x1=1,2", "--vary", "f.x2=1 mm:1 m:log", "--samples", 5, "--figure", "rms f.disc")
    assert rovbrush(monkeypatch, "sensitivity", known, *arguments, "--out", tmp_path / "out", "--workers", 1) == 0
    printed = capsys.readouterr().out
    assert "--samples 5 is no power of 2" in printed and "32 runs: 8 blocks of 4 for 2 parameters" in printed
    assert "rms f.disc" in printed and max(len(line) for line in printed.splitlines() if "│" in line) <= 100
