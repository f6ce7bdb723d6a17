"""What the archive itself shows: would a rebuild give the same bytes, and is everything in it that should be?"""

from __future__ import annotations

import itertools
import os
import posixpath
import zipfile
from collections.abc import Iterator

from ....errors import FmuError, counted, listed
from ....fmu.files.binary import LONGEST, find_library, is_file_name, is_identifier, remedy
from ....fmu.files.compiled import ASKED
from ....fmu.files.windows import platform_of
from ..rows import Row, judged
from ..subject import PLATFORMS, Subject, suffix

STAGE = "archive"


def archive_rows(subject: Subject) -> Iterator[Row]:
    """One row per rule on entries, dates, documentation, sources and binaries."""
    with zipfile.ZipFile(subject.archive) as archive:
        entries = archive.infolist()
    yield from _reproducible(subject, entries)
    documented = (subject.folder / "documentation" / "index.html").is_file()
    yield judged(
        STAGE, "documentation is inside", [] if documented else ["no documentation/index.html"],
        "documentation/index.html", "", "add it, with equations, units and validity", "finding",
    )  # fmt: skip
    yield _sources(subject)
    yield from _binaries(subject)


def _reproducible(subject: Subject, entries: list[zipfile.ZipInfo]) -> Iterator[Row]:
    dates = sorted({entry.date_time for entry in entries})
    made = subject.description.generationDateAndTime
    bad = [f"{len(dates)} different dates of entries"] if len(dates) > 1 else []
    bad += [f"generationDateAndTime {made}"] if made else []
    good = "one date for all entries, no time of generation: " + "-".join(f"{part:02d}" for part in dates[0][:3])
    mend = "write one fixed date, or a rebuild never has the same bytes"
    yield judged(STAGE, "dates are fixed", bad, good, "", mend, "finding")
    files = [entry.filename for entry in entries if not entry.is_dir()]
    unsorted = [b for a, b in itertools.pairwise(files) if b < a]
    mend = "pack the entries in sorted order"
    yield judged(STAGE, "entries are sorted", unsorted, "by name", "out of order", mend, "finding")


def _sources(subject: Subject) -> Row:
    rule, folder = "sources are complete", subject.folder / "sources"
    named = sorted(
        {n for b in subject.description.buildConfigurations for s in b.sourceFileSets for n in s.sourceFiles}
    )
    if not folder.is_dir() and not named:
        return Row(STAGE, rule, "not applicable", "no sources")
    there = {file.relative_to(folder).as_posix() for file in folder.rglob("*") if file.is_file()}
    missing = [name[:100] for name in named if posixpath.normpath(name) not in there]
    if not named:
        missing = ["a list of the source files"]
    where = "SourceFiles of modelDescription.xml" if subject.version < 3 else "sources/buildDescription.xml"
    mend = f"let {where} and sources/ agree"
    return judged(STAGE, rule, missing, f"{counted(len(named), 'file')} to compile", "missing", mend, "finding")


def _binaries(subject: Subject) -> Iterator[Row]:
    identifier = str(subject.interface.modelIdentifier)
    bad = [] if is_identifier(identifier) else [identifier[:100]]
    mend = f"use letters, digits and _ only, at most {LONGEST}"
    runs = subject.version > 1 and is_file_name(identifier)  # of FMI 1.0 functions begin with it
    rule = "modelIdentifier is a C name"
    yield judged(STAGE, rule, bad, identifier, "is none", mend, "finding" if runs else "error")
    there = subject.binaries
    unknown = [name for name in there if name not in PLATFORMS[subject.version]]
    mend = f"FMI {subject.version}.0 names them {listed(PLATFORMS[subject.version][-4:])}"
    good = listed(there) or "no binaries"
    yield judged(STAGE, "platform folders", unknown, good, "not a name of the standard", mend, "finding")
    known = [name for name in there if name not in unknown]
    lacking = [f"binaries/{name}/{identifier}{suffix(name)}" for name in known
               if f"{identifier}{suffix(name)}" not in there[name]]  # fmt: skip
    mend = "name each library after modelIdentifier"
    yield judged(STAGE, "binaries bear the identifier", lacking, good, "missing", mend, "finding")


def loadable_row(subject: Subject) -> Row:
    """Whether there is a binary for this machine, or one was made, and if not, what can be done."""
    rule = "binary for this machine"
    usable = is_file_name(subject.interface.modelIdentifier)  # it becomes a path
    try:
        if not usable:
            raise FmuError("none is looked for")
        library = find_library(subject.path, subject.folder, subject.description, subject.interface)
    except FmuError as error:
        if os.environ.get(ASKED) and usable:
            found = str(error).removeprefix(f"FMU {subject.path}").lstrip(": ")
            return Row("dry run", rule, "error", found, "pack sources that compile, or a binary of this platform")
        found = f"none for {subject.platform}; there is {listed(subject.binaries) or 'none at all'}"
        mend = remedy(subject.path, subject.folder, subject.description, subject.interface)
        return Row("dry run", rule, "error", found, mend)
    if target := platform_of(library):
        return Row("dry run", rule, "pass", f"{library.name}, for {target}: wine runs it")
    if library.is_relative_to(subject.folder / "binaries"):
        return Row("dry run", rule, "pass", f"binaries/{library.parent.name}/{library.name}")
    return Row("dry run", rule, "pass", f"{library.name}, compiled from its sources")
