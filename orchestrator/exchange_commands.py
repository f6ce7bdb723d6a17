"""The commands for FMUs that come from others or go to them."""

from __future__ import annotations

from .options import app  # noqa: F401
