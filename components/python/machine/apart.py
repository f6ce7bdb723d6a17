"""Which arrays of a function lie apart from all others that it is given: LLVM may then keep their numbers in registers.

Otherwise each number that is stored could have changed every array. It follows from all calls that there are, so a
kernel may give one array twice. Where neither is written to, they count as apart: nothing can change under the other.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping, Sequence
from itertools import permutations

from .kinds import DIMENSIONS, annotation

Given = tuple[str, str]  # a function and one of its arrays
Call = tuple[str, str, dict[str, str]]  # in which function, of which, and its arrays with what each is given


def apart(functions: Mapping[str, ast.FunctionDef], entries: Iterable[tuple[str, Sequence[str]]]) -> set[Given]:
    """The arrays that lie apart.

    `entries`: the calls from outside, with arguments that are whole arrays of an instance, or parts of them.
    """
    arrays = {name: _arrays(node) for name, node in functions.items()}
    calls = [
        (name, call.func.id, {one: ast.unparse(call.args[place]) for one, place in arrays[call.func.id].items()})
        for name, function in functions.items()
        for call in ast.walk(function)
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id in functions
    ]
    written = _written(functions, calls)
    together: set[Given] = set()
    for name, given in entries:
        parts = {one: _part(given[place]) for one, place in arrays[name].items()}
        together |= {(name, one) for one, other in permutations(parts, 2) if _overlap(parts[one], parts[other])}
    known = -1
    while known < len(together):  # arrays that lie together in a function do so in those that it calls
        known = len(together)
        for caller, called, given_arrays in calls:
            doubtful = [
                one for one, name in given_arrays.items()
                if (caller, name) in together or list(given_arrays.values()).count(name) > 1
            ]  # fmt: skip
            for one, other in permutations(doubtful, 2):
                names = given_arrays[one], given_arrays[other]
                same = names[0] == names[1] or {(caller, name) for name in names} <= together
                if same and {(called, one), (called, other)} & written:
                    together.add((called, one))
    return {(name, one) for name, own in arrays.items() for one in own} - together


def _arrays(function: ast.FunctionDef) -> dict[str, int]:
    """Names and places of the arrays among the parameters."""
    return {one.arg: place for place, one in enumerate(function.args.args) if annotation(one.annotation) in DIMENSIONS}


def _written(functions: Mapping[str, ast.FunctionDef], calls: Sequence[Call]) -> set[Given]:
    """The arrays that a function writes to, or lets one that it calls write to."""
    found = {
        (name, ast.unparse(node.value))
        for name, function in functions.items()
        for node in ast.walk(function)
        if isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Store)
    }
    known = -1
    while known < len(found):
        known = len(found)
        for caller, called, given_arrays in calls:
            found |= {(caller, name) for one, name in given_arrays.items() if (called, one) in found}
    return found


def _part(text: str) -> tuple[str, float, float]:
    """Of `lent(values[3:7])` or `lent(eta)`: the array, the first element, and the one behind the last."""
    node = ast.parse(text, mode="eval").body
    if isinstance(node, ast.Call):
        node = node.args[0]
    if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Slice):
        first, behind = (ast.literal_eval(end) for end in (node.slice.lower, node.slice.upper) if end is not None)
        return ast.unparse(node.value), first, behind
    return ast.unparse(node), 0, float("inf")


def _overlap(one: tuple[str, float, float], other: tuple[str, float, float]) -> bool:
    return one[0] == other[0] and one[1] < other[2] and other[1] < one[2]
