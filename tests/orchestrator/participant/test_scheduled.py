"""Scheduled Execution, driven by hand: partitions at the ticks of their clocks, countdowns and output clocks."""

from __future__ import annotations

import re
import weakref
from fractions import Fraction
from pathlib import Path

import fmpy
import pytest
from clock_build import built
from fmpy import fmi3
from native_build import needs_gcc
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.contents import readable
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.base import State
from rovbrush.orchestrator.participant.here.scheduled import ScheduledInstance
from rovbrush.orchestrator.participant.opening import load

pytestmark = needs_gcc


@pytest.fixture
def partitions(tmp_path: Path) -> ScheduledInstance:
    instance = ScheduledInstance(readable(built(tmp_path) / "partitions.fmu")[0], "p")
    instance.begin(10.0)
    instance.exit_initialization()
    return instance


def test_each_partition_runs_at_the_ticks_of_its_clock(partitions: ScheduledInstance) -> None:
    partitions.set("u", 1.0)
    ticks = [("fast", Fraction(k, 100)) for k in range(100)] + [("slow", Fraction(k, 30)) for k in range(30)]
    for clock, instant in sorted(ticks, key=lambda entry: entry[1]):
        partitions.run_partition(clock, float(instant))
        assert partitions.get(f"at_{clock}") == float(instant)
    assert (partitions.get("n_fast"), partitions.get("n_slow")) == (100, 30)
    assert partitions.get("y") == pytest.approx(1 - 0.75**100, abs=1e-15)
    assert partitions.close() == "" and partitions.state is State.FREED


def test_a_partition_begins_a_countdown_and_ticks_an_output_clock_while_it_runs(partitions: ScheduledInstance) -> None:
    told = [partitions.run_partition("slow", k / 30) for k in range(3)]
    assert told[:2] == [([], {}), ([], {})] and told[2] == ([], {"burst": Fraction(5, 1000)})
    assert partitions.run_partition("burst", 2 / 30 + 0.005) == (["alarm"], {})
    assert partitions.run_partition("slow", 0.1) == ([], {})


def test_calls_keep_to_the_states_of_scheduled_execution(partitions: ScheduledInstance) -> None:
    for what, call in (
        ("ask clock alarm", lambda: partitions.ticking(["alarm"])),
        ("tick clock fast", lambda: partitions.tick(["fast"])),
    ):
        with pytest.raises(FmuError, match=f"cannot {what} while it is between two activations"):
            call()
    partitions.run_partition("fast", 1.0)
    with pytest.raises(FmuError, match=r"cannot activate the partition of clock fast at t = 0.5 s \(fmi3Error\)"):
        partitions.run_partition("fast", 0.5)
    assert partitions.state is State.FAILED


def test_a_step_of_an_fmu_alone_runs_all_partitions_until_its_end(partitions: ScheduledInstance) -> None:
    partitions.set("u", 1.0)
    kept = 0
    for k in range(10):
        kept = kept or (partitions.save() if k == 5 else 0)
        partitions.step(k * 0.1, 0.1)
    counts = {name: partitions.get(f"n_{name}") for name in ("fast", "slow", "burst")}
    assert counts == {"fast": 101, "slow": 31, "burst": 10}
    partitions.restore(partitions.deserialize(partitions.serialize(kept)))
    assert partitions.get("n_fast") == 51
    partitions.step(0.5, 0.5)
    assert counts == {name: partitions.get(f"n_{name}") for name in counts}


def test_what_fails_inside_a_clock_update_is_an_error_of_the_activation(
    partitions: ScheduledInstance, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(_name: str) -> None:
        raise FmuError("no interval")

    monkeypatch.setattr(partitions, "interval", fails)
    for k in range(2):
        partitions.run_partition("slow", k / 30)
    with pytest.raises(FmuError, match=r"activate the partition of clock slow at t = 0\.06.* s: no interval"):
        partitions.run_partition("slow", 2 / 30)


def test_an_instance_that_is_dropped_is_gone_at_once(tmp_path: Path) -> None:
    folder = built(tmp_path)
    for model in ("partitions", "controller"):
        instance = load(Fmu.open(folder / f"{model}.fmu"), model)
        instance.begin(1.0)
        instance.exit_initialization()
        gone = weakref.ref(instance)
        instance.close()
        del instance
        assert gone() is None, model


def test_states_are_kept_between_two_activations(partitions: ScheduledInstance) -> None:
    partitions.run_partition("fast", 0.0)
    kept = partitions.save()
    content = partitions.serialize(kept)
    partitions.run_partition("fast", 0.01)
    partitions.restore(kept)
    assert partitions.get("n_fast") == 1
    partitions.run_partition("fast", 0.01)
    partitions.restore(partitions.deserialize(content))
    assert partitions.state is State.ACTIVATING
    partitions.run_partition("fast", 0.01)
    assert partitions.get("n_fast") == 2


HEADER = Path(fmpy.__file__).parent / "c-code" / "fmi3FunctionTypes.h"
C_TYPES = {
    "fmi3Instance": "c_void_p", "fmi3ValueReference": "c_uint", "size_t": "c_ulong", "fmi3Float64": "c_double",
    "fmi3UInt64": "c_ulong", "fmi3Clock": "c_bool", "fmi3Boolean": "c_bool", "fmi3IntervalQualifier": "c_int",
    "fmi3String": "c_char_p", "fmi3InstanceEnvironment": "c_void_p",
}  # fmt: skip
USED = [
    *(f"fmi3{verb}Interval{how}" for verb in ("Get", "Set") for how in ("Decimal", "Fraction")),
    *("fmi3GetShiftDecimal", "fmi3GetShiftFraction"),
    *("fmi3GetClock", "fmi3SetClock", "fmi3EvaluateDiscreteStates", "fmi3UpdateDiscreteStates", "fmi3EnterStepMode"),
    *("fmi3EnterEventMode", "fmi3DoStep", "fmi3ActivateModelPartition", "fmi3InstantiateScheduledExecution"),
    "fmi3InstantiateCoSimulation",
]  # fmt: skip


@pytest.mark.parametrize("function", USED)
def test_fmpy_declares_every_function_that_is_used_as_the_header_does(
    function: str, partitions: ScheduledInstance
) -> None:
    text = re.sub(r"/\*.*?\*/", "", HEADER.read_text(encoding="utf-8"), flags=re.DOTALL)
    found = re.search(rf"typedef\s+(\w+)\s+{function}TYPE\s*\((.*?)\);", text, re.DOTALL)
    assert found, function
    result, wanted = found[1], []
    for parameter in found[2].split(","):
        kind, name = re.fullmatch(r"\s*(?:const\s+)?(\w+\*?)\s*(\w+(?:\[\])?)\s*", parameter).groups()  # type: ignore[union-attr]
        pointer = kind.endswith("*") or name.endswith("[]")
        base = kind.removesuffix("*")
        wanted.append(
            base.replace("Lock", "Unlock")
            if "Callback" in base
            else f"LP_{C_TYPES[base]}"
            if pointer
            else C_TYPES[base]
        )
    bound = getattr(partitions.slave.dll, function)
    callbacks = {getattr(fmi3, name): name for name in dir(fmi3) if name.endswith("Callback")}
    assert [callbacks.get(kind, kind.__name__) for kind in bound.argtypes] == wanted
    assert bound.restype.__name__ == {"fmi3Status": "c_int", "fmi3Instance": "c_void_p"}[result]
