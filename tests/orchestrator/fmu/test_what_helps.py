"""What a message advises where a library is missing or cannot be loaded is true, and works."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import fmpy
import pytest
from helpers import edited, read_system
from native_build import NATIVE, feedthrough2, needs_gcc
from rovbrush.orchestrator.errors import FmuError
from rovbrush.orchestrator.exchange.checks.rules.archive_rules import loadable_row
from rovbrush.orchestrator.exchange.checks.rules.good_manners import runs
from rovbrush.orchestrator.exchange.checks.subject import open_subject
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.studies.bench.fmus.native import compiler

pytestmark = needs_gcc
linux = pytest.mark.skipif(sys.platform != "linux", reason="libraries are ELF files")
LIBRARY = f"binaries/{fmpy.platform}/feedthrough2{fmpy.sharedLibraryExtension}"
LISTED = {"<CoSimulation ": "<CoSimulation ", "/>\n<TypeDef": '><SourceFiles><File name="all.c"/></SourceFiles></CoSimulation>\n<TypeDef'}  # noqa: E501  # fmt: skip
SOURCE = {LIBRARY: None, "sources/all.c": (NATIVE / "feedthrough2.c").read_bytes()}


def headers() -> dict[str, bytes]:
    folder = Path(fmpy.__file__).parent / "c-code"
    return {f"sources/{path.name}": path.read_bytes() for path in folder.glob("fmi2*.h")}


def test_sources_that_are_listed_are_compiled_by_the_word_that_is_named(tmp_path: Path) -> None:
    (tmp_path / "a folder").mkdir()
    sound = feedthrough2(tmp_path / "feedthrough2.fmu")
    fmu = edited(sound, tmp_path / "a folder" / "feedthrough2.fmu", {**SOURCE, **headers()}, LISTED)
    with pytest.raises(FmuError, match="it carries its sources: --compile") as error:
        Fmu.open(fmu)
    assert "`compile = true`" in str(error.value) and "--compile" in loadable_row(open_subject(fmu)).mend
    parts = {"a": (str(fmu), "1 ms", {"=u": 1.0})}
    system = read_system(tmp_path, tmp_path, parts, stop="3 ms", of={"a": {"compile": True}})
    assert not simulate(make_plan(system)).failure


@pytest.mark.parametrize(
    "changes",
    [
        SOURCE,  # not listed
        {LIBRARY: None},  # listed, and not there
    ],
)
def test_and_not_advised_where_it_would_fail(changes: dict[str, bytes | None], tmp_path: Path) -> None:
    listed = {} if changes is SOURCE else LISTED
    fmu = edited(feedthrough2(tmp_path / "feedthrough2.fmu"), tmp_path / "their.fmu", changes, listed)
    with pytest.raises(FmuError, match="ask for a binary of this platform") as error:
        Fmu.open(fmu)
    assert "--compile" not in str(error.value) + loadable_row(open_subject(fmu)).mend


def with_library(make: Callable[[Path], bytes]) -> Callable[[Path], Path]:
    def build(folder: Path) -> Path:
        return edited(feedthrough2(folder / "feedthrough2.fmu"), folder / "their.fmu", {LIBRARY: make(folder)})

    return build


def linked(source: str, *options: str) -> Callable[[Path], bytes]:
    """A library with `source` beside what it needs."""

    def make(folder: Path) -> bytes:
        (folder / "more.c").write_text(source)
        (folder / "gone.c").write_text("int gone(void) { return 1; }\n")
        gcc, shared = str(compiler()), ["-shared", "-fPIC"]
        subprocess.run(
            [gcc, *shared, "gone.c", "-o", "libgone.so.3", "-Wl,-soname,libgone.so.3"], cwd=folder, check=True
        )
        include = f"-I{Path(fmpy.__file__).parent / 'c-code'}"
        sources = [str(NATIVE / "feedthrough2.c"), "more.c"]
        subprocess.run([gcc, *shared, include, *sources, "-lm", *options, "-o", "all.so"], cwd=folder, check=True)
        return (folder / "all.so").read_bytes()

    return make


NEEDS = "int gone(void); int more(void) { return gone(); }\n"
BROKEN = {
    "another library": (linked(NEEDS, "-L.", "-l:libgone.so.3"), "it needs libgone.so.3, which this machine lacks"),
    "a symbol": (linked(NEEDS), "it uses gone, which neither it nor any library that it names has"),
    "no library": (lambda _: b"this is no library, but long enough to be looked at as one" * 9, "no library for this"),
    "cut off": (lambda folder: linked("")(folder)[:40], "is no library for this machine"),
}  # fmt: skip


@linux
@pytest.mark.parametrize("kind", BROKEN)
@pytest.mark.parametrize("isolation", ["none", "process"])
def test_a_library_that_cannot_be_loaded_says_what_it_lacks(kind: str, isolation: str, tmp_path: Path) -> None:
    """And not that the FMU gave no reason, or that its GUID is wrong."""
    make, words = BROKEN[kind]
    fmu = with_library(make)(tmp_path)
    parts = {"a": (str(fmu), "1 ms", {"=u": 1.0})}
    system = read_system(tmp_path, tmp_path, parts, stop="3 ms", of={"a": {"isolation": isolation}})
    with pytest.raises(FmuError, match=r"component a: their\.fmu cannot be instantiated: its library") as error:
        simulate(make_plan(system))
    assert words in str(error.value) and "gave no reason" not in str(error.value)
    row = runs(open_subject(fmu))
    assert words in row.mend and "GUID" not in row.mend and words not in row.found
