"""Functions of a kernel as LLVM's text, statement by statement."""

from __future__ import annotations

import ast
from collections.abc import Set
from typing import Any

from .expressions import Expressions
from .inference import counters, variables
from .kinds import BOOL, INT, Array, Number, UnknownError, returned
from .text import result_type


class Function(Expressions):
    """One function. Variables lie in memory; LLVM puts them into registers."""

    def __init__(
        self,
        node: ast.FunctionDef,
        functions: dict[str, ast.FunctionDef],
        namespace: dict[str, Any],
        externals: set[str],
        alone: Set[tuple[str, str]],
        prefix: str = "k",
    ) -> None:
        """`alone`: functions and arrays of theirs that lie apart from all others that these are given."""
        super().__init__(functions, namespace, externals)
        self.prefix = prefix
        self.alone = {array for name, array in alone if name == node.name}
        self.node, self.result = node, returned(node)
        self.local = {n.id for n in ast.walk(node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
        self.kinds = variables(node, self.kind_of, self.kinds_of_call)
        self.counters = counters(node)
        self.loops: list[tuple[str, str]] = []  # where `continue` and `break` go

    def text(self) -> str:
        """Its definition."""
        taken, scalars = [], []
        for parameter in self.node.args.args:
            name, kind = parameter.arg, self.parameter_kind(parameter)
            if isinstance(kind, str):
                if self.kinds[name] != kind:
                    raise UnknownError(f"{name} is given as one kind and put as another")
                taken.append(f"{kind} %a.{name}")
                scalars.append(name)
                continue
            sizes = tuple(f"%n{k}.{name}" for k in range(kind))
            self.arrays[name] = Array(f"%a.{name}", sizes)
            pointer = f"ptr{' noalias' * (name in self.alone)} %a.{name}"
            taken += [pointer, *(f"i64 {size}" for size in sizes)]
        for name, kind in self.kinds.items():
            self.do(f"%v.{name} = alloca {kind}")
            first = f"%a.{name}" if name in scalars else "zeroinitializer"
            self.do(f"store {kind} {first}, ptr %v.{name}")
        self.statements(self.node.body)
        self.do(f"ret {result_type(self.result)} zeroinitializer" if self.result else "ret void")
        name = f"@{self.prefix}.{self.node.name}"
        head = f"define internal {result_type(self.result)} {name}({', '.join(taken)}) nounwind {{"
        return "\n".join([head, "entry:", *self.lines, "}", ""])

    def statements(self, nodes: list[ast.stmt]) -> None:
        for node in nodes:
            self.statement(node)

    def statement(self, node: ast.stmt) -> None:
        """One statement."""
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            self._assign(node.targets[0], node.value)
        elif isinstance(node, ast.AugAssign):
            self._change(node)
        elif isinstance(node, ast.If):
            self._if(node)
        elif isinstance(node, ast.For) and not node.orelse:
            self._count(node)
        elif isinstance(node, ast.While) and not node.orelse:
            self._while(node)
        elif isinstance(node, ast.Return):
            self._return(node.value)
        elif isinstance(node, ast.Break | ast.Continue):
            self._leave(f"br label %{self.loops[-1][isinstance(node, ast.Break)]}")
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            if self.called(node.value) not in self.functions:
                raise UnknownError(ast.unparse(node))
            self.call_own(node.value)
        elif not isinstance(node, ast.Pass) and not (
            isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        ):
            raise UnknownError(ast.unparse(node))

    def _leave(self, how: str) -> None:
        self.do(how)
        self.begin(self.label())  # what stands behind is never reached

    def _assign(self, target: ast.expr, given: ast.expr) -> None:
        if not isinstance(target, ast.Tuple):
            self._store(target, self.value(given))
            return
        if isinstance(given, ast.Tuple):
            values = [self.value(one) for one in given.elts]
        else:
            kinds = self.kinds_of_call(given)
            assert isinstance(given, ast.Call)
            made, packed = self.call_own(given), result_type(kinds)
            values = [Number(self.new(f"extractvalue {packed} {made}, {k}"), kind) for k, kind in enumerate(kinds)]
        for one, value in zip(target.elts, values, strict=True):
            self._store(one, value)

    def _store(self, target: ast.expr, value: Number) -> None:
        if isinstance(target, ast.Name) and target.id in self.kinds:
            kind = self.kinds[target.id]
            self.do(f"store {kind} {self.as_kind(value, kind)}, ptr %v.{target.id}")
        elif isinstance(target, ast.Subscript):
            text = self.as_kind(value, "double")
            self.do(f"store double {text}, ptr {self.place(target)}")
        else:
            raise UnknownError(ast.unparse(target))

    def _change(self, node: ast.AugAssign) -> None:
        if isinstance(node.target, ast.Subscript):
            place = self.place(node.target)
            before = Number(self.new(f"load double, ptr {place}"), "double")
            after = self.arithmetic(node.op, before, self.value(node.value))
            self.do(f"store double {after.text}, ptr {place}")
        else:
            assert isinstance(node.target, ast.Name)
            before = self.value(ast.Name(node.target.id))
            self._store(node.target, self.arithmetic(node.op, before, self.value(node.value)))

    def _if(self, node: ast.If) -> None:
        yes, no, end = self.label(), self.label(), self.label()
        self.do(f"br i1 {self.truth(node.test)}, label %{yes}, label %{no if node.orelse else end}")
        for block, body in ((yes, node.body), (no, node.orelse)):
            if body:
                self.begin(block)
                self.statements(body)
                self.do(f"br label %{end}")
        self.begin(end)

    def _while(self, node: ast.While) -> None:
        test, body, end = self.label(), self.label(), self.label()
        self.do(f"br label %{test}")
        self.begin(test)
        self.do(f"br i1 {self.truth(node.test)}, label %{body}, label %{end}")
        self._loop(body, node.body, test, end)
        self.do(f"br label %{test}")
        self.begin(end)

    def _loop(self, block: str, body: list[ast.stmt], ahead: str, end: str) -> None:
        self.begin(block)
        self.loops.append((ahead, end))
        self.statements(body)
        self.loops.pop()

    def _count(self, node: ast.For) -> None:
        """`for i in range(...)`: how often is decided before the first time, and i stays what it was last."""
        call, name = node.iter, node.target
        if not isinstance(call, ast.Call) or self.called(call) != "range" or not isinstance(name, ast.Name):
            raise UnknownError(ast.unparse(node.iter))
        stride = _whole(call.args[2]) if len(call.args) == 3 else 1
        ends = [self.value(one) for one in call.args[:2]]
        first, last = ends if len(ends) == 2 else (Number("0", INT), ends[0])
        if not stride or (first.kind, last.kind) != (INT, INT):
            raise UnknownError(ast.unparse(node.iter))
        if self.kinds[name.id] == BOOL:
            raise UnknownError(ast.unparse(node))
        test, body, ahead, end = (self.label() for _ in range(4))
        before = self.block
        self.do(f"br label %{test}")
        self.begin(test)
        at, later = f"%i.{test}", f"%j.{test}"
        self.do(f"{at} = phi i64 [ {first.text}, %{before} ], [ {later}, %{ahead} ]")
        going = self.new(f"icmp {'slt' if stride > 0 else 'sgt'} i64 {at}, {last.text}")
        self.do(f"br i1 {going}, label %{body}, label %{end}")
        self.begin(body)
        self._store(name, Number(at, INT))
        self.do(f"br label %{body}.0")
        self._loop(f"{body}.0", node.body, ahead, end)
        self.do(f"br label %{ahead}")
        self.begin(ahead)
        self.do(f"{later} = add nsw i64 {at}, {stride}")
        self.do(f"br label %{test}")
        self.begin(end)

    def _return(self, given: ast.expr | None) -> None:
        if given is None or not self.result:
            if given is not None or self.result:
                raise UnknownError(f"{self.node.name} returns what it does not say")
            self._leave("ret void")
            return
        packed = result_type(self.result)
        if len(self.result) == 1:
            text = self.as_kind(self.value(given), self.result[0])
        elif isinstance(given, ast.Tuple) and len(given.elts) == len(self.result):
            values = [self.as_kind(self.value(v), k) for v, k in zip(given.elts, self.result, strict=True)]
            text = "undef"
            for k, (one, kind) in enumerate(zip(values, self.result, strict=True)):
                text = self.new(f"insertvalue {packed} {text}, {kind} {one}, {k}")
        elif isinstance(given, ast.Call) and self.kinds_of_call(given) == self.result:
            text = self.call_own(given)
        else:
            raise UnknownError(ast.unparse(given))
        self._leave(f"ret {packed} {text}")


def _whole(node: ast.expr) -> int:
    """A whole number that is written out; 0 for anything else."""
    try:
        value = ast.literal_eval(node)
    except ValueError:
        return 0
    return value if isinstance(value, int) else 0
