"""An FMU for Windows is opened where wine could run it; where not, one message says what to install."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from helpers import edited, read_system
from native_build import built, feedthrough2, needs_gcc
from rovbrush.orchestrator.cache.cache import cache_folder
from rovbrush.orchestrator.cli.main import main
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.exchange.checks.chain import check_fmu
from rovbrush.orchestrator.fmu.files import binary
from rovbrush.orchestrator.fmu.files import windows as known
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.windows import build
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from windows_build import feedthrough_for_windows, needs_wine

pytestmark = [needs_gcc, pytest.mark.skipif(not known.runs_windows(), reason="wine runs on Linux on x86-64")]


def renamed(folder: Path, platform: str) -> Path:
    """An FMU whose only library is said to be for Windows; nobody loads it."""
    fmu = feedthrough2(folder / "feedthrough2.fmu")
    content = {f"binaries/{platform}/feedthrough2.dll": b"a library"}
    return edited(fmu, folder / "theirs.fmu", {"binaries/linux64/feedthrough2.so": None, **content})


@pytest.mark.parametrize(("platform", "packages"), [("win64", "wine64 mingw-w64"), ("win32", "wine32:i386")])
def test_without_wine_the_packages_are_named(
    platform: str, packages: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(binary, "wine", lambda _platform: None)
    with pytest.raises(FmuError, match=f"has no binary for linux64; it has {platform}; wine runs it") as error:
        Fmu.open(renamed(tmp_path, platform))
    assert packages in str(error.value) and "\n" not in str(error.value)


def test_without_mingw_the_package_is_named_before_time_0(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(binary, "wine", lambda _platform: "/bin/false")
    monkeypatch.setattr(build, "COMPILERS", {"win64": "no-such-compiler"})
    monkeypatch.setattr(build, "OPTIONS", ("-DANOTHER",))  # not built before
    system = read_system(tmp_path, tmp_path, {"a": (str(renamed(tmp_path, "win64")), "1 ms")}, stop="3 ms")
    with pytest.raises(FmuError, match=r"no-such-compiler is missing.*apt install wine64 mingw-w64"):
        simulate(make_plan(system))


def test_a_32_bit_fmu_is_not_run_by_a_wine_for_64_bit_alone(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    loader = tmp_path / "wine64"
    loader.touch(mode=0o755)
    monkeypatch.setattr(known, "ONLY_64", str(loader))
    monkeypatch.setattr(known, "LOADERS", {"win64": (str(loader),), "win32": (str(tmp_path / "wine"),)})
    assert known.wine("win32") is None and known.wine("win64") == str(loader)


@pytest.fixture(scope="module")
def theirs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("theirs")
    return feedthrough_for_windows(built(folder) / "feedthrough2.fmu", folder / "theirs.fmu")


@needs_wine
def test_check_runs_it_under_wine(theirs: Path) -> None:
    report = check_fmu(theirs)
    rows = {row.rule: row for row in report.rows}
    assert rows["binary for this machine"].found == "feedthrough2.dll, for win64: wine runs it"
    assert rows["runs with its start values"].verdict == "pass"
    assert not [row for row in report.rows if row.verdict == "error"]


@needs_wine
@pytest.mark.parametrize(
    ("command", "words"),
    [
        ("info", "by wine, in a process of its own (win64)"),
        ("plan", "in a process of its own: its library is for win64, which wine runs"),
        ("doctor", "win64 FMUs"),
    ],
)
def test_the_commands_say_that_wine_runs_it(
    command: str, words: str, theirs: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    monkeypatch.setattr(sys, "argv", ["rovbrush", command, *([str(theirs)] if command != "doctor" else [])])
    with pytest.raises(SystemExit):
        main()
    assert words in " ".join(capsys.readouterr().out.split())


@needs_wine
def test_run_takes_it_as_any_fmu(theirs: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    arguments = ["run", str(theirs), "--step", "1 ms", "--stop", "5 ms", "--out", str(tmp_path / "out")]
    monkeypatch.setattr(sys, "argv", ["rovbrush", *arguments])
    with pytest.raises(SystemExit) as end:
        main()
    assert end.value.code == 0 and json.loads((tmp_path / "out" / "summary.json").read_text())["complete"]


@pytest.mark.parametrize("platform", ["win64", "win32"])
def test_what_loads_it_compiles_without_a_warning(platform: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """For win32 it is compiled only: not tested where wine for that is missing."""
    if platform not in build.available():
        pytest.skip(f"no {build.COMPILERS[platform]}")
    monkeypatch.setattr(build, "OPTIONS", (*build.OPTIONS, "-Wextra", "-Werror"))
    assert build.server(platform).read_bytes()[:2] == b"MZ"


@needs_wine
def test_what_loads_it_is_compiled_once_and_the_same_everywhere() -> None:
    program = build.server("win64")
    content, made = program.read_bytes(), program.stat().st_mtime_ns
    assert build.server("win64").stat().st_mtime_ns == made and cache_folder() in program.parents
    program.unlink()
    assert build.server("win64").read_bytes() == content


@pytest.mark.skipif("win32" not in build.available(), reason="gcc-mingw-w64-i686 is not there")
def test_the_server_for_32_bits_is_compiled_of_the_same_sources() -> None:
    """Whether it runs an FMU is not tried here: that takes wine32."""
    content = build.server("win32").read_bytes()
    header = int.from_bytes(content[0x3C:0x40], "little")
    assert content[header : header + 6] == b"PE\0\0\x4c\x01", "a program for i386"
