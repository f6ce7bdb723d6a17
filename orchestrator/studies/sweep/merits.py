"""Figures of merit that a study asks for: by their names, or as they are written (`peak motor.i`)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...errors import InputError, nearest
from ...system.file.merits import OPERATIONS, merit


def written_out(names: Iterable[str]) -> dict[str, str]:
    """Those of `names` that are no names but an operation with its signals, called as they are written."""
    return {name: name for name in names if " " in name.strip() and merit(name)[0] in OPERATIONS}


def require_known(names: Iterable[str], units: Mapping[str, str], option: str) -> None:
    """Raise InputError for a name that is no figure of merit of the system."""
    for name in names:
        if name not in units:
            raise InputError(
                f"{option} {name}: no figure of merit of the system{nearest(name, units)}; or write one, such as "
                f'{option} "mean component.variable" (operations: {", ".join(OPERATIONS)})'
            )
