"""The documentation inside of an exported FMU: what it is made of, and what its user must know."""

from __future__ import annotations

from html import escape

from ..clock import seconds_text
from ..plan.explain import explain
from .prepared import Prepared


def pages(found: Prepared) -> dict[str, bytes]:
    """`documentation/index.html`, and the pages that the components' FMUs brought."""
    system, step, whole = found.plan.system, found.code.cycle.step, found.code.cycle.whole
    entries: dict[str, bytes] = {}
    rows = []
    for name, component in system.components.items():
        unit = found.units[name]
        own = unit.fmu.folder / "documentation"
        for path in sorted(own.rglob("*")) if own.is_dir() else []:
            if path.is_file():
                entries[f"documentation/{unit.prefix}/{path.relative_to(own).as_posix()}"] = path.read_bytes()
        page = f"{unit.prefix}/index.html" if (own / "index.html").is_file() else ""
        shown = escape(unit.fmu.path.name)
        link = f'<a href="{page}">{shown}</a>' if page else shown
        kind = "in C" if unit.in_c else "as a library"
        rows.append(
            f"<tr><td>{escape(name)}</td><td>{link}</td><td>{seconds_text(component.period)}</td><td>{kind}</td></tr>"
        )
    text = [
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">', f"<title>{escape(system.name)}</title>",
        "<style>body{font-family:sans-serif;max-width:60em;margin:2em auto;padding:0 1em}td,th{padding:.2em .8em;"
        "text-align:left}pre{overflow-x:auto;font-size:85%}</style></head><body>",
        f"<h1>{escape(system.name)}</h1><p>{escape(system.description)}</p>",
        "<p>A whole system as one FMU: its plan in C, linked with its components. Communication points are instants of "
        "the plan; multiples of the fastest period always are.</p>",
        "<table><tr><th>component</th><th>FMU</th><th>period</th><th></th></tr>", *rows, "</table>",
        f"<p>At most {step.arithmetic} floating-point operations and {step.calls} calls of components from an instant "
        f"to the next, {whole.arithmetic} and {whole.calls} in a hyperperiod, beside what components do inside.</p>",
        f"<h2>The plan</h2><pre>{escape(explain(found.plan))}</pre></body></html>",
    ]  # fmt: skip
    entries["documentation/index.html"] = "\n".join(text).encode()
    return entries
