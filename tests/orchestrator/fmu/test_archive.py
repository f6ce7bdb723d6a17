"""What an archive from a stranger may hold."""

from __future__ import annotations

import stat
import zipfile
from pathlib import Path

import pytest
from helpers import edited
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.files import archive
from rovbrush.orchestrator.fmu.files.unpacked import unpack
from rovbrush.orchestrator.fmu.tolerant.rules import TWICE, Notes


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache folder."""
    folder = tmp_path / "cache"
    monkeypatch.setenv("ROVBRUSH_CACHE", str(folder))
    return folder


def packed(path: Path, *entries: str | zipfile.ZipInfo, content: bytes = b"x") -> Path:
    with zipfile.ZipFile(path, "w") as file:
        for entry in entries:
            file.writestr(zipfile.ZipInfo(entry) if isinstance(entry, str) else entry, content)
    return path


@pytest.mark.parametrize(
    ("names", "words"),
    [
        (["a", "a/b"], "entry 'a' is a file and a folder"),
        (["a/", "a"], "entry 'a' is a file and a folder"),
        (["a/b/c/d", "a/b"], "entry 'a/b' is a file and a folder"),
        (["."], "has a name that no file may have"),
        (["a\nb"], "has a name that no file may have"),
        (["\x7f"], "has a name that no file may have"),
        ([".rovbrush/manifest.json"], "has a name that no file may have"),
        (["x" * 256], "has too long a name"),
        (["ä" * 128], "has too long a name"),
        (["x/" * 600 + "x"], "has too long a name"),
    ],
)
def test_names_that_are_no_single_file_are_refused(names: list[str], words: str, tmp_path: Path) -> None:
    with pytest.raises(FmuError) as error:
        unpack(packed(tmp_path / "bad.fmu", *names))
    assert words in str(error.value) and len(str(error.value)) < 500


@pytest.mark.parametrize("other", ["resources/./a", "resources\\a", "resources//a"])
def test_two_contents_for_one_file_are_refused_and_one_is_taken_once(other: str, tmp_path: Path) -> None:
    same, notes = packed(tmp_path / "same.fmu", "resources/a", other), Notes()
    with archive.opened(same, notes=notes) as (_, contents):
        assert list(contents) == ["resources/a"]
    assert TWICE in {note.rule for note in notes.all()}
    with zipfile.ZipFile(same, "a") as file:
        file.writestr("resources/././a", b"y")
    with pytest.raises(FmuError, match="entry 'resources/a' is there twice with different contents; pack one of them"):
        unpack(same)


def test_an_entry_without_a_name_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FmuError, match="entry '' has a name that no file may have"):
        unpack(packed(tmp_path / "bad.fmu", ""))


def test_parts_that_say_nothing_are_passed_over(tmp_path: Path) -> None:
    folder, _ = unpack(packed(tmp_path / "good.fmu", "./", "./a", "b//c", "d/./e"))
    assert {p.relative_to(folder).as_posix() for p in folder.rglob("?") if p.is_file()} == {"a", "b/c", "d/e"}


@pytest.mark.parametrize("kind", [stat.S_IFLNK, stat.S_IFIFO, stat.S_IFCHR, stat.S_IFBLK, stat.S_IFSOCK])
def test_only_files_and_folders_are_unpacked(kind: int, tmp_path: Path) -> None:
    info = zipfile.ZipInfo("resources/thing")
    info.create_system, info.external_attr = 3, (kind | 0o777) << 16
    with pytest.raises(
        FmuError, match=r"is a symbolic link, .*; pack the file itself|is no file and no folder; leave it out"
    ):
        unpack(packed(tmp_path / "bad.fmu", info))


def test_files_that_may_be_executed_still_may(tmp_path: Path) -> None:
    program, text = zipfile.ZipInfo("resources/program"), zipfile.ZipInfo("resources/text")
    program.external_attr, text.external_attr = (stat.S_IFREG | 0o755) << 16, (stat.S_IFREG | 0o666) << 16
    folder, _ = unpack(packed(tmp_path / "good.fmu", program, text))
    assert (folder / "resources/program").stat().st_mode & 0o777 == 0o755
    assert not (folder / "resources/text").stat().st_mode & 0o111


def test_no_right_of_a_stranger_is_taken_over_but_the_one_to_execute(tmp_path: Path) -> None:
    info = zipfile.ZipInfo("resources/program")
    info.external_attr = (stat.S_IFREG | 0o6777) << 16
    folder, _ = unpack(packed(tmp_path / "good.fmu", info))
    assert (folder / "resources/program").stat().st_mode & 0o7777 == 0o755


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_other_methods_of_compression_than_the_standard_allows_are_refused(method: int, tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "bad.fmu", "w", method) as file:
        file.writestr("modelDescription.xml", b"<x/>" * 100)
    with pytest.raises(FmuError, match="compressed by a method that FMI does not allow"):
        unpack(tmp_path / "bad.fmu")


def test_a_hundred_thousand_empty_files_are_refused(tmp_path: Path, own_cache: Path) -> None:
    path = packed(tmp_path / "bad.fmu", *(f"resources/{k}" for k in range(archive.MOST + 1)), content=b"")
    with pytest.raises(FmuError, match=r"has 50001 entries, more than 50000; pack it with fewer files"):
        unpack(path)
    assert not list((own_cache / "fmus").iterdir())


def test_the_budget_is_one_for_all_entries(fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(archive, "LARGEST", 1 << 20)
    parts: dict[str, bytes | None] = {f"resources/{k}": bytes(1 << 18) for k in range(4)}
    with pytest.raises(FmuError, match="would unpack to more than"):
        unpack(edited(fmus / "gain.fmu", tmp_path / "bad.fmu", parts))


@pytest.mark.parametrize("date", [(1980, 0, 0, 0, 0, 0), (2107, 15, 31, 31, 63, 62), (1980, 1, 1, 0, 0, 0)])
def test_a_date_that_is_none_is_no_trouble(date: tuple[int, ...], tmp_path: Path) -> None:
    info = zipfile.ZipInfo("a")
    info.date_time = date  # type: ignore[assignment]
    path = packed(tmp_path / "odd.fmu", info)
    assert unpack(path) == unpack(path)
