"""FMUs come from strangers: what cannot be read or must not be unpacked is refused with a clear message."""

from __future__ import annotations

import os
import shutil
import stat
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import fmpy
import pytest
from helpers import edited, python
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.files import archive as unpacking
from rovbrush.orchestrator.fmu.fmu import Fmu


@pytest.fixture
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache folder."""
    folder = tmp_path / "cache"
    monkeypatch.setenv("ROVBRUSH_CACHE", str(folder))
    return folder


def test_a_cache_folder_may_be_given_relative_to_the_working_directory(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ROVBRUSH_CACHE", "cache")
    assert Fmu.open(fmus / "gain.fmu").folder.parent == tmp_path / "cache" / "fmus"  # FMI takes it as a URI


def refused(path: Path, *words: str) -> None:
    with pytest.raises(FmuError) as error:
        Fmu.open(path)
    for word in (str(path), *words):
        assert word in str(error.value)


def test_a_missing_file_is_named_with_the_mend(tmp_path: Path) -> None:
    refused(tmp_path / "none.fmu", "does not exist", "rovbrush build")
    refused(tmp_path, "is a folder without modelDescription.xml")


@pytest.mark.parametrize("how", ["empty", "no zip", "cut off", "flipped bytes", "bad header"])
def test_a_corrupt_archive_is_refused_and_leaves_nothing_behind(
    how: str, fmus: Path, tmp_path: Path, own_cache: Path
) -> None:
    content = (fmus / "gain.fmu").read_bytes()
    changed = {
        "empty": b"", "no zip": b"hello" * 100, "cut off": content[: len(content) // 2],
        "flipped bytes": content[:2000] + bytes(255 - b for b in content[2000:2400]) + content[2400:],
        "bad header": b"XX" + content[2:40] + b"\0" * 200 + content[240:],
    }[how]  # fmt: skip
    path = tmp_path / "bad.fmu"
    path.write_bytes(changed)
    refused(path, "is not a readable zip archive", "again")
    assert not own_cache.exists() or not list((own_cache / "fmus").iterdir())


@pytest.mark.parametrize(
    "name", ["../evil.txt", "resources/../../evil.txt", "/evil.txt", "..\\evil.txt", "C:\\evil.txt", "C:evil.txt"]
)
def test_entries_that_leave_the_folder_are_refused(name: str, fmus: Path, tmp_path: Path, own_cache: Path) -> None:
    path = shutil.copy(fmus / "gain.fmu", tmp_path / "bad.fmu")
    with zipfile.ZipFile(path, "a") as archive:
        archive.writestr(zipfile.ZipInfo(name), b"evil")
    refused(Path(path), "would leave the unpack folder")
    assert not list(tmp_path.rglob("evil.txt"))


def test_a_symbolic_link_is_refused(fmus: Path, tmp_path: Path, own_cache: Path) -> None:
    path = shutil.copy(fmus / "gain.fmu", tmp_path / "bad.fmu")
    info = zipfile.ZipInfo("resources/link")
    info.create_system, info.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
    with zipfile.ZipFile(path, "a") as archive:
        archive.writestr(info, "/etc/passwd")
    refused(Path(path), "'resources/link' is a symbolic link")


def test_a_bomb_is_refused_before_it_is_unpacked(
    fmus: Path, tmp_path: Path, own_cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(unpacking, "LARGEST", 1 << 20)
    bomb = edited(fmus / "gain.fmu", tmp_path / "bomb.fmu", {"resources/zeros": b"\0" * (1 << 21)})
    refused(bomb, "would unpack to more than")


def test_a_document_type_is_refused(fmus: Path, tmp_path: Path) -> None:
    doctype = '<!DOCTYPE x [<!ENTITY e SYSTEM "file:///etc/passwd">]><fmiModelDescription'
    refused(
        edited(fmus / "gain.fmu", tmp_path / "bad.fmu", {}, {"<fmiModelDescription": doctype}),
        "document type declaration",
    )


def test_a_missing_description_is_refused(fmus: Path, tmp_path: Path) -> None:
    path = tmp_path / "bad.fmu"
    with zipfile.ZipFile(fmus / "gain.fmu") as source, zipfile.ZipFile(path, "w") as archive:
        for name in source.namelist():
            if name != "modelDescription.xml":
                archive.writestr(name, source.read(name))
    refused(path, "has no modelDescription.xml")


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            'fmiVersion="2.0"',
            'fmiVersion="1.0"',
            ["is of FMI version 1.0 and written as a later one", "export it again"],
        ),
        ('fmiVersion="2.0"', 'fmiVersion="4.0"', ["is of FMI version 4.0; version 1.0, 2.0 or 3.0 is needed"]),
        ('fmiVersion="2.0"', 'fmiVersion="3.0"', ["none of its 9 variables can be understood as FMI 3.0 writes them"]),
        ("</fmiModelDescription>", "", ["not well-formed"]),
    ],
)
def test_a_wrong_description_is_refused(old: str, new: str, words: list[str], fmus: Path, tmp_path: Path) -> None:
    refused(edited(fmus / "gain.fmu", tmp_path / "bad.fmu", {}, {old: new}), *words)


def test_an_fmu_for_model_exchange_alone_is_taken_for_one(fmus: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(fmus / "gain.fmu") as archive:
        xml = archive.read("modelDescription.xml").decode()
    tag = xml[xml.index("<CoSimulation") : xml.index("/>", xml.index("<CoSimulation")) + 2]
    path = edited(fmus / "gain.fmu", tmp_path / "bad.fmu", {}, {tag: '<ModelExchange modelIdentifier="gain"/>'})
    assert Fmu.open(path).kind == "model-exchange" and Fmu.open(fmus / "gain.fmu").kind == "co-simulation"


def test_a_missing_binary_names_the_platforms_that_are_there(fmus: Path, tmp_path: Path) -> None:
    own = f"binaries/{fmpy.platform}/gain{fmpy.sharedLibraryExtension}"
    other, elsewhere = "binaries/win64/gain.dll", "binaries/darwin32/gain.dylib"
    bad = edited(fmus / "gain.fmu", tmp_path / "bad.fmu", {own: None, other: None, elsewhere: b"a library"})
    refused(bad, f"no binary for {fmpy.platform}", "it has darwin32")
    refused(edited(fmus / "gain.fmu", tmp_path / "bad2.fmu", {own: None, other: None}), "it has none")


def test_a_broken_binary_is_an_error_with_the_component_name(fmus: Path, tmp_path: Path) -> None:
    from rovbrush.orchestrator.participant.here.fmi2 import Fmi2Instance as Instance

    own = f"binaries/{fmpy.platform}/gain{fmpy.sharedLibraryExtension}"
    fmu = Fmu.open(edited(fmus / "gain.fmu", tmp_path / "bad.fmu", {own: b"no library"}))
    with pytest.raises(FmuError, match=r"component g: bad\.fmu cannot be instantiated"):
        Instance(fmu, "g")


def test_a_broken_component_source_is_an_error_with_its_reason(fmus: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(fmus / "gain.fmu") as archive:
        kernel = next(name for name in archive.namelist() if name.endswith("/kernel.py"))
    path = edited(fmus / "gain.fmu", tmp_path / "bad.fmu", {kernel: b"import nonexistent_module_x\n"})
    # In a process of its own: the package keeps its name, and Python would find the one it has imported before.
    run = python(
        "import sys; from rovbrush.orchestrator.fmu.fmu import *; "
        "from rovbrush.orchestrator.participant.opening import load; "
        "load(Fmu.open(Path(sys.argv[1])), 'g')",
        str(path),
    )
    assert run.returncode == 1
    assert "component g: bad.fmu cannot be instantiated" in run.stderr and "nonexistent_module_x" in run.stderr


def test_the_same_content_is_unpacked_once(fmus: Path, tmp_path: Path, own_cache: Path) -> None:
    first = Fmu.open(fmus / "gain.fmu").folder
    marker = first / "marker"
    marker.touch()
    assert Fmu.open(Path(shutil.copy(fmus / "gain.fmu", tmp_path / "other name.fmu"))).folder == first
    assert marker.exists() and len(list((own_cache / "fmus").iterdir())) == 1


def test_many_at_once_unpack_into_one_folder(fmus: Path, own_cache: Path) -> None:
    with ThreadPoolExecutor(8) as pool:
        folders = {fmu.folder for fmu in pool.map(Fmu.open, [fmus / "gain.fmu"] * 16)}
    assert len(folders) == 1 and len(list((own_cache / "fmus").iterdir())) == 1


def test_an_unwritable_cache_is_named_with_the_mend(
    fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setenv("ROVBRUSH_CACHE", str(tmp_path / "file"))
    with pytest.raises(FmuError, match=r"cannot write to the cache folder .*set ROVBRUSH_CACHE"):
        Fmu.open(fmus / "gain.fmu")


@pytest.mark.skipif(os.geteuid() == 0 if hasattr(os, "geteuid") else True, reason="root reads everything")
def test_an_unreadable_file_is_named(fmus: Path, tmp_path: Path) -> None:
    path = Path(shutil.copy(fmus / "gain.fmu", tmp_path / "secret.fmu"))
    path.chmod(0)
    refused(path, "cannot be read")


def test_an_archive_that_holds_an_entry_twice_is_refused(fmus: Path, tmp_path: Path) -> None:
    """Two tools could read two different model descriptions from it; the same content twice is taken and noted."""
    path = tmp_path / "twice.fmu"
    shutil.copy(fmus / "gain.fmu", path)
    with zipfile.ZipFile(path, "a") as archive, pytest.warns(UserWarning, match="Duplicate name"):
        archive.writestr("modelDescription.xml", "<fmiModelDescription/>")
    refused(path, "entry 'modelDescription.xml' is there twice with different contents; pack one of them")
