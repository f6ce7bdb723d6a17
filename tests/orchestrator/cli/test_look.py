"""What `plot` and `compare` say of folders that hold no result."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import rovbrush


@pytest.mark.parametrize("command", ["plot", "compare"])
@pytest.mark.parametrize(
    ("name", "what"), [("nowhere", "no result.nc: there is no such folder"), ("empty", "no result.nc")]
)
def test_a_folder_without_a_result_is_named_as_that(
    command: str, name: str, what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    (tmp_path / "empty").mkdir()
    folders = [tmp_path / name] * (2 if command == "compare" else 1)
    assert rovbrush(monkeypatch, command, *folders) == 2
    told = " ".join(capsys.readouterr().err.split())
    assert name in told and what in told and "--out" not in told.split("give the folder")[0]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["empty"] and not list((tmp_path / "empty").iterdir())
