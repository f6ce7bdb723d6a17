"""Tables in resumed runs and in components that somebody else has made."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import last, read_system
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.checkpoint.checkpoint import read_checkpoint, write_checkpoint
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import apply_changes
from rovbrush.orchestrator.system.request import Changes
from series_cases import ROWS, VALUES, one, planned


def test_a_resumed_run_goes_on_with_the_table_and_with_no_other(tmp_path: Path, fmus: Path) -> None:
    t = np.linspace(0.0, 0.02, 33)
    system = one(tmp_path, fmus)
    plan, other = (planned(system, {"i.u": (t, np.sin(k * t))}) for k in (300.0, 301.0))
    with Session(plan) as session:
        session.advance(cycles=4)
        write_checkpoint(session, tmp_path)
    with Session(plan) as session:
        read_checkpoint(tmp_path).restore(session)
        assert session.time == 0.008
        session.advance()
        resumed = session.run()
    assert resumed.tables[0].tobytes() == simulate(plan).tables[0].tobytes()
    with Session(other) as session, pytest.raises(InputError, match=r"i\.u was a table \("):
        read_checkpoint(tmp_path).restore(session)


def test_a_table_reaches_the_fmu_that_replaces_a_component_in_its_direction(tmp_path: Path, fmus: Path) -> None:
    entry = {"time": ROWS, "values": VALUES}
    system = read_system(tmp_path, fmus, {"i": ("integrator", "2 ms", {"=u": entry})}, stop="20 ms")
    (tmp_path / "map.toml").write_text('[variables]\nu = { name = "u", sign = -1 }\n')
    same, turned = (
        apply_changes(system, Changes((("i", str(fmus / "integrator.fmu")),), mappings))
        for mappings in ((), (("i", str(tmp_path / "map.toml")),))
    )
    x, kept, against = (last(simulate(make_plan(s)), "i.x") for s in (system, same, turned))
    assert kept == x and against == -x and x > 0.0


def test_a_replaced_component_without_the_input_must_be_said_to_lack_it(tmp_path: Path, fmus: Path) -> None:
    entry = {"time": ROWS, "values": VALUES}
    system = read_system(tmp_path, fmus, {"i": ("integrator", "2 ms", {"=u": entry})}, stop="20 ms")
    with pytest.raises(InputError, match=r"u.*which the system sets to the table in the system file"):
        apply_changes(system, Changes((("i", str(fmus / "wave.fmu")),)))
