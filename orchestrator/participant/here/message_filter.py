"""Messages that nobody reads cost nothing: they end in machine code, before they are formatted and reach Python.

Many FMUs log whatever they are told. Their logger is a function made here, once per process, which looks into a table:
a message that is wanted goes on to the logger behind it with all its arguments, those of printf too (a variadic tail
call, which no language above the machine has); any other one is counted. An FMU is known by what it was told of its
environment; one that gives back something else shares the first row.
"""

from __future__ import annotations

import ctypes
import hashlib
import threading
from functools import cache
from typing import Any

import numpy as np

from ...extras import needed
from ...loop.machine import shipped
from ...loop.machine.compiled import own_hash

# Columns of the table: environment, how many messages may still pass, how many did not, the lowest status that passes.
ENVIRONMENT, ALLOWANCE, COUNTED, LOWEST, COLUMNS = range(5)
ROWS = 4096  # instances that log through here at a time
AT_FIRST = 1000  # messages that pass
AT_A_TIME = 20  # that may pass after each look; the last ones before an error are among them

_table = np.zeros((ROWS, COLUMNS), dtype=np.int64)
_size = np.ones(1, dtype=np.int64)
_lock = threading.Lock()

# Of all versions: FMI 1.0 and 2.0 give environment, name, status, category, format and what it takes; FMI 3.0 has no
# name and one text. `status` is an int.
_TEXT = """
@{name}_table = global i64 {table}
@{name}_size = global i64 {size}
@{name}_target = global i64 {target}

define void @{name}({parameters}) {{
entry:
  %at_table = load i64, ptr @{name}_table
  %at_size = load i64, ptr @{name}_size
  %table = inttoptr i64 %at_table to ptr
  %sizes = inttoptr i64 %at_size to ptr
  %size = load i64, ptr %sizes
  %told = ptrtoint ptr %environment to i64
  br label %look
look:
  %k = phi i64 [ 1, %entry ], [ %next, %other ]
  %inside = icmp slt i64 %k, %size
  br i1 %inside, label %compare, label %found
compare:
  %at = mul i64 %k, {columns}
  %cell = getelementptr i64, ptr %table, i64 %at
  %known = load i64, ptr %cell
  %same = icmp eq i64 %known, %told
  br i1 %same, label %found, label %other
other:
  %next = add i64 %k, 1
  br label %look
found:
  %row = phi i64 [ %k, %compare ], [ 0, %look ]
  %begin = mul i64 %row, {columns}
  %first = getelementptr i64, ptr %table, i64 %begin
  %limits = getelementptr i64, ptr %first, i64 {lowest}
  %limit = load i64, ptr %limits
  %wide = sext i32 %status to i64
  %wanted = icmp sge i64 %wide, %limit
  br i1 %wanted, label %count, label %out
count:
  %allowances = getelementptr i64, ptr %first, i64 {allowance}
  %allowance = load i64, ptr %allowances
  %may = icmp sgt i64 %allowance, 0
  br i1 %may, label %pass, label %full
full:
  %counts = getelementptr i64, ptr %first, i64 {counted}
  %counted = load i64, ptr %counts
  %more = add i64 %counted, 1
  store i64 %more, ptr %counts
  br label %out
out:
  ret void
pass:
  %less = sub i64 %allowance, 1
  store i64 %less, ptr %allowances
  %behind = load i64, ptr @{name}_target
  %target = inttoptr i64 %behind to ptr
  musttail call void ({types}) %target({arguments})
  ret void
}}
"""
_PARAMETERS = {
    2: ("ptr %environment", "ptr %name", "i32 %status", "ptr %category", "ptr %message", "..."),
    3: ("ptr %environment", "i32 %status", "ptr %category", "ptr %message"),
}
_made: list[Any] = []  # the machine code lives as long as the process


def machine_text(version: int, **values: int) -> str:
    """The logger of an FMI version as text for LLVM; `values` of its table, size and target, set later if not here."""
    parameters = _PARAMETERS[version]
    return _TEXT.format(
        name=_name(version), parameters=", ".join(parameters), types=", ".join(p.split()[0] for p in parameters),
        arguments=", ".join(parameters), columns=COLUMNS, lowest=LOWEST, allowance=ALLOWANCE, counted=COUNTED,
        **{"table": 0, "size": 0, "target": 0, **values},
    )  # fmt: skip


def _name(version: int) -> str:
    """With a hash of the text: a library that came with other sources has no function of this name."""
    return f"log{version}_{hashlib.sha256(_TEXT.encode()).hexdigest()[:8]}"


@cache
def filtered(version: int, target: int) -> int:
    """The address of a logger of an FMI version that passes what is wanted on to another one at `target`."""
    values = {"table": _table.ctypes.data, "size": _size.ctypes.data, "target": target}
    return _shipped(version, values) or _compiled(version, values)


def _shipped(version: int, values: dict[str, int]) -> int:
    """The one of the library that came with the package, for one target in a process; 0 where there is none."""
    library, name = shipped.library(own_hash()), _name(version)
    if library is None or not library.has(name):
        return 0
    if library.number(f"{name}_target").value not in (0, values["target"]):
        return 0
    for key, value in values.items():
        library.number(f"{name}_{key}").value = value
    return library.address_of(name)


def _compiled(version: int, values: dict[str, int]) -> int:
    llvm = needed("llvmlite.binding", "a second logger of FMUs")
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    module = llvm.parse_assembly(machine_text(version, **values))
    module.verify()
    engine = llvm.create_mcjit_compiler(module, llvm.Target.from_default_triple().create_target_machine(opt=2))
    engine.finalize_object()
    _made.append(engine)
    return int(engine.get_function_address(_name(version)))


class Row:
    """The row of an instance, until it is given back."""

    def __init__(self, environment: int, everything: bool) -> None:
        self.environment = environment
        with _lock:
            _table[0] = 0, max(int(_table[0, ALLOWANCE]), AT_FIRST), _table[0, COUNTED], 1
            lowest, allowance = (0, 1 << 62) if everything else (1, AT_FIRST)
            at = self._at() or int(_size[0])  # an earlier instance at the same address may never have been closed
            if at < ROWS:
                _table[at] = environment, allowance, 0, lowest
                _size[0] = max(int(_size[0]), at + 1)

    def _at(self) -> int:
        """Its number; 0 where the table had no room."""
        found = np.flatnonzero(_table[1 : _size[0], ENVIRONMENT] == self.environment)
        return int(found[0]) + 1 if found.size else 0

    def known_as(self, environment: int) -> None:
        """From now on its messages come with another environment; until then they may have come with any."""
        with _lock:
            at, self.environment = self._at(), environment
            if at:
                _table[at, ENVIRONMENT] = environment

    def look(self) -> None:
        """Let some more messages pass."""
        _table[: _size[0], ALLOWANCE] = np.maximum(_table[: _size[0], ALLOWANCE], AT_A_TIME)

    @property
    def counted(self) -> int:
        """Messages that did not pass."""
        return int(_table[self._at(), COUNTED])

    def give_back(self) -> None:
        """The instance is no more."""
        with _lock:
            at, last = self._at(), int(_size[0]) - 1
            if at:
                _table[at] = _table[last]
                _size[0] = last


def address_of(callback: Any) -> int:
    """The address of a ctypes function."""
    return ctypes.cast(callback, ctypes.c_void_p).value or 0
