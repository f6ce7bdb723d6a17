"""The cache folder is this user's alone, stays below its limit, and loses nothing that a living process needs."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from rovbrush.orchestrator.cache import cache, users
from rovbrush.orchestrator.errors import FmuError, InputError

HOLD = """
import sys
from rovbrush.orchestrator.cache import cache
cache.place("fmus", sys.argv[1])
print("held", flush=True)
sys.stdin.read()
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache folder."""
    monkeypatch.setenv("ROVBRUSH_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def filled(folder: Path, number: int, size: int = 1000) -> Path:
    """An entry of a dead process, the older the smaller its number."""
    entry = folder / "fmus" / f"{number:024x}"
    entry.mkdir(parents=True)
    (entry / "used").touch()
    (entry / "library").write_bytes(bytes(size))
    os.utime(entry / "used", (number, number))
    folder.chmod(0o700)
    (folder / "fmus").chmod(0o700)
    return entry


@pytest.fixture
def other(folder: Path) -> Iterator[Path]:
    """An entry that another process needs as long as the test runs."""
    entry = filled(folder, 1)
    with subprocess.Popen(
        [sys.executable, "-c", HOLD, entry.name], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None and process.stdout.readline() == "held\n"
        yield entry
        process.kill()


def test_the_folder_is_made_for_this_user_alone(folder: Path) -> None:
    before = os.umask(0)
    try:
        entry = cache.place("fmus", "0" * 24)
    finally:
        os.umask(before)
    assert all(made.stat().st_mode & 0o777 == 0o700 for made in (folder, entry.parent, folder / "users"))


def test_a_folder_of_another_user_is_refused(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cache.cache_folder()
    monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    with pytest.raises(FmuError, match=rf"cache folder {folder} belongs to another user .*set ROVBRUSH_CACHE"):
        cache.cache_folder()


@pytest.mark.parametrize("mode", [0o777, 0o770, 0o722, 0o1777])
@pytest.mark.parametrize("which", [".", "fmus", f"fmus/{1:024x}"])
def test_a_folder_that_others_can_write_to_is_refused(mode: int, which: str, folder: Path) -> None:
    entry = filled(folder, 1)
    (folder / which).chmod(mode)
    with pytest.raises(FmuError, match=r"other users can write to the cache folder .*chmod go-w .*ROVBRUSH_CACHE"):
        cache.place("fmus", entry.name)
    (folder / which).chmod(mode & 0o755)
    assert cache.place("fmus", entry.name) == entry


def test_a_link_of_another_user_is_refused(folder: Path, tmp_path: Path) -> None:
    if os.geteuid() != 0:
        pytest.skip("only root can make a link of another user")
    (tmp_path / "real").mkdir(mode=0o700)
    folder.symlink_to(tmp_path / "real")
    os.chown(folder, 12345, 12345, follow_symlinks=False)
    with pytest.raises(FmuError, match="belongs to another user"):
        cache.cache_folder()


def test_the_least_recently_used_entries_go_first(folder: Path) -> None:
    made = [filled(folder, number) for number in (3, 1, 4, 2)]
    left = cache.prune(2500)
    assert [entry.path.name for entry in left] == [f"{number:024x}" for number in (4, 3)]
    assert [entry.is_dir() for entry in made] == [True, False, True, False]
    cache.mark_used(made[0])
    assert [entry.path for entry in cache.prune(1500)] == [made[0]]


def test_what_another_process_needs_stays_and_goes_when_the_process_is_dead(folder: Path, other: Path) -> None:
    newer = filled(folder, 2)
    assert [(entry.path, entry.needed) for entry in cache.entries()] == [(newer, False), (other, True)]
    gone, left = cache.clear()
    assert gone == 1000 and [entry.path for entry in left] == [other] and other.is_dir() and not newer.exists()


def test_what_a_killed_process_needed_and_left_half_unpacked_goes(folder: Path) -> None:
    entry = filled(folder, 1)
    code = HOLD.replace('print("held', 'work = cache.workspace(); work.__enter__(); print("held')
    with subprocess.Popen(
        [sys.executable, "-c", code, entry.name], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None and process.stdout.readline() == "held\n"
        assert len(list((folder / "moving").iterdir())) == 1
        process.kill()
    assert cache.clear()[1] == [] and not entry.exists()
    assert not list((folder / "moving").iterdir())


def test_what_this_process_needs_stays(folder: Path) -> None:
    entry = filled(folder, 1)
    cache.place("fmus", entry.name)
    assert cache.clear() == (0, [next(iter(cache.entries()))]) and entry.is_dir()


def test_a_register_that_an_fmu_has_closed_is_opened_anew(folder: Path) -> None:
    entry, second = filled(folder, 1), filled(folder, 2)
    cache.place("fmus", entry.name)
    os.close(users._own[folder].file)
    stranger = os.open(folder / "result", os.O_RDWR | os.O_CREAT)  # takes the same number
    cache.place("fmus", second.name)
    assert (folder / "result").read_bytes() == b""
    assert {e.path for e in cache.clear()[1]} == {entry, second}
    os.close(stranger)


def test_what_is_not_ours_stays_when_the_cache_is_emptied(folder: Path) -> None:
    strange = [folder / "fmus" / "motor.fmu", folder / "notes.txt", folder / "kernels" / "mine", folder / "fmus" / "x"]
    for path in strange:
        path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        path.touch()
    (folder / "kernels" / f"link_{0:024x}").symlink_to(folder / "notes.txt")
    cache.clear()
    assert all(path.exists() for path in strange) and (folder / "kernels" / f"link_{0:024x}").is_symlink()


def test_entries_of_older_versions_go_too(folder: Path) -> None:
    old = [folder / "kernels" / f"dc_motor_{0:024x}.py", folder / "kernels" / "__pycache__" / "x.nbc"]
    for path in old:
        path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        path.write_bytes(b"old")
    assert cache.clear() == (6, [])
    assert not any(path.exists() for path in old)


def test_the_cache_stays_below_its_limit_as_it_grows(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROVBRUSH_CACHE_LIMIT", "5 kB")
    for number in range(1, 30):
        filled(folder, number)
        cache.grew(1000)
        assert sum(entry.size for entry in cache.entries()) <= 6000
    assert (folder / "fmus" / f"{29:024x}").is_dir()


@pytest.mark.parametrize(
    ("text", "size"),
    [("", 2 * 10**9), ("500 MB", 5 * 10**8), ("1.5GB", 15 * 10**8), ("0", 0), ("1024", 1024)],
)
def test_the_limit_is_a_size(text: str, size: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROVBRUSH_CACHE_LIMIT", text)
    assert cache.limit() == size


@pytest.mark.parametrize("text", ["much", "-1 GB", "1e9", "5 XB", "9" * 5000])
def test_a_limit_that_is_no_size_is_an_error(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROVBRUSH_CACHE_LIMIT", text)
    with pytest.raises(InputError, match=r'ROVBRUSH_CACHE_LIMIT = .* is no size; write for instance "2 GB"'):
        cache.limit()
