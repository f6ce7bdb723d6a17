"""The nominal run, done once for all tests of the whole system."""

from __future__ import annotations

from pathlib import Path

import pytest
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.tables import Run, require_complete
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.studies.single import planned


@pytest.fixture(scope="session")
def nominal_plan(fmus: Path) -> Plan:
    return planned("nominal", {}, fmus=fmus)


@pytest.fixture(scope="session")
def nominal(nominal_plan: Plan) -> Run:
    return require_complete(simulate(nominal_plan))


@pytest.fixture(scope="session")
def signals(nominal: Run) -> Signals:
    return Signals(nominal)
