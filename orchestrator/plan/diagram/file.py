"""The block diagram as a file of its own."""

from __future__ import annotations

from pathlib import Path

from ...errors import InputError, shown
from ...files import prepare_folder, write_file
from ..plan import Plan
from .draw import block_diagram


def require_svg(path: Path, option: str = "--svg") -> None:
    """Raise InputError unless a file can be a picture: another one, a system file say, is not written over."""
    if path.suffix.lower() != ".svg" or path.is_dir():
        raise InputError(f"{option} {shown(path)} is no name for a picture; take one that ends with .svg")
    prepare_folder(path.absolute().parent, option)


def write_diagram(plan: Plan, path: Path) -> Path:
    """Write it. Raises InputError for a name that does not end with .svg, RunError if the disk refuses."""
    require_svg(path)
    text = block_diagram(plan, alone=True)
    return write_file(path, lambda temporary: temporary.write_text(text, encoding="utf-8"))
