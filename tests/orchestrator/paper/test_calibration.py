"""The shipped parameter file is what the calibration asks for, and the components' defaults are the same numbers."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest
from helpers import Measured
from rovbrush.orchestrator.paper.calibration import brush_text
from rovbrush.orchestrator.paper.specification import SPECIFICATION
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.file.shipped import SYSTEMS

WANTED = tomllib.loads(SPECIFICATION.read_text(encoding="utf-8"))
SHIPPED = tomllib.loads((SYSTEMS / WANTED["write"]).read_text(encoding="utf-8"))


@pytest.mark.evidence
def test_shipped_file_meets_every_target_and_limit(fmus: Path, measured: Measured) -> None:
    summary = summarize(simulate(make_plan(load_system(WANTED["system"], fmus))))
    for key, target in WANTED["targets"].items():
        measured(
            f"calibration: {key} over the paper's, less 1", summary[key] / target["reference"] - 1, str(target["bound"])
        )
        assert summary[key] == pytest.approx(target["reference"], rel=target["bound"])
    for key, limit in WANTED["limits"].items():
        assert summary[key] <= limit["at_most"]


def test_defaults_of_the_fmus_are_the_calibrated_values(fmus: Path) -> None:
    components = load_system(WANTED["system"], fmus).components
    for name, values in SHIPPED.items():
        if name == "description":
            continue
        for variable, value in values.items():
            assert float(components[name].fmu.variables[variable].start) == value, f"{name}.{variable}"


def test_shipped_file_says_what_its_bristles_would_amount_to(fmus: Path) -> None:
    system = load_system(WANTED["system"], fmus)
    assert system.parameter_set is not None
    assert system.parameter_set.description == SHIPPED["description"] == brush_text(system)
    assert "not a buildable brush" in SHIPPED["description"]
