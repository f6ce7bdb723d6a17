"""Wrong usage of a sweep ends before anything is run; a full disk loses no point."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from helpers import rovbrush, system_text
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.studies.sweep.file import sweep_file
from rovbrush.orchestrator.studies.sweep.options import Options
from rovbrush.orchestrator.studies.sweep.points import Points
from rovbrush.orchestrator.studies.sweep.sweep import sweep
from sweep_cases import PARTS, lines, plain_case


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--vary", "brush.mu_z=0.4,0.5"), "brush.mu_z is unknown; did you mean 'mu_s'?"),
        (("--vary", "motor.V_in=8,10"), "driven by the connection controller.V_in -> motor.V_in"),
        (("--vary", "brush.mu_s=0.72:0.48:7"), "an empty range"),
        (("--vary", "brush.mu_s=0.48:0.72:0"), "an empty range"),
        (("--vary", "brush.mu_s=0.48:0.48:3"), "an empty range"),
        (("--vary", "brush.mu_s="), "an empty value"),
        (("--vary", "brush.mu_s=0.4,,0.5"), "an empty value"),
        (("--vary", "brush.mu_s"), "write component.variable=low:high:count"),
        (("--vary", "brush.mu_s=0.48:0.72"), "write low:high:count"),
        (("--vary", "brush.mu_s=a:b:3"), "not a range of numbers"),
        (("--vary", "brush.mu_s=0:1:3:log"), "equal ratios need a range above 0"),
        (("--vary", "brush.mu_s=0.1:0.2:9999999"), "more than 1000000 values"),
        (("--vary", "brush.mu_s=0.4,9"), "brush.mu_s = 9 is out of range"),
        (("--vary", "brush.mu_s=0.4,0.4"), "a value is there twice"),
        (("--vary", "brush.mu_s=1,2", "--vary", "brush.mu_s=3,4"), "varied twice"),
        (("--vary", "brush.zeta=0.1,0.2", "--vary", "brush.zeta[2]=0.1,0.3"), "varied by brush.zeta already"),
        (("--vary", "brush.mu_s=1,2", "--set", "brush.mu_s=1"), "it is varied"),
        (("--vary", "brush.mu_s=0.1:0.2:5", "--random", "3"), "write low:high"),
        ((), "nothing to vary"),
        (("--points", "no/such.csv"), "cannot be read"),
        (("--vary", "brush.mu_s=1,2", "--scheduler", "nonsense"), "--scheduler nonsense does not answer"),
        (("--vary", "brush.mu_s=1,2", "--scheduler", "tcp://127.0.0.1:1"), "Connection refused"),
        (("--vary", "brush.mu_s=1,2", "--stop", "soon"), "--stop"),
    ],
)
def test_wrong_usage_ends_with_2_before_anything_is_run(
    arguments: tuple[str, ...], message: str, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    out = tmp_path / "out"
    assert rovbrush(monkeypatch, "sweep", "nominal", *arguments, "--fmus", fmus, "--out", out) == 2
    err = capsys.readouterr().err
    assert message in err and err.startswith("error: ") and "Traceback" not in err and not out.exists()


def test_an_unknown_name_suggests_sweeps_and_systems() -> None:
    with pytest.raises(InputError, match="no sweep or system 'frictoin'; did you mean 'friction'"):
        sweep_file("frictoin")


def test_a_full_disk_ends_the_sweep_and_loses_no_point(
    case: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, options = tmp_path / "out", Options(["w.c0=1:5:5"], workers=1, fmus=fmus)
    write, room = Points._write, [3]

    def limited(self: Points, content: Any) -> None:
        room[0] -= 1
        if room[0] < 0:
            raise OSError(28, "No space left on device")
        write(self, content)

    monkeypatch.setattr(Points, "_write", limited)
    with pytest.raises(RunError, match=r"No space left on device(.|\n)*2 of 5 points are kept"):
        sweep(str(case), out, options).require_all()
    monkeypatch.undo()
    assert lines(out) == 3
    assert sweep(str(case), out, options).require_all().attrs["complete"] == 1


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full")
def test_a_disk_that_is_full_from_the_start_ends_with_2(
    case: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    out.mkdir()
    (out / "points.jsonl").symlink_to("/dev/full")
    assert rovbrush(monkeypatch, "sweep", case, "--vary", "w.c0=1,2", "--fmus", fmus, "--out", out) == 2
    assert "No space left on device" in capsys.readouterr().err


def test_a_folder_that_cannot_be_written_ends_with_2(
    case: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert rovbrush(monkeypatch, "sweep", case, "--vary", "w.c0=1,2", "--fmus", fmus, "--out", case / "below") == 2
    assert "cannot write to the output folder" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("vary", "keys"),
    [
        (["w.c0=1:2"], {"random": 10_000_000_000}),
        (["w.c0=1:2:1000", "w.a=1:2:1000", "w.b=1:2:1000"], {}),
    ],
)
def test_a_design_too_large_for_memory_is_refused_before_it_is_made(
    vary: list[str], keys: dict[str, int], case: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "rovbrush.orchestrator.studies.sweep.design.design.drawn", lambda *_: pytest.fail("points were drawn")
    )
    with pytest.raises(InputError, match="a sweep may have 1000000 points at most"):
        sweep(str(case), tmp_path / "out", Options(vary, fmus=fmus, **keys))  # type: ignore[arg-type]
    assert not (tmp_path / "out").exists()


def test_a_system_without_figures_of_merit_is_refused_before_the_plan_with_the_lines_to_write(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "bare.toml"
    path.write_text(system_text(PARTS, ["w.y -> x.u"], stop="10 ms"))
    options = Options(["w.c0=1:2:2"], workers=1, fmus=fmus)
    with monkeypatch.context() as patch:
        patch.setattr("rovbrush.orchestrator.studies.sweep.workers.point.make_plan", lambda *_: pytest.fail("planned"))
        with pytest.raises(InputError, match=r"no \[summary\], so that there is nothing to gather") as error:
            sweep(str(path), tmp_path / "out", options)
    lines = str(error.value).splitlines()[-2:]
    path.write_text(path.read_text() + "\n" + "\n".join(lines) + "\n")
    assert len(sweep(str(path), tmp_path / "out", options).require_all().data_vars) == 2  # as it says, and `error`


def test_one_point_is_told_in_the_singular(fmus: Path, tmp_path: Path) -> None:
    said: list[str] = []
    failed = sweep(
        str(plain_case(tmp_path)), tmp_path / "out", Options(["p.mode=6"], workers=1, fmus=fmus), said.append
    )
    with pytest.raises(RunError, match="1 of 1 point failed"):
        failed.require_all()
    assert failed.cost and failed.cost.text.startswith("1 point in ")
