"""Files as they come from editors, tools and broken disks: small changes of good ones, by seeded random numbers."""

from __future__ import annotations

import random
import re
from collections.abc import Callable

from .strangers import Kind

WORDS = re.compile(r'"[^"\n]*"|[\w.+-]+|[^\w\s]')


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
    _word, _word, _swap, _lines, _cut, _letter, _letter, _doubled,
]  # fmt: skip


def _bytes(random_: random.Random, content: bytes) -> bytes:
    changed = bytearray(content)
    for _ in range(random_.randint(1, 8)):
        if changed:
            changed[random_.randrange(len(changed))] = random_.randrange(256)
    return bytes(changed)
