"""Settings of an algorithm: a frozen dataclass with fields declared as the keys of files are: `system/schema`.

    tolerance: Annotated[Positive, Meta(description="of a step [1]")] = 1e-4

A `Span` is a time; where nothing is stated the algorithm chooses. A `__post_init__` raises InputError where values do
not fit each other.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class NoSettings:
    """An algorithm that has none."""
