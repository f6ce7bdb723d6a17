"""Where the project's own FMUs are looked for, and what is said of those that came with the package."""

from __future__ import annotations

import json
import shutil
import zipfile
from importlib.metadata import version
from pathlib import Path

import pytest
from helpers import edited, rovbrush
from native_build import feedthrough2, needs_gcc
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.files import places
from rovbrush.orchestrator.fmu.fmu import Fmu

OWN = version("rovbrush")
SYSTEM = 'format = 2\nstop_time = "4 ms"\nconnections = ["a.y -> b.u"]\n' + "".join(
    f'[components.{name}]\nfmu = "{name}"\nperiod = "1 ms"\ninputs = {{ {"u = 1.0, " if name == "a" else ""}n_in = 0, '
    'mode_in = 1, on_in = false, s_in = "" }\n'
    for name in "ab"
)
pytestmark = needs_gcc


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An FMU that says that this version built it."""
    folder = tmp_path_factory.mktemp("made")
    return said(feedthrough2(folder / "plain.fmu"), folder / "a.fmu", OWN)


def said(fmu: Path, target: Path, made_by: str) -> Path:
    return edited(
        fmu, target, {}, {"<fmiModelDescription ": f'<fmiModelDescription generationTool="rovbrush {made_by}" '}
    )


@pytest.fixture
def installed(made: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of shipped FMUs `a` and `b` of an installed package; nothing is built."""
    monkeypatch.setattr(places, "HERE", tmp_path / "site-packages" / "rovbrush")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    folder = places.HERE / "fmus" / places.NATIVE
    folder.mkdir(parents=True)
    for name in "ab":
        shutil.copy(made, folder / f"{name}.fmu")
    return folder


def built(made: Path, name: str) -> Path:
    """One that the user built."""
    places.fmu_folder().mkdir(parents=True, exist_ok=True)
    return Path(shutil.copy(made, places.fmu_folder() / f"{name}.fmu"))


def test_one_that_the_user_built_comes_before_the_shipped_one_of_its_name(installed: Path, made: Path) -> None:
    assert places.named_fmu("a", None) == installed / "a.fmu"
    mine = built(made, "a")
    assert places.named_fmu("a", None) == mine
    assert places.named_fmu("b", None) == installed / "b.fmu"
    assert places.named_fmu("c", None) == mine.parent / "c.fmu"  # which is not there; its error says what to do


def test_a_folder_that_is_named_is_the_only_one(
    installed: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert places.named_fmu("a", tmp_path) == tmp_path / "a.fmu"
    monkeypatch.setenv("ROVBRUSH_FMUS", str(tmp_path))
    assert places.named_fmu("a", None) == tmp_path / "a.fmu"


def test_a_checkout_ships_nothing(installed: Path) -> None:
    (places.HERE / "pyproject.toml").touch()
    assert places.shipped_folder() is None and places.named_fmu("a", None) == places.HERE / "fmus" / "a.fmu"


def test_a_wheel_without_fmus_says_how_to_build_them(installed: Path) -> None:
    shutil.rmtree(installed.parent)
    with pytest.raises(FmuError, match="does not exist; build the project's own with `rovbrush build`"):
        Fmu.open(places.named_fmu("a", None))


@pytest.mark.parametrize(
    ("place", "said"),
    [
        ("their/modelDescription.xml", "pack what is in the folder their, not the folder"),
        ("ModelDescription.xml", "it has ModelDescription.xml, and capital letters matter: rename it"),
    ],
)
def test_an_archive_that_was_packed_wrongly_says_how_to_pack_it(place: str, said: str, tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "a.fmu", "w") as archive:
        archive.writestr(place, "<fmiModelDescription/>")
    with pytest.raises(FmuError, match=f"has no modelDescription.xml; it has {place.split('/')[0]}.*") as error:
        Fmu.open(tmp_path / "a.fmu")
    assert said in str(error.value)


def test_a_shipped_one_of_another_version_is_refused(installed: Path, made: Path) -> None:
    path = said(made.parent / "plain.fmu", installed / "a.fmu", "0.0.1")
    with pytest.raises(
        FmuError, match=rf"came with rovbrush 0.0.1, and this is rovbrush {OWN}; build.*`rovbrush build`"
    ):
        Fmu.open(path)


def test_a_shipped_one_for_other_machines_is_refused(installed: Path, made: Path) -> None:
    with zipfile.ZipFile(made) as archive:
        binaries = {name: None for name in archive.namelist() if name.startswith("binaries/")}
    path = edited(made, installed / "a.fmu", binaries)
    with pytest.raises(FmuError, match=r"are for 64-bit Linux and Windows on x86 processors, and this is .*--compile"):
        Fmu.open(path)


def test_summary_manifest_and_doctor_name_which_ran(
    installed: Path, made: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    case = tmp_path / "case.toml"
    case.write_text(SYSTEM)
    assert rovbrush(monkeypatch, "run", case, "--out", tmp_path / "one") == 0
    assert f"shipped native of rovbrush {OWN}" in capsys.readouterr().out
    built(said(made.parent / "plain.fmu", tmp_path / "older.fmu", "0.0.1"), "a")
    assert rovbrush(monkeypatch, "run", case, "--out", tmp_path / "two") == 0
    told = json.loads((tmp_path / "two" / "summary.json").read_text())["fmus"]
    assert told == f"a: built, native, by rovbrush 0.0.1; b: shipped native of rovbrush {OWN}"
    components = json.loads((tmp_path / "two" / "manifest.json").read_text())["components"]
    assert components["b"]["from"] == f"shipped native of rovbrush {OWN}"
    capsys.readouterr()
    assert rovbrush(monkeypatch, "doctor") == 0
    said_ = capsys.readouterr().out
    assert f"2 native of rovbrush {OWN}, in {installed}" in said_ and "1 built, in" in said_


def test_python_and_native_fmus_are_told_apart(fmus: Path, native: Path) -> None:
    found = [Fmu.open(folder / "dc_motor.fmu").origin for folder in (fmus, native / "fmi2")]
    assert found == ["built, Python", "built, native"]
