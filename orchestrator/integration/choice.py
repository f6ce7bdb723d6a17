"""Which method integrates a group where nobody says: by what its FMUs say of themselves."""

from __future__ import annotations

from typing import NamedTuple

from .settings import Method, SolverSettings
from .stiff.libraries import is_there, why_missing

MANY = 50  # states, from which on a model is taken for a stiff one: a discretized field, a network


class Chosen(NamedTuple):
    """A method, and why. `instead`: what a person must know of it where another one would be better."""

    method: Method
    reason: str
    instead: str = ""


def choose(settings: SolverSettings, states: int) -> Chosen:
    """The method for a group of so many states; see SolverSettings."""
    if settings.method:
        return Chosen(settings.method, "stated in the system file")
    if states >= MANY:
        reason = f"{states} states: so many are mostly a field or a network, which is stiff"
        if is_there():
            return Chosen("cvode", reason)
        return Chosen("dormand-prince", f"not by cvode, though it has {reason}: {why_missing()}", why_missing())
    if not is_there():
        return Chosen("dormand-prince", f"nothing says that it is stiff; {why_missing()}")
    return Chosen(
        "dormand-prince",
        "nothing says that it is stiff; should its steps prove to be limited by stability, CVODE goes on from there",
    )
