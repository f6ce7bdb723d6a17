"""What an observer costs the run that it looks at: native FMUs as fast as they go, with each kind and without."""

from __future__ import annotations

import socket
import statistics
import time
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ....observers.asked import KINDS
from ....observers.watched import NOBODY, Watching, watched
from ....plan.plan import Plan, make_plan
from ....run.session.session import Session
from ....system.assemble import assemble
from ..fmus.native import ring

RUNS, QUICK = 5, 1
STEPS = 20_000  # of 1 ms
EVERY = "20 ms"  # rows of a live view


def observer_rows(folder: Path, quick: bool = False) -> Iterator[tuple[float, dict[str, Any]]]:
    """Microseconds of a macro step of four native FMUs while nobody looks on, and with each kind of observer that is
    installed and needs no program beside it: of every row, and of one every 20 ms. Medians; behind them the rows that
    were sent and dropped in the last run, and how long the observer took to end [s].

    With each row comes the share of the work that is done.
    """
    plan = make_plan(assemble(str(ring(folder, 4, stop=f"{STEPS} ms"))))
    runs = QUICK if quick else RUNS
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as nobody:
        nobody.bind(("127.0.0.1", 0))
        places = {
            "csv": folder / "rows.csv", "mcap": folder / "run.mcap", "ros2": folder / "ros2.mcap", "foxglove": "0",
            "rerun": folder / "run.rrd", "udp": f"127.0.0.1:{nobody.getsockname()[1]}",
        }  # fmt: skip
        kinds = [kind for kind in places if not KINDS[kind].module or find_spec(KINDS[kind].module)]
        cases = [("nobody", NOBODY)]
        for kind in kinds:
            for every in ("", EVERY):
                name = f"{kind}{f', every {every}' if every else ''}"
                cases.append((name, Watching((f"{kind}={places[kind]}",), every=every)))
        for k, (name, watching) in enumerate(cases, 1):
            found = [_run(plan, watching) for _ in range(runs)]
            row = {"observer": name, "runs": runs, "us_per_step": 1e6 * statistics.median(f[0] for f in found) / STEPS}
            yield k / len(cases), row | {"end_s": statistics.median(f[1] for f in found), "told": found[-1][2]}


def _run(plan: Plan, watching: Watching) -> tuple[float, float, str]:
    """Seconds of wall time in the loop, seconds until the observer had ended, and what became of it."""
    with Session(plan) as session:
        with watched(session, watching):
            begin = time.perf_counter()
            session.advance()
            done = time.perf_counter()
        ended = time.perf_counter() - done
        told = [note.partition(": ")[2] for note in session.participants.notes if note.startswith("observer ")]
    return done - begin, ended, "; ".join(told)
