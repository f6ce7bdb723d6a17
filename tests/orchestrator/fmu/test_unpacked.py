"""What is in the cache is what was in the archive, whatever happened to it since."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from helpers import edited
from rovbrush.orchestrator.fmu.files import unpacked
from rovbrush.orchestrator.fmu.files.unpacked import MANIFEST, unpack

KERNEL = "resources/data.bin"  # a file of the archive that is damaged below
CONTENT = bytes(range(256)) * 64


@pytest.fixture
def fmu(fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An FMU that is not unpacked yet."""
    monkeypatch.setenv("ROVBRUSH_CACHE", str(tmp_path / "cache"))
    return edited(fmus / "gain.fmu", tmp_path / "gain.fmu", {KERNEL: CONTENT})


def flip(path: Path) -> None:
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.write_bytes(content)


def swap_for_folder(path: Path) -> None:
    path.unlink()
    (path / "inside").mkdir(parents=True)


def swap_for_link(path: Path) -> None:
    path.rename(path.with_name("elsewhere"))
    path.symlink_to(path.with_name("elsewhere"))


DAMAGES: dict[str, Callable[[Path], None]] = {
    "truncated": lambda path: os.truncate(path, 1000),
    "emptied": lambda path: path.write_bytes(b""),
    "one bit flipped": flip,
    "missing": Path.unlink,
    "its folder missing": lambda path: shutil.rmtree(path.parent),
    "longer": lambda path: path.write_bytes(CONTENT + b"x"),
    "a folder": swap_for_folder,
    "a link": swap_for_link,
}


@pytest.mark.parametrize("damage", DAMAGES.values(), ids=DAMAGES)
@pytest.mark.parametrize("name", [KERNEL, "modelDescription.xml"])
def test_a_damaged_file_is_noticed_and_mended(name: str, damage: Callable[[Path], None], fmu: Path) -> None:
    folder, _ = unpack(fmu)
    before = (folder / name).read_bytes()
    if (folder / name).parent == folder and damage is DAMAGES["its folder missing"]:
        shutil.rmtree(folder)
    else:
        damage(folder / name)
    assert unpack(fmu)[0] == folder
    assert (folder / name).read_bytes() == before and not (folder / name).is_symlink()


@pytest.mark.parametrize(
    "content", [b"", b"{}", b"\xff\xfe", b"0\n{}", b"[" * 100_000], ids=["empty", "json", "bytes", "hash", "deep"]
)
def test_a_damaged_manifest_is_made_anew(content: bytes, fmu: Path) -> None:
    folder, _ = unpack(fmu)
    before = (folder / MANIFEST).read_bytes()
    (folder / MANIFEST).write_bytes(content)
    (folder / KERNEL).write_bytes(b"hidden damage")
    unpack(fmu)
    assert (folder / KERNEL).read_bytes() == CONTENT and (folder / MANIFEST).read_bytes() == before


def test_an_entry_of_an_older_version_gets_a_manifest(fmu: Path) -> None:
    folder, _ = unpack(fmu)
    shutil.rmtree(folder / MANIFEST.split("/")[0])
    (folder / KERNEL).write_bytes(b"older")
    unpack(fmu)
    assert (folder / KERNEL).read_bytes() == CONTENT and (folder / MANIFEST).is_file()


def test_what_is_whole_is_not_hashed_again(fmu: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder, _ = unpack(fmu)

    def no_hash(file: Path) -> str:
        raise AssertionError(f"{file} is hashed")

    monkeypatch.setattr(unpacked, "_hash", no_hash)
    unpack(fmu)
    (folder / KERNEL).touch()
    with pytest.raises(AssertionError, match=r"data\.bin is hashed"):
        unpack(fmu)


def test_a_file_of_another_date_is_hashed_once(fmu: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder, _ = unpack(fmu)
    hashed: list[Path] = []
    original = unpacked._hash
    monkeypatch.setattr(unpacked, "_hash", lambda file: hashed.append(file) or original(file))
    (folder / KERNEL).touch()
    inode = (folder / KERNEL).stat().st_ino
    unpack(fmu)
    unpack(fmu)
    assert hashed == [folder / KERNEL] and (folder / KERNEL).stat().st_ino == inode


def test_a_process_that_has_the_damaged_file_open_is_not_disturbed(fmu: Path) -> None:
    """Each file is put in place by renaming: what is open stays as it is, and the name never leads to half a file."""
    folder, _ = unpack(fmu)
    flip(folder / KERNEL)
    with (folder / KERNEL).open("rb") as reader:
        unpack(fmu)
        assert reader.read() != CONTENT
    assert (folder / KERNEL).read_bytes() == CONTENT


def test_files_that_python_or_the_fmu_put_there_stay(fmu: Path) -> None:
    folder, _ = unpack(fmu)
    (folder / "resources" / "log.txt").write_text("mine")
    (folder / KERNEL).unlink()
    unpack(fmu)
    assert (folder / "resources" / "log.txt").read_text() == "mine"


def test_many_processes_mend_and_use_one_entry_at_one_time(fmu: Path) -> None:
    folder, _ = unpack(fmu)
    code = (
        "import sys, os; from pathlib import Path; from rovbrush.orchestrator.fmu.files.unpacked import unpack\n"
        "for k in range(30):\n"
        "    folder, _ = unpack(Path(sys.argv[1]))\n"
        "    assert len((folder / 'modelDescription.xml').read_bytes()) == int(sys.argv[2])\n"
        "    if k % 10 == int(sys.argv[3]): (folder / '.rovbrush/manifest.json').write_bytes(b'')\n"
        "    if k % 5 == int(sys.argv[3]): (folder / 'resources/data.bin').write_bytes(b'damaged')\n"
    )
    size = (folder / "modelDescription.xml").stat().st_size
    running = [
        subprocess.Popen([sys.executable, "-c", code, str(fmu), str(size), str(k)], stderr=subprocess.PIPE, text=True)
        for k in range(3)
    ]
    for process in running:
        assert process.communicate(timeout=60)[1] == "" and process.returncode == 0
    unpack(fmu)
    assert (folder / KERNEL).read_bytes() == CONTENT
    assert [path.name for path in folder.parent.iterdir()] == [folder.name]
    assert not list((folder.parents[1] / "moving").iterdir())
