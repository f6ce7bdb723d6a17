"""Versions, instances and processes: FMUs made with pythonfmu side by side, made, freed and ended."""

from __future__ import annotations

import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from helpers import FIXTURES, last, python, run_of, system_text
from pythonfmu_instance import started, stir
from rovbrush.components.build import build
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.here.fmi2 import Fmi2Instance as Instance


def test_two_versions_of_one_fmu_in_one_process_give_their_own_results(tmp_path: Path, fmus: Path) -> None:
    changed = tmp_path / "new" / "integrator"
    shutil.copytree(FIXTURES / "integrator", changed)
    kernel = changed / "kernel.py"
    before = kernel.read_text()
    kernel.write_text(before.replace("x.x = x.x + h * u.u", "x.x = x.x + 2.0 * h * u.u"))
    assert kernel.read_text() != before
    build(changed, tmp_path)
    (tmp_path / "old.fmu").write_bytes((fmus / "integrator.fmu").read_bytes())
    part = {"x_start": 1.0, "=u": 3.0}
    parts = {
        "old": (str(tmp_path / "old.fmu"), "10 ms", part),
        "new": (str(tmp_path / "integrator.fmu"), "10 ms", part),
    }
    run = run_of(tmp_path, fmus, parts)
    assert last(run, "old.x") == pytest.approx(4.0, abs=1e-12)
    assert last(run, "new.x") == pytest.approx(7.0, abs=1e-12)


def test_instances_of_one_fmu_are_independent(tmp_path: Path, fmus: Path) -> None:
    parts = {f"i{k}": ("integrator", "10 ms", {"=u": float(k), "x_start": 10.0 * k}) for k in range(5)}
    run = run_of(tmp_path, fmus, parts)
    assert [last(run, f"i{k}.x") for k in range(5)] == pytest.approx([11.0 * k for k in range(5)], abs=1e-12)


def test_instances_can_be_made_and_freed_many_times(fmus: Path) -> None:
    fmu = Fmu.open(fmus / "integrator.fmu")
    for k in range(100):
        instance = Instance(fmu, f"i{k}")
        instance.set("x_start", float(k))
        with instance.unguarded():  # FMI 2.0 allows no get before initialization
            assert instance.get("x") == k
        instance.close()
    with started(fmus / "integrator.fmu") as instance:
        assert stir(instance, 0, 1)


RUN = """
import sys
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.run.simulation import simulate
from pathlib import Path
run = simulate(make_plan(load_system(sys.argv[1], Path(sys.argv[2]))), interpreted=True)
print("END" + run.failure.replace(chr(10), " "))
sys.exit(int(sys.argv[3]))
"""


def test_exit_codes_survive_the_end_of_the_process(tmp_path: Path, fmus: Path) -> None:
    """The library of pythonfmu aborts now and then at exit: twenty processes, with healthy and failing runs."""
    inputs = {"=u": 0.0, "=temperature": 0.0, "=speed": 0.0}
    files = []
    for mode in (0, 1):
        path = tmp_path / f"mode{mode}.toml"
        path.write_text(system_text({"p": ("plain", "1 ms", {"mode": mode, **inputs})}, stop="10 ms"))
        files.append(path)
    cases = [(files[k % 4 == 3], (0, 3)[k % 2]) for k in range(20)]
    with ThreadPoolExecutor(2) as pool:
        runs = list(pool.map(lambda case: python(RUN, str(case[0]), str(fmus), str(case[1])), cases))
    assert [run.returncode for run in runs] == [code for _, code in cases], [
        run.stderr for run in runs if run.returncode not in (0, 3)
    ]
    assert all("END" in run.stdout for run in runs)


def test_a_cache_folder_beyond_plain_ascii_is_refused_with_the_mend(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROVBRUSH_CACHE", str(tmp_path / "bürste"))
    with pytest.raises(FmuError, match=r"cache folder .*bürste.*set ROVBRUSH_CACHE"):
        Fmu.open(fmus / "gain.fmu")


def test_an_fmu_in_a_folder_beyond_plain_ascii_runs(fmus: Path, tmp_path: Path) -> None:
    folder = tmp_path / "bürste 刷子"
    folder.mkdir()
    shutil.copy(fmus / "gain.fmu", folder / "gäin.fmu")
    run = run_of(folder, folder, {"g": (str(folder / "gäin.fmu"), "100 ms", {"=u": 2.0, "k": 3.0, "offset": 0.0})})
    assert last(run, "g.y") == 6.0
