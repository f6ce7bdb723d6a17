"""The text of a system's C files: what all systems share with its names in it, and what is its own."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from ...errors import counted
from ...plan.plan import Plan
from ..units import EXACT, SOURCES, Unit
from .beginning import Beginning
from .exchange import Key, Names
from .exposed import Exposed
from .happening import Happening
from .instants import Cycle, Instants
from .names import SHORT, comment, system_identifier
from .operations.cost import Cost
from .operations.rows import Rows
from .requirements import requirements
from .tables import (
    cells_table,
    first_of_steps,
    in_cells_table,
    instants_table,
    parts_table,
    references_table,
    sizes,
    tables_table,
    token,
    variables_table,
    words_table,
)

SHARED = ("core.c", "values.c", "messages.c", "loops.c", "parts.c", "state.c")


@dataclass(frozen=True)
class Code:
    """A system in C: its name there, its files by path, those to compile, what it shows, and what a step costs."""

    name: str
    files: dict[str, bytes]
    compiled: tuple[str, ...]
    main: str
    shown: list[Exposed]
    cycle: Cycle
    units: tuple[Unit, ...]


def code_of(plan: Plan, units: Mapping[str, Unit], shown: list[Exposed], solutions: Mapping[Key, float]) -> Code:
    """The files of a system but those of its units; `units`: by component."""
    name = system_identifier(plan.system.name)
    names = Names(plan, name, dict(units))
    rows = Rows(names)
    instants = Instants(names, rows)
    cycle, last = instants.cycle(plan.cycle), instants.cycle(plan.last)
    happening = Happening(names, instants) if plan.system.events else None
    happenings = happening.texts() if happening else []
    beginning = Beginning(names, shown, solutions).functions()
    own = tuple({unit.prefix: unit for unit in units.values()}.values())
    versions = {unit.version for unit in own}
    functions = "\n".join((SOURCES / f"functions{v}.h").read_text(encoding="utf-8") for v in sorted(versions))
    counts = _counts(cycle)
    places = {
        "@TITLE@": comment(f"{plan.system.name}: {plan.system.description}"),
        "@COUNTS@": counts,
        "@SIZES@": sizes(
            plan,
            names,
            shown,
            versions,
            len(cycle.instants),
            len(last.instants),
            happening.sizes() if happening else {},
        ),
        "@HEADERS@": "\n".join(f'#include "fmi{v}FunctionTypes.h"' for v in sorted(versions)),
        "@FUNCTIONS@": functions,
        "@EXACT@": EXACT,
        "@TOKEN@": token(plan, shown),
        "@TABLES@": tables_table(plan, names),
    }
    files = {f"{name}.h": filled("system.h", name, places), f"{name}_inside.h": filled("inside.h", name, places)}
    shared = (
        *SHARED, *(f"parts{v}.c" for v in sorted(versions)), *("events.c", "faults.c") * bool(happening),
        *("steps.c",) * (not plan.algorithm.one_pass),
    )  # fmt: skip
    for source in shared:
        files[f"{name}_{source}"] = filled(source, name, places)
    files[f"{name}_main.c"] = filled("main.c", name, places)
    parts = [
        f"/* {places['@TITLE@']}\n\n   Its plan as functions: what ends and what begins at an instant;\n"
        f"   {name}_cycle lists them over a hyperperiod. */",
        f'#include "{name}_inside.h"\n',
        "\n".join(f"#define {short} {name}_{short}" for short in SHORT),
        parts_table(plan, names, own),
        cells_table(names),
        references_table(names),
        "\n".join([*rows.constants(), *instants.solvers]),
        "\n".join(instants.starts_tables()),
        *instants.found.texts,
        *happenings,
        *(
            []
            if plan.algorithm.steps_vary
            else [
                instants_table(name, "cycle", cycle, "INSTANTS"),
                instants_table(name, "last", last, "LAST_INSTANTS"),
            ]
        ),
        *beginning,
        requirements(plan, shown, name),
        variables_table(name, shown),
        in_cells_table(name, shown),
        first_of_steps(plan, name),
        words_table(name, names),
        f"const int {name}_loop_places[{name}_LOOPS + 1] = {{"
        + ", ".join([*(str(first + 1) for first in plan.layout.loops), "0"])
        + "};",
    ]
    files[f"{name}.c"] = ("\n\n".join(part for part in parts if part) + "\n").encode()
    compiled = (f"{name}.c", *(f"{name}_{source}" for source in shared))
    return Code(name, files, compiled, f"{name}_main.c", shown, cycle, own)


def filled(source: str, name: str, places: Mapping[str, str]) -> bytes:
    """A file of `sources`/ for a system: its name for SYSTEM, and what stands at the places."""
    found = (SOURCES / source).read_text(encoding="utf-8")
    found = found.replace('#include "inside.h"', f'#include "{name}_inside.h"')
    found = re.sub(r"\bSYSTEM(?=_|\b)", name, found)
    for key, value in places.items():
        found = found.replace(key, value)
    return found.encode()


def _words_of(cost: Cost) -> str:
    return (
        f"{counted(cost.arithmetic, 'floating-point operation')}, {counted(cost.calls, 'call')} of FMI functions, "
        f"{counted(cost.moves, 'value')} moved"
    )


def _counts(cycle: Cycle) -> str:
    return (
        f"Worst case of a step, from an instant to the next: {_words_of(cycle.step)};\n   of a hyperperiod: "
        f"{_words_of(cycle.whole)}. What the components do inside of their\n   functions comes on top."
    )
