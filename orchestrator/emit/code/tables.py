"""The tables of a system in C: sizes, components, cells, variables, instants, and what is recorded."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping, Sequence

from ...fmu.types import BOOLEAN, FLOAT, TEXT, FmiType
from ...loop.operations import RECORD
from ...plan.plan import Plan
from ...results.files.csv import csv_text, rate_names
from ...results.signals import about, label
from ..carried import members
from ..units import Unit
from .exchange import Key, Names
from .exposed import OUTPUT, Exposed
from .instants import Cycle
from .names import comment, number, text, whole

TYPES = {"Real": "FLOAT64", "Integer": "INT32", "Boolean": "BOOLEAN", "String": "STRING"}


def sizes(
    plan: Plan, names: Names, shown: Sequence[Exposed], versions: set[int], instants: int, last: int,
    more: Mapping[str, object],
) -> str:  # fmt: skip
    """Constants of the header; `more`: those of events."""
    clock, layout, name = plan.clock, plan.layout, names.system
    arrays = [place.count for c in plan.system.components.values() for place in c.fmu.places.values()]
    loops = [len(block.torn) for block in plan.start if block.loop]
    loops += [len(b.torn) for b in plan.instants.blocks(frozenset(names.components) - set(plan.early)) if b.loop]
    sizes = {
        "CELLS": max(layout.size, 1), "VARIABLES": max(len(shown), 1), "PARTS": len(names.components),
        "BLOCKS": len(plan.start), "LOOPS": len(layout.loops), "SOLVER": max(layout.loop_cells, 1),
        "LARGEST_LOOP": max([1, *loops]), "LARGEST_ARRAY": max([1, *arrays]), "INSTANTS": instants,
        "LAST_INSTANTS": last, "TABLES": max(len(plan.groups), 1),
        "FMI2": int(2 in versions), "FMI3": int(3 in versions), **(more or {"EVENTS": 0}),
    }  # fmt: skip
    algorithm = plan.algorithm
    sizes |= {
        "REPEATS": int(algorithm.saves_states), "VARIES": int(algorithm.steps_vary), "EVEN": algorithm.even,
        "WORK": len(algorithm.arrays(plan).work),
    }  # fmt: skip
    times = {
        "NUMERATOR": clock.numerator, "DENOMINATOR": clock.denominator, "HYPERPERIOD": clock.hyperperiod,
        "START": clock.start, "STOP": clock.stop, "CYCLES": clock.cycles,
    }  # fmt: skip
    lines = [f"#define {name}_TITLE {text(plan.system.name)}"]
    lines += [f"#define {name}_{key} {value}" for key, value in sizes.items()]
    lines += [f"#define {name}_{key} {whole(value)}" for key, value in times.items()]
    lines.append(f"#define {name}_TICK {number(float(clock.seconds(1)))} /* s */")
    return "\n".join(lines)


def token(plan: Plan, shown: Sequence[Exposed]) -> str:
    """What a state begins with, so that another system's is refused."""
    digest = hashlib.sha256(repr([plan.layout.size, plan.clock, [e.name for e in shown]]).encode())
    for component in plan.system.components.values():
        digest.update(component.fmu.digest.encode())
    digest.update(plan.cycle.tobytes() + plan.coefficients.tobytes())
    return digest.hexdigest()[:32]


def parts_table(plan: Plan, names: Names, units: Sequence[Unit]) -> str:
    lines = ["enum { " + ", ".join(names.parts.values()) + " };", ""]
    for unit in units:
        lines.append(f"/* {unit.fmu.path.name}, {unit.fmu.standard}, sha256 {unit.fmu.digest[:12]} */")
        there = [m for m in members(unit.version) if f"fmi{unit.version}{m}" in unit.functions]
        if unit.loader:
            lines += [f"extern fmi{unit.version}{m}TYPE *{unit.function(m)};" for m in there]
            lines += [
                f"extern Functions{unit.version} {unit.prefix}_functions;",
                f"int {unit.prefix}_load({names.system} *s);",
                "",
            ]
            continue
        lines += [f"extern fmi{unit.version}{m}TYPE {unit.function(m)};" for m in there]
        inside = [f"    {unit.function(m) if m in there else 'NULL'}," for m in members(unit.version)]
        lines += [f"static const Functions{unit.version} {unit.prefix}_functions = {{", *inside, "};", ""]
    lines.append(f"const Part {names.system}_parts[{names.system}_PARTS] = {{")
    for name, component in plan.system.components.items():
        unit, fmu = names.units[name], component.fmu
        experiment = fmu.description.defaultExperiment
        stated = float(experiment.tolerance) if experiment is not None and experiment.tolerance else 0.0
        tolerance = component.tolerance if component.tolerance is not None else stated
        folder = text(f"{unit.prefix}/resources") if (fmu.folder / "resources").is_dir() else "NULL"
        token = fmu.description.guid if unit.version == 2 else fmu.description.instantiationToken
        saves, writes = int(fmu.can_save_state), int(fmu.can_serialize_state)
        load = "NULL" if unit.in_c else f"{unit.prefix}_load"
        lines.append(
            f"    {{{text(name)}, {text(token)}, {folder}, {unit.version}, &{unit.prefix}_functions, "
            f"{number(tolerance)}, {saves}, {writes}, {load}}},"
        )
    return "\n".join([*lines, "};"])


def cells_table(names: Names) -> str:
    known = {
        slot: key for table in (names.plan.layout.inputs, names.plan.layout.outputs) for key, slot in table.items()
    }
    lines = []
    for slot, (cell, words) in enumerate(zip(names.cells, names.words, strict=True)):
        said = words
        if slot in known:
            name, variable = known[slot]
            v = names.plan.system.components[name].fmu.variables[variable]
            said += (f": {v.description}" if v.description else "") + (f" [{v.unit}]" if v.unit else "")
        elif extra := names.extras.get(slot):
            said += f": {extra.description} [{extra.unit}]"
        lines.append(f"    {cell}, /* {comment(said)} */")
    return "\n".join(["/* The vector of signals. */", "enum {", *lines, "};"])


def references_table(names: Names) -> str:
    return "\n".join(
        f"static const unsigned {name}[] = {{{', '.join(map(str, references))}}};"
        for references, name in names.references.items()
    )


def instants_table(name: str, which: str, cycle: Cycle, size: str) -> str:
    entries = [
        f"    {{{tick}, {begin or 'NULL'}, {end or 'NULL'}, {starts or 'NULL'}}},"
        for tick, begin, end, starts in cycle.instants
    ]
    return "\n".join([f"const Instant {name}_{which}[{name}_{size}] = {{", *entries, "};"])


def variables_table(name: str, shown: Iterable[Exposed]) -> str:
    lines = [f"const {name}_Variable {name}_variables[{name}_VARIABLES] = {{"]
    for e in shown:
        kind = f"{name}_{_kind(e.kind)}"
        causality = f"{name}_{e.causality.upper()}"
        said = text(e.start) if isinstance(e.start, str) else "NULL"
        start = "{0.0}"
        if not isinstance(e.start, (str, bytes)):
            start = f"{{{number(float(e.start))}}}" if e.kind.real else f"{{.whole = {whole(int(e.start))}}}"
        lines.append(
            f"    {{{text(e.name)}, {text(e.unit or '')}, {kind}, {causality}, {e.component}, {_type(e.kind)}, "
            f"{e.slot}, {e.reference}, {e.index}, {e.count}, {int(e.given)}, {start}, {said}}},"
        )
    if len(lines) == 1:  # C has no empty arrays
        lines.append(f'    {{"", "", {name}_REAL, {name}_HIDDEN, -1, T_FLOAT64, -1, 0, 0, 1, 0, {{0.0}}, NULL}},')
    return "\n".join([*lines, "};"])


def first_of_steps(plan: Plan, name: str) -> str:
    """What macro steps that are repeated or vary begin with."""
    if plan.algorithm.one_pass:
        return ""
    arrays = plan.algorithm.arrays(plan)
    lines = [f"const double {name}_first_work[{name}_WORK] = {{{', '.join(map(number, arrays.work.tolist()))}}};"]
    if plan.algorithm.steps_vary:
        lines.append(f"const int64_t {name}_first_clock[7] = {{{', '.join(map(str, arrays.clock.tolist()))}}};")
    return "\n".join(lines)


def in_cells_table(name: str, shown: Iterable[Exposed]) -> str:
    """Where doubles are to be read at any step: outputs by their cells, -1 for all else."""
    cells = [e.slot if e.causality == OUTPUT and e.kind.code == FLOAT and e.kind.size == 8 else -1 for e in shown]
    return f"const int {name}_in_cells[{name}_VARIABLES] = {{{', '.join(map(str, cells or [-1]))}}};"


def _kind(kind: FmiType) -> str:
    return "REAL" if kind.real else "BOOLEAN" if kind.code == BOOLEAN else "TEXT" if kind.code == TEXT else "WHOLE"


def _type(kind: FmiType) -> str:
    if kind.name == "Enumeration":
        return "T_INT64" if kind.size == 8 else "T_INT32"
    return f"T_{TYPES.get(kind.name, kind.name.upper())}"


def words_table(name: str, names: Names) -> str:
    lines = [f"    {text(words)}," for words in names.words]
    return "\n".join([f"const char *const {name}_cells[{name}_CELLS] = {{", *lines, "};"])


def _column(names: Names, slot: int, key: Key) -> str:
    """What a column of a table holds: d, a double; i, a whole number; u, one that is never below zero."""
    if not names.whole[slot]:
        return "d"
    return "i" if names.memory.kind(key).signed else "u"


def tables_table(plan: Plan, names: Names) -> str:
    lines, entries = [], []
    for g, (group, file) in enumerate(zip(plan.groups, rate_names(plan), strict=True)):
        slots = group.slots.tolist()
        group_cells = list(zip(slots, group.columns, strict=True))
        most = 1
        if plan.algorithm.saves_states:
            most = max(int(((r[:, 0] == RECORD) & (r[:, 3] == g)).sum()) for r in (plan.cycle, plan.last)) or 1
        lines.append(f"static int64_t ROWS_{g}[{most * (len(slots) + 1)}];")
        lines.append(f"static const int CELLS_{g}[] = {{{', '.join(map(str, slots))}}};")
        heads = [".".join(key) for key in group.columns]
        heads = [csv_text(label(name, about(plan, name)[0])) for name in heads]
        lines.append(f"static const char *const HEADS_{g}[] = {{{', '.join(map(text, heads))}}};")
        lines.append(f"static const char KINDS_{g}[] = {text(''.join(_column(names, s, k) for s, k in group_cells))};")
        entries.append(f"    {{{text(file)}, {len(slots)}, CELLS_{g}, HEADS_{g}, KINDS_{g}, {most}, ROWS_{g}, 0}},")
    if not entries:
        return (
            'static int64_t NO_ROWS[1];\nstatic Table TABLES[] = {{"nothing.csv", 0, NULL, NULL, "", 1, NO_ROWS, 0}};'
        )
    return "\n".join([*lines, "static Table TABLES[] = {", *entries, "};"])
