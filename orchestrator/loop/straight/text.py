"""A cycle of operations as a function of C in LLVM's text, with the signature of the compiled loop.

Codes, cells, value references' counts, ticks and what is recorded are in the text; addresses and coefficients are data,
so that the same system has the same text in every process, whatever its parameters.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .. import cells
from ..machine.frame import ARRAYS, WORDS
from ..machine.wrapped import with_its_numbers
from ..operations import GET, RECORD, SET, STEP
from ..run import FOREVER
from .calls import HELPERS, write_exchange, write_step
from .formulas import FORMULAS, literal, write_formula
from .writer import POINTERS, Writer

NAME, ONE = "rovbrush_straight", "rovbrush_straight_one"  # the function; and with its numbers in memory
PIECE = 96  # operations of a function, about
COVERED = frozenset([SET, STEP, GET, RECORD, *FORMULAS])
MOST = 256  # operations; beyond that it is no quicker than what looks them up
COPIED = 8  # cells of a record in a row, from which on they are copied at once
# Where the arrays of a piece's parameters are among the arguments of the loop.
AMONG = {"z": 4, "c": 1, "control": 14, "raw": 6, "index": 9, "groups": 11, "buffer": 12, "rows": 13, "t": len(ARRAYS)}
_MAIN = """
define i64 @{name}(i64 %frame, i64 %first, i64 %cycles, i64 %ticks, i64 %numerator, i64 %whole_denominator) nounwind {{
entry:
  %f = inttoptr i64 %frame to ptr
{loads}
  %resume = getelementptr i64, ptr %control, i64 {resume}
  store i64 0, ptr %resume
  %at_start = getelementptr i64, ptr %control, i64 {start}
  %start = load i64, ptr %at_start
  %at_promised = getelementptr i64, ptr %control, i64 {promised}
  %promised = load i64, ptr %at_promised
  %denominator = sitofp i64 %whole_denominator to double
  %end = add i64 %start, %promised
  %end_ticks = mul i64 %end, %numerator
  %end_number = sitofp i64 %end_ticks to double
  %end_time = fdiv double %end_number, %denominator
  %is_promised = icmp sgt i64 %promised, 0
  %stop = select i1 %is_promised, double %end_time, double {forever}
  %last = add i64 %first, %cycles
  %some = icmp slt i64 %first, %last
  br i1 %some, label %cycle, label %done
cycle:
  %k = phi i64 [ %first, %entry ], [ %next, %whole ]
  %passed = mul i64 %k, %ticks
  %base = add i64 %start, %passed
{calls}
whole:
  %next = add i64 %k, 1
  %more = icmp slt i64 %next, %last
  br i1 %more, label %cycle, label %done
out:
  %code = phi i64 {codes}
  %at_cycle = getelementptr i64, ptr %control, i64 {at_cycle}
  store i64 %k, ptr %at_cycle
  ret i64 %code
done:
  ret i64 0
}}
"""
_LOAD = """  %p.{name} = getelementptr i64, ptr %f, i64 {at}
  %{name} = load ptr, ptr %p.{name}"""
_CALL = """  %r{k} = call i64 @piece_{k}({given})
  %g{k} = icmp eq i64 %r{k}, 0
  br i1 %g{k}, label %{then}, label %out, !prof !0"""


def why_not(codes: Sequence[int]) -> str:
    """Why operations with such codes have no text; empty where they have one."""
    if len(codes) > MOST:
        return f"{len(codes)} operations, {MOST} at most are written one behind the other"
    return "" if COVERED.issuperset(codes) else "operations that are looked up: events, loops, steps that vary"


class Straight(Writer):
    """Operations, and the tables of components and blocks as the loop has them; `recorded`: the cells of each table of
    rows. `wanted` is filled: the cells of the tables that the text wants as addresses."""

    def __init__(
        self, rows: np.ndarray, components: np.ndarray, blocks: np.ndarray, recorded: Sequence[np.ndarray]
    ) -> None:
        super().__init__()
        self.rows, self.components, self.blocks, self.recorded = rows, components, blocks, recorded
        self.wanted: dict[tuple[int, int, int], int] = {}
        for m in range(len(rows)):
            if m and m % PIECE == 0:
                self.begin_piece()
            self._write(m)

    def addresses(self, components: np.ndarray, blocks: np.ndarray) -> np.ndarray:
        """What `wanted` names of tables such as these."""
        return np.array([(components, blocks)[table][row, k] for table, row, k in self.wanted], dtype=np.int64)

    def whole_text(self) -> str:
        """Pieces, what they call, and the function that calls them in every cycle."""
        loads = "\n".join(_LOAD.format(name=name, at=WORDS * AMONG[name]) for name in POINTERS)
        given = ", ".join([*(f"ptr %{name}" for name in POINTERS), "i64 %base", "i64 %numerator",
                           "double %denominator", "double %stop"])  # fmt: skip
        count = len(self.pieces)
        calls, codes = [], []
        for k in range(count):
            begins = "" if k == 0 else f"p{k}:\n"
            calls.append(begins + _CALL.format(k=k, given=given, then=f"p{k + 1}" if k + 1 < count else "whole"))
            codes.append(f"[ %r{k}, %{f'p{k}' if k else 'cycle'} ]")
        main = _MAIN.format(
            name=NAME, loads=loads, calls="\n".join(calls), codes=", ".join(codes), resume=cells.RESUME_AT,
            start=cells.START, promised=cells.PROMISED, at_cycle=cells.AT_CYCLE, forever=literal(FOREVER),
        )  # fmt: skip
        return self.text() + HELPERS + main + with_its_numbers(ONE, NAME)

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
            exact = self.known.get(("seconds", ticks)) or self._seconds(str(ticks))
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
        if m == 0 or tick != self.rows[m - 1, 1]:
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
