"""The functions around the pieces, in LLVM's text: one that does whole cycles, with the signature of the compiled loop,
or one for each segment, which the loop calls where its operations would be (`run.SEGMENT`).
"""

from __future__ import annotations

from collections.abc import Sequence

from .. import cells
from ..machine.frame import ARRAYS, WORDS
from ..machine.wrapped import with_its_numbers
from ..run import FOREVER
from .formulas import literal
from .writer import POINTERS

NAME, ONE = "rovbrush_straight", "rovbrush_straight_one"  # the function; and with its numbers in memory
SEGMENT = "rovbrush_segment_{}"
# Where the arrays of a piece's parameters are among the arguments of the loop.
AMONG = {"z": 4, "c": 1, "control": 14, "raw": 6, "index": 9, "groups": 11, "buffer": 12, "rows": 13, "t": len(ARRAYS)}
GIVEN = ", ".join([*(f"ptr %{name}" for name in POINTERS), "i64 %base", "i64 {varying}", "i64 %numerator",
                   "double %denominator", "double %stop"])  # fmt: skip
_WHOLE = """
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
_LOAD = """  %p.{name} = getelementptr i64, ptr %{of}, i64 {at}
  %{name} = load ptr, ptr %p.{name}"""
_CALL = """  %r{k} = call i64 @piece_{k}({given})
  %g{k} = icmp eq i64 %r{k}, 0
  br i1 %g{k}, label %{then}, label %out, !prof !0"""


_SEGMENT = """
define i64 @{name}(ptr %p, i64 %base, i64 %varying, i64 %numerator, i64 %whole_denominator, double %stop) nounwind {{
entry:
{loads}
  %denominator = sitofp i64 %whole_denominator to double
{calls}
whole:
  ret i64 0
out:
  %code = phi i64 {codes}
  ret i64 %code
}}
"""


def whole_cycles(pieces: Sequence[int]) -> str:
    """What calls these pieces in every cycle, and the same with its numbers in memory."""
    loads = "\n".join(_LOAD.format(name=name, of="f", at=WORDS * AMONG[name]) for name in POINTERS)
    calls, codes = _one_after_the_other(pieces, "0", "cycle")
    return _WHOLE.format(
        name=NAME, loads=loads, calls=calls, codes=codes, resume=cells.RESUME_AT,
        start=cells.START, promised=cells.PROMISED, at_cycle=cells.AT_CYCLE, forever=literal(FOREVER),
    ) + with_its_numbers(ONE, NAME)  # fmt: skip


def segment(number: int, pieces: Sequence[int]) -> str:
    """What calls these pieces once; it takes the address of the table that `pointers` makes."""
    loads = "\n".join(_LOAD.format(name=name, of="p", at=k) for k, name in enumerate(POINTERS))
    calls, codes = _one_after_the_other(pieces, "%varying", "entry")
    return _SEGMENT.format(name=SEGMENT.format(number), loads=loads, calls=calls, codes=codes)


def _one_after_the_other(pieces: Sequence[int], varying: str, begin: str) -> tuple[str, str]:
    """The calls, and which code comes from where if one does not end as it should."""
    given, calls, codes = GIVEN.format(varying=varying), [], []
    for n, k in enumerate(pieces):
        begins = f"p{k}:\n" if n else ""
        then = f"p{pieces[n + 1]}" if n + 1 < len(pieces) else "whole"
        calls.append(begins + _CALL.format(k=k, given=given, then=then))
        codes.append(f"[ %r{k}, %{f'p{k}' if n else begin} ]")
    return "\n".join(calls), ", ".join(codes)
