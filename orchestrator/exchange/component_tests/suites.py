"""The suites that installed packages publish, one per component, through entry points."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any, Protocol

from ...errors import InputError, nearest, or_else

GROUP = "rovbrush.behaviours"
FILES = ("behaviour.py", "behaviour/__init__.py")  # one of them, which has the SUITE


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
    """The suite of a component: one that an installed package publishes, or that in a folder's `behaviour.py`
    or `behaviour/__init__.py`.

    Raises InputError where there is none.
    """
    found = {point.name: point for point in entry_points(group=GROUP)}
    if component in found:
        suite: Suite = found[component].load()
        return suite
    folder = Path(component)
    for file in FILES:
        if (folder / file).is_file():
            return _suite_in(folder.resolve(), file)
    if folder.is_dir() or len(folder.parts) > 1:
        raise InputError(f"no tests are known for {folder}: it has no {FILES[0]}")
    hint = or_else(nearest(component, found), "give the folder of one")
    raise InputError(f"no tests are known for a component '{component}'{hint}")


def _suite_in(folder: Path, file: str) -> Suite:
    """The suite of a component that is not installed, imported from its folder or the package around it."""
    top, names = folder.parent, [folder.name]
    while (top / "__init__.py").is_file():
        top, names = top.parent, [top.name, *names]
    if str(top) not in sys.path:
        sys.path.insert(0, str(top))
    try:
        module = importlib.import_module(".".join([*names, "behaviour"]))
    except ImportError as error:
        raise InputError(f"{folder / file} cannot be imported: {error}") from error
    if Path(str(module.__file__)).resolve() != folder / file:
        raise InputError(f"{folder}: Python has another module {names[0]}: {module.__file__}; rename the folder")
    if not hasattr(module, "SUITE"):
        raise InputError(f"{folder / file} has no SUITE, which names the tests and the interface")
    suite: Suite = module.SUITE
    return suite


def claim_of(test: Callable[[Any], None]) -> str:
    """The first paragraph of the docstring in one line; the name where there is none."""
    text = (test.__doc__ or test.__name__.removeprefix("test_").replace("_", " ")).strip()
    return " ".join(text.split("\n\n")[0].split())
