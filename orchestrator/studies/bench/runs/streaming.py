"""Memory of long runs: two native FMUs for one and for ten million macro steps, every row on disk."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from ....errors import RunError
from ..fmus.native import ring

STEPS, QUICK = (1_000_000, 10_000_000), (100_000, 1_000_000)
PEAK = (
    "import re, sys; from rovbrush.orchestrator.cli.main import main; sys.argv[0] = 'rovbrush'\n"
    "try: main()\n"
    "finally: print('peak', re.search(r'VmHWM:\\s*(\\d+)', open('/proc/self/status').read())[1])"
)


def long_runs(quick: bool = False) -> list[dict[str, Any]]:
    """One row per length: wall time, peak memory, rows in result.nc. Raises RunError if rows are missing."""
    import h5netcdf  # type: ignore[import-untyped]

    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        path = ring(folder, 2)
        for steps in QUICK if quick else STEPS:
            begin = time.perf_counter()
            done = subprocess.run(
                [sys.executable, "-c", PEAK, "run", str(path), "--stop", f"{steps} ms", "--out", str(folder / "out")],
                capture_output=True, text=True, check=False,
            )  # fmt: skip
            wall = time.perf_counter() - begin
            if done.returncode:
                raise RunError(f"the run of {steps} steps failed: {done.stderr.strip()}")
            with h5netcdf.File(folder / "out" / "result.nc", "r") as file:
                sizes = {variable.shape[0] for variable in file["every_1_ms"].variables.values()}
            if sizes != {steps + 1}:
                raise RunError(f"the run of {steps} steps left {sizes} rows in result.nc")
            loop = json.loads((folder / "out" / "summary.json").read_text(encoding="utf-8"))["wall_s"]
            peak = re.search(r"peak (\d+)", done.stdout)
            rows.append({
                "system": "ring2, streamed", "macro_steps": steps, "rows": steps + 1, "command_s": wall, "loop_s": loop,
                "peak_memory_MB": int(peak[1]) * 1024 / 1e6 if peak else 0.0,
            })  # fmt: skip
    return rows
