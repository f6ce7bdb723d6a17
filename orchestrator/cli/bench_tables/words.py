"""What the tables share."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

Rows = Sequence[Mapping[str, Any]]


def medians(rows: Rows) -> str:
    """How often each was measured, in words."""
    return f"medians of {rows[0]['runs']} runs" if rows[0]["runs"] > 1 else "one run of each"
