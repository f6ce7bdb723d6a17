"""A compiler of functions that are parts of those that call them only, which halves the first compile.

Numba makes of every function machine code of its own, twice the code that unpacks its arguments, for Python and for C,
and optimizes it by itself. The functions of a kernel, which take dozens of arrays, are all inlined: none of that ever
ran.
"""

# mypy: disable-error-code="no-untyped-call, misc, unused-ignore"
# Numba has no types.

from __future__ import annotations

import uuid
from typing import Any

from numba.core import typed_passes, untyped_passes
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import register_pass
from numba.core.typed_passes import NativeLowering

# For closures, `with`, array expressions and the like, which no kernel has (`lowering/` refuses them).
NEEDLESS = (
    untyped_passes.WithLifting, untyped_passes.InlineClosureLikes, untyped_passes.MakeFunctionToJitFunction,
    untyped_passes.InlineInlinables, untyped_passes.FindLiterallyCalls, untyped_passes.LiteralUnroll,
    untyped_passes.LiteralPropagationSubPipelinePass, typed_passes.InlineOverloads, typed_passes.NopythonRewrites,
)  # fmt: skip


@register_pass(mutates_CFG=True, analysis_only=False)  # type: ignore[untyped-decorator]
class _PartLowering(NativeLowering):
    """LLVM code for those that call the function, without machine code and wrappers."""

    _name = f"part_{uuid.uuid4().hex}"  # Numba knows passes by name, and each FMU of a process brings its own

    def run_pass(self, state: Any) -> bool:
        """Lower the function and make it known to its callers, as Numba does after it has made machine code."""
        state.library = state.targetctx.codegen().create_library(state.func_id.func_qualname)
        state.library._optimize_final_module = lambda: None  # the caller's optimization covers it
        state.flags.no_compile = state.flags.no_cpython_wrapper = state.flags.no_cfunc_wrapper = True
        super().run_pass(state)
        # Numba knows a function by what Python calls: some built-in one, of each its own, that refuses numbers.
        stand_in = state["cr"].fndesc.mangled_name.join
        state["cr"] = state["cr"]._replace(cfunc=stand_in)
        state.targetctx.insert_user_function(stand_in, state["cr"].fndesc, [state.library])
        state.reload_init.extend(getattr(state.library, "_reload_init", ()))  # from 0.62 on
        return True


class PartCompiler(CompilerBase):
    """Numba's compiler with that pass in the place of its own, and fewer of the others."""

    def define_pipelines(self) -> list[Any]:
        """The passes, in Numba's order."""
        pipeline = DefaultPassBuilder.define_nopython_pipeline(self.state)
        pipeline.passes = [
            (_PartLowering if one is NativeLowering else one, words)
            for one, words in pipeline.passes
            if one not in NEEDLESS
        ]
        pipeline.finalize()
        return [pipeline]
