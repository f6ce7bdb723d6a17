"""Sweeps: every point is the run that it says, whoever computes it and however often the sweep is cut short."""

from __future__ import annotations

import csv
import json
import os
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray
from helpers import Part, system_text
from rovbrush.orchestrator.cli import main
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.reader import load_system
from rovbrush.orchestrator.simulation import simulate
from rovbrush.orchestrator.studies.design import Design, make_design, vary_entries
from rovbrush.orchestrator.studies.point import Job, load, needed
from rovbrush.orchestrator.studies.points import Points
from rovbrush.orchestrator.studies.single import planned
from rovbrush.orchestrator.studies.sweep import Options, sweep
from rovbrush.orchestrator.studies.sweep_file import shipped_sweeps, sweep_file
from rovbrush.orchestrator.summary import figure_units, summarize
from rovbrush.orchestrator.system import System

SUMMARY = '\n[summary]\nwindow = { start = 0.005 }\nx_last = "last x.x"\ny_mean = "mean x.held"\n'
PARTS: dict[str, Part] = {"w": ("wave", "1 ms", {"c0": 1.0}), "x": ("integrator", "1 ms")}


@pytest.fixture
def case(tmp_path: Path) -> Path:
    """A wave, integrated: x(0.01 s) is about c0/100."""
    path = tmp_path / "case.toml"
    path.write_text(system_text(PARTS, ["w.y -> x.u"], stop="10 ms") + SUMMARY)
    return path


def plain_case(folder: Path, stop: str = "10 ms", mode: int = 0) -> Path:
    """A stranger's FMU whose `mode` decides what goes wrong."""
    path = folder / "plain.toml"
    start = {"mode": mode, "=u": 0.0, "=temperature": 0.0, "=speed": 0.0}
    path.write_text(system_text({"p": ("plain", "1 ms", start)}, stop=stop) + '\n[summary]\ny_last = "last p.y"\n')
    return path


def rovbrush(monkeypatch: pytest.MonkeyPatch, *arguments: object) -> int:
    """The command in this process; returns its exit code."""
    monkeypatch.setattr(sys, "argv", ["rovbrush", *map(str, arguments)])
    with pytest.raises(SystemExit) as ending:
        main()
    return int(ending.value.code or 0)


def design_of(path: Path, fmus: Path, *vary: str, **keys: Any) -> Design:
    return make_design(load_system(str(path), fmus), vary_entries(vary), **keys)


# --- designs ---


def test_a_grid_is_the_product_of_its_axes_with_the_last_one_fastest(case: Path, fmus: Path) -> None:
    design = design_of(case, fmus, "w.c0=0.48:0.72:7", "w.a=8,10,12")
    assert design.shape == (7, 3) and len(design) == 21
    assert design.axes[0].values == (0.48, 0.52, 0.56, 0.6, 0.64, 0.68, 0.72), "as a person would write them"
    assert [design.point(k)["w.a"] for k in range(4)] == [8.0, 10.0, 12.0, 8.0]
    assert design.point(20) == {"w.c0": 0.72, "w.a": 12.0}
    assert design.axes[0].unit == "m/s"
    assert design_of(case, fmus, "w.w=1:100:3:log").axes[0].values == (1.0, 10.0, 100.0)


def test_a_random_design_follows_from_its_seed_and_each_axis_from_its_name(case: Path, fmus: Path) -> None:
    one = design_of(case, fmus, "w.c0=2:3", count=50, seed=1)
    both = design_of(case, fmus, "w.a=0,5", "w.c0=2:3", count=50, seed=1)
    other = design_of(case, fmus, "w.c0=2:3", count=50, seed=2)
    assert one.axes[0].values == both.axes[1].values != other.axes[0].values
    assert all(2.0 <= float(value) <= 3.0 for value in one.axes[0].values)
    assert set(both.axes[0].values) == {0.0, 5.0}
    assert len(both) == 50 and both.shape == (50,)


def test_random_values_of_an_integer_are_whole_and_reach_both_ends(tmp_path: Path, fmus: Path) -> None:
    path = tmp_path / "gain.toml"
    path.write_text(system_text({"g": ("gain", "1 ms", {"=u": 1.0})}))
    values = design_of(path, fmus, "g.count=1:3", count=60).axes[0].values
    assert set(values) == {1, 2, 3} and all(isinstance(value, int) for value in values)


def test_a_table_lists_every_point(case: Path, fmus: Path, tmp_path: Path) -> None:
    table = tmp_path / "points.csv"
    table.write_text("w.c0, w.a\n1, 2\n3, 4\n")
    design = make_design(load_system(str(case), fmus), {}, table=table)
    assert [design.point(k) for k in range(2)] == [{"w.c0": 1.0, "w.a": 2.0}, {"w.c0": 3.0, "w.a": 4.0}]
    table.write_text("w.c0,w.a\n1\n")
    with pytest.raises(InputError, match="row 2 has 1 cells"):
        make_design(load_system(str(case), fmus), {}, table=table)


@pytest.mark.parametrize("name", shipped_sweeps())
def test_every_shipped_sweep_can_be_planned(name: str, fmus: Path) -> None:
    study = sweep_file(name)
    values = tuple(study.values.items())
    system: System = load(Job(study.system, str(fmus), values, tuple(study.summary.items()), study.stop)).system
    assert len(make_design(system, study.vary)) >= 5 and study.description and figure_units(system)


def test_a_worker_keeps_only_the_signals_that_the_summary_reads(fmus: Path) -> None:
    plan = load(Job("nominal", str(fmus)))
    recorded = {".".join(key) for group in plan.groups for key in group.columns}
    assert {name for name in recorded if not name.startswith("coupling.")} == set(needed(plan.system))
    assert len(recorded) < 20


# --- results ---


def test_results_are_those_of_single_runs_whatever_the_number_of_workers(fmus: Path, tmp_path: Path) -> None:
    options = Options(["brush.delta=0.004,0.005", "motor.V_in=10,12"], {}, "100 ms", fmus=fmus)
    found = {}
    for workers in (1, 2):
        out = tmp_path / str(workers)
        sweep("test_stand", out, Options(**{**vars(options), "workers": workers}))
        found[workers] = [(out / name).read_bytes() for name in ("sweep.nc", "sweep.csv")]
    assert found[1] == found[2], "bitwise"
    with xarray.open_dataset(tmp_path / "2" / "sweep.nc") as result:
        assert result.F_z_mean.dims == ("brush.delta", "motor.V_in") and result.F_z_mean.attrs["units"] == "N"
        assert result["brush.delta"].attrs["units"] == "m" and result.attrs["complete"] == 1
        values = {"brush.delta": 0.005, "motor.V_in": 10.0}
        alone = summarize(simulate(planned("test_stand", values, "100 ms", fmus)))
        for name in figure_units(planned("test_stand", {}, fmus=fmus).system):
            assert float(result.sel(values)[name]) == alone[name], name


def test_a_random_sweep_is_indexed_by_point(case: Path, fmus: Path, tmp_path: Path) -> None:
    result = sweep(str(case), tmp_path / "out", Options(["w.c0=1:2"], random=4, seed=3, workers=1, fmus=fmus))
    assert result.x_last.dims == ("point",) and result.attrs["seed"] == 3
    np.testing.assert_allclose(result.x_last, 0.01 * result["w.c0"], rtol=1e-12)
    with (tmp_path / "out" / "sweep.csv").open() as file:
        rows = list(csv.reader(file))
    assert rows[0] == ["point", "w.c0 [m/s]", "x_last [1]", "y_mean [1]", "error"]
    assert [float(row[2]) for row in rows[1:]] == result.x_last.values.tolist()


def test_a_failed_point_is_recorded_and_the_rest_goes_on(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    options = ("--fmus", fmus, "--out", out, "--workers", 2)
    assert rovbrush(monkeypatch, "sweep", plain_case(tmp_path), "--vary", "p.mode=0,1,3", *options) == 1
    assert "1 of 3 points failed" in capsys.readouterr().err
    with xarray.open_dataset(out / "sweep.nc") as result:
        assert np.isnan(result.y_last.values).tolist() == [False, True, False]
        errors = result.error.values.tolist()
    assert errors[0] == errors[2] == "" and "component p returned" in errors[1] and "100 % of %s%n gone" in errors[1]


def test_a_point_that_kills_its_process_costs_nothing_but_itself(fmus: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    with pytest.raises(RunError, match=r"1 of 4 points failed(.|\n)*process that computed this point died"):
        sweep(str(plain_case(tmp_path)), out, Options(["p.mode=0,6,3,7"], workers=2, fmus=fmus))
    with xarray.open_dataset(out / "sweep.nc") as result:
        assert np.isnan(result.y_last.values).tolist() == [False, True, False, False]


# --- interruptions ---


def begun(system: Path, fmus: Path, out: Path, points: int) -> subprocess.Popen[str]:
    """A sweep in a process group of its own that has finished some points."""
    command = [sys.executable, "-m", "rovbrush.orchestrator", "sweep", str(system), "--vary", "p.u=0:1:40", "--out",
               str(out), "--fmus", str(fmus), "--workers", "2"]  # fmt: skip
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    until = time.monotonic() + 60.0
    while lines(out) < 1 + points:
        assert process.poll() is None and time.monotonic() < until, process.communicate(timeout=10)
        time.sleep(0.02)
    return process


def lines(out: Path) -> int:
    path = out / "points.jsonl"
    return path.read_bytes().count(b"\n") if path.is_file() else 0


def running(pid: int) -> bool:
    """Whether a process is there and no mere entry of one that ended."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


@pytest.mark.skipif(sys.platform != "linux", reason="looks at processes")
@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_an_interrupted_sweep_goes_on_where_it_was_and_leaves_no_process(
    how: signal.Signals, fmus: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, system = tmp_path / "out", plain_case(tmp_path, mode=3)
    process = begun(system, fmus, out, 3)
    children = [int(x) for x in Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()]
    if how == signal.SIGINT:
        os.killpg(process.pid, how)  # as a terminal does
    else:
        process.send_signal(how)
    _, err = process.communicate(timeout=30)
    until = time.monotonic() + 20.0
    while any(running(pid) for pid in children) and time.monotonic() < until:
        time.sleep(0.05)
    assert len(children) >= 2 and not any(running(pid) for pid in children)
    kept = lines(out) - 1
    assert 3 <= kept < 40
    if how == signal.SIGINT:
        assert process.returncode == 1 and f"{kept} of 40 points are kept" in err and "Traceback" not in err
        with xarray.open_dataset(out / "sweep.nc") as partial:
            assert int(np.isfinite(partial.y_last).sum()) == kept and partial.attrs["complete"] == 0
            assert partial.error.values.tolist().count("not computed") == 40 - kept
    with (out / "points.jsonl").open("a") as file:
        file.write('{"point": 39, "figu')  # cut short
    result = sweep(str(system), out, Options(["p.u=0:1:40"], fmus=fmus))
    assert f"{kept} of 40 points are there already" in capsys.readouterr().out
    assert bool(np.isfinite(result.y_last).all()) and lines(out) == 41
    assert [json.loads(line) for line in (out / "points.jsonl").read_text().splitlines()]


def test_a_different_design_in_the_folder_is_an_error_that_says_so(case: Path, fmus: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    first = Options(["w.c0=1,2"], workers=1, fmus=fmus)
    sweep(str(case), out, first)
    before = (out / "points.jsonl").read_bytes()
    with pytest.raises(
        InputError, match=r"2 points of a different sweep \(.*vary w.c0: \[1.0, 2.0\], now \[1.0, 3.0\]"
    ):
        sweep(str(case), out, Options(["w.c0=1,3"], fmus=fmus))
    with pytest.raises(InputError, match="content of system file"):
        sweep(str(case), out, Options(["w.c0=1,2"], {"w.a": 1.0}, fmus=fmus))
    assert (out / "points.jsonl").read_bytes() == before
    sweep(str(case), out, first)  # nothing is left to do
    assert (out / "points.jsonl").read_bytes() == before


def test_a_failed_point_gets_another_try(case: Path, fmus: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    options = Options(["w.c0=1,2"], workers=1, fmus=fmus)
    sweep(str(case), out, options)
    path = out / "points.jsonl"
    head, first, _ = path.read_text().splitlines()
    path.write_text("\n".join([head, first, '{"point": 1, "error": "out of memory"}', ""]))
    assert sweep(str(case), out, options).error.values.tolist() == ["", ""]


# --- bad input ---


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
        sweep(str(case), out, options)
    monkeypatch.undo()
    assert lines(out) == 3
    assert sweep(str(case), out, options).attrs["complete"] == 1


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


# --- Dask ---


def test_a_dask_cluster_gives_the_same_bits(case: Path, fmus: Path, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=2, dashboard_address=None, silence_logs=50
    ) as cluster:
        there = Options(["w.c0=1:5:5"], scheduler=cluster.scheduler_address, fmus=fmus)
        sweep(str(case), tmp_path / "there", there)
    sweep(str(case), tmp_path / "here", Options(["w.c0=1:5:5"], workers=1, fmus=fmus))
    for name in ("sweep.nc", "sweep.csv"):
        assert (tmp_path / "there" / name).read_bytes() == (tmp_path / "here" / name).read_bytes()


def test_a_stranger_at_the_address_of_the_scheduler_is_an_error_within_seconds(
    case: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("rovbrush.orchestrator.studies.dask_workers.ANSWER", 1.0)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        options = Options(["w.c0=1,2"], scheduler=f"tcp://127.0.0.1:{silent.getsockname()[1]}", fmus=fmus)
        with pytest.raises(InputError, match="does not answer as a Dask scheduler within 1 s"):
            sweep(str(case), tmp_path / "out", options)
    assert not (tmp_path / "out").exists()
