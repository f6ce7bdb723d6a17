"""FMUs that are damaged, or made to do harm: their archives byte by byte, their model descriptions word by word."""

from __future__ import annotations

import io
import os
import random
import stat
import warnings
import zipfile
from pathlib import Path

from lxml import etree
from native_build import built
from rovbrush.orchestrator.cache import users
from rovbrush.orchestrator.errors import RovbrushError
from rovbrush.orchestrator.exchange.checks.rules.archive_rules import archive_rows, loadable_row
from rovbrush.orchestrator.exchange.checks.rules.description_rules import capability_rows, description_rows
from rovbrush.orchestrator.exchange.checks.rules.unit_rules import unit_rows
from rovbrush.orchestrator.exchange.checks.subject import open_subject
from rovbrush.orchestrator.fmu.fmu import Fmu

from . import seeded

NAME = "archives"
CLAIM = "a mutated FMU is read, or refused by an error of our own, and nothing is written outside the cache"
COUNT = 20_000
UNIT = "mutated FMUs (2.0 and 3.0)"
LIMIT = 5.0
SAMPLE = 40

DESCRIPTION = "modelDescription.xml"
NAMES = (
    "../up", "/tmp/abs", "a/./b", "a//b", "", ".", "..", "C:x", "a\\b", "x" * 300, "a/" * 600 + "b", "\n", "ä" * 200,
    "modelDescription.xml", "modelDescription.xml/x", "./modelDescription.xml", ".rovbrush/manifest.json",
)  # fmt: skip
VALUES = (
    "", "0", "-1", "1e308", "1e999999999", "-1e999999999", "INF", "NaN", "9" * 5000, "0x10", "true", " ", "a b", "ä",
    "../../x", "/etc/passwd", "1 2 3", "4294967295", "18446744073709551615", "-9223372036854775809", "1.5", "x" * 10000,
    "2.0", "3.0", "3.0-beta.1", "[1]", "a[1]", "%s%n", "input", "output", "parameter", "calculatedParameter", "local",
    "independent", "fixed", "tunable", "continuous", "discrete", "constant", "exact", "approx", "calculated",
)  # fmt: skip
WORDS = (
    b"<!DOCTYPE x>", b"<!ENTITY a 'b'>", b"&a;", b"&#0;", b"\xff", b"\x00", b"<![CDATA[", b"-->", b"<?xml?>", b"]]>",
    b"encoding='UTF-16'", b"<a>" * 300, b"xmlns:x='u'", b"x:", b"<x/>",
)  # fmt: skip


def prepare(folder: Path) -> None:
    built(folder)


def one(index: int, folder: Path) -> str:
    rng = seeded(NAME, index)
    source = folder.parent / rng.choice(("feedthrough2.fmu", "feedthrough3.fmu"))
    path = folder / "mutated.fmu"
    path.write_bytes(rng.choice((_bytes, _entries, _elements, _elements, _attributes, _attributes, _text))(rng, source))
    os.environ["ROVBRUSH_CACHE"] = str(folder / "cache")
    try:
        return _read(path) or _strayed(folder)
    finally:
        register = users._own.pop(folder / "cache", None)
        if register:
            os.close(register.file)


def _read(path: Path) -> str:
    """What is wrong with the way in which an FMU is read."""
    try:
        fmu = Fmu.open(path)
        for name in fmu.variables:
            try:
                fmu.start(name)
            except RovbrushError:
                continue
        _ = fmu.places, fmu.arrays, fmu.feedthrough(), fmu.feedthrough(True), fmu.recommended_step, fmu.internal_step
        if not fmu.library.resolve().is_relative_to(fmu.folder):
            return "the library is outside the archive"
    except RovbrushError as error:
        if not str(error).strip() or str(path) not in str(error):
            return f"the error does not name the file: {error}"
    try:
        subject = open_subject(path)
        for rows in (archive_rows, description_rows, unit_rows, capability_rows):
            list(rows(subject))
        loadable_row(subject)
    except RovbrushError:
        pass
    return ""


def _strayed(folder: Path) -> str:
    """What was written outside the cache."""
    return ", ".join(path.name for path in folder.iterdir() if path.name not in ("cache", "mutated.fmu"))


def _bytes(rng: random.Random, source: Path) -> bytes:
    """The archive with bytes changed, lost, doubled, or its end cut off; most changes meet its headers."""
    content = bytearray(source.read_bytes())
    for _ in range(rng.choice((1, 1, 2, 8, 64))):
        headers = [content.find(mark, rng.randrange(len(content))) for mark in (b"PK\1\2", b"PK\3\4", b"PK\5\6")]
        at = rng.choice([k for k in headers if k >= 0] or [0]) + rng.randrange(64)
        at = at if at < len(content) and rng.random() < 0.8 else rng.randrange(len(content))
        match rng.randrange(5):
            case 0:
                content[at] = rng.randrange(256)
            case 1:
                content[at] = rng.choice((0, 255))
            case 2:
                del content[at : at + rng.choice((1, 4, 100))]
            case 3:
                content[at:at] = content[at : at + rng.choice((1, 4, 1000))]
            case 4:
                del content[rng.choice((at, len(content) - rng.randrange(1, 200))) :]
        if not content:
            break
    return bytes(content)


def _packed(source: Path, rng: random.Random, description: bytes | None = None) -> bytes:
    """An archive with the entries of another, and one more or less where there is no new description."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(source) as old, zipfile.ZipFile(buffer, "w") as new:
        for entry in old.infolist():
            content = old.read(entry)
            if description is not None:
                content = description if entry.filename == DESCRIPTION else content
            elif rng.random() < 0.1:
                continue
            new.writestr(zipfile.ZipInfo(entry.filename), content)
        for _ in range(rng.randrange(1, 4) if description is None else 0):
            info = zipfile.ZipInfo(rng.choice(NAMES))
            info.filename = rng.choice((info.filename, info.filename + "/", "resources/" + info.filename))
            info.external_attr = rng.choice((0, stat.S_IFLNK, stat.S_IFIFO, stat.S_IFDIR, 0o177777)) << 16
            info.compress_type = rng.choice((0, 8, 12, 14))
            info.date_time = rng.choice(((1980, 1, 1, 0, 0, 0), (1980, 0, 0, 0, 0, 0), (2107, 15, 31, 31, 63, 62)))
            with warnings.catch_warnings(action="ignore"):  # of a name that is there twice
                new.writestr(info, rng.randbytes(rng.choice((0, 1, 1000))))
    return buffer.getvalue()


def _entries(rng: random.Random, source: Path) -> bytes:
    """The archive with strange entries."""
    return _packed(source, rng)


def _described(source: Path) -> bytes:
    with zipfile.ZipFile(source) as archive:
        return archive.read(DESCRIPTION)


def _elements(rng: random.Random, source: Path) -> bytes:
    """Elements of the model description lost, doubled, moved or renamed."""
    root = etree.fromstring(_described(source))
    for _ in range(rng.choice((1, 1, 2, 5))):
        elements = [e for e in root.iter(etree.Element) if e is not root]
        if not elements:
            break
        element, other = rng.choice(elements), rng.choice(elements)
        parent = element.getparent()
        match rng.randrange(4):
            case 0:
                parent.remove(element)
            case 1:
                parent.insert(0, etree.fromstring(etree.tostring(element)))
            case 2:
                if element not in (other, *other.iterancestors()):
                    other.append(element)
            case 3:
                element.tag = rng.choice((other.tag, "Real", "String", "Binary", "Clock", "x"))
    return _packed(source, rng, etree.tostring(root))


def _attributes(rng: random.Random, source: Path) -> bytes:
    """Attributes of the model description lost, exchanged, or with values that mean harm."""
    root = etree.fromstring(_described(source))
    elements = [e for e in root.iter(etree.Element) if e.attrib]
    names = sorted({name for e in elements for name in e.attrib})
    for _ in range(rng.choice((1, 1, 2, 5))):
        element, other = rng.choice(elements), rng.choice(elements)
        name = rng.choice(sorted(element.attrib) or names)
        match rng.randrange(4):
            case 0:
                element.attrib.pop(name, None)
            case 1:
                element.set(rng.choice(names), rng.choice(VALUES))
            case 2:
                element.set(name, other.get(name) or rng.choice(VALUES))
            case 3:
                element.set(name, rng.choice(VALUES))
    return _packed(source, rng, etree.tostring(root))


def _text(rng: random.Random, source: Path) -> bytes:
    """The model description as text: bytes changed, lost, doubled, or words of XML where they do not belong."""
    content = bytearray(_described(source))
    for _ in range(rng.choice((1, 1, 3, 10))):
        at = rng.randrange(len(content))
        match rng.randrange(4):
            case 0:
                content[at] = rng.randrange(256)
            case 1:
                content[at:at] = rng.choice(WORDS)
            case 2:
                del content[at : at + rng.choice((1, 10, 1000))]
            case 3:
                content[at:at] = content[at : at + 100]
        if not content:
            break
    return _packed(source, rng, bytes(content))
