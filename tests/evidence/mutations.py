"""Files as they come from editors, tools and broken disks: small changes of good ones, by seeded random numbers."""

from __future__ import annotations

import os
import random
import re
import tomllib
import zipfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import fmpy
from rovbrush.orchestrator.errors import RovbrushError

_TOML = [
    "0",
    "-1",
    "1.5",
    "1e400",
    "nan",
    "-inf",
    '""',
    '" "',
    '"0 s"',
    '"1/3 s"',
    '"1e30000000 s"',
    '"1e300 s"',
    "[]",
    "{}",
    "[[]]",
    "[1, [2]]",
    "{ a = { b = 1 } }",
    "true",
    '"a.b.c"',
    '"a.y -> a.u"',
    '"../x"',
    '"\\u0000"',
    '"\\uFFFF"',
    "1979-05-27",
    "07:32:00",
    "9" * 400,
    "9" * 5000,
    "0x" + "f" * 600,
    "[" * 40 + "]" * 40,
    "[" * 2000 + "]" * 2000,
    '"' + "x" * 5000 + '"',
    ".".join("a" * 90),
    '"' + "[" * 50 + '"',
    "{ csv = 3 }",
    '{ csv = "t.csv" }',
    "{ time = [0, 1], values = [[1], 2] }",
    '"*"',
    '"mean"',
    '"ratio a.y"',
    "[components.a]",
    "[[bonds]]",
    "[iteration]",
    "#",
    "\n",
    "=",
    "]",
    "}",
    '"""',
    "'''",
]
_XML = [
    '""',
    '" "',
    '"-1"',
    '"nan"',
    '"1e400"',
    '"1e-400"',
    '"true"',
    '"a.b"',
    '"../x"',
    '"a%00b"',
    '"http://[x"',
    '"//x/y"',
    '"#a"',
    f'"{"9" * 400}"',
    f'"{"9" * 5000}"',
    f'"{"x" * 5000}"',
    '"&#0;"',
    '"&amp;"',
    '"&unknown;"',
    '"2.0"',
    '"1.0"',
    '"3.0"',
    '"input"',
    '"output"',
    '"parameter"',
    '"calculatedParameter"',
    '"independent"',
    '"structuralParameter"',
    '"exact"',
    '"any"',
    '"ModelExchange"',
    '"a"',
    '"b"',
    '"toy"',
    '"u"',
    '"y"',
    '"kg"',
    '"deg"',
    '"N.m"',
    "<Real/>",
    "<Annotations/>",
    "<",
    ">",
    "</a>",
    "<a>" * 300,
    "<!-- -->",
    "<![CDATA[x]]>",
    '<!DOCTYPE a [<!ENTITY e "x">]>',
    "<?x?>",
    "xmlns",
    "\u2028",
    "é",
]
_CSV = [
    "0",
    "-1",
    "1e400",
    "nan",
    "inf",
    "",
    " ",
    "x",
    '"',
    '""',
    '"a\nb"',
    ",",
    ",,",
    ";",
    "\n",
    "\r",
    "\r\n",
    "\0",
    "\ufeff",
    "1e-400",
    "9" * 400,
    "9" * 5000,
    "time",
    "time [ms]",
    "a.u",
    "a.u [m]",
    "a.u [",
    "a.none",
    "true",
    "true",
    "1/3",
    "0x10",
    "1_000",
    "١",
    "a" * 140_000,
]
WORDS = re.compile(r'"[^"\n]*"|[\w.+-]+|[^\w\s]')


@dataclass(frozen=True)
class Kind:
    """Of a text: what may stand in the place of any word, what in the place of a value, and where values stand."""

    strangers: list[str]
    values: list[str]
    places: re.Pattern[str]


def _is_toml(text: str) -> bool:
    try:
        tomllib.loads(f"x = {text}\n")
    except (ValueError, RecursionError):
        return False
    return True


TOML = Kind(
    _TOML, [*filter(_is_toml, _TOML)], re.compile(r'(?<=[=\[,] )"[^"\n]*"|(?<== )[\w.+-]+|(?<=\[)"[^"\n]*"(?!\])')
)
XML = Kind(_XML, [x for x in _XML if x[0] == '"' and "&#0" not in x and "&u" not in x], re.compile(r'"[^"\n]*"'))
CSV = Kind(_CSV, [x for x in _CSV if not set(x) & set(',\n\r"')], re.compile(r"[^,\n]+"))


def mutated(random_: random.Random, text: str, kind: Kind, most: int = 4) -> bytes:
    """The text with one to `most` changes. Half of them leave it well-formed: values for values, lines left out."""
    if random_.random() < 0.5:
        for _ in range(random_.randint(1, most)):
            text = _lines(random_, text, []) if random_.random() < 0.2 else _value(random_, text, kind)
        return text.encode("utf-8", "surrogatepass")
    for _ in range(random_.randint(1, most)):
        text = random_.choice(CHANGES)(random_, text, kind.strangers)
    content = text.encode("utf-8", "surrogatepass")
    return _bytes(random_, content) if random_.random() < 0.1 else content


def _value(random_: random.Random, text: str, kind: Kind) -> str:
    """Another value, a strange one or one of the file, in the place of a value."""
    values = list(kind.places.finditer(text))
    if not values:
        return text
    at = random_.choice(values)
    new = random_.choice(kind.values) if random_.random() < 0.7 else random_.choice(values)[0]
    return text[: at.start()] + new + text[at.end() :]


def _word(random_: random.Random, text: str, strangers: list[str]) -> str:
    """A stranger, or another word of the file, in the place of a word."""
    words = list(WORDS.finditer(text))
    if not words:
        return text
    at = random_.choice(words)
    new = random_.choice(strangers) if random_.random() < 0.7 else random_.choice(words)[0]
    return text[: at.start()] + new + text[at.end() :]


def _swap(random_: random.Random, text: str, _strangers: list[str]) -> str:
    words = [match.span() for match in WORDS.finditer(text)]
    if len(words) < 2:
        return text
    (a, b), (c, d) = sorted(random_.sample(words, 2))
    return text[:a] + text[c:d] + text[b:c] + text[a:b] + text[d:]


def _lines(random_: random.Random, text: str, _strangers: list[str]) -> str:
    """A line left out, doubled or moved."""
    lines = text.splitlines(keepends=True)
    if not lines:
        return text
    line = lines.pop(random_.randrange(len(lines)))
    for _ in range(random_.randint(0, 2)):
        lines.insert(random_.randint(0, len(lines)), line)
    return "".join(lines)


def _cut(random_: random.Random, text: str, _strangers: list[str]) -> str:
    return (
        text[: random_.randrange(len(text) + 1)] if random_.random() < 0.5 else text[random_.randrange(len(text) + 1) :]
    )


def _letter(random_: random.Random, text: str, _strangers: list[str]) -> str:
    """A character left out, doubled, or another one."""
    if not text:
        return text
    at = random_.randrange(len(text))
    new = random_.choice(["", text[at] * 2, chr(random_.randrange(1, 0x250)), random_.choice("[]{}\"'=.,<>&#\\/ \n0")])
    return text[:at] + new + text[at + 1 :]


def _doubled(random_: random.Random, text: str, _strangers: list[str]) -> str:
    """A piece many times."""
    if not text:
        return text
    a = random_.randrange(len(text))
    b = min(len(text), a + random_.randint(1, 60))
    return text[:b] + text[a:b] * random_.choice([1, 2, 30, 300]) + text[b:]


CHANGES: list[Callable[[random.Random, str, list[str]], str]] = [
    _word,
    _word,
    _word,
    _swap,
    _lines,
    _cut,
    _letter,
    _letter,
    _doubled,
]


def _bytes(random_: random.Random, content: bytes) -> bytes:
    changed = bytearray(content)
    for _ in range(random_.randint(1, 8)):
        if changed:
            changed[random_.randrange(len(changed))] = random_.randrange(256)
    return bytes(changed)


def read(reader: Callable[[], object]) -> str:
    """What is wrong with a reading: nothing where it succeeds, or fails with an error of ours that says something."""
    try:
        reader()
    except RovbrushError as error:
        return "" if str(error).strip() else "an error without words"
    return ""


SEEDS = Path(__file__).parent / "seeds"
DESCRIPTION2, DESCRIPTION3 = ((SEEDS / f"toy{version}.xml").read_text(encoding="utf-8") for version in (2, 3))


def write_fmu(path: Path, description: bytes, more: Mapping[str, bytes] | None = None) -> Path:
    """An FMU of which only the description is read: its binaries are empty."""
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("modelDescription.xml", description)
        for platform in (fmpy.platform, fmpy.platform_tuple):
            archive.writestr(f"binaries/{platform}/toy{fmpy.sharedLibraryExtension}", b"\x7fELF")
        for name, content in (more or {}).items():
            archive.writestr(name, content)
    return path


def prepare_toy(folder: Path) -> None:
    """`toy.fmu` and a cache of its own, once per process."""
    os.environ["ROVBRUSH_CACHE"] = str(folder / "cache")
    write_fmu(folder / "toy.fmu", DESCRIPTION2.encode())
    write_fmu(folder / "toy3.fmu", DESCRIPTION3.encode())
