"""The bare calls of a plan that repeats steps are those of the plan, as often as it makes them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from native_build import needs_gcc
from rovbrush.orchestrator.loop.operations import GET, ITERATE, REPEAT, RESTORE, SAVE, SET, STEP
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.studies.bench.fmus.native import ring
from rovbrush.orchestrator.studies.bench.peers.floor import Floor, _calls
from rovbrush.orchestrator.system.file.reader import load_system


@needs_gcc
def test_calls_are_those_of_the_plan_and_go_on_where_it_goes_on(tmp_path: Path) -> None:
    plan = make_plan(replace(load_system(str(ring(tmp_path, 3, stop="10 ms"))), algorithm="iterated"))
    calls, cycle = _calls(plan.cycle), plan.cycle
    for code in (SET, STEP, GET, ITERATE, REPEAT):
        assert np.sum(calls[:, 0] == code) == np.sum(cycle[:, 0] == code) > 0
    for code in (SAVE, RESTORE):  # of FMUs; cells are saved by nobody's function
        assert calls[calls[:, 0] == code, 1].tolist() == [0, 1, 2]
    (repeat,) = calls[calls[:, 0] == REPEAT]
    (iterate,) = calls[calls[:, 0] == ITERATE]
    assert calls[repeat[2], 0] == SET  # the next pass begins with inputs
    assert iterate[2] == len(calls)  # what follows a step calls nobody
    floor = Floor(plan, passes=3)
    try:
        assert floor._call(5, 1e-3) == 0  # no status is worse than OK
    finally:
        floor.close()
