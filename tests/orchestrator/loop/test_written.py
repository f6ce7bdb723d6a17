"""The loop's text beside its sources: of these sources, with the bits of the interpreter, and taken without Numba."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import python
from native_build import needs_gcc
from rovbrush.orchestrator.loop.machine import kept_object, written
from rovbrush.orchestrator.loop.machine.compiled import own_hash
from rovbrush.orchestrator.studies.bench.fmus.native import ring

pytestmark = pytest.mark.skipif(written.shipped.target() != "linux64", reason="the text is for Linux on x86-64")

RUN = """
import sys
from rovbrush.orchestrator.loop.machine import kept_object
from rovbrush.orchestrator.loop.machine.compiled import is_compiled, own_hash
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
before = kept_object.is_there(own_hash())
run = simulate(make_plan(load_system(sys.argv[1])))
print(run.failure or run.tables[0].tobytes().hex(), "numba" in sys.modules, before, kept_object.is_there(own_hash()))
"""


def test_the_text_is_of_these_sources() -> None:
    assert written.text(own_hash()), "the loop was changed: run `python -m release.loop --text`"


def test_a_text_of_other_sources_is_not_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(written, "FILE", tmp_path / "loop.ll")
    assert written.text("a" * 24) is None
    written.write("a" * 24, "define void @f() {\n  ret void\n}\n")
    assert written.text("a" * 24) and written.text("b" * 24) is None
    written.FILE.write_bytes(b"\xff\xfe\x00")
    assert written.text("a" * 24) is None


def test_hints_and_long_names_are_left_out_and_nothing_else() -> None:
    made = (
        "; ModuleID = 'a'\ntarget triple = \"x\"\n@_ZN3env = common local_unnamed_addr global ptr null\n"
        "define range(i32 -1, -2) i32 @_ZN4main(ptr captures(none) initializes((0, 8)) %a) local_unnamed_addr #1 {\n"
        "  %p = getelementptr nuw i8, ptr %a, i64 8\n  %q = getelementptr inbounds nuw i8, ptr %a, i64 8\n"
        "  %t = trunc nuw nsw i64 8 to i32\n  %o = or disjoint i32 %t, 1\n  %s = add nuw nsw i32 %o, 1\n"
        "  %l = load i32, ptr %p, align 8, !noalias !0\n  ret i32 %l\n}\n\n"
        "attributes #1 = { nounwind }\n!0 = !{!1}\n"
    )
    assert written.plain(made) == (
        "define i32 @f1(ptr %a) {\n"
        "  %p = getelementptr i8, ptr %a, i64 8\n  %q = getelementptr inbounds i8, ptr %a, i64 8\n"
        "  %t = trunc i64 8 to i32\n  %o = or i32 %t, 1\n  %s = add nuw nsw i32 %o, 1\n"
        "  %l = load i32, ptr %p, align 8\n  ret i32 %l\n}\n"
    )


@needs_gcc
def test_a_first_run_compiles_it_without_numba_and_has_the_bits_of_the_interpreter(tmp_path: Path) -> None:
    given = str(ring(tmp_path, 3, stop="20 ms"))
    first = python(RUN, given, NUMBA_CACHE_DIR=str(tmp_path / "cache"))
    assert first.returncode == 0, first.stderr
    bits, *rest = first.stdout.split()
    assert len(bits) > 100 and rest == ["False", "False", "True"]
    interpreted = python(RUN, given, NUMBA_DISABLE_JIT="1")
    assert interpreted.stdout.split()[0] == bits, interpreted.stderr


def test_where_llvm_does_not_take_it_numba_is_left_to_compile(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(written, "text", lambda digest: "define what no LLVM knows")
    kept_object._path.cache_clear()
    try:
        assert not kept_object.keep_written(own_hash())
        assert kept_object.wanted(own_hash()) and not kept_object.is_there(own_hash())
    finally:
        monkeypatch.undo()
        kept_object._path.cache_clear()
