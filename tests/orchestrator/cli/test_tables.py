"""Tables in a terminal: whatever does not fit beside each other comes below each other, and nothing is cut."""

from __future__ import annotations

import pytest
from rich.console import Console
from rovbrush.orchestrator.cli import console
from rovbrush.orchestrator.cli.console import columns_that_fit, print_table

LABELS = ["cold", "a label that is as long as people write them", "another one of such a length", "d"]


def test_columns_that_find_no_room_make_further_tables_with_the_leading_words_in_each() -> None:
    assert columns_that_fit([5, 3, 8, 8], (0, 1), 100) == [[0, 1, 2, 3]]
    assert columns_that_fit([5, 3, 60, 60, 8], (0, 1), 100) == [[0, 1, 2], [0, 1, 3, 4]]
    assert columns_that_fit([90, 8, 8, 90], (0, 3), 100) == [[0, 1, 2, 3]], "words are folded"
    assert columns_that_fit([200], (), 100) == [[0]]
    assert columns_that_fit([30, 30, 20, 20, 15], (0, 1), 100) == [[0, 1, 2, 3, 4]], "rather tight than in two"


@pytest.mark.parametrize("width", [80, 100, 200])
def test_no_cell_and_no_heading_is_cut(
    width: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(console, "console", Console(width=width))
    rows = [["coupling_energy_relative", "rad/s", *(f"{k}.12345678" for k in range(len(LABELS)))], ["x", "", *"1234"]]
    print_table("Figures of merit", ("", "unit", *LABELS), rows, words=(0, 1))
    seen = capsys.readouterr().out
    assert max(map(len, seen.splitlines())) <= width
    for text in (*LABELS, *rows[0][1:]):
        assert text in seen
    assert "coupling_energy" in seen and "relative" in seen
    assert seen.count("Figures of merit") == 1, "the parts of one table have one title"
