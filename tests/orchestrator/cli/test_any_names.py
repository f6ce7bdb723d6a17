"""Names as people and tools give them: in pictures, in what is printed to be copied, and where a file is not found."""

from __future__ import annotations

import shlex
import warnings
from pathlib import Path

import pytest
from cells_fmu import cells, scalar
from helpers import rovbrush
from native_build import needs_gcc

pytestmark = needs_gcc
NAMES = [r"$\frac{$", "a$b$c", "日本", "x^2_{", "<b>&", "say 'hi'", "a\\b", "%s"]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Path:
    """The results of an FMU with such names, in a folder with such a name."""
    variables = [scalar("u", 0, "input", start="0.5"), *(scalar(name, 100 + k) for k, name in enumerate(NAMES))]
    fmu = cells(tmp_path / "their pump ü.fmu", variables)
    out = tmp_path / "Versuch ü 1"
    assert rovbrush(monkeypatch, "run", fmu, "--stop", "5 ms", "--out", out) == 0, capsys.readouterr().err
    return out


@pytest.mark.parametrize("ending", ["png", "svg"])
def test_pictures_show_names_as_they_are_written(
    ending: str, run: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert rovbrush(monkeypatch, "plot", run, *NAMES, "--out", tmp_path / f"p.{ending}") == 0
        assert rovbrush(monkeypatch, "compare", run, run, "--out", tmp_path / "compared") == 0
    assert (run / "overview.png").stat().st_size > 1000 and (tmp_path / f"p.{ending}").stat().st_size > 1000
    assert not capsys.readouterr().err


def test_what_is_printed_to_be_typed_has_quotes_and_a_path_stays_in_one_line(
    run: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    capsys.readouterr()
    assert rovbrush(monkeypatch, "systems", "--copy", "nominal", "--to", tmp_path / "mein Stand") == 0
    command = " ".join(capsys.readouterr().out.partition("  rovbrush")[2].split())
    assert shlex.split(command)[:2] == ["run", str(tmp_path / "mein Stand" / "nominal.toml")]
    fmu = tmp_path / "their pump ü.fmu"
    assert rovbrush(monkeypatch, "run", fmu, "--stop", "5 ms", "--out", run) == 0
    assert f'xarray.open_datatree("{run / "result.nc"}")' in capsys.readouterr().out


def test_a_run_without_signals_has_no_picture_and_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    fmu = cells(tmp_path / "silent.fmu", [scalar("k", 4, "parameter", start="1")])
    assert rovbrush(monkeypatch, "run", fmu, "--stop", "5 ms", "--out", tmp_path / "out") == 0
    assert rovbrush(monkeypatch, "plot", tmp_path / "out") == 2
    assert "nothing was recorded that could be drawn" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("info", "their_pumb.fmu"), "did you mean 'their_pump.fmu'?"),
        (("check", "their_pumb.fmu"), "did you mean 'their_pump.fmu'?"),
        (("info", "their_pump"), "did you mean 'their_pump.fmu'?"),
        (("run", "their_pump"), "did you mean 'their_pump.fmu'?"),
        (("run", "plant"), "did you mean 'plant.toml'?"),
        (("run", "plnat.toml"), "there is no such file; did you mean 'plant.toml'?"),
        (("run", "nominal", "--real-time", "fast"), "--real-time fast: write how many times faster than the clock"),
    ],
)
def test_a_name_that_is_not_quite_one_is_told_with_what_is_meant(
    arguments: tuple[str, ...], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    cells(tmp_path / "their_pump.fmu", [scalar("y", 100)])
    (tmp_path / "plant.toml").touch()
    assert rovbrush(monkeypatch, *arguments) > 0
    told = capsys.readouterr()
    assert said in " ".join((told.out + told.err).split())


@pytest.mark.parametrize("command", ["info", "check", "run"])
def test_a_component_is_found_by_its_name_in_what_is_said(
    command: str, fmus: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("ROVBRUSH_FMUS", str(fmus))
    assert rovbrush(monkeypatch, command, "dc_motor") > 0
    told = capsys.readouterr()
    assert "dc_motor.fmu" in told.out + told.err and "rovbrush build" not in told.out + told.err
