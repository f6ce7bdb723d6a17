"""The kinds of a function's variables: each has one, which takes all that is put into it."""

from __future__ import annotations

import ast
from collections.abc import Callable

from .kinds import DIMENSIONS, FLOAT, INT, OF_ANNOTATION, UnknownError, annotation, joined

KindOf = Callable[[ast.expr, dict[str, str]], str]
TupleOf = Callable[[ast.expr], tuple[str, ...]]


def variables(node: ast.FunctionDef, kind_of: KindOf, kinds_of_call: TupleOf) -> dict[str, str]:
    """The kind of each scalar by name, parameters too; arrays are not among them."""
    found = {}
    for argument in node.args.args:
        text = annotation(argument.annotation)
        if text in OF_ANNOTATION:
            found[argument.arg] = OF_ANNOTATION[text]
        elif text not in DIMENSIONS:
            raise UnknownError(f"{node.name} takes {text or 'what is not said'}")
    statements = [one for one in ast.walk(node) if isinstance(one, ast.Assign | ast.AugAssign | ast.For)]
    before: dict[str, str] | None = None
    while before != found:
        before = dict(found)
        for one in statements:
            _put(one, found, kind_of, kinds_of_call)
    return found


def _put(node: ast.stmt, found: dict[str, str], kind_of: KindOf, kinds_of_call: TupleOf) -> None:
    """Take one statement into account, as far as the kinds on its right are known."""
    if isinstance(node, ast.For):
        _join(node.target, INT, found)
    elif isinstance(node, ast.AugAssign):
        kind = FLOAT if isinstance(node.op, ast.Div) else kind_of(node.value, found)
        _join(node.target, kind, found)
    elif isinstance(node, ast.Assign):
        target = node.targets[0]
        if not isinstance(target, ast.Tuple):
            _join(target, kind_of(node.value, found), found)
            return
        given = node.value
        many = isinstance(given, ast.Tuple)
        kinds = [kind_of(v, found) for v in given.elts] if isinstance(given, ast.Tuple) else kinds_of_call(given)
        if len(kinds) != len(target.elts):
            raise UnknownError(f"{len(kinds)} values for {len(target.elts)} names ({many})")
        for one, kind in zip(target.elts, kinds, strict=True):
            _join(one, kind, found)


def _join(target: ast.expr, kind: str, found: dict[str, str]) -> None:
    if isinstance(target, ast.Name) and kind:
        found[target.id] = joined(found.get(target.id, ""), kind)


def counters(node: ast.FunctionDef) -> set[str]:
    """Variables that count loops up from a number that is not negative, and that nothing else writes to."""
    loops = [one for one in ast.walk(node) if isinstance(one, ast.For)]
    up = {one.target.id for one in loops if isinstance(one.target, ast.Name) and _upwards(one.iter)}
    written = [
        one.id for one in ast.walk(node) if isinstance(one, ast.Name) and isinstance(one.ctx, ast.Store)
    ]  # fmt: skip
    others = {one.target.id for one in loops if isinstance(one.target, ast.Name) and not _upwards(one.iter)}
    times = {name: sum(isinstance(o.target, ast.Name) and o.target.id == name for o in loops) for name in up}
    parameters = {argument.arg for argument in node.args.args}
    return {name for name in up - others - parameters if written.count(name) == times[name]}


def _upwards(node: ast.expr) -> bool:
    if not isinstance(node, ast.Call) or len(node.args) > 2:
        return False
    first = node.args[0] if len(node.args) == 2 else ast.Constant(0)
    return isinstance(first, ast.Constant) and isinstance(first.value, int) and first.value >= 0
