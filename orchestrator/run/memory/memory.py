"""The memory of a run: its vector of cells, the raw values that FMUs want otherwise, and the texts."""

from __future__ import annotations

import numpy as np

from ...fmu.types import BINARY, NEGATED, TEXT, FmiType, Value, decode, encode, function_type
from ...loop.calls import STEP_FLAGS
from ...loop.cells import IN_PLACE
from ...loop.operations import RESTORE
from ...loop.texts import MANY, MANY_BYTES, Texts
from ...loop.versions import signatures
from ...participant.base import Participant
from ...plan.plan import Plan
from ...plan.speed.together import Key, given, in_place, internal, kind_of, together

Typed = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]


class Memory:
    """Cells `z` of all signals, and the tables by which `loop.run` exchanges them with the FMUs."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.z = np.zeros(max(plan.layout.size, 1))
        self.whole = self.z.view(np.int64)
        self.texts = Texts(MANY, MANY_BYTES) if self._has_bytes() else Texts()
        self.raw = np.zeros(0, dtype=np.uint8)
        self.keep: list[np.ndarray] = []  # value references, alive as long as their addresses are in use

    def _has_bytes(self) -> bool:
        layout = self.plan.layout
        return any(self.kind(key).code == BINARY for table in (layout.inputs, layout.outputs) for key in table)

    def kind(self, key: Key) -> FmiType:
        """The type of a signal that has a cell."""
        return kind_of(self.plan, key)

    def put(self, key: Key, slot: int, value: Value) -> None:
        """A value into its cell."""
        kind = self.kind(key)
        if kind.code == TEXT:
            self.whole[slot] = self.texts.number(str(value))
        elif isinstance(value, bytes):
            self.whole[slot] = self.texts.number_of_bytes(value)
        else:
            assert not isinstance(value, str)
            self.z[slot] = encode(kind, value)

    def value(self, key: Key, slot: int) -> Value:
        """The value in a cell."""
        kind = self.kind(key)
        found: Value = decode(kind, self.z[slot : slot + 1])[0].item()
        if kind.code == BINARY:
            return self.texts.bytes(int(found))
        return self.texts.text(int(found)) if kind.code == TEXT else found

    def tables(self, instances: dict[str, Participant]) -> tuple[np.ndarray, np.ndarray, Typed]:
        """`components` (n, 11) and `blocks` (k, 10) for `loop.run`, see exchange.py, and its typed arrays."""
        components: list[list[int]] = []
        blocks: list[list[int]] = []
        raw = 0
        final = int(RESTORE not in self.plan.cycle[:, 0])  # nobody goes back behind a step
        inside = internal(self.plan)
        for name, instance in instances.items():
            flags, raw = raw, raw + STEP_FLAGS
            do_step = 0 if self.plan.system.components[name].scheduled else instance.address(f"{instance.prefix}DoStep")
            row = [signatures(instance.fmu.version), instance.pointer, do_step, flags]
            taken = self.plan.layout.exchanged(name)[1]
            answering = self.plan.instants.answering(name)
            again = {variable: slot for variable, slot in taken.items() if variable in answering}
            for table, verb in ((given(self.plan, name, inside), "Set"), (taken, "Get"), (again, "Get")):
                row.append(len(blocks))
                for kind, found in together(self.plan, name, table):
                    block, used = self._block(instance, kind, verb, found, raw)
                    blocks.append(block)
                    raw += used
                row.append(len(blocks))
            ends = 1 if instance.fmu.version == 1 else final  # there: a new step, none that is repeated
            components.append([*row[:-2], ends, *row[-2:]])
        self.raw = np.zeros(max(raw, 1), dtype=np.uint8)
        base = self.raw.ctypes.data
        for row in components:
            row[3] += base
        for block in blocks:
            block[3] += base if block[6] != IN_PLACE else self.z.ctypes.data
        typed = (self.whole, self.raw, self.raw.view(np.float32), self.texts.pool, self.texts.index)
        return np.array(components, dtype=np.int64), np.array(blocks, dtype=np.int64).reshape(-1, 10), typed

    def _block(
        self, instance: Participant, kind: FmiType, verb: str, slots: list[tuple[int, Key]], raw: int
    ) -> tuple[list[int], int]:
        """A row of `blocks`, its VALUES still from 0, and how many raw bytes it takes."""
        fmu = instance.fmu
        places = [fmu.places[variable] for _, (_, variable) in slots]
        references = np.array([place.reference for place in places if place.index == 0], dtype=np.uint32)
        self.keep.append(references)
        function = f"{instance.prefix}{verb}{function_type(fmu.version, kind.name)}"
        first, size = slots[0][0], len(slots)
        code, negated = kind.code, places[0].negated
        here = in_place(self.plan, kind, slots[0][1])
        if negated and not kind.real:
            code = NEGATED
        each = kind.size * (2 if code == BINARY else 1)  # an address, and how many bytes are there
        used = 0 if here else -(-size * each // 16) * 16
        address = (-1 if code == BINARY else 1) * instance.address(function)  # see `versions.exchange`
        return [
            address, references.ctypes.data, len(references), 8 * first if here else raw, size, first,
            IN_PLACE if here else raw, code, kind.size, int(kind.signed),
        ], used  # fmt: skip
