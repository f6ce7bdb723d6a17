"""Operations as functions of C in LLVM's text.

Codes, cells, value references' counts, ticks and what is recorded are in the text; addresses and coefficients are data,
so that the same system has the same text in every process, whatever its parameters.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .. import cells
from ..formulas import FORMULAS
from ..operations import GET, RECORD, SET, STEP
from .calls import HELPERS, write_exchange, write_step
from .formulas import write_formula
from .functions import segment, whole_cycles
from .writer import Writer

PIECE = 96  # operations of a function, about
COVERED = frozenset([SET, STEP, GET, RECORD, *FORMULAS])
COPIED = 8  # cells of a record in a row, from which on they are copied at once
Segments = Sequence[tuple[int, int]]  # the first operation, and that behind the last


class Straight(Writer):
    """Operations, and the tables of components and blocks as the loop has them; `recorded`: the cells of each table of
    rows. `segments`: which of them have a function of their own, each of one instant; without, whole cycles have one.
    `varies`: whether the length of a step is known only when it is made. `wanted` is filled: the cells of the tables
    that the text wants as addresses."""

    def __init__(
        self, rows: np.ndarray, components: np.ndarray, blocks: np.ndarray, recorded: Sequence[np.ndarray],
        segments: Segments = (), varies: bool = False,
    ) -> None:  # fmt: skip
        super().__init__()
        self.rows, self.components, self.blocks, self.recorded = rows, components, blocks, recorded
        self.varies, self.whole = varies, not segments
        self.wanted: dict[tuple[int, int, int], int] = {}
        self.pieces_of: list[range] = []
        for first, last in segments or [(0, len(rows))]:
            begin = len(self.pieces)
            for m in range(first, last):
                if (m - first) % PIECE == 0:
                    self.begin_piece()
                self._write(m)
            self.pieces_of.append(range(begin, len(self.pieces)))

    def addresses(self, components: np.ndarray, blocks: np.ndarray) -> np.ndarray:
        """What `wanted` names of tables such as these."""
        return np.array([(components, blocks)[table][row, k] for table, row, k in self.wanted], dtype=np.int64)

    def whole_text(self) -> str:
        """Pieces, what they call, and the functions that call them."""
        if self.whole:
            around = whole_cycles(self.pieces_of[0])
        else:
            around = "".join(segment(k, pieces) for k, pieces in enumerate(self.pieces_of))
        return self.text(any(len(pieces) > 1 for pieces in self.pieces_of)) + HELPERS + around

    # --- what operations are made of ---

    def address(self, table: int, row: int, column: int) -> str:
        """An address out of `components` (0) or `blocks` (1)."""
        number = self.wanted.setdefault((table, row, column), len(self.wanted))
        return self.load("ptr", self.place("t", number))

    def time(self, ticks: int) -> str:
        """An instant of the cycle [s]."""
        if ("time", ticks) not in self.known:
            at = self.value(f"add i64 %base, {ticks}")
            self.known["time", ticks] = self._seconds(at)
        return self.known["time", ticks]

    def length(self, ticks: int, begin: int) -> str:
        """Of a step from an instant of the cycle: so many ticks, or to the stop [s]."""
        key = ("length", ticks, begin)
        if key not in self.known:
            exact = self.known.get(("seconds", ticks))
            if exact is None:
                exact = self._seconds(self.value(f"add i64 %varying, {ticks}") if self.varies else str(ticks))
                self.known["seconds", ticks] = exact
            given = f"double {self.time(begin)}, double {exact}, double %stop"
            self.known[key] = self.value(f"call double @length_of({given})")
        return self.known[key]

    def _seconds(self, ticks: str) -> str:
        number = self.value(f"sitofp i64 {self.value(f'mul i64 {ticks}, %numerator')} to double")
        return self.value(f"fdiv double {number}, %denominator")

    def noted(self, m: int, value: str = "", to: int = 0) -> list[str]:
        """Lines for `require`: where the loop ends, and something more."""
        found = []
        for number, cell in ((str(m), cells.AT_OPERATION), *([(value, to)] if value else [])):
            name = self.name()
            found += [f"%{name} = getelementptr i64, ptr %control, i64 {cell}", f"store i64 {number}, ptr %{name}"]
        return found

    def good(self, status: str, m: int) -> None:
        """Go on where a status of operation m is."""
        name = self.name()
        lines = [f"%{name} = sext i32 {status} to i64", *self.noted(m, f"%{name}", cells.STATUS)]
        fine = self.value(f"icmp eq i32 {self.value(f'or i32 {status}, 1')}, 1")
        self.require(fine, lines, cells.BAD_STATUS)

    # --- operations ---

    def _write(self, m: int) -> None:
        code, tick, _, a, b, p, q, k = self.rows[m].tolist()
        if self.whole and (m == 0 or tick != self.rows[m - 1, 1]):  # the loop looks, before each segment
            self._may_go_on(m, tick)
        if code in (SET, GET):
            write_exchange(self, m)
        elif code == STEP:
            write_step(self, m)
        elif code == RECORD:
            self._record(a)
        else:
            write_formula(self, code, {"a": a, "b": b, "p": p, "q": q}, k)

    def _may_go_on(self, m: int, tick: int) -> None:
        """Nobody asks to stop, and the run does not end before this instant."""
        asked = self.load("i64", self.place("control", cells.STOP_REQUEST), "volatile ")
        self.require(self.value(f"icmp eq i64 {asked}, 0"), self.noted(m), cells.INTERRUPTED)
        end = self.load("i64", self.place("control", cells.ENDS_AT))
        here = self.value(f"add i64 %base, {tick}")
        self.require(self.value(f"icmp sle i64 {here}, {end}"), self.noted(m), cells.ENDED)

    def _record(self, table: int) -> None:
        slots = self.recorded[table].tolist()
        count = self.place("rows", table)
        row = self.load("i64", count)
        first = self.load("i64", self.place("groups", 3 * table + 2))
        cell = self.value(f"add i64 {first}, {self.value(f'mul i64 {row}, {len(slots)}')}")
        to = self.value(f"getelementptr i64, ptr %buffer, i64 {cell}")
        j = 0
        while j < len(slots):
            n = j + 1
            while n < len(slots) and slots[n] == slots[j] + n - j:
                n += 1
            if n - j >= COPIED:
                given = f"ptr {self.value(f'getelementptr i64, ptr {to}, i64 {j}')}, ptr {self.cell(slots[j])}"
                self.line(f"call void @llvm.memcpy.p0.p0.i64({given}, i64 {8 * (n - j)}, i1 false)")
            else:
                for i in range(j, n):
                    value = self.load("double", self.cell(slots[i]))
                    self.store("double", value, self.value(f"getelementptr i64, ptr {to}, i64 {i}"))
            j = n
        self.store("i64", self.value(f"add i64 {row}, 1"), count)
