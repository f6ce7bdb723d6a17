"""The tables of a group, as its compiled functions read them: see integration/cells.py."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np

from ...errors import FmuError
from ...fmu.reading.states import derivative_names, state_names
from ...fmu.types import function_type
from ...integration import cells
from ...integration.stiff.offered import offers_directional
from ...loop.versions import signatures
from ..here.loaded import LoadedInstance
from .links import Crossed, Link, LinkBlock

CELL = cells.CELL
FUNCTIONS = {  # of a member, by the column of its address, in each version; "" where there is none
    cells.SET_TIME: ("SetTime",) * 3,
    cells.SET_STATES: ("SetContinuousStates",) * 3,
    cells.GET_DERIVATIVES: ("GetDerivatives", "GetDerivatives", "GetContinuousStateDerivatives"),
    cells.GET_INDICATORS: ("GetEventIndicators",) * 3,
    cells.GET_STATES: ("GetContinuousStates",) * 3,
    cells.GET_NOMINALS: ("GetNominalContinuousStates", *("GetNominalsOfContinuousStates",) * 2),
    cells.COMPLETED: ("CompletedIntegratorStep",) * 3,
    cells.ENTER_EVENTS: ("", "EnterEventMode", "EnterEventMode"),
    cells.ENTER_CONTINUOUS: ("", "EnterContinuousTimeMode", "EnterContinuousTimeMode"),
    cells.UPDATE: ("EventUpdate", "NewDiscreteStates", "UpdateDiscreteStates"),
    cells.DIRECTIONAL: ("", "GetDirectionalDerivative", "GetDirectionalDerivative"),
}
TYPES = {
    1: {"Real": cells.DOUBLE, "Integer": cells.I32, "Enumeration": cells.I32, "Boolean": cells.TRUTH8,
        "String": cells.POINTER},
    2: {"Real": cells.DOUBLE, "Integer": cells.I32, "Enumeration": cells.I32, "Boolean": cells.TRUTH32,
        "String": cells.POINTER},
    3: {"Float64": cells.DOUBLE, "Float32": cells.FLOAT, "Int8": cells.I8, "UInt8": cells.U8, "Int16": cells.I16,
        "UInt16": cells.U16, "Int32": cells.I32, "UInt32": cells.U32, "Int64": cells.I64, "UInt64": cells.U64,
        "Enumeration": cells.I64, "Boolean": cells.TRUTH8, "String": cells.POINTER},
}  # fmt: skip


def needs_completed(member: LoadedInstance) -> bool:
    """Whether an FMU wants to hear of every accepted step."""
    return bool(member.fmu.interface.needsCompletedIntegratorStep)


@dataclass
class Tables:
    """Rows of members, of what is exchanged in each evaluation, and of what is sent at events.

    `keep`: arrays whose addresses are in use.
    """

    members: Sequence[LoadedInstance]
    keep: list[np.ndarray] = field(default_factory=list)
    states: int = 0
    indicators: int = 0
    slots: dict[tuple[int, str], int] = field(default_factory=dict)  # cells of V of outputs and inputs
    rows: list[list[int]] = field(default_factory=list)
    discrete: list[Link] = field(default_factory=list)
    places: dict[tuple[int, str], int] = field(default_factory=dict)  # of the states, by member and name
    given: dict[tuple[int, str], None] = field(default_factory=dict)  # inputs that are set in each evaluation

    def references(self, numbers: Iterable[int]) -> int:
        """The address of value references."""
        self.keep.append(np.array([*numbers], dtype=np.uint32))
        return int(self.keep[-1].ctypes.data)

    def member_rows(self) -> np.ndarray:
        """MEMBERS: instances, functions, first states and indicators."""
        table = np.zeros((len(self.members), cells.MEMBER // CELL), dtype=np.int64)
        for m, (row, member) in enumerate(zip(table, self.members, strict=True)):
            fmu, version = member.fmu.own, member.fmu.version
            states = state_names(fmu)
            skipped = {cells.COMPLETED} if not needs_completed(member) else set()
            skipped |= {cells.DIRECTIONAL} if not offers_directional(member.fmu) else set()
            for column, names in FUNCTIONS.items():
                if column not in skipped and names[version - 1]:
                    row[column // CELL] = member.address(f"{member.prefix}{names[version - 1]}")
            row[cells.FIRST_FMI // CELL] = version == 1
            row[cells.VERSION // CELL], row[cells.INSTANCE // CELL] = signatures(fmu.version), member.pointer
            row[cells.FIRST_STATE // CELL], row[cells.STATE_COUNT // CELL] = CELL * self.states, len(states)
            indicators = int(fmu.description.numberOfEventIndicators)
            row[cells.FIRST_INDICATOR // CELL] = CELL * self.indicators
            row[cells.INDICATOR_COUNT // CELL] = indicators
            self.places |= {(m, name): self.states + k for k, name in enumerate(states)}
            self.states += len(states)
            self.indicators += indicators
        return table

    def seed_rows(self, rows: np.ndarray, v_seeds: int) -> None:
        """What directional derivatives are taken of and along, into MEMBERS; `v_seeds`: the address of V_SEEDS."""
        for m, (row, member) in enumerate(zip(rows, self.members, strict=True)):
            fmu = member.fmu.own
            if not offers_directional(member.fmu):
                continue
            known = list(dict.fromkeys(fmu.places[name].reference for name in state_names(fmu)))
            inputs = [fmu.places[first] for n, first in self.given if n == m]
            slots = [
                v_seeds + CELL * self.slots[m, name] for n, first in self.given if n == m for name in fmu.arrays[first]
            ]
            self.keep += [np.array(slots, dtype=np.int64), np.zeros(int(row[cells.STATE_COUNT // CELL]) + len(slots))]
            known += [place.reference for place in inputs]
            unknown = list(dict.fromkeys(fmu.places[name].reference for name in derivative_names(fmu)))
            for column, value in (
                (cells.KNOWN_INPUTS, self.keep[-2].ctypes.data), (cells.KNOWN_SEEDS, self.keep[-1].ctypes.data),
                (cells.KNOWN_SIZE, self.keep[-1].size), (cells.KNOWN, self.references(known)),
                (cells.KNOWN_COUNT, len(known)), (cells.DERIVATIVES, self.references(unknown)),
                (cells.DERIVATIVE_COUNT, len(unknown)),
            ):  # fmt: skip
                row[column // CELL] = int(value)

    def slot(self, key: tuple[int, str]) -> int:
        """The cell of V of a variable; the elements of an array lie one behind the other."""
        if key not in self.slots:
            for name in self.members[key[0]].fmu.own.arrays[key[1]]:
                self.slots[key[0], name] = len(self.slots)
        return self.slots[key]

    def lay_out(self, blocks: Iterable[LinkBlock]) -> None:
        """Give every solved output and input its cell of V."""
        for block in blocks:
            for link in filter(self.solved, block.links):
                self.slot(link.source)
                self.slot(link.target)

    def link(self, blocks: Iterable[LinkBlock], v: int) -> np.ndarray:
        """ROWS for the blocks of links, in their order; `v`: the address of V. What is not solved is in `discrete`."""
        for block in blocks:
            real = [link for link in block.links if self.solved(link)]
            self.discrete += [link for link in block.links if not self.solved(link)]
            sources = list(dict.fromkeys(link.source for link in real))
            targets = list(dict.fromkeys(link.target for link in real))
            if real and block.loop:
                unknowns = [self.slot(key) for key in targets]
                self.keep.append(v + CELL * np.array(unknowns, dtype=np.int64))
                addresses, n = int(self.keep[-1].ctypes.data), len(unknowns)
                self.keep.append(np.zeros(n * (2 * n + 2)))  # Newton's method, and the matrix for seeds
                memory = int(self.keep[-1].ctypes.data)
                inside = [*self._moves(targets, cells.GIVE_AS_IS, v), *self._moves(sources, cells.TAKE, v)]
                self.rows.append([cells.LOOP, targets[0][0], 0, addresses, len(inside), memory, n, -1])
                self.rows += inside
            elif real:
                self.rows += [*self._moves(sources, cells.TAKE, v), *self._moves(targets, cells.GIVE, v)]
        return np.array(self.rows, dtype=np.int64).reshape(-1, cells.ROW // CELL)

    def solved(self, link: Link) -> bool:
        """Whether a link is solved in each evaluation: doubles that are not sampled. The others are sent at events."""
        (a, source), (b, target) = link.source, link.target
        fmus = self.members[a].fmu.own, self.members[b].fmu.own
        kinds = [fmu.type_of(name) for fmu, name in zip(fmus, (source, target), strict=True)]
        if fmus[1].variables[target].variability == "discrete" or any(kind is None or not kind.real for kind in kinds):
            return False
        for fmu, name, kind, member in zip(fmus, (source, target), kinds, (a, b), strict=True):
            if kind is not None and kind.size != 8:
                raise FmuError(
                    f"component {self.members[member].name}: {name} is a {kind.name}; between FMUs for Model Exchange "
                    f"{fmu.path.name} must give and take 64 bits: connect it through a component for co-simulation"
                )
        return True

    def _moves(self, keys: Iterable[tuple[int, str]], kind: int, v: int) -> list[list[int]]:
        """Rows that get outputs or set inputs, whole arrays together."""
        found = []
        whole = {(m, self.members[m].fmu.own.arrays[name][0]) for m, name in keys}
        for m, first in sorted(whole, key=lambda key: (key[0], self.slot(key))):
            fmu, member = self.members[m].fmu.own, self.members[m]
            verb = "Get" if kind == cells.TAKE else "Set"
            named = function_type(fmu.version, fmu.variables[first].type)
            function = member.address(f"{member.prefix}{verb}{named}")
            if kind != cells.TAKE:
                self.given[m, first] = None
            references, at = self.references([fmu.places[first].reference]), v + CELL * self.slot((m, first))
            found.append([kind, m, function, references, 1, at, fmu.places[first].count, self._state_of(m, first)])
        return found

    def _state_of(self, m: int, first: str) -> int:
        """Which states of the group a variable is [bytes behind the first]; -1 where it is none."""
        found = [self.places.get((m, name), -1) for name in self.members[m].fmu.own.arrays[first]]
        return CELL * found[0] if found == list(range(found[0], found[0] + len(found))) and found[0] >= 0 else -1

    def crossing_rows(self, crossings: Sequence[Crossed]) -> np.ndarray:
        """CROSSINGS: doubles that are scalars."""
        table = np.zeros((len(crossings), cells.CROSSING // CELL), dtype=np.int64)
        for row, crossed in zip(table, crossings, strict=True):
            member = self.members[crossed.member]
            fmu = member.fmu.own
            function = f"{member.prefix}Get{function_type(fmu.version, fmu.variables[crossed.name].type)}"
            row[:] = (member.address(function), crossed.member, fmu.places[crossed.name].reference, crossed.limit,
                      int(crossed.rises), 0)  # fmt: skip
        return table

    def discrete_rows(self) -> np.ndarray:
        """DISCRETE: what is sent at events."""
        table = np.zeros((len(self.discrete), cells.LINK // CELL), dtype=np.int64)
        numbers = table.view(np.float64)
        for k, link in enumerate(self.discrete):
            for (m, name), verb, columns in (
                (link.source, "Get", (cells.GET, cells.GET_WHO, cells.GET_REFERENCE, cells.GET_TYPE)),
                (link.target, "Set", (cells.PUT, cells.PUT_WHO, cells.PUT_REFERENCE, cells.PUT_TYPE)),
            ):
                fmu, member = self.members[m].fmu.own, self.members[m]
                if fmu.places[name].count > 1:
                    raise FmuError(
                        f"component {member.name}: {name} is an element of an array that is sent at events only; "
                        f"between FMUs for Model Exchange these must be scalars"
                    )
                kind = fmu.variables[name].type
                function = member.address(f"{member.prefix}{verb}{function_type(fmu.version, kind)}")
                values = function, m, fmu.places[name].reference, TYPES[fmu.version][kind]
                for column, value in zip(columns, values, strict=True):
                    table[k, column // CELL] = value
            numbers[k, cells.GAIN // CELL], numbers[k, cells.OFFSET // CELL] = link.gain, link.offset
        return table
