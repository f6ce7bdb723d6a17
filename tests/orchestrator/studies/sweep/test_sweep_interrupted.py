"""A sweep that was cut short goes on where it was, and computes no point twice."""

from __future__ import annotations

import json
import multiprocessing
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import xarray
from rovbrush.orchestrator.environment import versions
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.studies.sweep.options import Options
from rovbrush.orchestrator.studies.sweep.sweep import sweep
from rovbrush.orchestrator.studies.sweep.workers.point import Job, load
from rovbrush.orchestrator.studies.sweep.workers.workers import LocalWorkers
from sweep_cases import begun, lines, plain_case, running


@pytest.mark.evidence
@pytest.mark.skipif(sys.platform != "linux", reason="looks at processes")
@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_an_interrupted_sweep_goes_on_where_it_was_and_leaves_no_process(
    how: signal.Signals, fmus: Path, tmp_path: Path
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
    said: list[str] = []
    result = sweep(str(system), out, Options(["p.u=0:1:40"], fmus=fmus), said.append).require_all()
    assert f"{kept} of 40 points are there already" in said
    assert bool(np.isfinite(result.y_last).all()) and lines(out) == 41
    assert [json.loads(line) for line in (out / "points.jsonl").read_text().splitlines()]


def test_a_different_design_in_the_folder_is_an_error_that_says_so(case: Path, fmus: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    first = Options(["w.c0=1,2"], workers=1, fmus=fmus)
    sweep(str(case), out, first).require_all()
    before = (out / "points.jsonl").read_bytes()
    with pytest.raises(
        InputError, match=r"2 points of a different sweep \(.*vary w.c0: \[1.0, 2.0\], now \[1.0, 3.0\]"
    ):
        sweep(str(case), out, Options(["w.c0=1,3"], fmus=fmus)).require_all()
    with pytest.raises(InputError, match="content of system file"):
        sweep(str(case), out, Options(["w.c0=1,2"], {"w.a": 1.0}, fmus=fmus)).require_all()
    assert (out / "points.jsonl").read_bytes() == before
    sweep(str(case), out, first).require_all()  # nothing is left to do
    assert (out / "points.jsonl").read_bytes() == before


def test_a_failed_point_gets_another_try(case: Path, fmus: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    options = Options(["w.c0=1,2"], workers=1, fmus=fmus)
    sweep(str(case), out, options).require_all()
    path = out / "points.jsonl"
    head, first, _ = path.read_text().splitlines()
    path.write_text("\n".join([head, first, '{"point": 1, "error": "out of memory"}', ""]))
    assert sweep(str(case), out, options).require_all().error.values.tolist() == ["", ""]


def test_points_of_other_versions_or_another_processor_are_taken_only_when_asked(
    case: Path, fmus: Path, tmp_path: Path
) -> None:
    out, options = tmp_path / "out", Options(["w.c0=1,2"], workers=1, fmus=fmus)
    sweep(str(case), out, options).require_all()
    path = out / "points.jsonl"
    head, first, _ = path.read_text().splitlines()
    for key, then in (("numba", "0.1"), ("rovbrush", "0.0.1"), ("processor", "i386")):
        other = json.loads(head)
        other["made with"][key] = then
        path.write_text("\n".join([json.dumps(other), first, ""]))
        before = path.read_bytes()
        with pytest.raises(InputError, match=f"1 point, computed otherwise .{key} {then}, now"):
            sweep(str(case), out, options)
        assert path.read_bytes() == before
    result = sweep(str(case), out, replace(options, force=True)).require_all()
    assert "processor i386" in result.attrs["made_with"] and result.attrs["made_with"].count("numba") == 2
    sweep(str(case), out, options).require_all()  # the last of them count from now on


def test_a_worker_with_other_versions_is_refused(case: Path, fmus: Path) -> None:
    with pytest.raises(RunError, match=r"began with other versions \(numba 0\.1, now"):
        load(Job(str(case), str(fmus), versions=tuple({**versions(), "numba": "0.1"}.items())))


def test_ending_the_workers_leaves_other_processes_of_the_program_alone() -> None:
    workers = LocalWorkers(1)
    other = multiprocessing.get_context("spawn").Process(target=time.sleep, args=(60.0,))
    other.start()
    try:
        own = workers.pool.submit(os.getpid).result()
        workers.stop()
        until = time.monotonic() + 20.0
        while running(own) and time.monotonic() < until:
            time.sleep(0.05)
        assert not running(own) and other.is_alive()
    finally:
        other.kill()
        other.join()


def test_a_script_that_begins_a_sweep_outside_of_main_is_told_so_and_ends(
    case: Path, fmus: Path, tmp_path: Path
) -> None:
    """Each process of the sweep reads the script, and would begin a sweep of its own."""
    script = tmp_path / "script.py"
    script.write_text(
        "from pathlib import Path\n"
        "from rovbrush.orchestrator.studies.sweep.options import Options\n"
        "from rovbrush.orchestrator.studies.sweep.sweep import sweep\n"
        f"sweep({str(case)!r}, Path({str(tmp_path / 'out')!r}), Options(['w.c0=1,2'], fmus=Path({str(fmus)!r})))\n",
        encoding="utf-8",
    )
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 1 and 'under `if __name__ == "__main__":`' in done.stderr
    assert lines(tmp_path / "out") == 1  # the head alone: no point is told to have failed
