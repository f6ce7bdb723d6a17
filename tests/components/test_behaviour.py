"""Every component's own behaviour tests, on its kernel and on each of its FMUs, and on a motor that a stranger made."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from helpers import FIXTURES, Measured, build_fixture
from kernel_unit import KernelUnit
from rovbrush.components.build import COMPONENTS, HERE
from rovbrush.components.python.building.build import sources
from rovbrush.orchestrator.exchange.component_tests.suites import NotApplicableError, suite_of
from rovbrush.orchestrator.exchange.component_tests.verdicts import TOLERANCE, Bench, attempt, make_bench

FOREIGN_MAP = (FIXTURES / "foreign_motor.toml").read_text(encoding="utf-8")
OWN = ("python", "fmi2", "fmi3")
TESTS = [(name, test) for name in COMPONENTS for test in suite_of(name).tests]
IDS = [f"{name}-{test.__name__.removeprefix('test_')}" for name, test in TESTS]
# On its kernel every claim is tried, and on one of the kinds of FMU in turn; on the other two by `make evidence`.
ON_FMUS = [
    pytest.param(*case, kind, id=f"{name}-{kind}", marks=() if kind == OWN[k % len(OWN)] else pytest.mark.evidence)
    for k, (case, name) in enumerate(zip(TESTS, IDS, strict=True))
    for kind in OWN
]
BENCHES: dict[tuple[str, str], Bench] = {}


@pytest.fixture
def bench_of(request: pytest.FixtureRequest) -> Callable[[str, str], Bench]:
    """The bench for a component in one of its forms, made once; no solver tolerance is granted to our own."""

    def bench(name: str, kind: str) -> Bench:
        if (name, kind) not in BENCHES:
            folder: Path = (
                request.getfixturevalue("fmus") if kind == "python" else request.getfixturevalue("native") / kind
            )
            BENCHES[name, kind] = make_bench(folder / f"{name}.fmu", name, None, tolerance=0.0)
        return BENCHES[name, kind]

    return bench


@pytest.fixture(scope="session")
def foreign(tmp_path_factory: pytest.TempPathFactory) -> Bench:
    """A motor with other names, one direction turned round, revolutions per minute and no account of energy."""
    folder = tmp_path_factory.mktemp("foreign")
    (folder / "map.toml").write_text(FOREIGN_MAP)
    return make_bench(build_fixture("foreign_motor", folder), "dc_motor", folder / "map.toml", TOLERANCE)


@pytest.mark.parametrize(("name", "test"), TESTS, ids=IDS)
def test_kernel_behaves(name: str, test: Callable[[Any], None], measured: Measured) -> None:
    unit = KernelUnit(name)
    test(unit)
    for what, deviation, bound in unit.observed:
        measured(f"{name}: {what}, relative to its size, of {bound:.0e}", deviation, f"{bound:.1e}")


@pytest.mark.parametrize(("name", "test", "kind"), ON_FMUS)
def test_fmu_behaves(name: str, test: Callable[[Any], None], kind: str, bench_of: Callable[[str, str], Bench]) -> None:
    attempt(test, bench_of(name, kind).unit)


@pytest.mark.parametrize("kind", OWN)
@pytest.mark.parametrize("name", COMPONENTS)
def test_interface_of_the_fmu_is_the_declared_one(name: str, kind: str, bench_of: Callable[[str, str], Bench]) -> None:
    comparison = bench_of(name, kind).comparison
    assert [row for row in comparison.rows if row.finding != "fits"] == []
    assert set(comparison.bindings) == {v.name for v in suite_of(name).interface}


@pytest.mark.parametrize("test", suite_of("dc_motor").tests, ids=lambda test: test.__name__.removeprefix("test_"))
def test_foreign_motor_behaves(test: Callable[[Any], None], foreign: Bench) -> None:
    try:
        attempt(test, foreign.unit)
    except NotApplicableError as reason:
        pytest.skip(f"not applicable: {reason}")


@pytest.mark.parametrize("name", COMPONENTS)
def test_every_claim_is_said_in_a_sentence(name: str) -> None:
    suite = suite_of(name)
    assert all(test.__doc__ and test.__doc__.strip().endswith(".") for test in suite.tests)
    assert len({test.__name__ for test in suite.tests}) == len(suite.tests)
    assert set(suite.essential) <= {v.name for v in suite.interface}


@pytest.mark.parametrize("name", COMPONENTS)
def test_fmus_do_not_carry_the_tests(name: str) -> None:
    assert not [path for path in sources(HERE / name) if "behaviour" in path]
