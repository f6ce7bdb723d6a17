"""A run does not depend on the runs before it, nor on what else is in its process: libraries and modules apart."""

from __future__ import annotations

import csv
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from helpers import column, plan_of, python, rovbrush
from native_build import moody, needs_gcc
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.fmu.sharing import imports_late, why_alone
from rovbrush.orchestrator.participant.apart.library import fresh_library
from rovbrush.orchestrator.participant.isolated.parent import IsolatedInstance
from rovbrush.orchestrator.participant.opening import load
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan
from rovbrush.orchestrator.run.session.session import Session
from rovbrush.orchestrator.run.simulation import simulate

needs_fork = pytest.mark.skipif(not hasattr(os, "fork"), reason="isolation needs Linux or macOS")
linux = pytest.mark.skipif(sys.platform != "linux", reason="symbols of ELF")
COUNTS = "m->u = ever"  # x gets the steps that this library has made, over all instances
ONCE = 'canBeInstantiatedOnlyOncePerProcess="true"'


def counting(folder: Path, *names: str, flags: str = "", model: str = "m", **more: str) -> Plan:
    """Components of one FMU that counts the steps of its library.

    A `model` of its own is one that no other test has used in this process: the cache knows FMUs by their content.
    """
    moody(folder / f"{model}.fmu", flags, ON_STEP=COUNTS, **more)
    return plan_of(folder, folder, {name: (model, "1 ms", {"=u": 0.0}) for name in names}, stop="5 ms")


def end(plan: Plan, name: str) -> float:
    return float(column(simulate(plan), f"{name}.x")[1][-1])


FRESH = pytest.approx(1e-3 * (1 + 2 + 3 + 4 + 5), rel=1e-12)


@needs_gcc
def test_a_library_begins_afresh_with_every_run_of_a_process(tmp_path: Path) -> None:
    plan = counting(tmp_path, "a")
    assert [end(plan, "a") for _ in range(4)] == [FRESH] * 4


@needs_gcc
def test_two_components_of_one_fmu_do_not_meet(tmp_path: Path) -> None:
    run = simulate(counting(tmp_path, "a", "b", "c"))
    assert [float(column(run, f"{name}.x")[1][-1]) for name in "abc"] == [FRESH] * 3


@needs_gcc
def test_nor_do_two_sessions_at_once(tmp_path: Path) -> None:
    with Session(counting(tmp_path, "a")) as one, Session(counting(tmp_path, "a")) as other:
        one.advance(cycles=3)
        other.advance()
        one.advance()
        assert one.get("a.x") == other.get("a.x") == FRESH


@pytest.mark.evidence
@needs_gcc
@needs_fork
@pytest.mark.parametrize("flags", ["", ONCE], ids=["counts", "once per process"])
def test_points_of_a_sweep_are_one_whatever_their_order_and_the_number_of_workers(
    flags: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = counting(tmp_path, "a", flags=flags).system.path
    path.write_text(path.read_text() + '[summary]\nx = "last a.x"\n')
    found = []
    for workers, values in (("1", "1,2,3"), ("2", "3,2,1")):
        out = tmp_path / f"out{workers}"
        options = ["--vary", f"a.k={values}", "--out", out, "--workers", workers, "--fmus", tmp_path]
        assert rovbrush(monkeypatch, "sweep", path, *options) == 0
        rows = list(csv.DictReader((out / "sweep.csv").open()))
        found.append({row["a.k [1]"]: next(v for key, v in row.items() if key.startswith("x ")) for row in rows})
    assert found[0] == found[1] and list(map(float, found[0].values())) == [FRESH] * 3


@needs_gcc
def test_a_private_copy_leaves_nothing_behind_and_the_first_use_makes_none(tmp_path: Path) -> None:
    fmu = Fmu.open(moody(tmp_path / "used_first.fmu"))
    before = sorted(fmu.library.parent.iterdir())
    with fresh_library(fmu) as first:
        assert first in before
    with fresh_library(fmu) as second:
        assert second not in before and second.parent == first.parent and second.read_bytes() == first.read_bytes()
    assert sorted(fmu.library.parent.iterdir()) == before


STAYS = {
    "a thread": {"BACKGROUND": "1", "ON_ENTER": "background()"},
    "a handler that is called": {"ON_ENTER": "signal(SIGALRM, (void (*)(int))fmi2GetVersion); ualarm(2000, 2000)"},
}  # fmt: skip


@needs_gcc
@linux
@pytest.mark.parametrize("kind", STAYS)
def test_a_library_stays_where_something_of_it_goes_on_behind_its_end(kind: str, tmp_path: Path) -> None:
    """In a process of its own: what is unloaded too early ends it."""
    plan = counting(tmp_path, "a", **STAYS[kind])
    code = (
        "import sys, time; from rovbrush.orchestrator import load\n"
        "for _ in range(3): print(load(sys.argv[1], fmus=sys.argv[2]).run()['a.x'].values[-1]); time.sleep(0.05)"
    )
    done = python(code, str(plan.system.path), str(tmp_path))
    assert done.returncode == 0, done.stderr
    assert list(map(float, done.stdout.split())) == [FRESH] * 3


@needs_gcc
@linux
def test_and_is_unloaded_where_nothing_does(tmp_path: Path) -> None:
    fmu = Fmu.open(moody(tmp_path / "goes.fmu"))
    instance = load(fmu, "a")
    name = fmu.library.name
    assert name in Path("/proc/self/maps").read_text()
    instance.close()
    assert name not in Path("/proc/self/maps").read_text()


def test_our_own_fmus_keep_nothing_and_stay_loaded(fmus: Path) -> None:
    for name in ("dc_motor", "mission"):
        fmu = Fmu.open(fmus / f"{name}.fmu")
        assert why_alone(fmu) == imports_late(fmu) == ""
        for _ in range(2):
            with fresh_library(fmu) as library:
                assert not library.name.startswith(".")


@needs_gcc
@needs_fork
def test_an_fmu_that_allows_one_instance_gets_processes_and_the_plan_says_why(tmp_path: Path) -> None:
    plan = counting(tmp_path, "a", "b", flags=ONCE, model="once_first")
    assert [c.isolation for c in plan.system.components.values()] == ["", "process"]
    assert "in a process of its own: a is the same FMU, and it allows one instance per process" in " ".join(
        explain(plan).split()
    )
    with Session(plan) as session:
        session.advance()
        kinds = [isinstance(instance, IsolatedInstance) for instance in session.instances.values()]
        assert kinds == [False, True] and session.get("a.x") == session.get("b.x") == FRESH
    with Session(counting(tmp_path, "a", flags=ONCE, model="once_first")) as again:
        assert isinstance(again.instances["a"], IsolatedInstance)
        assert (
            "component a runs in a process of its own: once_first.fmu was used in this process before"
            in again.run().notes[0]
        )


@needs_gcc
@linux
def test_data_that_all_copies_of_a_library_share_are_found(tmp_path: Path) -> None:
    assert why_alone(Fmu.open(moody(tmp_path / "plain.fmu"))) == ""
    unique = Fmu.open(moody(tmp_path / "unique.fmu", UNIQUE="1"))
    assert "shares data among all its copies in a process (ever, STB_GNU_UNIQUE)" in why_alone(unique)


@needs_gcc
@linux
@needs_fork
def test_and_get_a_process_where_they_would_meet(tmp_path: Path) -> None:
    plan = counting(tmp_path, "a", "b", UNIQUE="1")
    run = simulate(plan)
    assert [c.isolation for c in plan.system.components.values()] == ["", "process"]
    assert [float(column(run, f"{name}.x")[1][-1]) for name in "ab"] == [FRESH] * 2
    assert end(plan, "a") == FRESH


# --- Python ---

MODEL = """
from pythonfmu import Fmi2Causality, Fmi2Slave, Real
{imports}
OWN = {value}
class {name}(Fmi2Slave):
    count = 0
    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.own = OWN
        self.helped = helper.VALUE
        self.counted = 0.0
        for name in ("own", "helped", "counted"):
            self.register_variable(Real(name, causality=Fmi2Causality.output))
    def do_step(self, t, h):
        {step}
        type(self).count += 1
        helper.STEPS.append(t)
        self.counted = float(type(self).count + len(helper.STEPS))
        return True
"""


def python_fmu(
    folder: Path, script: str, name: str, value: float, imports: str = "import helper", step: str = "pass"
) -> Path:
    """A Python FMU of somebody else's: a script, and a `helper.py` beside it."""
    folder.mkdir()
    (folder / "helper.py").write_text(f"VALUE = {value}\nSTEPS = []\n")
    (folder / "late.py").write_text("")
    text = MODEL.format(name=name, value=value, imports=imports, step=step)
    (folder / f"{script}.py").write_text(text)
    code = (
        "import sys; from pythonfmu.builder import FmuBuilder;"
        "FmuBuilder.build_FMU(sys.argv[1], sys.argv[2], project_files=sys.argv[3:])"
    )
    files = [f"{script}.py", str(folder), "helper.py", "late.py"]
    subprocess.run([sys.executable, "-c", code, *files], cwd=folder, check=True, capture_output=True)
    return folder / f"{name}.fmu"


def values(folder: Path, *paths: Path) -> list[dict[str, float]]:
    parts = {f"c{k}": (str(path), "0.1 s") for k, path in enumerate(paths)}
    run = simulate(plan_of(folder, folder, parts, stop="0.5 s"))
    assert not run.failure, run.failure
    return [
        {v: float(column(run, f"c{k}.{v}")[1][-1]) for v in ("own", "helped", "counted")} for k in range(len(paths))
    ]


def alone(value: float) -> dict[str, float]:
    return {"own": value, "helped": value, "counted": 10.0}


NAMES = {
    "same script and class": (("model", "Model"), ("model", "Model")),
    "same script, other class": (("model", "One"), ("model", "Two")),
    "own names, same helper": (("first", "First"), ("second", "Second")),
}


@pytest.mark.parametrize("names", NAMES.values(), ids=NAMES.keys())
def test_two_python_fmus_run_their_own_code(names: tuple[tuple[str, str], ...], tmp_path: Path) -> None:
    a, b = (python_fmu(tmp_path / f"f{k}", *names[k], float(k + 1)) for k in range(2))
    modules, path = set(sys.modules), list(sys.path)
    assert values(tmp_path, a, b) == [alone(1.0), alone(2.0)]
    assert values(tmp_path, b, a, b) == [alone(2.0), alone(1.0), alone(2.0)]
    assert sys.path == path
    assert not {name for name in set(sys.modules) - modules if name.split(".")[0] in ("helper", "late", *names[0])}


def test_runs_of_one_python_fmu_do_not_meet(tmp_path: Path) -> None:
    fmu = python_fmu(tmp_path / "f", "model", "Model", 3.0)
    assert [values(tmp_path, fmu)[0] for _ in range(3)] == [alone(3.0)] * 3


def test_a_module_of_the_users_own_program_stays_the_users(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    fmu = python_fmu(tmp_path / "f", "model", "Model", 3.0)
    mine = type(sys)("helper")
    monkeypatch.setitem(sys.modules, "helper", mine)
    assert values(tmp_path, fmu) == [alone(3.0)] and sys.modules["helper"] is mine


LATE = {
    "in a step": {"step": "import late"},
    "from a package in a step": {"step": "from helper import VALUE"},
    "by name": {"imports": "import helper, importlib"},
    "for pickles": {"imports": "import helper\nimport pickle"},
    "by a function": {"step": "__import__('late')"},
}


@needs_fork
@pytest.mark.parametrize("keys", LATE.values(), ids=LATE.keys())
def test_one_that_imports_while_it_runs_gets_a_process_and_the_plan_says_why(
    keys: dict[str, str], tmp_path: Path
) -> None:
    late = python_fmu(tmp_path / "late", "model", "Model", 1.0, **keys)
    plain = python_fmu(tmp_path / "plain", "model", "Model", 2.0)
    assert values(tmp_path, plain, late, plain) == [alone(2.0), alone(1.0), alone(2.0)]
    plan = plan_of(tmp_path, tmp_path, {"a": (str(late), "0.1 s")}, stop="0.5 s")
    assert "in a process of its own: model.py imports" in " ".join(explain(plan).split())


def test_what_python_fmus_give_is_the_same_in_a_process_of_their_own(tmp_path: Path) -> None:
    fmu = python_fmu(tmp_path / "f", "model", "Model", 3.0)
    plan = plan_of(tmp_path, tmp_path, {"a": (str(fmu), "0.1 s")}, stop="0.5 s")
    here = simulate(plan).tables
    path = plan.system.path
    path.write_text(path.read_text().replace("[components.a]\n", '[components.a]\nisolation = "process"\n'))
    from rovbrush.orchestrator.plan.plan import make_plan
    from rovbrush.orchestrator.system.file.reader import load_system

    there = simulate(make_plan(load_system(str(path), tmp_path))).tables
    assert all(np.array_equal(a, b) for a, b in zip(here, there, strict=True))
