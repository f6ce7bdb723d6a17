"""A TOML file that nothing could mean is one error with file and line; what it holds is found without looking twice."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.toml import lines
from rovbrush.orchestrator.toml.file import LARGEST, TomlFile

WRONG = {
    "lists too deep for the parser": ("x = 1\ny = " + "[" * 3000 + "]" * 3000, "too deep within each other", "line 2"),
    "lists too deep for anything": ("x = 1\ny = " + "[" * 40 + "]" * 40, "y: lists or tables stand too deep", "line 2"),
    "tables too deep": ("x = 1\n" + ".".join("a" * 40) + " = 1", "too deep within each other", "line 2"),
    "a number of 5000 digits": ("x = 1\n\ny = " + "9" * 5000, "too many digits", "line 3"),
    "a number of 5000 hexadecimal digits": ("[t]\ny = 0x" + "f" * 5000, "t.y: a number has too many digits", "line 2"),
    "a name of 50 000 parts": ("x = 1\n" + "a." * 50_000 + "b = 1", "a name of so many parts", "line 2"),
    "NUL in a text": ('[t]\ny = "a\\u0000b"', "t.y: the character NUL is not allowed", "line 2"),
    "NUL in a key": ('[t]\n"a\\u0000b" = 1', "the character NUL is not allowed", "line 1"),
    "no TOML": ("x = 1\ny = ", "is not valid TOML", "line 2"),
}


@pytest.mark.parametrize("slip", WRONG)
def test_what_no_file_can_mean_is_named_with_its_line(slip: str, tmp_path: Path) -> None:
    text, says, where = WRONG[slip]
    path = tmp_path / "case.toml"
    path.write_text(text)
    with pytest.raises(InputError) as error:
        TomlFile(path)
    assert says in str(error.value) and "case.toml" in str(error.value)
    assert where in str(error.value) or "end of document" in str(error.value)


@pytest.mark.parametrize("name", ["a\0b.toml", "x" * 3000 + ".toml", "none.toml"])
def test_a_name_that_no_file_can_have_is_an_error(name: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be read"):
        TomlFile(tmp_path / name)


def test_a_folder_a_pipe_and_a_very_large_file_are_refused_before_they_are_read(tmp_path: Path) -> None:
    large, pipe = tmp_path / "large.toml", tmp_path / "pipe.toml"
    with large.open("wb") as file:
        file.truncate(LARGEST + 1)
    os.mkfifo(pipe)
    for path, says in ((large, "more than 16 MB"), (pipe, "is no file"), (tmp_path, "is no file")):
        with pytest.raises(InputError, match=says):
            TomlFile(path)


def test_each_of_many_connections_is_located_by_looking_at_a_few_lines(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    looked, real = [0], lines._holds
    monkeypatch.setattr(lines, "_holds", lambda *words: (looked.__setitem__(0, looked[0] + 1), real(*words))[1])
    path, entries = tmp_path / "case.toml", [f"a.y{k} -> b.u{k}" for k in range(1000)]
    path.write_text("connections = [\n" + "".join(f'  "{entry}",\n' for entry in entries) + "]\n")
    file = TomlFile(path)
    assert [file.at(entry) for entry in entries] == [f"(case.toml, line {k + 2})" for k in range(1000)]
    assert looked[0] <= 2 * len(entries)
