"""Functions of FMI that know their group: what the loop calls of a member leads to the group's own function.

A few lines of machine code for each: the member's instance, which FMI gives first, is replaced by the group's table.
"""

from __future__ import annotations

from typing import Any

from ..loop.machine.compiled import numba_compiles
from .compiled import address_of

_PASSED = {  # of C, behind the instance, and how it is passed on
    "step2": ("double %a, double %b, i32 %c", "double %a, double %b, i64 %c64", ("%c64 = sext i32 %c to i64",)),
    "step": (
        "double %a, double %b, i32 %c, i64 %d, i64 %e, i64 %f, i64 %g",
        "double %a, double %b, i64 %c64, i64 %d, i64 %e, i64 %f, i64 %g",
        ("%c8 = and i32 %c, 255", "%c64 = zext i32 %c8 to i64"),
    ),
    "save": ("i64 %a", "i64 %a", ()),
    "restore": ("i64 %a", "i64 %a", ()),
    "forget": ("i64 %a", "i64 %a", ()),
}  # fmt: skip


class Bound:
    """Functions bound to a group; they live as long as this object."""

    def __init__(self, g: int) -> None:
        self.g = g
        self._made: dict[str, tuple[int, Any]] = {}

    def address(self, name: str) -> int:
        """The address of one: step (fmi3DoStep), step2 (fmi2DoStep), save, restore, forget."""
        if name not in self._made:
            self._made[name] = _interpreted(name, self.g) if not numba_compiles() else _compiled(name, self.g)
        return self._made[name][0]


def _compiled(name: str, g: int) -> tuple[int, Any]:
    import llvmlite.binding as llvm

    given, passed, before = _PASSED[name]
    lines = "\n".join(f"  {line}" for line in before)
    text = (
        f"define i32 @{name}(i64 %instance, {given}) {{\n{lines}\n"
        f"  %target = inttoptr i64 {address_of(name)} to ptr\n"
        f"  %status = tail call i32 %target(i64 {g}, {passed})\n  ret i32 %status\n}}\n"
    )
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    module = llvm.parse_assembly(text)
    module.verify()
    engine = llvm.create_mcjit_compiler(module, llvm.Target.from_default_triple().create_target_machine(opt=2))
    engine.finalize_object()
    return int(engine.get_function_address(name)), engine


def _interpreted(name: str, g: int) -> tuple[int, Any]:
    import ctypes

    from .compiled import FUNCTIONS

    function, kinds = FUNCTIONS[name]
    types: dict[str, Any] = {"w": ctypes.c_int64, "d": ctypes.c_double, "b": ctypes.c_bool}
    made = ctypes.CFUNCTYPE(ctypes.c_int, *(types[kind] for kind in kinds))(lambda _, *rest: function(g, *rest))
    return ctypes.cast(made, ctypes.c_void_p).value or 0, made
