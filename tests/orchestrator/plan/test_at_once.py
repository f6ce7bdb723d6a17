"""Who can be stepped at once, and in which order the operations are then."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from native_build import needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.loop.operations import GET, SET, STEP
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.studies.bench.runs.workers import busy, busy_ring
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

pytestmark = needs_gcc


def ring(folder: Path, **changes: object) -> System:
    system = load_system(str(busy_ring(folder, 10, stop="10 ms")))
    return replace(system, **{"workers": "auto", **changes})  # type: ignore[arg-type]


def star(folder: Path, periods: tuple[str, ...] = ("1 ms",) * 3) -> System:
    """c0 drives three others, which drive nobody."""
    busy(folder / "busy.fmu", 10)
    wires = ", ".join(f'"c0.y -> c{k}.u"' for k in (1, 2, 3))
    tables = "".join(f'[components.c{k}]\nfmu = "busy.fmu"\nperiod = "{p}"\n' for k, p in enumerate(("1 ms", *periods)))
    path = folder / "star.toml"
    path.write_text(f'format = 2\nstop_time = "10 ms"\nworkers = "auto"\nconnections = [{wires}]\n{tables}')
    return load_system(str(path))


def codes(plan: Plan, *wanted: int) -> list[tuple[int, int]]:
    return [(code, component) for code, _, component, *_ in plan.cycle.tolist() if code in wanted]


def test_in_a_ring_with_jacobi_all_inputs_are_set_before_the_first_step(tmp_path: Path) -> None:
    system = ring(tmp_path)
    plan, one = make_plan(system), make_plan(replace(system, workers="1"))
    assert plan.together.groups == (("c0", "c1", "c2", "c3"),)
    assert codes(plan, SET, STEP) == [*((SET, k) for k in range(4)), *((STEP, k) for k in range(4))]
    assert codes(plan, STEP, GET) == codes(one, STEP, GET), "nothing else is moved"
    assert sorted(map(tuple, plan.cycle.tolist())) == sorted(map(tuple, one.cycle.tolist()))
    assert "stepped at once: c0, c1, c2, c3" in explain(plan)


def test_in_a_ring_with_gauss_seidel_each_waits_for_the_one_before_it(tmp_path: Path) -> None:
    plan = make_plan(ring(tmp_path, algorithm="gauss-seidel"))
    assert plan.together.groups == ()
    assert np.array_equal(plan.cycle, make_plan(ring(tmp_path, algorithm="gauss-seidel", workers="1")).cycle)
    assert "all steps on one thread (nobody else steps at its instants without waiting for it)" in explain(plan)


def test_branches_of_gauss_seidel_that_need_nothing_of_each_other_are_stepped_at_once(tmp_path: Path) -> None:
    plan = make_plan(star(tmp_path))
    assert plan.together.groups == (("c1", "c2", "c3"),)
    assert codes(plan, SET, STEP)[0] == (STEP, 0)


def test_only_components_of_one_period_are_stepped_at_once(tmp_path: Path) -> None:
    assert make_plan(star(tmp_path, ("1 ms", "2 ms", "2 ms"))).together.groups == (("c2", "c3"),)


def test_a_component_can_stay_out(tmp_path: Path) -> None:
    system = ring(tmp_path)
    out = system.with_component(replace(system.components["c1"], parallel="off"))
    plan = make_plan(out)
    assert plan.together.groups == (("c0", "c2", "c3"),)
    assert 'by itself: c1, parallel = "off"' in explain(plan)


def test_python_fmus_are_stepped_at_once_in_processes_only(fmus: Path, tmp_path: Path) -> None:
    for isolation, groups in (("none", ()), ("process", (("a", "b"),))):
        stated = f'fmu = "gain"\nperiod = "1 ms"\nisolation = "{isolation}"\ninputs = {{ u = 1.0 }}\n'
        tables = "".join(f"[components.{name}]\n{stated}" for name in "ab")
        path = tmp_path / f"{isolation}.toml"
        path.write_text(f'format = 2\nstop_time = "5 ms"\nworkers = 2\n{tables}')
        plan = make_plan(load_system(str(path), fmus))
        assert plan.together.groups == groups, explain(plan)


@pytest.mark.parametrize("algorithm", ["iterated", "adaptive"])
def test_steps_that_are_done_again_or_vary_go_on_one_thread(algorithm: str, tmp_path: Path) -> None:
    plan = make_plan(ring(tmp_path, algorithm=algorithm))
    assert plan.together.groups == () and "repeated or vary" in explain(plan)


@pytest.mark.parametrize("text", ["0", "-2", "1.5", '"many"', '""', "1000", "true"])
def test_a_number_of_workers_that_means_nothing_is_an_error_with_its_line(text: str, tmp_path: Path) -> None:
    path = busy_ring(tmp_path, 10)
    path.write_text(path.read_text().replace("format = 2\n", f"format = 2\nworkers = {text}\n"))
    with pytest.raises(InputError, match=r"workers.*(line 2)"):
        load_system(str(path))
