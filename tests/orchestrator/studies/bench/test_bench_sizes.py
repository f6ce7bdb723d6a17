"""`rovbrush bench sizes` measures what packages name, and says so where none does."""

from __future__ import annotations

import re
from importlib.metadata import entry_points
from pathlib import Path

import pytest
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.studies.bench.components import sizes


def test_the_components_name_cases() -> None:
    (entry,) = entry_points(group=sizes.GROUP)
    assert {case.component for case in entry.load()()} == {"filament_brush"}


def test_an_installation_that_names_nothing_is_an_error_and_no_empty_table(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sizes, "entry_points", lambda **_: ())
    with pytest.raises(InputError, match=re.escape("(entry points of the group rovbrush.sizes)")):
        list(sizes.size_rows(tmp_path, tmp_path, True))
