"""What an environment of Gymnasium costs: steps and resets, in a process of its own, as one uses it."""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ....errors import InputError, RunError
from ..fmus.native import ring

RUNS, QUICK = 15, 5
STEPS, RESETS = 20_000, 2_000  # of a run
SYSTEMS = {"feedthrough4, open": (4, 1), "signals20, open": (2, 20)}  # FMUs, signals of each
MEASURE = """
import json, sys, time
from rovbrush.gym import Environment

path, actions, observations, runs, steps, resets = json.loads(sys.argv[1])
env = Environment(path, actions, observations, f"-abs({list(observations)[0]} - 0.5)", episode=f"{steps} ms")
action = (env.action_space.low + env.action_space.high) / 2 + 0.5
for run in range(runs + 1):
    begin = time.perf_counter()
    for _ in range(resets):
        env.reset()
    middle = time.perf_counter()
    for _ in range(steps):
        env.step(action)
    end = time.perf_counter()
    if run:  # the first one warms up
        print(json.dumps([(end - middle) / steps, (middle - begin) / resets]))
env.close()
"""


def gym_rows(folder: Path, quick: bool = False) -> Iterator[tuple[float, dict[str, Any]]]:
    """Steps per second and microseconds of a reset, medians of all runs and the best: native FMUs, an open chain of
    which the first inputs are set and the last outputs seen, an expression as reward, nothing recorded, no wrappers.

    With each row comes the share of the work that is done. Raises InputError without Gymnasium, RunError where an
    environment fails.
    """
    if find_spec("gymnasium") is None:
        raise InputError("environments need Gymnasium: pip install 'rovbrush[gym]'")
    runs = QUICK if quick else RUNS
    for k, (system, (components, signals)) in enumerate(SYSTEMS.items()):
        ends = [f"[{n + 1}]" for n in range(signals)] if signals > 1 else [""]
        actions = {f"c0.u{end}": (-1.0, 1.0) for end in ends}
        observations = {f"c{components - 1}.y{end}": (-2.0, 2.0) for end in ends}
        path = ring(folder, components, signals, stop=f"{STEPS} ms", closed=False)
        asked = json.dumps([str(path), actions, observations, runs, STEPS, RESETS])
        done = subprocess.run([sys.executable, "-c", MEASURE, asked], capture_output=True, text=True, check=False)
        if done.returncode:
            raise RunError(f"the environment of {system} failed: {done.stderr.strip()}")
        found = [json.loads(line) for line in done.stdout.splitlines()]
        steps, resets = zip(*found, strict=True)
        yield (k + 1) / len(SYSTEMS), {
            "system": system, "runs": runs, "actions": len(actions), "observations": len(observations),
            "steps_per_s": 1 / statistics.median(steps), "best_steps_per_s": 1 / min(steps),
            "us_per_reset": 1e6 * statistics.median(resets), "best_us_per_reset": 1e6 * min(resets),
        }  # fmt: skip
