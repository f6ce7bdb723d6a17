"""The dry run of `rovbrush check` sees each fault of an FMU, and survives it."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import clock_build
import pytest
from helpers import build_fixture, edited, plan_of
from native_build import feedthrough2, feedthrough3, moody, needs_gcc
from rovbrush.orchestrator.errors import FmuError, InputError
from rovbrush.orchestrator.exchange.checks.dry_run import run_rules
from rovbrush.orchestrator.exchange.checks.rows import Row
from rovbrush.orchestrator.exchange.checks.rules import good_manners, misuse
from rovbrush.orchestrator.exchange.checks.subject import Subject, open_subject
from rovbrush.orchestrator.fmu.fmu import Fmu

STATES = {
    'canGetAndSetFMUstate="false"': 'canGetAndSetFMUstate="true"',
    'canSerializeFMUstate="false"': 'canSerializeFMUstate="true"',
}


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The fixture without a fault, its flags and ranges declared."""
    folder = tmp_path_factory.mktemp("misbehaving")
    bounded = {'<Real start="1"/>': '<Real start="1" min="-2.0" max="2.0"/>'}
    return edited(build_fixture("misbehaving", folder), folder / "sound.fmu", {}, {**STATES, **bounded})


def with_fault(sound: Path, folder: Path, fault: str, **replacements: str) -> Path:
    return edited(sound, folder / "faulty.fmu", {"resources/fault.txt": fault.encode()}, replacements)


def test_an_fmu_without_fault_passes_every_rule(sound: Path) -> None:
    rows = run_rules(sound, (*good_manners.RULES, *misuse.RULES))
    assert [row.verdict for row in rows] == ["pass"] * len(rows), rows


@pytest.mark.parametrize(
    ("fault", "rule", "words"),
    [
        ("nan", "runs", "y not finite after 22 steps"),
        ("random", "repeats", "outputs differ from step 1 of 12"),
        ("hidden", "restores", "outputs differ from step 1 of 12"),
        ("hidden", "serializes", "outputs differ from step 1 of 12"),
        ("shared", "independent", "outputs differ"),
        ("reset", "resets", "outputs differ from step 1 of 12"),
        ("one step size", "varies", "doStep at t = 0.001 s returned Discard"),
    ],
)
def test_a_fault_is_found_by_its_rule(fault: str, rule: str, words: str, sound: Path, tmp_path: Path) -> None:
    (row,) = run_rules(with_fault(sound, tmp_path, fault), [rule])
    assert row.verdict == "error" and words in row.found and row.mend, row


def test_a_state_that_loses_a_number_on_its_way_through_bytes_is_found(sound: Path, tmp_path: Path) -> None:
    lossy = edited(sound, tmp_path / "lossy.fmu", {"resources/forgets.txt": b""})
    kept, lost = run_rules(lossy, ["restores", "serializes"])
    assert kept.verdict == "pass"
    assert lost.verdict == "error" and "outputs differ" in lost.found


@pytest.mark.parametrize("rule", sorted(misuse.RULES.keys() - {"step_before_initialization"}))
def test_an_fmu_that_refuses_nothing_gets_a_finding(rule: str, sound: Path, tmp_path: Path) -> None:
    (row,) = run_rules(with_fault(sound, tmp_path, "meek"), [rule])
    assert (row.verdict, row.mend) == ("finding", misuse.MEND) and "accepted" in row.found, row


def test_a_step_before_initialization_that_is_accepted_is_a_finding(sound: Path, tmp_path: Path) -> None:
    (row,) = run_rules(with_fault(sound, tmp_path, "meek"), ["step_before_initialization"])
    assert row.verdict == "finding" and "accepted" in row.found, row


def test_a_refusal_without_a_word_is_a_finding(sound: Path, tmp_path: Path) -> None:
    (row,) = run_rules(with_fault(sound, tmp_path, "silent"), ["step_before_initialization"])
    assert row.verdict == "finding" and row.found == "refused with Discard, but without a word", row


def test_a_crash_is_a_row_and_the_next_rule_runs(sound: Path, tmp_path: Path) -> None:
    path = with_fault(sound, tmp_path, "aborts out of turn")
    before, after, fine = run_rules(path, ["step_before_initialization", "step_after_terminate", "repeats"])
    for row in (before, after):
        assert (row.stage, row.verdict) == (misuse.ORDER, "error") and "SIGABRT" in row.found and row.mend
    assert fine.verdict == "pass"


def test_a_crash_in_a_step_is_a_row(sound: Path, tmp_path: Path) -> None:
    crashed, refused = run_rules(with_fault(sound, tmp_path, "aborts"), ["runs", "step_before_initialization"])
    assert crashed.verdict == "error" and "SIGABRT" in crashed.found
    assert refused.verdict == "pass"


def test_an_fmu_that_never_comes_back_is_a_row(sound: Path, tmp_path: Path) -> None:
    (row,) = run_rules(with_fault(sound, tmp_path, "hangs"), ["runs"], patience=2.0)
    assert row.verdict == "error" and "did not come back within 2 s" in row.found


def test_what_an_fmu_says_it_cannot_do_is_not_counted(sound: Path, tmp_path: Path) -> None:
    flags = {new: old for old, new in STATES.items()}
    flags['canBeInstantiatedOnlyOncePerProcess="false"'] = 'canBeInstantiatedOnlyOncePerProcess="true"'
    flags['canHandleVariableCommunicationStepSize="true"'] = 'canHandleVariableCommunicationStepSize="false"'
    modest = edited(sound, tmp_path / "modest.fmu", {}, flags)
    rows: list[Row] = run_rules(modest, ["restores", "serializes", "independent", "varies"])
    assert [row.verdict for row in rows] == ["not applicable"] * 4


def test_an_fmu_without_bounds_and_parameters_has_nothing_to_refuse(sound: Path, tmp_path: Path) -> None:
    free = edited(sound, tmp_path / "free.fmu", {}, {' min="-2.0" max="2.0"': ""})
    for rule in ("above_maximum", "below_minimum"):
        assert run_rules(free, [rule])[0].verdict == "not applicable"


def test_a_library_that_does_not_load_is_a_row(sound: Path, tmp_path: Path) -> None:
    broken = edited(sound, tmp_path / "broken.fmu", {"binaries/linux64/Misbehaving.so": b"no library"})
    (row,) = run_rules(broken, ["runs"])
    assert row.verdict == "error" and "cannot be loaded" in row.found, row


def test_the_calls_of_a_rule_that_broke_off_can_be_made_again_as_the_row_says(sound: Path, tmp_path: Path) -> None:
    path = with_fault(sound, tmp_path, "aborts")
    (row,) = run_rules(path, ["runs"])
    command = row.mend.partition("python -m ")[2].partition(";")[0].split()
    assert command == ["rovbrush.orchestrator.exchange.checks.child", str(path), "rows.jsonl", "runs"]
    again = subprocess.run([sys.executable, "-m", *command], cwd=tmp_path, capture_output=True, check=False)
    assert again.returncode == -signal.SIGABRT


@pytest.mark.parametrize("status", [-1, 7, 99])
@needs_gcc
def test_a_status_that_fmi_does_not_know_is_an_error_of_its_rule(status: int, tmp_path: Path) -> None:
    path = moody(tmp_path / "moody.fmu", ON_STEP=f"if (m->steps > 2) return {status}")
    (row,) = run_rules(path, ["runs"])
    assert row.verdict == "error" and f"status {status}, which FMI does not know" in row.found


@needs_gcc
def test_an_fmu_that_asks_to_end_does_what_it_may(tmp_path: Path) -> None:
    path = moody(tmp_path / "moody.fmu", ON_STEP="if (m->steps > 3) return fmi2Discard", TERMINATED="1")
    rows = run_rules(path, tuple(good_manners.RULES))
    assert rows[0].verdict == "pass" and "asks to end the simulation: doStep at t = 0.003 s" in rows[0].found
    assert {row.verdict for row in rows} == {"pass", "not applicable"}, rows


def test_an_fmu_that_gives_nothing_when_instantiated_is_a_row_with_its_words(tmp_path: Path) -> None:
    (row,) = run_rules(feedthrough2(tmp_path / "tool.fmu", REFUSES=1), ["runs"])
    assert row.verdict == "error" and "cannot be instantiated" in row.found and "no licence for the tool" in row.found


def test_an_fmu_without_an_interface_is_refused(sound: Path, tmp_path: Path) -> None:
    other = edited(sound, tmp_path / "other.fmu", {}, {"<CoSimulation ": "<Cosimulation "})
    with pytest.raises(FmuError, match="has no interface at all; export it for co-simulation"):
        open_subject(other)


@needs_gcc
def test_an_fmu_for_scheduled_execution_is_taken_for_one(tmp_path: Path) -> None:
    scheduled = {"<CoSimulation ": "<ScheduledExecution "}
    other = edited(feedthrough3(tmp_path / "clocked.fmu"), tmp_path / "other.fmu", {}, scheduled)
    assert open_subject(other).interface.modelIdentifier == "clocked" and Fmu.open(other).kind == "scheduled-execution"
    with pytest.raises(
        InputError, match=r"component one: other.fmu has no input clock that would activate a partition"
    ):
        plan_of(tmp_path, tmp_path, {"one": (str(other), "1 s")})


@pytest.mark.sampled(4)
@needs_gcc
@pytest.mark.parametrize("model", clock_build.MODELS)
def test_an_fmu_with_events_clocks_or_partitions_is_driven_over_them(model: str, tmp_path: Path) -> None:
    rows = run_rules(clock_build.built(tmp_path) / f"{model}.fmu", (*good_manners.RULES, *misuse.RULES))
    assert not [row for row in rows if row.verdict == "error"]


@needs_gcc
@pytest.mark.parametrize("rule", [misuse.step_before_initialization, misuse.step_after_terminate, misuse.backward_step])
def test_what_is_scheduled_has_no_step_that_could_be_misused(rule: Callable[[Subject], Row], tmp_path: Path) -> None:
    row = rule(open_subject(clock_build.clocked(tmp_path / "partitions.fmu", "partitions")))
    assert (row.verdict, row.found) == ("not applicable", "what is scheduled has partitions and no doStep")
