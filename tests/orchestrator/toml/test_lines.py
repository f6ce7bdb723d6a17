"""A line is found by an index as it would be found by looking through the whole text."""

from __future__ import annotations

import re

from hypothesis import given
from hypothesis import strategies as st
from rovbrush.orchestrator.toml.lines import Lines

PIECES = st.sampled_from(
    [
        "a",
        "b",
        "a.b",
        "b.a",
        " ",
        "\n",
        "[a]",
        "[a.b]",
        "[[b]]",
        " = ",
        "#",
        '"',
        "->",
        "aa",
        "_",
        ".",
        "\n",
        "[a.bc]",
        "é",
    ]
)
NEEDLES = st.sampled_from(["a", "b", "a.b", "a.b -> b.a", "aa", "[a]", "a.bc", "c", "é", "_", "b.a"])


def by_looking(text: str, needle: str, table: str) -> int | None:
    """The first line that holds the needle as a word, below the heading of the table."""
    word = re.compile(rf"(?<![\w.]){re.escape(needle)}(?!\w)")
    inside = not table
    for number, line in enumerate(text.split("\n"), 1):
        heading = re.match(r"\s*\[+([^\[\]]+)\]", line)
        if heading and table:
            inside = f"{heading[1]}.".startswith(f"{table}.")
        if inside and word.search(line.partition("#")[0]):
            return number
    return None


@given(st.lists(PIECES, max_size=60).map("".join), NEEDLES, st.sampled_from(["", "a", "a.b", "b", "a.bc"]))
def test_the_index_finds_what_a_search_through_all_lines_finds(text: str, needle: str, table: str) -> None:
    assert Lines(text).find(needle, table) == by_looking(text, needle, table)
