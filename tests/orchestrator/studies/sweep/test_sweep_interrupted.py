"""A sweep that was cut short goes on where it was, and computes no point twice."""

from __future__ import annotations

import json
import os
import signal
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import xarray
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.studies.sweep.sweep import Options, sweep
from sweep_cases import begun, lines, plain_case, running


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
