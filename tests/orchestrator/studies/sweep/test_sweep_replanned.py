"""Sweeps over what a plan depends on: sizes of arrays, and numbers of events."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from arrays_build import chain
from clock_build import clocked
from native_build import needs_gcc
from rovbrush.orchestrator import load
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.studies.sweep.options import Options
from rovbrush.orchestrator.studies.sweep.sweep import sweep

pytestmark = [needs_gcc, pytest.mark.sampled(4)]
PUSHED = """
format = 2
stop_time = "2 s"
[components.p]
fmu = "plant.fmu"
period = "10 ms"
inputs = { u = 0.0 }
[[events]]
name = "push"
at = "1 s"
set = { "p.u" = 2.0 }
[[events]]
name = "enough"
when = "p.x > 0.5"
set = { "p.u" = 0.0 }
[summary]
x = "last p.x"
"""
BROKEN = """
format = 2
stop_time = "1 s"
connections = ["a.x -> p.u"]
[components.a]
fmu = "plant.fmu"
period = "10 ms"
parameters = { x0 = 1.0 }
inputs = { u = 0.0 }
[components.p]
fmu = "plant.fmu"
period = "10 ms"
[[events]]
name = "drift"
at = "200 ms"
fault = "bias"
on = "p.u"
value = 1.0
for = "100 ms"
[summary]
x = "last p.x"
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    clocked(tmp_path / "plant.fmu", "plant")
    (tmp_path / "pushed.toml").write_text(PUSHED, encoding="utf-8")
    (tmp_path / "broken.toml").write_text(BROKEN, encoding="utf-8")
    return tmp_path


def swept(path: Path, *vary: str, **options: object) -> dict[str, list[float]]:
    """The figures of merit over all points."""
    done = sweep(str(path), path.parent / "out", Options(vary=vary, workers=2, **options))  # type: ignore[arg-type]
    dataset = done.require_all()
    return {str(name): dataset[name].values.ravel().tolist() for name in dataset.data_vars if name != "error"}


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("vary", "x"), [
    ("events.push.at=1.9,1.95,1.99", [0.2, 0.1, 0.02]), ("events.push.at=1900 ms:1980 ms:3", [0.2, 0.12, 0.04]),
    ("events.push.set.p.u=0.1,0.2", [0.1, 0.2]), ("events.enough.threshold=0.3:0.9:3", [0.3, 0.6, 0.9]),
])  # fmt: skip
def test_numbers_of_an_event_are_varied(vary: str, x: list[float], folder: Path) -> None:
    """x' = u: what is pushed from `at` on, until it is enough; the crossing is seen within a step of 0.01 s."""
    assert swept(folder / "pushed.toml", vary)["x"] == pytest.approx(x, abs=1e-12 if "push" in vary else 0.0201)


def test_the_value_and_the_length_of_a_fault_are_varied_together(folder: Path) -> None:
    found = swept(folder / "broken.toml", "events.drift.value=1,2", "events.drift.for=0.1,0.4")["x"]
    assert found == pytest.approx([1.0 + value * length for value in (1.0, 2.0) for length in (0.1, 0.4)], abs=1e-12)


def test_a_number_of_an_event_is_set_for_a_run(folder: Path) -> None:
    result = load(folder / "pushed.toml", values={"events.push.at": "1.95 s", "events.push.set.p.u": 1.0}).run()
    assert float(result["p.x"][-1]) == pytest.approx(0.05, abs=1e-12)


@pytest.mark.parametrize(("vary", "words"), [
    ("events.gust.at=1,2", r"no event is called 'gust'; did you mean 'push'\? \(pushed.toml\)"),
    ("events.push.value=1,2", "event push has no fault, whose value that is"),
    ("events.push.threshold=1,2", "event push has no crossing"),
    ("events.push.until=1,2", "event push: until goes with a fault"),
    ("events.push.until=a,b", "events.push.until: until = 'a' is not a time"),
    ("events.push.set.p.v=1,2", "has no number 'set.p.v'; did you mean 'set.p.u'"),
    ("events.push.set.p.u=1,two", "'two' is no number in the unit of its signal"),
])  # fmt: skip
def test_what_is_no_number_of_an_event_is_told_before_the_start(vary: str, words: str, folder: Path) -> None:
    with pytest.raises(InputError, match=words):
        swept(folder / "pushed.toml", vary)
    assert not (folder / "out" / "points.jsonl").exists()


def test_sizes_of_arrays_are_varied(tmp_path: Path) -> None:
    """A chain of n members that decay into each other: what is left in all of them after 1 s."""
    chain(tmp_path / "chain.fmu")
    text = 'format = 2\nstop_time = "1 s"\n[components.a]\nfmu = "chain.fmu"\nperiod = "10 ms"\n'
    (tmp_path / "s.toml").write_text(text + 'parameters = { k = 2.0 }\n[summary]\ntotal = "last a.total"\n')
    found = swept(tmp_path / "s.toml", "a.n=2,3,5", values={"a.x0": 1.0})["total"]
    alone = [load(tmp_path / "s.toml", values={"a.n": n, "a.x0": 1.0}).run() for n in (2, 3, 5)]
    assert found == [float(result["a.total"][-1]) for result in alone] and len(set(found)) == 3


def test_an_impossible_size_and_a_missing_element_are_told_before_the_start(tmp_path: Path) -> None:
    chain(tmp_path / "chain.fmu")
    text = 'format = 2\nstop_time = "1 s"\n[components.a]\nfmu = "chain.fmu"\nperiod = "10 ms"\n'
    path = tmp_path / "s.toml"
    path.write_text(text + '[summary]\nlast = "last a.amount[3]"\n')
    with pytest.raises(InputError, match=r"a\.n"):
        swept(path, "a.n=3,100000", values={"a.x0": 1.0})
    with pytest.raises(InputError, match=r"amount\[3\]"):
        swept(path, "a.n=2,3", values={"a.x0": 1.0})
    assert not (tmp_path / "out" / "points.jsonl").exists()


def test_an_fmu_alone_is_swept_over_its_sizes(tmp_path: Path) -> None:
    """The last values of its outputs; of elements that are not there for a size there is no number."""
    path = chain(tmp_path / "chain.fmu")
    found = swept(path, "n=2,3", stop="100 ms", values={"x0": 1.0})
    assert math.isnan(found["x[3]_last"][0]) and math.isfinite(found["x[3]_last"][1])
    assert found["x[2]_last"][0] == found["x[2]_last"][1]


@pytest.mark.sampled(16)
@pytest.mark.parametrize("text", ["e", "-", ".", "1e", "+-1", "1.2.3", "nan", "inf", "1e400", "0x1", "", "one"])
@pytest.mark.parametrize("key", ["push.at", "push.set.p.u", "enough.threshold", "enough.after"])
def test_what_only_looks_like_a_number_of_an_event_is_one_clear_error(key: str, text: str, folder: Path) -> None:
    with pytest.raises(InputError, match=r"event (push|enough)"):
        load(folder / "pushed.toml", values={f"events.{key}": text})
