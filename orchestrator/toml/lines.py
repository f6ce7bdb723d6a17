"""Where a word stands in a text of tables under headings: an index made once, so that many questions stay cheap."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections import defaultdict

HEADING = re.compile(r"\s*\[+([^\[\]]+)\]")
WORD = re.compile(r"\w+")
DEEPEST = 8  # levels of headings that can be asked for


class Lines:
    """Lines of a TOML text by the words that they hold, comments left out, and by the headings above them."""

    def __init__(self, text: str) -> None:
        self._lines: list[str] = []
        self._numbers: dict[str, list[int]] = defaultdict(list)  # of the lines that hold a word, rising
        self._blocks: dict[str, list[tuple[int, int]]] = defaultdict(list)  # first and last line, by heading or a part
        heading, begin = "", 1
        for number, line in enumerate(text.split("\n"), 1):
            found = HEADING.match(line)
            if found:
                self._close(heading, begin, number - 1)
                heading, begin = found[1], number
            code = line.partition("#")[0]
            self._lines.append(code)
            for word in set(WORD.findall(code)):
                self._numbers[word].append(number)
        self._close(heading, begin, len(self._lines))

    def _close(self, heading: str, begin: int, end: int) -> None:
        parts = heading.split(".", DEEPEST) if heading else []
        for k in range(1, len(parts) + 1):
            self._blocks[".".join(parts[:k])].append((begin, end))

    def find(self, needle: str, table: str = "") -> int | None:
        """The first line that holds the needle as a word, below the heading of `table` or one that it begins.

        Every word of the needle is a whole word of the line: only the lines of its rarest word are looked at.
        """
        words = WORD.findall(needle)
        numbers = min((self._numbers.get(word, []) for word in words), key=len) if words else []
        for begin, end in self._blocks.get(table, []) if table else [(1, len(self._lines))]:
            for k in range(bisect_left(numbers, begin), len(numbers)):
                if numbers[k] > end:
                    break
                if _holds(self._lines[numbers[k] - 1], needle):
                    return numbers[k]
        return None


def _holds(line: str, needle: str) -> bool:
    """Whether the needle stands in the line with no letter, digit or _ beside it, and no dot before it."""
    at = line.find(needle)
    while at >= 0:
        before, after = line[at - 1 : at], line[at + len(needle) : at + len(needle) + 1]
        if not ((before and WORD.match(before)) or before == "." or (after and WORD.match(after))):
            return True
        at = line.find(needle, at + 1)
    return False
