"""Calls of FMI functions as C: values set and got together, and one by one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...fmu.types import BOOLEAN, FLOAT, FLOAT32, FmiType, function_type
from ...loop.operations import MOVE, PUSH
from ...plan.plan import Plan
from ...plan.speed.together import together
from ...run.memory.memory import Memory
from ..units import Unit
from .names import cell_identifiers, cell_words, identifiers, number

Key = tuple[str, str]


@dataclass(frozen=True)
class Block:
    """What one call exchanges: values of one type in cells one behind the other."""

    kind: FmiType
    first: int
    size: int
    references: tuple[int, ...]


class Names:
    """A plan with the names that its components, cells and FMUs have in C."""

    def __init__(self, plan: Plan, system: str, units: dict[str, Unit]) -> None:
        self.plan, self.system, self.units = plan, system, units  # units: by component
        self.components = list(plan.system.components)
        self.parts = dict(
            zip(self.components, identifiers(f"part_{name}".upper() for name in self.components), strict=True)
        )
        self.words = cell_words(plan)
        self.extras = {extra.slot: extra for extra in plan.layout.extras.values()}
        prefixes = {unit.prefix for unit in units.values()}
        taken = {*self.parts.values(), *(f"{prefix}_{what}" for prefix in prefixes for what in ("functions", "load"))}
        self.cells = cell_identifiers(self.words, taken, system)
        self.memory = Memory(plan)
        layout = plan.layout
        self.whole = np.zeros(max(layout.size, 1), dtype=bool)  # cells that are no doubles
        for table in (layout.outputs, layout.inputs, layout.previous, layout.before, layout.begins):
            for key, slot in table.items():
                self.whole[slot] = not self.memory.kind(key).real
        events = [*plan.at_events.bring.values(), *plan.at_events.after.values()]
        for rows in (plan.cycle, plan.last, *events):  # what is kept of an input is what the input is
            for _, _, _, a, b, *_ in rows[np.isin(rows[:, 0], (MOVE, PUSH))].tolist():
                self.whole[b] |= self.whole[a]
        self.references: dict[tuple[int, ...], str] = {}  # tables of value references, each once

    def cell(self, slot: int) -> str:
        """A cell, by its array: doubles in `z`, whole numbers in `w`."""
        return f"{'w' if self.whole[slot] else 'z'}[{self.cells[slot]}]"

    def table(self, references: Sequence[int]) -> str:
        """The name of a table of value references."""
        key = tuple(references)
        if key not in self.references:
            self.references[key] = f"REFERENCES_{len(self.references)}"
        return self.references[key]

    def given(self, name: str) -> list[Block]:
        """What the loop sets of a component."""
        return self._blocks(name, self.plan.layout.exchanged(name)[0])

    def taken(self, name: str, again: bool = False) -> list[Block]:
        """What the loop gets of a component; `again`: at an instant."""
        table = self.plan.layout.exchanged(name)[1]
        if again:
            answering = self.plan.instants.answering(name)
            table = {variable: slot for variable, slot in table.items() if variable in answering}
        return self._blocks(name, table)

    def _blocks(self, name: str, table: dict[str, int]) -> list[Block]:
        places = self.plan.system.components[name].fmu.places
        return [
            Block(kind, found[0][0], len(found),
                  tuple(places[v].reference for _, (_, v) in found if places[v].index == 0))
            for kind, found in together(self.plan, name, table)
        ]  # fmt: skip

    # --- lines ---

    def call(self, name: str, what: str, function: str, arguments: str) -> str:
        """A call of an FMI function, and the end of all where it is refused."""
        unit = self.units[name]
        return (
            f'CALL({self.parts[name]}, "{what}", {unit.function(function)}(s->part[{self.parts[name]}], {arguments}));'
        )

    def exchange(self, name: str, verb: str, kind: FmiType, references: Sequence[int], values: str, size: int) -> str:
        """A call that sets or gets `size` values."""
        unit = self.units[name]
        function = f"{verb}{function_type(unit.version, kind.name)}"
        more = f", {size}" if unit.version == 3 else ""
        what = "set its inputs" if verb == "Set" else "give its outputs"
        return self.call(name, what, function, f"{self.table(references)}, {len(references)}, {values}{more}")

    def set_block(self, name: str, block: Block) -> list[str]:
        """Values from their cells into an FMU."""
        kind, first, size = block.kind, self.cells[block.first], block.size
        if _in_place(kind):
            return [self.exchange(name, "Set", kind, block.references, f"z + {first}", size)]
        c_type = self.c_type(name, kind)
        source = f"{'z' if kind.real else 'w'}[{first} + k]"
        lines = [f"{c_type} v[{size}];"]
        if kind.real:
            lines.append(f"for (int k = 0; k < {size}; k++)")
            lines.append(f"    if (fabs({source}) > {number(FLOAT32)}) return unfit(s, {first} + k);")
        lines.append(f"for (int k = 0; k < {size}; k++) v[k] = ({c_type}){source};")
        return ["{", *indented([*lines, self.exchange(name, "Set", kind, block.references, "v", size)]), "}"]

    def get_block(self, name: str, block: Block) -> list[str]:
        """Values from an FMU into their cells; doubles must be finite."""
        kind, first, size = block.kind, self.cells[block.first], block.size
        finite = [f"FINITE({first}, {size});"] if kind.code == FLOAT else []
        if _in_place(kind):
            return [self.exchange(name, "Get", kind, block.references, f"z + {first}", size), *finite]
        c_type = self.c_type(name, kind)
        value = "v[k] != 0" if kind.code == BOOLEAN else f"({'double' if kind.real else 'int64_t'})v[k]"
        lines = [
            f"{c_type} v[{size}];", self.exchange(name, "Get", kind, block.references, "v", size),
            f"for (int k = 0; k < {size}; k++) {'z' if kind.real else 'w'}[{first} + k] = {value};", *finite,
        ]  # fmt: skip
        return ["{", *indented(lines), "}"]

    def set_one(self, key: Key) -> list[str]:
        """One input from its cell; of an array all of its elements, which have cells one behind the other."""
        name, variable = key
        fmu = self.plan.system.components[name].fmu
        kind, place = self.memory.kind(key), fmu.places[variable]
        first = self.plan.layout.inputs[name, fmu.arrays[variable][0]]
        return self.set_block(name, Block(kind, first, place.count, (place.reference,)))

    def get_one(self, key: Key, to: str) -> list[str]:
        """One output, now, into a variable of C: a double, or an int64_t."""
        name, variable = key
        fmu = self.plan.system.components[name].fmu
        kind, place = self.memory.kind(key), fmu.places[variable]
        value = f"v[{place.index}]"
        value = f"{value} != 0" if kind.code == BOOLEAN else value
        lines = [
            f"{self.c_type(name, kind)} v[{place.count}];",
            self.exchange(name, "Get", kind, (place.reference,), "v", place.count),
            f"{to} = {value};",
        ]
        if kind.real:
            slot = self.plan.layout.outputs[key]
            lines.append(f"if (!isfinite({to})) return not_finite(s, {self.cells[slot]}, {to});")
        return ["{", *indented(lines), "}"]

    def c_type(self, name: str, kind: FmiType) -> str:
        """The type of C that an FMI function takes."""
        version = self.units[name].version
        return f"fmi{version}{function_type(version, kind.name)}"


def _in_place(kind: FmiType) -> bool:
    return kind.real and kind.size == 8


def indented(lines: Sequence[str], by: int = 1) -> list[str]:
    """Lines, further to the right."""
    return [f"{'    ' * by}{line}" if line else "" for line in lines]
