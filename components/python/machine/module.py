"""A kernel as one module of LLVM's: its functions, and its entry points that take an instance's arrays from a table.

An entry point is `define i64 @NAME(ptr %table)`; of each array the table has address and two sizes, in order. Beside it
is `@NAME.repeat(ptr %table, i64 %count)`, which calls it so often, for measurements.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .apart import apart
from .expressions import Expressions
from .functions import Function
from .kinds import Array, UnknownError

WORDS = 3  # of an array in the table
REPEAT = """define i64 @{name}.repeat(ptr %table, i64 %count) nounwind {{
entry:
  br label %test
test:
  %k = phi i64 [ 0, %entry ], [ %next, %body ]
  %going = icmp slt i64 %k, %count
  br i1 %going, label %body, label %end
body:
  %status = call i64 @{name}(ptr %table)
  %next = add i64 %k, 1
  br label %test
end:
  ret i64 0
}}
"""


@dataclass(frozen=True)
class Usual:
    """What is known of `function` where parameters are what they usually are: its arguments, and sizes of arrays."""

    function: str
    given: Sequence[str]
    sizes: Mapping[str, tuple[int | None, ...]]


def machine_text(
    text: str, entries: Mapping[str, Sequence[str]], arrays: Mapping[str, int], usual: Usual | None = None
) -> str:
    """LLVM's text of a lowered kernel.

    `entries`: for each function that is called from outside, its arguments as expressions over the `arrays`, which have
    so many dimensions. `usual`: that function, and all that it calls, is compiled for what is known there. Raises
    UnknownError for what only Numba compiles.
    """
    nodes = [node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)]
    functions = {node.name: node for node in nodes}
    if len(functions) < len(nodes):
        raise UnknownError("two functions of one name")
    namespace: dict[str, Any] = {}
    exec(compile(text, "<kernel>", "exec"), namespace)  # definitions and constants
    externals: set[str] = set()
    needed = _needed(functions, [name for name in entries if not usual or name != usual.function])
    common = functions, namespace, externals, apart(functions, entries.items())
    made = [Function(node, *common).text() for name, node in functions.items() if name in needed]
    if usual:
        copied = _needed(functions, [usual.function])
        made += [Function(node, *common, "u").text() for name, node in functions.items() if name in copied]
    for name, given in entries.items():
        entry = _Entry(functions, namespace, externals, arrays)
        if usual and name == usual.function:
            entry = _Entry(functions, namespace, externals, arrays, usual.sizes)
            entry.prefix, given = "u", usual.given
        made += [entry.text(name, name, given), REPEAT.format(name=name)]
    return "\n".join([*sorted(externals), *made])


def _needed(functions: Mapping[str, ast.FunctionDef], first: Iterable[str]) -> set[str]:
    """The names of the functions that are called, directly or not."""
    found, waiting = set[str](), list(first)
    while waiting:
        name = waiting.pop()
        if name in functions and name not in found:
            found.add(name)
            waiting += [one.id for one in ast.walk(functions[name]) if isinstance(one, ast.Name)]
    return found


class _Entry(Expressions):
    """What unpacks the table and calls a function of the kernel."""

    def __init__(
        self,
        functions: dict[str, ast.FunctionDef],
        namespace: dict[str, Any],
        externals: set[str],
        arrays: Mapping[str, int],
        sizes: Mapping[str, tuple[int | None, ...]] | None = None,
    ) -> None:
        super().__init__(functions, namespace, externals)
        for k, (name, dimensions) in enumerate(arrays.items()):
            words = [
                self.new(f"load {kind}, ptr {self.new(f'getelementptr i64, ptr %table, i64 {WORDS * k + j}')}")
                for j, kind in enumerate(["ptr", *["i64"] * dimensions])
            ]
            known = (sizes or {}).get(name, (None, None))
            found = (word if size is None else str(size) for word, size in zip(words[1:], known, strict=False))
            self.arrays[name] = Array(words[0], tuple(found))

    def text(self, name: str, function: str, given: Sequence[str]) -> str:
        """Its definition: a call of a function."""
        self.call_own(ast.Call(ast.Name(function), [ast.parse(one, mode="eval").body for one in given], []))
        lines = [f"define i64 @{name}(ptr %table) nounwind noinline {{", "entry:", *self.lines, "  ret i64 0", "}", ""]
        return "\n".join(lines)

    def array(self, node: ast.expr) -> Array:
        """`lent(values[3:7])`, or an array by its name."""
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "lent":
            node = node.args[0]
        if not isinstance(node, ast.Subscript):
            return super().array(node)
        whole, part = super().array(node.value), node.slice
        if not isinstance(part, ast.Slice) or part.lower is None or part.upper is None or part.step is not None:
            raise UnknownError(ast.unparse(node))
        first, behind = ast.literal_eval(part.lower), ast.literal_eval(part.upper)
        pointer = self.new(f"getelementptr double, ptr {whole.pointer}, i64 {first}")
        return Array(pointer, (str(behind - first),))
