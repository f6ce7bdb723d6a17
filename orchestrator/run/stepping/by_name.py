"""Values of a session by their names: found once, then read and set without looking for them again."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

from ...errors import InputError, nearest
from ...plan.plan import Plan
from ...system.file.recorded import matches
from ..memory.ports import reader_of, writer_of
from ..session.session import Session


def reader_by_name(session: Session, name: str) -> Callable[[], Any]:
    """What gives a value at any time, as long as the session is open. Raises InputError for an unknown name."""
    read = partial(Session.get, session, name)
    read()  # or raise
    component, _, variable = session.plan.system.full_name(name).partition(".")
    return reader_of(session.plan, session.memory, (component, variable)) or read


def writer_by_name(session: Session, name: str, usual: Callable[[str, object], None]) -> Callable[[float], None]:
    """What sets an input to a number: as `usual` does it the first time, then quicker where it can."""
    quick: Callable[[float], bool] | None = None

    def write(value: float) -> None:
        nonlocal quick
        if quick is None or session.closed or session.over or not quick(value):
            usual(name, value)
            quick = quick or _quick_writer(session, name)

    return write


def _quick_writer(session: Session, name: str) -> Callable[[float], bool]:
    """What sets an input that `Session.set` can set, where nothing but its FMU must know."""
    plan = session.plan
    component, _, variable = plan.system.full_name(name).partition(".")
    kept = (component, variable) in plan.layout.inputs  # its cell is what counts: events change it too
    kept |= variable in plan.system.components[component].at_events
    return _leave if kept else writer_of(session.instances[component], variable)


def _leave(_value: float) -> bool:
    """A writer that leaves every value to `Session.set`."""
    return False


def outputs_named(plan: Plan, patterns: Iterable[str]) -> list[str]:
    """The outputs and signals of the coupling that patterns such as `motor.*` name.

    Raises InputError for one that names nothing.
    """
    known = [".".join(key) for key in (*plan.layout.outputs, *plan.layout.extras)]
    found: list[str] = []
    for pattern in patterns:
        hits = [name for name in known if matches((pattern,), name)]
        if not hits:
            raise InputError(f"no output '{pattern}'{nearest(pattern, known)}")
        found += hits
    return list(dict.fromkeys(found))
