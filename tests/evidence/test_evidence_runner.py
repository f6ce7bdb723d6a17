"""The runner of the evidence: no case is lost, none counted that was not tried, whatever a case does."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from .__main__ import main

HEAD = """
import os, time
from pathlib import Path
from . import seeded

NAME = "some"
CLAIM = "something holds"
COUNT = 6
LIMIT = 5.0
"""
GOOD = "def one(index: int, folder: Path) -> str:\n    return '' if folder.is_dir() else 'no folder'\n"


def tried(folder: Path, body: str, *arguments: str) -> tuple[int, list[dict[str, object]]]:
    """Exit code and journal of a run of one claim."""
    (folder / "some.py").write_text(HEAD + body, encoding="utf-8")
    code = main(["--jobs", "2", *arguments], folder, folder / "kept")
    lines = (folder / "kept" / "some.jsonl").read_text(encoding="utf-8").splitlines()
    return code, sorted(map(json.loads, lines), key=lambda row: row["index"])


def test_good_cases_are_counted_and_the_exit_code_is_0(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, rows = tried(tmp_path, GOOD)
    assert code == 0 and [row["index"] for row in rows] == list(range(6)) and not any(row["wrong"] for row in rows)
    assert capsys.readouterr().out.splitlines()[-1].split()[:-2] == [
        "some:",
        "something",
        "holds",
        "6",
        "cases",
        "6",
        "6",
        "0",
    ]


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("return 'odd' if index == 3 else ''", "odd"),
        ("assert index != 3; return ''", "AssertionError"),
        ("index == 3 and os.abort(); return ''", "SIGABRT"),
        ("index == 3 and os._exit(7); return ''", "exit code 7"),
        ("index == 3 and time.sleep(60); return ''", "longer than 5 s"),
    ],
)
def test_a_bad_case_is_named_and_the_others_go_on(body: str, words: str, tmp_path: Path) -> None:
    code, rows = tried(tmp_path, f"def one(index, folder):\n    {body}\n")
    assert code == 1 and [row["index"] for row in rows] == list(range(6))
    assert [row["index"] for row in rows if row["wrong"]] == [3] and words in str(rows[3]["wrong"])


def test_a_second_run_tries_what_is_left(tmp_path: Path) -> None:
    mark = f"def one(index, folder):\n    open({str(tmp_path / 'log')!r}, 'a').write(f'{{index}} ')\n    return ''\n"
    tried(tmp_path, mark, "--count", "2")
    code, rows = tried(tmp_path, mark)
    assert code == 0 and len(rows) == 6
    assert sorted((tmp_path / "log").read_text().split()) == list("012345"), "each case once"


def test_what_another_seed_or_source_tried_does_not_count(tmp_path: Path) -> None:
    tried(tmp_path, GOOD)
    assert len(tried(tmp_path, GOOD, "--seed", "1")[1]) == 12
    assert len(tried(tmp_path, GOOD + "# changed\n", "--seed", "1")[1]) == 18
    assert len(tried(tmp_path, GOOD, "--fresh")[1]) == 6


def test_seed_and_index_decide_the_random_numbers(tmp_path: Path) -> None:
    body = "def one(index, folder):\n    return str(seeded(NAME, index).random())\n"
    values = [
        [row["wrong"] for row in tried(tmp_path, body, "--fresh", *seed)[1]] for seed in ((), (), ("--seed", "1"))
    ]
    assert values[0] == values[1] and len({*values[0], *values[2]}) == 12


def test_prepare_is_called_once_per_worker(tmp_path: Path) -> None:
    body = (
        "def prepare(folder):\n    (folder / 'made').touch(exist_ok=False)\n"
        "def one(index, folder):\n    return '' if (folder.parent / 'made').exists() else 'not prepared'\n"
    )
    assert tried(tmp_path, body)[0] == 0


def test_a_claim_of_so_many_cases_and_no_more_has_no_others(tmp_path: Path) -> None:
    code, rows = tried(tmp_path, f"FINITE = True\n{GOOD}", "--count", "40")
    assert code == 0 and [row["index"] for row in rows] == list(range(6))
