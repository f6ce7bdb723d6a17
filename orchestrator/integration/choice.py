"""Which method integrates a group where nobody says: by what its FMUs say of themselves."""

from __future__ import annotations

from typing import NamedTuple

from .settings import Method, SolverSettings
from .stiff.sundials import is_there

MANY = 50  # states, from which on a model is taken for a stiff one: a discretized field, a network


class Chosen(NamedTuple):
    """A method, and why."""

    method: Method
    reason: str


def choose(settings: SolverSettings, states: int) -> Chosen:
    """The method for a group of so many states; see SolverSettings."""
    if settings.method:
        return Chosen(settings.method, "stated in the system file")
    if states >= MANY and is_there():
        return Chosen("cvode", f"{states} states: so many are mostly a field or a network, which is stiff")
    if not is_there():
        return Chosen("dormand-prince", "there is no CVODE for this platform")
    return Chosen(
        "dormand-prince",
        "nothing says that it is stiff; should its steps prove to be limited by stability, CVODE goes on from there",
    )
