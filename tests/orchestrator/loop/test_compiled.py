"""Code of the loop that was compiled from other sources is never taken from Numba's cache."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from helpers import plan_of, python
from rovbrush.orchestrator.loop.machine.compiled import ENTRY, compiled_loop, loop_files, loop_hash, own_hash

HERE = ENTRY
FILES = loop_files(HERE)


def test_the_loop_is_made_of_these_files() -> None:
    own = (
        "run cells exchange calls texts operations iteration step_control step_doubling lookup versions last_step "
        "noise lives entry frame pacing turns"
    )
    assert {path.stem for path in FILES} == {*own.split(), "types"}
    assert {path.parent.name for path in FILES if path.stem == "calls"} == {"loop", "machine"}


@pytest.mark.parametrize("changed", [f"{path.parent.name}/{path.name}" for path in FILES])
def test_a_change_in_any_of_them_gives_another_name_in_the_cache(changed: str, tmp_path: Path) -> None:
    package = HERE.parent.parent.parent
    copied = [tmp_path / path.relative_to(package) for path in FILES]
    for path, copy in zip(FILES, copied, strict=True):
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, copy)
    top = tmp_path / HERE.relative_to(package)
    assert loop_hash(top) == loop_hash(HERE)
    with next(copy for copy in copied if str(copy).endswith(changed)).open("a", encoding="utf-8") as file:
        file.write("# changed\n")
    assert loop_hash(top) != loop_hash(HERE)


def test_numba_keeps_the_compiled_loop_under_that_name() -> None:
    folder = Path(compiled_loop()._cache.cache_path)
    kept = [path.name for path in folder.glob(f"entry.entry_{own_hash()}-*")]
    assert {name.rsplit(".", 1)[1] for name in kept} == {"nbi", "nbc"}


def test_with_numba_switched_off_the_interpreter_runs(tmp_path: Path, fmus: Path) -> None:
    """NUMBA_DISABLE_JIT is an everyday switch for debugging: the same bits, slowly."""
    plan_of(tmp_path, fmus, {"a": ("integrator", "10 ms", {"=u": 0.3})}, stop="100 ms")
    code = (
        "import sys; from pathlib import Path\n"
        "from rovbrush.orchestrator.plan.plan import make_plan\n"
        "from rovbrush.orchestrator.run.simulation import simulate\n"
        "from rovbrush.orchestrator.system.file.reader import load_system\n"
        "run = simulate(make_plan(load_system(sys.argv[1], Path(sys.argv[2]))))\n"
        "print(run.failure or run.tables[0].tobytes().hex())\n"
    )
    arguments = (str(tmp_path / "case.toml"), str(fmus))
    off = python(code, *arguments, NUMBA_DISABLE_JIT="1")
    assert off.returncode == 0, off.stderr
    assert off.stdout == python(code, *arguments).stdout != ""


def test_the_command_runs_with_numba_switched_off_and_says_nothing_of_compiling(tmp_path: Path, fmus: Path) -> None:
    plan_of(tmp_path, fmus, {"a": ("integrator", "10 ms", {"=u": 0.3})}, stop="100 ms")
    code = "import sys; from rovbrush.orchestrator.cli.main import main; main()"
    out = str(tmp_path / "out")
    run = python(code, "run", str(tmp_path / "case.toml"), "--fmus", str(fmus), "--out", out, NUMBA_DISABLE_JIT="1")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "compiles" not in run.stdout and (tmp_path / "out" / "result.nc").is_file()


DOUBLE = """
import sys
sys.path.insert(0, sys.argv[1])
import numba, kept
from rovbrush.orchestrator.loop.machine.kept import CheckedCache
double = numba.njit(kept.double)
double._cache = CheckedCache(kept.double)
print(double(2.0), sum(double.stats.cache_hits.values()))
"""


@pytest.fixture(scope="module")
def filled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with what a process has compiled."""
    folder = tmp_path_factory.mktemp("filled")
    (folder / "kept.py").write_text("def double(x):\n    return x + x\n")
    assert doubled(folder) == ["4.0", "0"]
    return folder


def doubled(folder: Path) -> list[str]:
    """The answer, and how often the cache had what was needed."""
    return python(DOUBLE, str(folder)).stdout.split()


def test_what_is_whole_is_taken(filled: Path, tmp_path: Path) -> None:
    assert doubled(shutil.copytree(filled, tmp_path / "copy")) == ["4.0", "1"]


@pytest.mark.sampled(2)
@pytest.mark.parametrize("suffix", ["nbc", "nbi"])
@pytest.mark.parametrize("cut", [slice(0), slice(-100), slice(40, None)])
def test_a_damaged_file_of_the_compiled_loop_is_compiled_anew(
    suffix: str, cut: slice, filled: Path, tmp_path: Path
) -> None:
    folder = shutil.copytree(filled, tmp_path / "copy")
    (file,) = folder.rglob(f"*.{suffix}")
    file.write_bytes(file.read_bytes()[cut])
    assert [doubled(folder), doubled(folder)] == [["4.0", "0"], ["4.0", "1"]]
