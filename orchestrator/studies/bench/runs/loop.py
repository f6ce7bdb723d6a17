"""The loop beside the bare calls of the same FMUs: rings of native ones, in turns with each other in one run."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from ....plan.plan import Plan, make_plan
from ....plan.speed.straight import worth_of
from ....run.blocks.straight_on import ALWAYS, NEVER
from ....run.session.session import Session
from ....run.stepping.stepping import Stepping
from ....system.file.reader import load_system
from ..fmus.native import ring
from ..peers.floor import Floor

ROUNDS, QUICK = 41, 9
SEVERAL = 1_000  # FMUs
PERIOD = Fraction(1, 1000)  # s


@dataclass(frozen=True)
class Ring:
    """How many FMUs, and how many macro steps of them are measured at a time."""

    components: int
    steps: int
    algorithm: str = "jacobi"
    recording: bool = False
    by_hand: bool = False


CASES = (
    Ring(4, 10_000), Ring(4, 10_000, recording=True), Ring(4, 10_000, "gauss-seidel"), Ring(4, 5_000, "iterated"),
    Ring(4, 500, by_hand=True),
    Ring(4, 500, recording=True, by_hand=True), Ring(40, 1_000), Ring(400, 100), Ring(1_000, 40), Ring(4_000, 10),
)  # fmt: skip


def loop_rows(folder: Path, quick: bool = False) -> Iterator[tuple[float, dict[str, Any]]]:
    """Microseconds of a macro step of the bare calls, of the loop one operation after the other, fused, and by machine
    code of its own, where a plan can have that; medians, and the ratios of the best way to the first: that of the
    medians, and of the fastest rounds.

    With each row comes the share of the work that is done. Rounds take turns; rows are recorded where they were before.
    """
    for k, case in enumerate(CASES):
        path = ring(folder, case.components, stop="1000 s")
        system = replace(
            load_system(str(path)), algorithm=case.algorithm, record=("*",) if case.recording else (),
            stop=PERIOD * case.steps,
        )  # fmt: skip
        yield (k + 1) / len(CASES), measured(case, make_plan(system), QUICK if quick else ROUNDS)


def measured(case: Ring, plan: Plan, rounds: int) -> dict[str, Any]:
    """The row of a case."""
    with ExitStack() as stack:
        floor, code = Floor(plan, _passes(plan)), not worth_of(plan).why_not
        stack.callback(floor.close)
        ways: dict[str, Callable[[], float]] = {"bare": lambda: floor.seconds(case.steps)}
        if case.by_hand:
            ways["loop"] = by_hand(stack.enter_context(Stepping(plan)), case.steps)
            if code:
                ways["code"] = by_hand(stack.enter_context(Stepping(plan, straight=ALWAYS)), case.steps)
        else:
            if case.components <= SEVERAL:  # to load thousands of FMUs takes long
                ways["operations"] = whole(stack.enter_context(Session(plan, fuses=False)))
            ways["loop"] = whole(stack.enter_context(Session(plan, straight=NEVER)))
            if code:
                ways["code"] = whole(stack.enter_context(Session(plan, straight=ALWAYS)))
        found: dict[str, list[float]] = {name: [] for name in ways}
        for number in range(rounds + 1):
            for name, way in ways.items():
                seconds = way()
                if number:  # the first one warms up
                    found[name].append(1e6 * seconds / case.steps)
    row: dict[str, Any] = {
        "FMUs": case.components, "algorithm": case.algorithm, "recording": case.recording, "by_hand": case.by_hand,
        "runs": rounds, **{f"{name}_us": statistics.median(times) for name, times in found.items()},
    }  # fmt: skip
    best = "code" if code else "loop"
    row["ratio"] = row[f"{best}_us"] / row["bare_us"]
    row["ratio_of_fastest"] = min(found[best]) / min(found["bare"])
    return row | {"best_us": min(found[best])}


def _passes(plan: Plan) -> int:
    """How often the steps of a plan are done, that repeats them."""
    if not plan.algorithm.saves_states:
        return 1
    with Session(plan) as session:
        session.advance(cycles=100)
        return int(session.get("coupling.iterations"))


def whole(session: Session) -> Callable[[], float]:
    """Wall time of a run to the stop [s], from the start again and again."""
    start = _snapshot(session)

    def run() -> float:
        session.advance()
        spent = session.at.wall
        start()
        return spent

    return run


def by_hand(session: Stepping, steps: int) -> Callable[[], float]:
    """Wall time of so many steps [s], of which Python asks for each."""
    start = session.snapshot()

    def run() -> float:
        begin = time.perf_counter()
        for _ in range(steps):
            session.step()
        spent = time.perf_counter() - begin
        session.restore(start)
        return spent

    return run


def _snapshot(session: Session) -> Callable[[], None]:
    """What brings a session back to where it is now."""
    from ....run.stepping.snapshot import go_back, take_snapshot

    taken = take_snapshot(session)
    return lambda: go_back(session, taken)
