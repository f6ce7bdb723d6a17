"""The notebooks of the documentation run from top to bottom, hold no outputs, and show what they are meant to show."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import nbformat
import pytest
from helpers import ROOT
from nbclient import NotebookClient

FOLDER = ROOT / "docs" / "notebooks"
SHOWN = {  # what must be in the outputs
    "first_run": ["every 500 us", "omega_b_mean", "<polygon", "did you mean", "image/png"],
    "rates_and_coupling": ["every 20 ms", "is aliased", "can be stepped", "image/png"],
    "controller_design": ["time constant", "speed at the end", "image/png"],
}


def cells(path: Path) -> list[Any]:
    return list(nbformat.read(path, as_version=4).cells)


def test_every_notebook_is_listed_and_tried() -> None:
    names = {path.stem for path in FOLDER.glob("*.ipynb")}
    assert names == set(SHOWN)
    index = (FOLDER / "index.md").read_text(encoding="utf-8")
    assert all(f"({name}.ipynb)" in index and f"\n{name}\n" in index for name in names)


@pytest.mark.parametrize("name", SHOWN)
def test_a_notebook_is_kept_without_outputs(name: str) -> None:
    notebook = nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)
    nbformat.validate(notebook)
    for cell in notebook.cells:
        assert cell.cell_type != "code" or (cell.outputs == [] and cell.execution_count is None), cell.source


@pytest.mark.parametrize("name", SHOWN)
def test_a_notebook_runs_from_top_to_bottom(
    name: str, shipped: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for key, value in {"ROVBRUSH_FMUS": shipped, "TMPDIR": tmp_path, "IPYTHONDIR": tmp_path / "ipython"}.items():
        monkeypatch.setenv(key, str(value))
    notebook = nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)
    client = NotebookClient(notebook, timeout=300, kernel_name="python3", resources={"metadata": {"path": tmp_path}})
    client.execute(env=dict(os.environ))
    said = str([cell.outputs for cell in notebook.cells if cell.cell_type == "code"])
    assert all(words in said for words in SHOWN[name]), [words for words in SHOWN[name] if words not in said]
    assert "Traceback" not in said and "Warning" not in said
