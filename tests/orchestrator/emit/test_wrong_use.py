"""What a host may do wrong with an exported FMU: each is a status and a message, and the FMU goes on where it can."""

from __future__ import annotations

from pathlib import Path

import pytest
from emit_cases import PARTS, WIRES
from fmpy import read_model_description
from helpers import python, read_system
from native_build import needs_gcc
from rovbrush.orchestrator.emit import archive
from rovbrush.orchestrator.emit.export import export_fmu

pytestmark = needs_gcc
STRANGER = r"""
import sys
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu
file = sys.argv[1]
assert validate_fmu(file) == [], validate_fmu(file)
d = read_model_description(file)
folder, two, h, nan = extract(file), d.fmiVersion == "2.0", 0.001, float("nan")
kind = FMU2Slave if two else FMU3Slave
number = {v.name: v.valueReference for v in d.modelVariables}
def new(token=d.guid):
    f = kind(guid=token, unzipDirectory=folder, modelIdentifier=d.coSimulation.modelIdentifier, instanceName="x")
    f.instantiate()
    f.read, f.write = (f.getReal, f.setReal) if two else (f.getFloat64, f.setFloat64)
    return f
def start(f, begin=0.0, stop=None):
    if two:
        f.setupExperiment(startTime=begin, stopTime=stop)
        f.enterInitializationMode()
    else:
        f.enterInitializationMode(startTime=begin, stopTime=stop)
    f.exitInitializationMode()
    return f
def refused(words, do, *arguments):
    try:
        do(*arguments)
    except Exception:
        return
    raise AssertionError(words)
x, m = [number["a.x"], number["f.F"]], [number["a.m"]]
f = new()
refused("a step before the initialization", f.doStep, 0.0, h)
refused("the end of an initialization that has not begun", f.exitInitializationMode)
f.freeInstance()
f = start(new())
refused("an output that is set", f.write, x[:1], [1.0])
refused("a parameter that is set too late", f.write, m, [1.0])
for reference in (10**9, 2**32 - 1, 2**31):
    refused("a reference of nothing", f.read, [reference])
    refused("a reference of nothing that is set", f.write, [reference], [1.0])
for step in (h / 3, 0.0, -h, nan, float("inf"), 1e300):
    refused(f"a step of {step}", f.doStep, 0.0, step)
for time in (1.0, nan, -h):
    refused(f"a step from {time}", f.doStep, time, h)
f.doStep(0.0, h)  # it is as good as before
first = f.read(x)
drifting = start(new())
drifting.doStep(0.0, h)
drifting.doStep(h + 4e-6, h)  # a host that adds step to step, after millions of them
refused("a step from far away", drifting.doStep, 2 * h + 2e-5, h)
refused("a step that is too long", drifting.doStep, 2 * h, 1.004 * h)
drifting.doStep(2 * h - 4e-6, h + 4e-6)  # to where it means to be
refused("a stop before the start", start, new(), 5 * h, 4 * h)
refused("a second initialization", f.enterInitializationMode)
state = f.getFMUState()
f.doStep(h, h)
second = f.read(x)
f.terminate()
refused("a step behind the end", f.doStep, 2 * h, h)
assert f.read(x) == second
f.setFMUState(state)
f.doStep(h, h)
assert f.read(x) == second
kept = bytearray(f.serializeFMUState(state))
other = start(new())
for place in (0, 50, len(kept) // 2, len(kept) - 1):
    damaged = bytearray(kept)
    damaged[place] ^= 0x5A
    refused(f"a state that is damaged at {place}", other.deserializeFMUState, bytes(damaged))
for part in (b"", bytes(kept[:20]), bytes(kept[:-8]), bytes(kept) + b"more"):
    refused("a part of a state", other.deserializeFMUState, part)
other.doStep(0.0, h)
assert other.read(x) == first
other.setFMUState(other.deserializeFMUState(bytes(kept)))
other.doStep(h, h)
assert other.read(x) == second
f.freeFMUState(state)
f.reset()
start(f).doStep(0.0, h)
assert f.read(x) == first
start(new()).terminate()  # without a step
new().freeInstance()
refused("a start between two ticks", start, new(), h / 10)
refused("a start that cannot be counted", start, new(), 1e18)
f = start(new(), 7 * h)
f.doStep(7 * h, h)
f = start(new(), 0.0, 2.5 * h)
f.doStep(0.0, 2 * h)
refused("a step beyond the stop", f.doStep, 2 * h, h)
refused("another FMU's token", new, "{wrong}")
print("alive")
"""


@pytest.mark.parametrize("version", ["2.0", "3.0"])
def test_wrong_use_is_a_status_and_never_a_crash(version: str, carried: Path, tmp_path: Path) -> None:
    system = read_system(tmp_path, carried, PARTS, WIRES, stop="0.1 s", algorithm="gauss-seidel")
    export_fmu(system, tmp_path / "whole.fmu", version)
    done = python(STRANGER, str(tmp_path / "whole.fmu"))
    assert done.stdout.split()[-1:] == ["alive"], done.stderr[-2000:]
    said = done.stdout + done.stderr
    assert "a step to t = 0.003 s is not possible: x was told to stop at 0.0025 s" in said
    assert "goes on by instants, the next one at 0.001 s" in said


TYPES = """
import sys
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
file = sys.argv[1]
d = read_model_description(file)
number = {v.name: v.valueReference for v in d.modelVariables}
said = []
def log(environment, name, status, category, text):
    said.append((status, category.decode(), text.decode()))
def new(**keys):
    f = FMU2Slave(guid=keys.get("guid", d.guid), unzipDirectory=folder,
                  modelIdentifier=d.coSimulation.modelIdentifier, instanceName="x")
    from fmpy.fmi2 import (fmi2CallbackFunctions, fmi2CallbackLoggerTYPE, fmi2CallbackAllocateMemoryTYPE,
                           fmi2CallbackFreeMemoryTYPE)
    f.own = fmi2CallbackFunctions()
    f.own.logger = fmi2CallbackLoggerTYPE(log)
    f.instantiate(callbacks=f.own)
    return f
folder = extract(file)
try:
    new(guid="{wrong}")
except Exception:
    pass
assert said[-1][:2] == (3, "logStatusError") and "GUID" in said[-1][2], said
f = new()
f.setupExperiment(startTime=0.0, stopTime=1.0)
f.setString([number["a.String_in"]], ["one"])
f.enterInitializationMode()
f.exitInitializationMode()
for name, value in (("a.Int8_in", 200), ("a.UInt8_in", -1), ("a.Int16_in", 2**15), ("a.UInt16_in", 2**16)):
    before = f.getInteger([number[name]])
    try:
        f.setInteger([number[name]], [value])
    except Exception:
        assert f.getInteger([number[name]]) == before
        assert "its type does not hold that" in said[-1][2], said[-1]
    else:
        raise AssertionError(name)
try:
    f.setReal([number["a.Float32_in"]], [1e300])
except Exception:
    assert "it is a Float32" in said[-1][2]
else:
    raise AssertionError("Float32")
assert f.getString([number["a.String_in"]]) == [b"one"]
state = f.getFMUState()
f.setString([number["a.String_in"]], ["another text"])
f.setFMUState(state)
assert f.getString([number["a.String_in"]]) == [b"one"]
kept = f.serializeFMUState(state)
f.setString([number["a.String_in"]], ["a third"])
f.setFMUState(f.deserializeFMUState(kept))
assert f.getString([number["a.String_in"]]) == [b"one"]
try:
    f.setupExperiment(startTime=5.0)
except Exception:
    print("alive")
"""


def test_types_texts_and_messages_are_as_they_should_be_in_a_host_of_fmi_2(
    carried: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whole numbers of 8 bits are Integers there: one that they do not hold is refused, and nothing has changed."""
    system = read_system(tmp_path, carried, {"a": ("feedthrough3", "1 ms")}, [], stop="0.1 s", algorithm="jacobi")
    monkeypatch.setattr(archive, "for_windows", lambda: None)
    export_fmu(system, tmp_path / "whole.fmu")
    names = {v.name: v for v in read_model_description(str(tmp_path / "whole.fmu")).modelVariables}
    assert "a.Int64_in" not in names and "a.Int8_in" in names
    assert "a.Enumeration_in" not in names  # one of its items is beyond the whole numbers of FMI 2.0
    done = python(TYPES, str(tmp_path / "whole.fmu"))
    assert done.stdout.split()[-1:] == ["alive"], done.stderr[-2000:]


def test_what_unknowns_depend_on_at_the_start_is_followed_along_connections(carried: Path, tmp_path: Path) -> None:
    parts = {"a": ("mass", "1 ms", {"x0": 0.1}), "f": ("force", "1 ms", {"k": 40.0})}
    system = read_system(tmp_path, carried, parts, ["a.x -> f.x1"], stop="0.1 s", algorithm="jacobi")
    export_fmu(system, tmp_path / "whole.fmu")
    description = read_model_description(str(tmp_path / "whole.fmu"))
    found = {u.variable.name: {v.name for v in u.dependencies} for u in description.initialUnknowns}
    assert found["f.F"] == {"f.k", "f.d", "f.v1", "f.x2", "f.v2", "a.m", "a.x0", "a.F"}  # f.x1 is driven by a
    assert found["a.x"] == {"a.m", "a.x0", "a.F"}  # it does not state on what it depends at the start
