"""How reading and planning grow with a system: connections, FMUs, stated inputs; each in a process of its own."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ....errors import RunError
from ....plan.plan import make_plan
from ....processes import peak_memory
from ....system.file.reader import load_system
from ..fmus.native import feedthrough

SIZES = {"connections": (500, 1000, 2000, 4000), "FMUs": (100, 300, 1000), "stated inputs": (1000, 2000, 4000)}


def growth_rows(folder: Path, quick: bool = False) -> Iterator[tuple[float, dict[str, Any]]]:
    """What grows, how large it is, and CPU time of reader and plan [s], peak memory [MB]; `quick`: the largest of each.

    With each row comes the share of the work that is done. Raises RunError if a system is refused.
    """
    every = [(what, size) for what, sizes in SIZES.items() for size in (sizes[-1:] if quick else sizes)]
    work, done = sum(size for _, size in every), 0
    for what, size in every:
        system = folder / f"{what.split()[-1]}_{size}.toml"
        system.write_text(text(folder, what, size), encoding="utf-8")
        run = subprocess.run([sys.executable, "-m", __name__, str(system)], capture_output=True, text=True, check=False)
        if run.returncode:
            raise RunError(f"the system with {size} {what} was refused: {run.stderr.strip()}")
        done += size
        yield done / work, {"grows": what, "size": size, **json.loads(run.stdout)}


def text(folder: Path, what: str, size: int) -> str:
    """A system with `size` connections, FMUs or stated inputs, of feedthrough FMUs that are made in `folder`."""
    signals = {"connections": size // 2, "FMUs": 1, "stated inputs": size}[what]
    fmu = folder / f"feedthrough{signals}.fmu"
    if not fmu.is_file():
        feedthrough(fmu, signals)
    table = f'[components.{{}}]\nfmu = "{fmu.name}"\nperiod = "1 ms"\n'
    if what == "stated inputs":
        inputs = "\n".join(f'"u[{k}]" = 0.0' for k in range(1, size + 1))
        return f'format = 2\nstop_time = "10 ms"\n{table.format("a")}[components.a.inputs]\n{inputs}\n'
    if what == "FMUs":
        names = [f"c{k}" for k in range(size)]
        wires = [f"{a}.y -> {b}.u" for a, b in zip(names, (*names[1:], names[0]), strict=True)]
    else:
        names = ["a", "b"]
        ends = (("a", "b"), ("b", "a"))
        wires = [f"{a}.y[{k}] -> {b}.u[{k}]" for a, b in ends for k in range(1, signals + 1)]
    lines = "".join(f'  "{wire}",\n' for wire in wires)
    return f'format = 2\nstop_time = "10 ms"\nconnections = [\n{lines}]\n{"".join(map(table.format, names))}'


def main(path: str) -> None:
    """The process of its own: read and plan one system, print what that took as JSON."""
    times = [time.process_time()]
    system = load_system(path)
    times.append(time.process_time())
    make_plan(system)
    times.append(time.process_time())
    reader, plan = times[1] - times[0], times[2] - times[1]
    print(json.dumps({"reader_s": reader, "plan_s": plan, "peak_memory_MB": peak_memory()}))


if __name__ == "__main__":
    main(sys.argv[1])
