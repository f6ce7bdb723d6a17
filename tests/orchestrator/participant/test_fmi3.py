"""What is special to FMI 3.0: the flags of a step, states, dependencies, and faults with the FMU's own words."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import column, edited, plan_of
from native_build import FAULTS3, FREE3, built, needs_gcc
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.opening import load
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = needs_gcc


@pytest.fixture(scope="module")
def native(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("native"))


@pytest.mark.parametrize("interpreted", [False, True])
@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("early", "returned early (earlyReturn)"),
        ("event", "needs event handling (eventHandlingNeeded)"),
        ("discard", "returned fmi3Discard"),
        ("error", "returned fmi3Error"),
        ("fatal", "returned fmi3Fatal"),
        ("nan", "output Float32_out became nan"),
    ],
)
def test_what_a_step_reports_ends_the_run_with_who_what_and_when(
    fault: str, words: str, interpreted: bool, native: Path, tmp_path: Path
) -> None:
    values = {**FREE3, "fault": FAULTS3[fault], "bad_at": 0.0035}
    run = simulate(plan_of(tmp_path, native, {"b": ("feedthrough3", "1 ms", values)}, stop="10 ms"), interpreted)
    assert run.failure.startswith("component b") and words in run.failure
    assert "in the step to t = 0.004 s" in run.failure and "a fault as asked for, 100 %s" in run.failure
    assert run.end == 0.003 and column(run, "b.Float64_out")[0][-1] == 0.003


def test_states_are_saved_restored_and_carried_over(native: Path) -> None:
    fmu = Fmu.open(native / "feedthrough3.fmu")
    first, second = load(fmu, "first"), load(fmu, "second")
    for instance in (first, second):
        instance.begin(1.0)
        instance.exit_initialization()
    first.set_all({"Int64_in": 5, "a_in[3]": 9.0, "t_in[2]": "kept"})
    kept = first.save()
    content = first.serialize(kept)
    first.set_all({"Int64_in": 6, "a_in[3]": 8.0})
    first.restore(kept)
    assert (first.get("Int64_in"), first.get("a_in[3]"), first.get("t_in[2]")) == (5, 9.0, "kept")
    second.restore(second.deserialize(content))
    assert (second.get("Int64_in"), second.get("a_in[3]"), second.get("t_in[1]")) == (5, 9.0, "left")
    first.forget(kept)
    first.close()
    second.close()


def test_feedthrough_follows_the_declared_dependencies(native: Path, tmp_path: Path) -> None:
    fmu = Fmu.open(native / "feedthrough3.fmu")
    found = fmu.feedthrough()
    assert found["Int8_out"] == {"Int8_in"} and found["trace"] == frozenset()
    assert found["a_out[3]"] == {f"a_in[{k}]" for k in range(1, 9)}
    everything = frozenset(fmu.names("input"))
    assert fmu.feedthrough(initial=True)["Int8_out"] == everything, "nothing is said about initialization"
    silent = edited(
        native / "feedthrough3.fmu", tmp_path / "feedthrough3.fmu", {},
        {'<Output valueReference="5" dependencies="4"/>': '<Output valueReference="5"/>'},
    )  # fmt: skip
    assert Fmu.open(silent).feedthrough()["Int8_out"] == everything


def test_dimensions_come_from_start_values(native: Path, tmp_path: Path) -> None:
    fmu = Fmu.open(native / "feedthrough3.fmu")
    assert fmu.expand("a_in") == [f"a_in[{k}]" for k in range(1, 9)]
    assert fmu.expand("M") == ["M[1,1]", "M[1,2]", "M[2,1]", "M[2,2]"]
    assert [fmu.start(name) for name in fmu.expand("t_in")] == ["left", "right"]
    huge = edited(
        native / "feedthrough3.fmu", tmp_path / "feedthrough3.fmu", {},
        {'start="1 2 3 4 5 6 7 8"><Dimension start="8"/>': 'start="0"><Dimension start="4000000000"/>'},
    )  # fmt: skip
    with pytest.raises(FmuError, match=r"with array a_in its arrays have more than 100000 elements"):
        Fmu.open(huge)
