"""Calls of FMI functions as LLVM's text: `exchange.py`, `versions.py` and `calls.py` with all numbers known.

The status, what is exchanged and that it is finite are checked as `run.run` does it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...fmu.types import BINARY, BOOLEAN, FLOAT, FLOAT32, NEGATED, TEXT, WHOLE
from .. import cells
from ..operations import AT_AN_INSTANT, GET, SET
from ..texts import ADDRESS, OFFSETS
from ..versions import EARLY, EVENT, TERMINATE
from .formulas import literal

if TYPE_CHECKING:
    from .text import Straight

INFINITE = literal(float("inf"))
MANY = 12  # values that are looked at one by one
SIGN = -(1 << 63)
GIVEN, TAKEN = (FLOAT, WHOLE, BOOLEAN, NEGATED, TEXT), (FLOAT, WHOLE, BOOLEAN, NEGATED)

# The first of some cells that is not finite, or -1; a length that ends at the stop; what a step of FMI 3.0 reports.
HELPERS = f"""
declare double @llvm.fabs.f64(double)
declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)
define internal i64 @unfit(ptr %z, i64 %first, i64 %last) noinline nounwind {{
entry:
  br label %look
look:
  %j = phi i64 [ %first, %entry ], [ %next, %good ]
  %left = icmp slt i64 %j, %last
  br i1 %left, label %one, label %none
one:
  %at = getelementptr i64, ptr %z, i64 %j
  %value = load double, ptr %at
  %size = call double @llvm.fabs.f64(double %value)
  %finite = fcmp olt double %size, {INFINITE}
  %next = add i64 %j, 1
  br i1 %finite, label %good, label %bad
good:
  br label %look
bad:
  ret i64 %j
none:
  ret i64 -1
}}
define internal double @length_to(double %time, double %stop) noinline nounwind {{
entry:
  %whole = fsub double %stop, %time
  br label %look
look:
  %length = phi double [ %whole, %entry ], [ %less, %again ]
  %end = fadd double %time, %length
  %beyond = fcmp ogt double %end, %stop
  br i1 %beyond, label %again, label %good
again:
  %less = fmul double %length, {literal(1.0 - 2.0**-52)}
  br label %look
good:
  ret double %length
}}
define internal double @length_of(double %time, double %length, double %stop) alwaysinline nounwind {{
  %end = fadd double %time, %length
  %beyond = fcmp ogt double %end, %stop
  br i1 %beyond, label %shorter, label %same, !prof !1
shorter:
  %found = call double @length_to(double %time, double %stop)
  ret double %found
same:
  ret double %length
}}
define internal i64 @reported(ptr %flags) noinline nounwind {{
  %second = getelementptr i8, ptr %flags, i64 1
  %ends = load i8, ptr %second
  %none = icmp eq i8 %ends, 0
  br i1 %none, label %early, label %terminate
terminate:
  ret i64 {TERMINATE}
early:
  %third = getelementptr i8, ptr %flags, i64 2
  %returns = load i8, ptr %third
  %late = icmp eq i8 %returns, 0
  %answer = select i1 %late, i64 {EVENT}, i64 {EARLY}
  ret i64 %answer
}}
!0 = !{{!"branch_weights", i32 1000000, i32 1}}
!1 = !{{!"branch_weights", i32 1, i32 1000000}}
"""


def can_exchange(code: int, kind: int) -> bool:
    """Whether values of a kind are known here, in a SET or in a GET."""
    return kind in (GIVEN if code == SET else TAKEN) and kind != BINARY


def write_exchange(to: Straight, m: int) -> None:
    """SET or GET, operation m."""
    code, component, a = (int(to.rows[m, k]) for k in (0, 2, 3))
    first, last = cells.FIRST_IN, cells.LAST_IN
    if code == GET:
        first, last = (cells.FIRST_AGAIN, cells.LAST_AGAIN) if a == AT_AN_INSTANT else (cells.FIRST_OUT, cells.LAST_OUT)
    fmi = int(to.components[component, cells.FMI])
    for n in range(int(to.components[component, first]), int(to.components[component, last])):
        block = to.blocks[n]
        kind, size, slot = int(block[cells.CODE]), int(block[cells.SIZE]), int(block[cells.FIRST_SLOT])
        here = block[cells.AT] == cells.IN_PLACE
        if code == SET and not here:
            _pack(to, m, n)
        instance, function = to.address(0, component, cells.INSTANCE), to.address(1, n, cells.FUNCTION)
        references = to.address(1, n, cells.REFERENCES)
        values = to.cell(slot) if here else to.value(f"getelementptr i8, ptr %raw, i64 {int(block[cells.AT])}")
        given = f"ptr {instance}, ptr {references}, i64 {int(block[cells.COUNT])}, ptr {values}"
        status = to.value(f"call i32 {function}({given}{'' if fmi == 2 else f', i64 {size}'})")
        to.good(status, m)
        if code == GET and not here:
            _unpack(to, n)
        if code == GET and kind == FLOAT:
            _finite(to, slot, size, m)


def write_step(to: Straight, m: int) -> None:
    """STEP, operation m."""
    component, ticks, begin = (int(to.rows[m, k]) for k in (2, 3, 4))
    row = to.components[component]
    time, length = to.time(begin), to.length(ticks, begin)
    instance, function = to.address(0, component, cells.INSTANCE), to.address(0, component, cells.DO_STEP)
    given = f"ptr {instance}, double {time}, double {length}, i32 {int(row[cells.FINAL])}"
    if row[cells.FMI] == 2:
        to.good(to.value(f"call i32 {function}({given})"), m)
        return
    flags = to.address(0, component, cells.FLAGS)
    ends = [flags, *(to.value(f"getelementptr i8, ptr {flags}, i64 {k}") for k in (1, 2, 8))]
    for flag in ends[:3]:
        to.store("i8", "0", flag)
    to.good(to.value(f"call i32 {function}({given}, {', '.join(f'ptr {end}' for end in ends)})"), m)
    found = [to.load("i8", flag) for flag in ends[:3]]
    some = to.value(f"or i8 {to.value(f'or i8 {found[0]}, {found[1]}')}, {found[2]}")
    name = to.name()
    lines = [f"%{name} = call i64 @reported(ptr {flags})", *to.noted(m, f"%{name}", cells.STATUS)]
    to.require(to.value(f"icmp eq i8 {some}, 0"), lines, cells.BAD_STATUS)


def _finite(to: Straight, slot: int, size: int, m: int) -> None:
    """The cells of a GET are."""
    looked = f"call i64 @unfit(ptr %z, i64 {slot}, i64 {slot + size})"
    name = to.name()
    if size > MANY:
        where = to.value(looked)
        to.require(to.value(f"icmp slt i64 {where}, 0"), to.noted(m, where, cells.SLOT), cells.NOT_FINITE)
        return
    every = "true"
    for j in range(slot, slot + size):
        magnitude = to.value(f"call double @llvm.fabs.f64(double {to.load('double', to.cell(j))})")
        one = to.value(f"fcmp olt double {magnitude}, {INFINITE}")
        every = one if every == "true" else to.value(f"and i1 {every}, {one}")
    lines = [f"%{name} = {looked}", *to.noted(m, f"%{name}", cells.SLOT)]
    to.require(every, lines, cells.NOT_FINITE)


def _places(to: Straight, n: int) -> list[tuple[str, int]]:
    """Where the raw values of a block are, and their cells."""
    at, size, first = (int(to.blocks[n, k]) for k in (cells.AT, cells.BYTES, cells.FIRST_SLOT))
    return [
        (to.value(f"getelementptr i8, ptr %raw, i64 {at + size * j}"), first + j)
        for j in range(int(to.blocks[n, cells.SIZE]))
    ]


def _pack(to: Straight, m: int, n: int) -> None:
    """See `exchange.pack`."""
    kind, size = int(to.blocks[n, cells.CODE]), int(to.blocks[n, cells.BYTES])
    for place, slot in _places(to, n):
        if kind == FLOAT and size == 4:
            value = to.load("double", to.cell(slot))
            magnitude = to.value(f"call double @llvm.fabs.f64(double {value})")
            fits = to.value(f"fcmp ule double {magnitude}, {literal(FLOAT32)}")
            to.require(fits, to.noted(m, str(slot), cells.SLOT), cells.UNFIT)
            to.store("float", to.value(f"fptrunc double {value} to float"), place)
            continue
        whole = to.load("i64", to.cell(slot))
        if kind == FLOAT:
            whole = to.value(f"xor i64 {whole}, {SIGN}")
        elif kind == NEGATED:
            whole = to.value(f"sub i64 0, {whole}")
        elif kind == TEXT:
            offset = to.value(f"getelementptr i64, ptr %index, i64 {whole}")
            offset = to.load("i64", to.value(f"getelementptr i64, ptr {offset}, i64 {OFFSETS}"))
            whole = to.value(f"add i64 {to.load('i64', to.place('index', ADDRESS))}, {offset}")
        if size < 8:
            whole = to.value(f"trunc i64 {whole} to i{8 * size}")
        to.store(f"i{8 * size}", whole, place)


def _unpack(to: Straight, n: int) -> None:
    """See `exchange.unpack`."""
    kind, size, signed = (int(to.blocks[n, k]) for k in (cells.CODE, cells.BYTES, cells.SIGNED))
    for place, slot in _places(to, n):
        if kind == FLOAT and size == 4:
            to.store("double", to.value(f"fpext float {to.load('float', place)} to double"), to.cell(slot))
            continue
        whole = to.load(f"i{8 * size}", place)
        if size < 8:
            extended = "sext" if kind == NEGATED or (signed and kind == WHOLE) else "zext"
            whole = to.value(f"{extended} i{8 * size} {whole} to i64")
        if kind == FLOAT:
            whole = to.value(f"xor i64 {whole}, {SIGN}")
        elif kind == NEGATED:
            whole = to.value(f"sub i64 0, {whole}")
        elif kind == BOOLEAN:
            whole = to.value(f"zext i1 {to.value(f'icmp ne i64 {whole}, 0')} to i64")
        to.store("i64", whole, to.cell(slot))
