"""Compiled kernels are kept where only this user writes, and a damaged file is compiled anew."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

# Compiles a kernel for one type of argument, and tells its answer and how often the cache had it.
RUN = """
import json
import sys
from pathlib import Path
import numba
from rovbrush.components.python.kernel_cache import stored
from rovbrush.components.python.numba_files import CheckedCache
import importlib.util
path = stored("double_" + "0" * 24, "def double(x):\\n    return x + x\\n")
spec = importlib.util.spec_from_file_location("double", path)
module = importlib.util.module_from_spec(spec)
sys.modules["double"] = module
spec.loader.exec_module(module)
double = numba.njit(module.double)
double._cache = CheckedCache(module.double)
print(*[double(x) for x in json.loads(sys.argv[1])], sum(double.stats.cache_hits.values()), path)
"""


@pytest.fixture(scope="module")
def filled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A cache that a process has filled."""
    cache = tmp_path_factory.mktemp("filled") / "cache"
    run(cache)
    return cache


def run(cache: Path, arguments: str = "[2.0]", **environment: str) -> list[str]:
    done = subprocess.run(
        [sys.executable, "-c", RUN, arguments],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "ROVBRUSH_CACHE": str(cache), **environment},
    )
    return done.stdout.split()


def kept(cache: Path) -> list[Path]:
    return sorted((cache / "kernels").rglob("*.nb[ci]"))


def test_a_second_process_takes_what_the_first_compiled(tmp_path: Path) -> None:
    assert run(tmp_path / "cache")[:2] == ["4.0", "0"]
    assert run(tmp_path / "cache")[:2] == ["4.0", "1"]


def test_a_cache_that_was_copied_is_taken(filled: Path, tmp_path: Path) -> None:
    assert run(shutil.copytree(filled, tmp_path / "cache"))[:2] == ["4.0", "1"]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("suffix", [".nbc", ".nbi"])
@pytest.mark.parametrize("how", ["emptied", "truncated", "one bit flipped", "missing"])
def test_a_damaged_file_is_compiled_anew(how: str, suffix: str, filled: Path, tmp_path: Path) -> None:
    cache = shutil.copytree(filled, tmp_path / "cache")
    (file,) = (path for path in kept(cache) if path.suffix == suffix)
    content = file.read_bytes()
    flipped = content[:-200] + bytes([content[-200] ^ 1]) + content[-199:]
    if how == "missing":
        file.unlink()
    else:
        file.write_bytes({"emptied": b"", "truncated": content[:-100], "one bit flipped": flipped}[how])
    assert run(cache)[:2] == ["4.0", "0"]
    assert run(cache)[:2] == ["4.0", "1"]


def test_a_damaged_source_is_written_anew(filled: Path, tmp_path: Path) -> None:
    cache = shutil.copytree(filled, tmp_path / "cache")
    (path,) = cache.rglob("kernel.py")
    path.write_text("def double(x):\n    return 666.0\n")
    assert run(cache)[0] == "4.0" and path.read_text().startswith("def double(x):\n    return x + x")


def test_processes_that_compile_for_two_types_take_two_files(filled: Path, tmp_path: Path) -> None:
    cache = shutil.copytree(filled, tmp_path / "cache")
    (index,) = cache.rglob("*.nbi")
    before = index.read_bytes()
    run(cache, "[2]")
    index.write_bytes(before)  # as if both had begun before either had ended
    assert run(cache, "[2, 2.0]")[:2] == ["4", "4.0"] and len(list(cache.rglob("*.nbc"))) == 3


@pytest.mark.parametrize("which", [".", "kernels", "users"])
def test_a_folder_that_others_can_write_to_is_refused(which: str, filled: Path, tmp_path: Path) -> None:
    cache = shutil.copytree(filled, tmp_path / "cache")
    (cache / which).chmod(0o777)
    with pytest.raises(subprocess.CalledProcessError) as error:
        run(cache)
    assert "other users can write to the cache folder" in error.value.stderr


def test_where_there_is_no_cache_a_private_folder_is_used_that_ends_with_the_process(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    (tmp_path / "temporary").mkdir()
    used = Path(run(tmp_path / "file", TMPDIR=str(tmp_path / "temporary"))[2])
    assert used.is_relative_to(tmp_path / "temporary") and not used.exists()
    assert not list((tmp_path / "temporary").iterdir())
