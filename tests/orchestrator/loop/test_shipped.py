"""The loop's library of a wheel gives the bits of the loop that Numba compiles, and of the interpreter."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from helpers import plan_of, python
from native_build import feedthrough2, feedthrough3, needs_gcc
from rovbrush.orchestrator.fmu.files.windows import wine
from rovbrush.orchestrator.loop import run
from rovbrush.orchestrator.loop.cells import ENDS_AT, EVENT_AT, GAVE_UP, NEVER
from rovbrush.orchestrator.loop.machine.compiled import compiled_run, own_hash
from rovbrush.orchestrator.loop.machine.frame import ARRAYS, CELLS, FLOATS, NUMBERS, TABLE, Loop
from rovbrush.orchestrator.loop.machine.shipped import Library, file_name
from rovbrush.orchestrator.loop.operations import COPY, LINEAR, MEAN, MIX, QUADRATIC, SAMPLE
from rovbrush.orchestrator.run.session import session
from rovbrush.orchestrator.run.simulation import simulate
from windows_build import needs_wine

RUN = """
import sys
sys.modules |= dict.fromkeys(["numba", "llvmlite"] if sys.argv[2] == "alone" else [])
from pathlib import Path
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
run = simulate(make_plan(load_system(sys.argv[1], Path(sys.argv[1]).parent)))
print(run.failure or run.tables[0].tobytes().hex(), "numba" in sys.modules and sys.modules["numba"] is not None)
"""
SYSTEM = """
format = 2
stop_time = "50 ms"
{more}
connections = [{links}]
[components.a]
fmu = "{fmu}.fmu"
period = "1 ms"
inputs = {{ {inputs} }}
[components.b]
fmu = "{fmu}.fmu"
period = "2 ms"
"""


TWO = (feedthrough2, 'u = 0.3, n_in = 7, mode_in = 2, on_in = true, s_in = "one"', [("y", "u"), ("s_out", "s_in")])
Make = Callable[[Path], Path]
KINDS = ("Float64", "Float32", "Int8", "UInt64", "String")
THREE = (
    feedthrough3, 'Float64_in = 0.3, Float32_in = 0.3, Int8_in = -3, UInt64_in = 9, String_in = "one"',
    [(f"{kind}_out", f"{kind}_in") for kind in KINDS],
)  # fmt: skip


@pytest.mark.sampled(2)
@needs_gcc
@pytest.mark.parametrize(("make", "inputs", "links"), [TWO, THREE], ids=["FMI 2.0", "FMI 3.0"])
@pytest.mark.parametrize("more", ["", 'algorithm = "gauss-seidel"'])
def test_a_run_needs_no_compiler_and_has_the_same_bits(
    make: Callable[[Path], Path],
    inputs: str,
    links: list[tuple[str, str]],
    more: str,
    tmp_path: Path,
    loop_library: Path,
) -> None:
    make(tmp_path / "a.fmu")
    text = SYSTEM.format(fmu="a", more=more, inputs=inputs, links=", ".join(f'"a.{a} -> b.{b}"' for a, b in links))
    (tmp_path / "case.toml").write_text(text)
    alone = python(RUN, str(tmp_path / "case.toml"), "alone", ROVBRUSH_LOOP=str(loop_library))
    compiled = python(RUN, str(tmp_path / "case.toml"), "", ROVBRUSH_LOOP="compile")
    assert alone.returncode == 0, alone.stderr
    bits, used = alone.stdout.split()
    assert used == "False"
    assert len(bits) > 100 and compiled.stdout.split() == [bits, "True"], compiled.stderr


def test_with_numba_switched_off_the_library_is_not_taken_either(loop_library: Path) -> None:
    code = (
        "import sys; sys.modules |= dict.fromkeys(['numba', 'llvmlite'])\n"
        "from rovbrush.orchestrator.loop.machine.compiled import compiled_run, require_loop\n"
        "from rovbrush.orchestrator.participant.here.message_filter import filtered\n"
        "require_loop(); print(compiled_run()); assert filtered(2, 1)"
    )
    given = {"ROVBRUSH_LOOP": str(loop_library)}
    assert "frame.Loop object" in python(code, **given).stdout
    off = python(code, NUMBA_DISABLE_JIT="1", **given)
    assert off.returncode == 0 and off.stdout.startswith("<function run "), off.stderr


def arrays() -> tuple[list[np.ndarray], tuple[int, ...]]:
    """Arguments of `run.run` for operations on numbers only, with a table of a signal; none of an FMU."""
    rng = np.random.default_rng(7)
    codes = (COPY, LINEAR, MEAN, QUADRATIC, MIX, SAMPLE)
    rows = [[code, 3 * k, -1, k % 5, 5 + k % 6, (k + 1) % 5, (k + 2) % 5, 4 * k] for k, code in enumerate(codes * 4)]
    for row in rows:
        if row[0] == SAMPLE:
            row[7] = 100
    coefficients = np.concatenate([rng.normal(size=100), [3.0, 0.0, 1.0, 2.0, 0.5, -0.25, 0.125]])
    made = {TABLE: np.zeros((0, 8), dtype=np.int64), CELLS: np.zeros(32, dtype=np.int64), NUMBERS: np.zeros(4)}
    dtypes = {FLOATS: np.float32, "bytes": np.uint8}
    found = [made[kind].copy() if kind in made else np.zeros(8, dtype=dtypes[kind]) for kind in ARRAYS]
    found[0], found[1], found[4] = np.array(rows, dtype=np.int64), coefficients, rng.normal(size=16)
    found[14][[ENDS_AT, EVENT_AT]] = NEVER
    return found, (2, 50, 100, 1, 1000)


def test_the_operations_on_numbers_have_one_result_in_all_lives(loop_library: Path) -> None:
    library = Library(next(loop_library.glob(f"linux64/loop_{own_hash()}.so")))
    ends = []
    for function in (run.run, compiled_run(), Loop(library.address, library)):
        given, numbers = arrays()
        ends.append((function(*given, *numbers), given[4].tobytes(), given[14].tobytes()))
    before = arrays()[0][4].tobytes()
    assert ends[0][0] == 0 and ends[0][1] != before and ends[0] == ends[1] == ends[2]


def test_machine_code_that_gives_up_ends_the_run_with_words(
    tmp_path: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan = plan_of(tmp_path, fmus, {"a": ("integrator", "10 ms", {"=u": 0.3})}, stop="100 ms")
    monkeypatch.setattr(session, "compiled_run", lambda **_: lambda *_: GAVE_UP)
    assert "the compiled loop gave up" in simulate(plan).failure


def test_an_array_of_another_kind_is_refused(loop_library: Path) -> None:
    given, numbers = arrays()
    library = Library(next(loop_library.glob("linux64/*.so")))
    for wrong in (given[4].astype(np.float32), given[4][::2]):
        with pytest.raises(TypeError, match="argument 4 of the loop: numbers wanted"):
            Loop(library.address, library)(*given[:4], wrong, *given[5:], *numbers)


def test_a_library_of_other_sources_is_not_taken(loop_library: Path, tmp_path: Path) -> None:
    (tmp_path / "linux64").mkdir()
    shutil.copy(next(loop_library.glob("linux64/*.so")), tmp_path / file_name("of_others", "linux64"))
    code = (
        "from rovbrush.orchestrator.loop.machine import compiled, shipped\n"
        "print(shipped.library(compiled.own_hash()), bool(shipped.library('of_others')))"
    )
    assert python(code, ROVBRUSH_LOOP=str(tmp_path)).stdout.split() == ["None", "True"]


@needs_wine
def test_the_library_for_windows_gives_the_same_bits(loop_library: Path, tmp_path: Path) -> None:
    """A few lines of C load it under wine and call it with the arrays of a file."""
    compiler = shutil.which("x86_64-w64-mingw32-gcc")
    if compiler is None:
        pytest.skip("no compiler for Windows")
    given, numbers = arrays()
    with (tmp_path / "in.bin").open("wb") as file:
        for array in given:
            rows, columns = array.shape if array.ndim == 2 else (*array.shape, 1)
            file.write(np.array([rows, columns, array.nbytes], dtype=np.int64).tobytes() + array.tobytes())
        file.write(np.array(numbers, dtype=np.int64).tobytes())
    (tmp_path / "call.c").write_text(HARNESS.replace("COUNT", str(len(ARRAYS))))
    subprocess.run([compiler, "-O1", "-o", str(tmp_path / "call.exe"), str(tmp_path / "call.c")], check=True)
    dll = shutil.copy(next(loop_library.glob("win64/*.dll")), tmp_path / "loop.dll")
    done = subprocess.run(
        [str(wine("win64")), "call.exe", Path(dll).name], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    status = run.run(*given, *numbers)
    assert done.stdout.split()[-1] == str(status)
    assert (tmp_path / "out.bin").read_bytes() == given[4].tobytes()


HARNESS = r"""
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <windows.h>
int main(int count, char **words) {
    int64_t frame[COUNT][3], head[3], n[5];
    FILE *in = fopen("in.bin", "rb"), *out;
    for (int k = 0; k < COUNT; k++) {
        fread(head, 8, 3, in);
        void *values = calloc(head[2] + 8, 1);
        fread(values, 1, head[2], in);
        frame[k][0] = (int64_t)values; frame[k][1] = head[0]; frame[k][2] = head[1];
    }
    fread(n, 8, 5, in);
    HMODULE library = LoadLibraryA(words[1]);
    if (!library) return 3;
    int64_t (*loop)(int64_t, int64_t, int64_t, int64_t, int64_t, int64_t);
    loop = (void *)GetProcAddress(library, "rovbrush_loop");
    if (!loop) return 4;
    int64_t status = loop((int64_t)frame, n[0], n[1], n[2], n[3], n[4]);
    out = fopen("out.bin", "wb");
    fwrite((void *)frame[4][0], 8, frame[4][1], out);
    fclose(out);
    printf("%lld\n", (long long)status);
    return 0;
}
"""
