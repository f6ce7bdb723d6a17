"""The compiled loop is loaded without Numba where its object was kept, and compiled anew where that is damaged."""

from __future__ import annotations

import shutil
from pathlib import Path
from types import SimpleNamespace

import pytest
from helpers import python
from native_build import needs_gcc
from rovbrush.orchestrator.loop.machine import kept_object
from rovbrush.orchestrator.loop.machine.compiled import compiled_loop, own_hash
from rovbrush.orchestrator.loop.machine.objects import read_whole, write_whole
from rovbrush.orchestrator.studies.bench.fmus.native import ring

pytestmark = pytest.mark.skipif(not kept_object.wanted(own_hash()), reason="no object of the loop is loaded here")

RUN = """
import sys
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
run = simulate(make_plan(load_system(sys.argv[1])))
print(run.failure or run.tables[0].tobytes().hex(), "numba" in sys.modules)
"""


@needs_gcc
def test_a_run_with_it_loads_no_numba_and_has_the_same_bits(tmp_path: Path) -> None:
    compiled_loop()
    if not kept_object.is_there(own_hash()):
        pytest.skip("Numba had the loop in its cache before objects were kept")
    given = str(ring(tmp_path, 3, stop="20 ms"))
    kept, compiled = python(RUN, given), python(RUN, given, ROVBRUSH_LOOP="compile")
    assert kept.returncode == 0, kept.stderr
    bits, used = kept.stdout.split()
    assert len(bits) > 100 and used == "False" and compiled.stdout.split() == [bits, "True"]


def test_what_is_damaged_is_not_loaded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    kept_object._path.cache_clear()
    kept_object.loaded.cache_clear()
    try:
        path = kept_object._path(own_hash())
        path.parent.mkdir(parents=True)
        write_whole(path, b"no object at all")
        path.write_bytes(path.read_bytes()[:-1])
        assert read_whole(path) is None and kept_object.is_there(own_hash())
        assert kept_object.loaded(own_hash()) is None and not path.exists()
    finally:
        monkeypatch.undo()
        kept_object._path.cache_clear()
        kept_object.loaded.cache_clear()


def test_a_numba_that_calls_the_loop_otherwise_is_not_asked_twice(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    kept_object._path.cache_clear()
    try:
        library = SimpleNamespace(get_llvm_str=lambda: "define void @other() {\n  ret void\n}\n")
        kept_object.keep(own_hash(), SimpleNamespace(_library=library, _wrapper_name="cfunc.loop"))
        assert not kept_object.wanted(own_hash()) and not kept_object.is_there(own_hash())
    finally:
        monkeypatch.undo()
        kept_object._path.cache_clear()
        shutil.rmtree(tmp_path / "rovbrush")
