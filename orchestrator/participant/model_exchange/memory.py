"""The memory of a group: the table by which its compiled functions find all else, see integration/cells.py."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence

import numpy as np

from ...integration import cells
from ...integration.bound import Bound
from ...integration.compiled import address_of
from ...integration.memory import put_whole, whole
from ..here.loaded import LoadedInstance
from .links import Crossed, LinkBlock
from .tables import Tables

CELL = cells.CELL
OWN = (cells.OWN_SAVE, cells.OWN_RESTORE, cells.OWN_FORGET)  # functions of the first member
LOGGED = 4096  # events that are kept


class GroupMemory:
    """`pointer`: what the functions of a group take first; `bound`: those that know it."""

    def __init__(
        self, members: Sequence[LoadedInstance], blocks: Sequence[LinkBlock], watched: Sequence[int],
        crossings: Sequence[Crossed],
    ) -> None:  # fmt: skip
        self.members, self.blocks, self.crossings = list(members), list(blocks), list(crossings)
        self._watched = np.array(watched, dtype=np.int64)
        self._table = np.zeros(cells.TABLE, dtype=np.int64)
        self.pointer = int(self._table.ctypes.data)
        self._lay_out()

    def _lay_out(self) -> None:
        tables = self.tables = Tables(self.members)
        g = self.pointer
        members = tables.member_rows()
        tables.lay_out(self.blocks)
        n, z, v = max(tables.states, 1), tables.indicators + len(self.crossings), len(tables.slots)
        tables.discrete = [link for block in self.blocks for link in block.links if not tables.solved(link)]
        discrete = tables.discrete_rows()
        sizes = {cells.X: n, cells.K1: n, cells.Z: z, cells.V: v, cells.ABSOLUTE: n, cells.SENT: len(discrete),
                 cells.SEEN: len(self._watched)}  # fmt: skip
        self._block = np.zeros(sum(sizes.values()) + 1)
        at = int(self._block.ctypes.data)
        put_whole(g + cells.ARRAYS, at)
        put_whole(g + cells.ARRAYS_SIZE, CELL * self._block.size)
        for cell, size in sizes.items():
            put_whole(g + cell, at)
            at += CELL * size
        self._view(cells.SENT, len(discrete), np.int64)[:] = -1  # nothing was sent yet
        if not tables.states:
            self._view(cells.ABSOLUTE, 1)[:] = 1.0  # of the one that stands for none
        rows = tables.link([block for block in self.blocks], whole(g + cells.V))
        work = {cells.K2: 6 * n, cells.STAGE: n, cells.X_NEW: n, cells.Z_NEW: 2 * z, cells.V_OLD: v, cells.NOMINAL: n,
                cells.INFO: 8, cells.SEEDS: n, cells.SEED_OUT: n, cells.LOG: LOGGED * cells.ENTRY // CELL,
                cells.SOURCES: v, cells.GAINS: v, cells.OFFSETS: v, cells.V_SEEDS: v}  # fmt: skip
        self._arrays = {cell: np.zeros(max(size, 1)) for cell, size in work.items()}
        for cell, array in self._arrays.items():
            put_whole(g + cell, array.ctypes.data)
        tables.seed_rows(members, whole(g + cells.V_SEEDS))
        for block in self.blocks:
            for link in block.links:
                if link.source in tables.slots and link.target in tables.slots and tables.solved(link):
                    k = tables.slots[link.target]
                    self._arrays[cells.SOURCES].view(np.int64)[k] = (
                        whole(g + cells.V) + CELL * tables.slots[link.source]
                    )
                    self._arrays[cells.GAINS][k], self._arrays[cells.OFFSETS][k] = link.gain, link.offset
        crossings = tables.crossing_rows(self.crossings)
        self._keep = members, rows, discrete, crossings
        self.bound = Bound(g)
        first = self.members[0]
        own = dict(zip(OWN, first.state_functions, strict=True)) if first.fmu.can_save_state else {}
        for cell, value in (
            (cells.STATES, tables.states), (cells.MEMBERS, members.ctypes.data),
            (cells.MEMBER_COUNT, len(self.members)), (cells.INDICATORS, z), (cells.VALUES, v),
            (cells.ROWS, rows.ctypes.data), (cells.ROW_COUNT, len(rows)), (cells.DISCRETE_COUNT, len(discrete)),
            (cells.DISCRETE, discrete.ctypes.data),
            (cells.CROSSINGS, crossings.ctypes.data), (cells.CROSSING_COUNT, len(crossings)),
            (cells.WATCHED, self._watched.ctypes.data), (cells.WATCHED_COUNT, len(self._watched)),
            *((cell, LoadedInstance.address(first, function)) for cell, function in own.items()),
            (cells.OWN_INSTANCE, first.pointer),
            (cells.LOG_SIZE, LOGGED),
            (cells.MALLOC, ctypes.cast(ctypes.pythonapi.PyMem_RawMalloc, ctypes.c_void_p).value),
            (cells.FREE, ctypes.cast(ctypes.pythonapi.PyMem_RawFree, ctypes.c_void_p).value),
            *((cell, address_of(name)) for name, cell in (
                ("evaluate", cells.EVALUATE), ("exchange", cells.EXCHANGE), ("indicate", cells.INDICATE),
                ("trial", cells.TRIAL), ("settle", cells.SETTLE),
            )),
        ):  # fmt: skip
            put_whole(g + cell, int(value or 0))

    def _view(self, cell: int, size: int, dtype: type = np.float64) -> np.ndarray:
        """An array at an address of the table."""
        at = (whole(self.pointer + cell) - int(self._block.ctypes.data)) // CELL
        return self._block[at : at + size].view(dtype)
