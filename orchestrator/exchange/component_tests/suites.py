"""The suites that installed packages publish, one per component, through entry points."""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import entry_points
from typing import Any, Protocol

from ...errors import InputError, nearest

GROUP = "rovbrush.behaviours"


class NotApplicableError(Exception):
    """A test needs what the unit under test does not have; the text says what."""


class Declared(Protocol):
    """One variable of a component's interface. `size` 0 is a scalar; `start` has one value per element."""

    @property
    def name(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def causality(self) -> str: ...
    @property
    def kind(self) -> str: ...
    @property
    def size(self) -> int: ...
    @property
    def depends(self) -> tuple[str, ...]: ...


class Suite(Protocol):
    """A component's interface and its tests, each a function of a unit under test whose docstring is the claim."""

    @property
    def name(self) -> str: ...
    @property
    def interface(self) -> tuple[Declared, ...]: ...
    @property
    def essential(self) -> tuple[str, ...]: ...
    @property
    def tests(self) -> tuple[Callable[[Any], None], ...]: ...


def suite_of(component: str) -> Suite:
    """The suite of a component. Raises InputError if no installed package publishes one of that name."""
    found = {point.name: point for point in entry_points(group=GROUP)}
    if component not in found:
        raise InputError(f"no tests are known for a component '{component}'{nearest(component, found)}")
    suite: Suite = found[component].load()
    return suite


def claim_of(test: Callable[[Any], None]) -> str:
    """The first paragraph of the docstring in one line; the name where there is none."""
    text = (test.__doc__ or test.__name__.removeprefix("test_").replace("_", " ")).strip()
    return " ".join(text.split("\n\n")[0].split())
