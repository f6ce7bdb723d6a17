"""An FMU that brings sources and no library for this machine is compiled where its user asks for that, and runs."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import fmpy
import pytest
from helpers import edited, last, read_system, run_of
from native_build import FREE3, NATIVE, WIRES3, feedthrough2, feedthrough3, needs_gcc
from rovbrush.orchestrator.cache import cache
from rovbrush.orchestrator.cli.main import main
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.fmu.files import compiled
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate

pytestmark = needs_gcc
LIBRARY2 = f"binaries/{fmpy.platform}/feedthrough2{fmpy.sharedLibraryExtension}"
LIBRARY3 = f"binaries/{fmpy.platform_tuple}/feedthrough3{fmpy.sharedLibraryExtension}"
SOURCE2 = (NATIVE / "feedthrough2.c").read_bytes()
PREFIXED = b"#define FMI2_FUNCTION_PREFIX feedthrough2_\n" + SOURCE2
Command = Callable[..., None]


def sources2(folder: Path, files: dict[str, bytes] | None = None, listed: str = "all.c") -> Path:
    """FMI 2.0: feedthrough2 as sources only; `files` by their names in `sources`."""
    names = "".join(f'<File name="{name}"/>' for name in listed.split())
    entries = {f"sources/{name}": content for name, content in (files or {"all.c": SOURCE2}).items()}
    return edited(
        feedthrough2(folder / "feedthrough2.fmu"), folder / "theirs.fmu", {LIBRARY2: None, **entries},
        {"<CoSimulation ": "<CoSimulation ",
         "/>\n<TypeDef": f"><SourceFiles>{names}</SourceFiles></CoSimulation>\n<TypeDef"},
    )  # fmt: skip


def sources3(folder: Path, inside: str, files: dict[str, bytes] | None = None, beside: str = "") -> Path:
    """FMI 3.0: feedthrough3 as sources with a build description, whose only SourceFileSet begins with `inside`."""
    build = (
        f'<fmiBuildDescription fmiVersion="3.0"><BuildConfiguration modelIdentifier="feedthrough3"><SourceFileSet '
        f"{inside}</SourceFileSet>{beside}</BuildConfiguration></fmiBuildDescription>"
    )
    own = files or {"feedthrough3.c": (NATIVE / "feedthrough3.c").read_bytes(),
                    "more/unused3.c": (NATIVE / "unused3.c").read_bytes()}  # fmt: skip
    entries = {f"sources/{name}": content for name, content in own.items()}
    return edited(
        feedthrough3(folder / "feedthrough3.fmu"), folder / "theirs.fmu",
        {LIBRARY3: None, "sources/buildDescription.xml": build.encode(), **entries},
    )  # fmt: skip


FILES3 = '><SourceFile name="feedthrough3.c"/><SourceFile name="more/unused3.c"/>'
COMPILED = {"compile": True}


def test_sources_of_fmi_2_run_as_the_binary_of_its_maker_does(tmp_path: Path) -> None:
    sound, theirs = tmp_path / "feedthrough2.fmu", sources2(tmp_path)
    outcome = [
        last(run_of(tmp_path, tmp_path, {"a": (str(fmu), "1 ms", {"=u": 0.1})}, stop="0.1 s", of=of), "a.x")
        for fmu, of in ((sound, {}), (theirs, {"a": COMPILED}))
    ]
    assert outcome[0] == outcome[1] != 0.0


def test_sources_whose_functions_have_a_prefix_run_too(tmp_path: Path) -> None:
    """FMI 2.0 has them define FMI2_FUNCTION_PREFIX, for programs that many of them are linked into."""
    headers = {h.name: h.read_bytes() for h in compiled.HEADERS.glob("fmi2*.h")}
    theirs = sources2(tmp_path, {"all.c": PREFIXED, **headers})
    run = run_of(tmp_path, tmp_path, {"a": (str(theirs), "1 ms", {"=u": 2.0})}, stop="3 ms", of={"a": COMPILED})
    assert last(run, "a.y") == 2.0


def test_the_build_description_of_fmi_3_says_what_is_compiled(tmp_path: Path) -> None:
    """Several files, one in a folder; every type of variable comes through."""
    theirs = sources3(tmp_path, f'language="C99"{FILES3}')
    parts = {name: (str(theirs), "1 ms", FREE3 if name == "a" else {}) for name in "ab"}
    system = read_system(tmp_path, tmp_path, parts, WIRES3, stop="3 ms", of={"a": COMPILED, "b": COMPILED})
    run = simulate(make_plan(system))
    assert not run.failure and last(run, "b.Float64_out") == 0.1


def test_definitions_folders_and_options_of_the_build_description_count(tmp_path: Path) -> None:
    first = b'#include "place.h"\n#if GAIN != 3 || defined(LEFT_OUT)\n#error definitions are lost\n#endif\n'
    files = {"feedthrough3.c": first + (NATIVE / "feedthrough3.c").read_bytes(), "headers/place.h": b"",
             "more/unused3.c": (NATIVE / "unused3.c").read_bytes()}  # fmt: skip
    inside = (
        f'compiler="gcc" compilerOptions="-O1 -Wall"{FILES3}<PreprocessorDefinition name="GAIN" value="3"/>'
        '<PreprocessorDefinition name="LEFT_OUT" optional="true"/><IncludeDirectory name="headers"/>'
    )
    theirs = sources3(tmp_path, inside, files, '<Library name="m" external="true"/>')
    assert Fmu.open(theirs, compiled=True).library.is_file()


def test_c_plus_plus_is_compiled_by_its_own_compiler(tmp_path: Path) -> None:
    if compiled.compiler(plus_plus=True) is None:
        pytest.skip("no C++ compiler")
    more = b'#include <vector>\nextern "C" int more(void) { std::vector<int> v(3); return (int)v.size(); }\n'
    theirs = sources2(tmp_path, {"all.c": SOURCE2, "more.cpp": more}, "all.c more.cpp")
    run = run_of(tmp_path, tmp_path, {"a": (str(theirs), "1 ms", {"=u": 2.0})}, stop="3 ms", of={"a": COMPILED})
    assert last(run, "a.y") == 2.0


def test_it_is_compiled_once(tmp_path: Path) -> None:
    theirs = sources2(tmp_path)
    library = Fmu.open(theirs, compiled=True).library
    made = library.stat().st_mtime_ns
    assert Fmu.open(theirs, compiled=True).library.stat().st_mtime_ns == made
    assert cache.cache_folder() in library.parents


def test_nothing_is_compiled_that_nobody_asked_for(tmp_path: Path) -> None:
    theirs = sources2(tmp_path)
    Fmu.open(theirs, compiled=True)
    with pytest.raises(FmuError, match="it carries its sources: --compile"):
        Fmu.open(theirs)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("command", ["run", "plan", "check", "info", "test-component"])
def test_every_command_takes_the_word(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv(compiled.ASKED, "")  # what the command sets there is taken back
    theirs = sources2(tmp_path)
    more = {"run": ["--stop", "3 ms", "--step", "1 ms", "--out", str(tmp_path / "out")],
            "test-component": ["--as", "dc_motor"]}.get(command, [])  # fmt: skip
    said = {}
    for word in ([], ["--compile"]):
        monkeypatch.setattr(sys, "argv", ["rovbrush", command, str(theirs), *more, *word])
        with pytest.raises(SystemExit):
            main()
        said[bool(word)] = "".join(capsys.readouterr())
    assert "--compile" in said[False].replace("\n", " ") and "it carries its sources" not in said[True]


@pytest.mark.parametrize("isolation", ["none", "process"])
def test_a_process_of_its_own_runs_what_was_compiled(isolation: str, tmp_path: Path) -> None:
    theirs = sources2(tmp_path)
    of = {"a": COMPILED | {"isolation": isolation}}
    run = run_of(tmp_path, tmp_path, {"a": (str(theirs), "1 ms", {"=u": 2.0})}, stop="3 ms", of=of)
    assert last(run, "a.y") == 2.0


BAD2 = {
    "does not compile": ({"all.c": b"int broken(;\n"}, "all.c", r"source all\.c cannot be compiled.*\n.*error"),
    "is not complete": ({"all.c": b"int gone(void); int f(void) { return gone(); }\n"}, "all.c",
                        "(?s)cannot be linked.*gone"),
    "is another program": ({"all.c": b"int f(void) { return 1; }\n"}, "all.c", "has no function fmi2Instantiate"),
    "is missing": ({"all.c": SOURCE2}, "all.c gone.c", "'gone.c' is not among its sources; there is all.c"),
    "lies outside": ({"all.c": SOURCE2}, "../modelDescription.xml", "leads out of them"),
    "is absolute": ({"all.c": SOURCE2}, "/etc/passwd", "leads out of them"),
}  # fmt: skip


@pytest.mark.parametrize("what", BAD2)
def test_a_source_that_cannot_be_used_is_named(what: str, tmp_path: Path) -> None:
    files, listed, words = BAD2[what]
    with pytest.raises(FmuError, match=words):
        Fmu.open(sources2(tmp_path, files, listed), compiled=True)


BAD3 = {
    "an option that runs programs": (f'compiler="gcc" compilerOptions="-fplugin=./evil.so"{FILES3}', "", "-fplugin="),
    "a file of options": (f'compiler="gcc" compilerOptions="@more"{FILES3}', "", "option '@more'"),
    "another language": (f'language="Fortran 90"{FILES3}', "", "are in Fortran 90; only C and C"),
    "a library that it brings": (FILES3, '<Library name="their.a"/>', "linked with their.a"),
    "a folder outside": (f'{FILES3}<IncludeDirectory name="../.."/>', "", "leads out of them"),
    "a macro that is no name": (f'{FILES3}<PreprocessorDefinition name="A B"/>', "", "no name in C"),
}  # fmt: skip


@pytest.mark.parametrize("what", BAD3)
def test_a_build_description_that_cannot_be_followed_is_an_error_that_says_where(what: str, tmp_path: Path) -> None:
    inside, beside, words = BAD3[what]
    with pytest.raises(FmuError, match=words):
        Fmu.open(sources3(tmp_path, inside, beside=beside), compiled=True)


def test_a_compiler_that_does_not_come_back_is_given_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    slow = tmp_path / "slow"
    slow.write_text("#!/bin/sh\nexec sleep 30\n")
    slow.chmod(0o755)
    monkeypatch.setenv("CC", str(slow))
    monkeypatch.setattr(compiled, "PATIENCE", 0.0)
    theirs = sources2(tmp_path, {"all.c": SOURCE2 + b"/* what other tests compile is kept */\n"})
    with pytest.raises(FmuError, match="cannot be compiled within 0 s"):
        Fmu.open(theirs, compiled=True)


def test_without_a_compiler_the_package_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    theirs = sources2(tmp_path, {"all.c": SOURCE2 + b"/* not compiled yet */\n"})
    monkeypatch.setattr(compiled, "compiler", lambda plus_plus=False: None)
    with pytest.raises(FmuError, match=r"need a C compiler; install one \(Debian: `apt install gcc`\)"):
        Fmu.open(theirs, compiled=True)
