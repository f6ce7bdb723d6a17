"""A system as C: its program's rows are those of the run, bit by bit, and it allocates nothing once it has started."""

from __future__ import annotations

import re
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest
from emit_cases import Masses, differing, run_of_system, tables_of
from helpers import column, read_system
from native_build import FREE2, FREE3, needs_gcc
from rovbrush.orchestrator.emit.folder import write_c
from rovbrush.orchestrator.system.assemble import assemble

pytestmark = needs_gcc


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_three_rates_with_every_transfer_are_those_of_the_run(algorithm: str, masses: Masses, tmp_path: Path) -> None:
    system = masses(algorithm=algorithm)
    assert differing(tables_of(system, tmp_path / "c"), run_of_system(system)) == []


def test_what_is_left_behind_the_last_whole_cycle_is_that_of_the_run(masses: Masses, tmp_path: Path) -> None:
    system = masses(stop="50.5 ms")
    assert differing(tables_of(system, tmp_path / "c"), run_of_system(system)) == []


def test_values_given_to_the_program_are_those_given_to_the_run(masses: Masses, tmp_path: Path) -> None:
    """But for the inputs of the loop at the start: for values that the export did not know it is solved anew."""
    tables = tables_of(masses(), tmp_path / "c", "-O1 -w", "f.k=55.5", "a.x0=-0.25")
    run = run_of_system(masses().with_values({"f.k": 55.5, "a.x0": -0.25}, "test"))
    for name in differing(tables, run):
        assert name in ("f.x1", "f.v1", "f.x2", "f.v2", "a.F", "b.F")
        own = column(run, name)[1]
        (their,) = (table[name] for table in tables.values() if name in table)
        assert own[1:].tobytes() == their[1:].tobytes()
        assert abs(own[0] - their[0]) < 1e-12


@pytest.mark.parametrize("version", [2, 3])
def test_whole_numbers_booleans_and_arrays_of_any_type_are_those_of_the_run(
    version: int, carried: Path, tmp_path: Path
) -> None:
    free = FREE2 if version == 2 else FREE3
    wires = [f"a.{v}_out -> b.{v}_in" for v in ("n", "mode", "on")] if version == 2 else []
    wires += (
        [f"a.{v[1:-3]}_out -> b.{v[1:]}" for v in FREE3 if v not in ("=String_in", "=t_in")] if version == 3 else []
    )
    parts = {"a": (f"feedthrough{version}", "1 ms", free), "b": (f"feedthrough{version}", "2 ms")}
    system = read_system(tmp_path, carried, parts, wires, stop="8 ms", algorithm="jacobi")
    known = system.components["a"].fmu
    numbers = [v for v in known.names("input", "output") if known.variables[v].type not in ("String", "Binary")]
    system = replace(system, record=tuple(f"{name}.{v}" for name in "ab" for v in numbers))
    assert differing(tables_of(system, tmp_path / "c"), run_of_system(system)) == []


def test_loops_at_the_start_and_at_every_instant_are_solved_as_in_the_run(carried: Path, tmp_path: Path) -> None:
    """Forces that answer to one another at once: each gives the other a fifth of what it feels, and a bias."""
    parts = {name: ("force", "1 ms", {"k": 0.2, "=x1": 0.5, "=v1": 0.0, "=v2": 0.0}) for name in "ab"}
    system = read_system(tmp_path, carried, parts, ["a.F -> b.x2", "b.F -> a.x2"], stop="5 ms", algorithm="jacobi")
    assert differing(tables_of(system, tmp_path / "c"), run_of_system(system)) == []


COUNTING = """
#include <stdio.h>
#include <stdlib.h>
#include "case.h"
static int counted;
void *__real_malloc(size_t n);
void *__real_calloc(size_t n, size_t m);
void *__real_realloc(void *p, size_t n);
void *__wrap_malloc(size_t n) { counted++; return __real_malloc(n); }
void *__wrap_calloc(size_t n, size_t m) { counted++; return __real_calloc(n, m); }
void *__wrap_realloc(void *p, size_t n) { counted++; return __real_realloc(p, n); }
static case_ s;
int main(void) {
    if (case__open(&s, "case", NULL, NULL, NULL) || case__enter(&s, 0.0, 1, 1.0) || case__start(&s)) return 1;
    const int before = counted;
    for (int k = 0; k < 100; k++)
        if (case__step(&s)) return 1;
    printf("%d %d", before, counted - before);
    case__close(&s);
    return 0;
}
"""


def test_nothing_is_allocated_after_the_start_and_the_header_states_the_cost_of_a_step(
    masses: Masses, tmp_path: Path
) -> None:
    folder = tmp_path / "c"
    write_c(masses(), folder)
    (folder / "counting.c").write_text(COUNTING.replace('"case.h"', '"case_.h"'))
    command = ["make", "CC=gcc -O1 -w", "libcase_.a"]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    wrapped = "-Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc"
    subprocess.run(["gcc", "counting.c", "libcase_.a", "-lm", wrapped, "-o", "counting"], cwd=folder, check=True)
    before, after = map(int, subprocess.run(["./counting"], cwd=folder, capture_output=True, check=True).stdout.split())
    assert before >= 3  # the components themselves
    assert after == 0
    text = (folder / "case_.h").read_text()
    step, cycle = (list(map(int, re.findall(r"(\d+) (?:float|call)", part))) for part in text.split("of a hyperperiod"))
    assert 0 < step[0] <= cycle[0]
    assert 0 < step[1] <= cycle[1]
    subprocess.run(["make", "CC=gcc -O1 -w"], cwd=folder, check=True, capture_output=True)
    speed = subprocess.run(["./case__run", "--speed"], cwd=folder, capture_output=True, text=True, check=True).stdout
    assert re.fullmatch(r"0.1 s in \S+ s of the processor: \S+ times real time\n", speed)
    readme = (folder / "README.md").read_text()
    assert f"| a step, from an instant to the next | {step[0]} | {step[1]} |" in readme
    assert f"| a hyperperiod | {cycle[0]} | {cycle[1]} |" in readme


FUSED = "-O3 -march=x86-64-v3 -w"  # for processors with fused multiply-add
HAS_FUSED = Path("/proc/cpuinfo").is_file() and " fma " in Path("/proc/cpuinfo").read_text()


@pytest.mark.parametrize(
    ("options", "own"),
    [("-O1 -w", ""), pytest.param(FUSED, "CFLAGS=-I.", marks=pytest.mark.skipif(not HAS_FUSED, reason="no such code"))],
)
def test_a_shipped_system_of_native_fmus_gives_the_rows_of_its_run(
    options: str, own: str, native: Path, tmp_path: Path
) -> None:
    """With the options of a tool that knows nothing of bits too: the sources forbid what would change them."""
    system = assemble("test_stand", {}, "50 ms", native / "fmi2")
    assert differing(tables_of(system, tmp_path / "c", f"{options}", make=own), run_of_system(system)) == []
