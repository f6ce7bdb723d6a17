"""A system in which somebody presses Ctrl-C."""

from __future__ import annotations

from helpers import Part


def pressing(mode: int) -> dict[str, Part]:
    """A system in which somebody presses Ctrl-C: mode 4 at the end of initialization, mode 5 in the step to 6 ms."""
    parts: dict[str, Part] = {"fast": ("wave", "0.5 ms", {"c1": 1.0})}
    return parts | {"p": ("plain", "1 ms", {"mode": mode, "=u": 0.0, "=temperature": 0.0, "=speed": 0.0})}
