"""Libraries that not every installation has: which extra of the package brings one, and the line to type for it."""

from __future__ import annotations

import re
from importlib import import_module
from importlib.metadata import PackageNotFoundError, requires
from importlib.util import find_spec
from typing import Any

from .errors import InputError

OTHERWISE = {"foxglove": "foxglove-sdk", "rerun": "rerun-sdk", "paho": "paho-mqtt"}  # packages by their modules
NOT_FOR_USERS = ("all", "test")  # extras that only gather others


def needed(module: str, what: str) -> Any:
    """A module of an extra. Raises InputError that says what needs it, and how to install it."""
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        raise InputError(f"{what} needs {how_to_install(error) or error}") from None


def require(module: str, what: str) -> None:
    """Raise InputError, as `needed`, where a module is not installed; nothing is loaded."""
    if find_spec(module) is None:
        error = ModuleNotFoundError(f"No module named '{module}'", name=module)
        raise InputError(f"{what} needs {how_to_install(error) or error}")


def how_to_install(error: ModuleNotFoundError) -> str:
    """`scipy: python -m pip install 'rovbrush[study]'`; empty where the missing module is of no extra."""
    module = (error.name or "").partition(".")[0]
    extra = extra_of(module)
    return f"{module}: python -m pip install 'rovbrush[{extra}]'" if extra else ""


def extra_of(module: str) -> str:
    """The extra that brings a module, the one with the fewest packages; empty if none does."""
    try:
        stated = requires("rovbrush") or []
    except PackageNotFoundError:
        return ""
    extras: dict[str, set[str]] = {}
    for text in stated:
        found = re.match(r"""([\w.-]+).*;.*extra == ['"]([\w-]+)['"]""", text)
        if found and found[2] not in NOT_FOR_USERS:
            extras.setdefault(found[2], set()).add(_normal(found[1]))
    package = _normal(OTHERWISE.get(module, module))
    holding = [extra for extra, names in extras.items() if package in names]
    return min(holding, key=lambda extra: len(extras[extra]), default="")


def _normal(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()
