"""The systems and parameter sets that come with the package."""

from __future__ import annotations

from pathlib import Path

SYSTEMS = Path(__file__).parent.parent.parent / "systems"
SWEEPS = SYSTEMS / "sweeps"
SCHEMAS = SYSTEMS / "schema"  # what editors know of them: `#:schema` in their first lines


def shipped_systems() -> list[str]:
    """Names of the systems that come with the package."""
    return sorted(path.stem for path in SYSTEMS.glob("*.toml") if "[components." in path.read_text(encoding="utf-8"))
