"""Here whole systems of shipped components are run: on the FMUs that take the least time."""

from __future__ import annotations

from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def fmus(shipped: Path) -> Path:
    """The components' FMUs, native where C can be compiled."""
    return shipped
