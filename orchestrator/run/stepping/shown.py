"""A session as a notebook shows it: the time that is reached, how it stands, and the values of its outputs now."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...markup import boxed, element, safe, table

if TYPE_CHECKING:
    from .stepping import Stepping

VALUES = 16  # outputs that are shown
RED = "#c2372d"  # legible on white and black


def session_html(session: Stepping) -> str:
    """All texts are escaped; lines and words take the colour of the page."""
    start = session.plan.clock.time(0)
    done = (session.time - start) / (session.stop - start)
    way = element("progress", value=f"{done:.4f}", max="1", style="width:12em;vertical-align:middle")
    how = state_of(session)
    head = [
        element("b", safe(session.plan.system.name)),
        f" {way} {session.time:.9g} s of {session.stop:g} s · ",
        element("span", safe(how), style=f"color:{RED}" if session.failure else ""),
    ]
    return boxed(element("div", head), _values(session))


def state_of(session: Stepping) -> str:
    """Whether it can go on, and if not why."""
    if session.failure:
        return session.failure
    if session.ended:
        return session.ended
    if session.closed:
        return "closed: its FMUs are given back"
    return "at the stop" if session.time >= session.stop else "can be stepped"


def _values(session: Stepping) -> str:
    """The outputs now, the first of each component; none of a session that cannot be asked any more."""
    if session.closed or session.failure:
        return ""
    by_owner: dict[str, list[str]] = {}
    for owner, variable in session.plan.layout.outputs:
        by_owner.setdefault(owner, []).append(variable)
    each = max(1, VALUES // max(1, len(by_owner)))
    rows = []
    for owner, variables in by_owner.items():
        fmu = session.plan.system.components[owner].fmu
        for variable in variables[:each]:
            value = session.get(f"{owner}.{variable}")
            unit = fmu.variables[variable].unit or ""
            text = f"{value:.6g}" if isinstance(value, float) else str(value)
            rows.append([safe(f"{owner}.{variable}"), safe(text[:40]), safe("" if unit == "1" else unit)])
    hidden = sum(map(len, by_owner.values())) - len(rows)
    more = element("div", f'and {hidden} more: session.get("NAME")', style="opacity:0.75;font-size:90%")
    return table(("output", "now", "unit"), rows[: 2 * VALUES], (0, 2)) + (more if hidden > 0 else "")
