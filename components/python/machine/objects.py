"""Machine code from LLVM's text, as the bytes of an object file, and such an object loaded."""

# mypy: disable-error-code="no-untyped-call, no-any-return, unused-ignore"
# llvmlite has no types.

from __future__ import annotations

from functools import cache
from typing import Any

import llvmlite
import llvmlite.binding as llvm


@cache
def processor() -> tuple[str, str]:
    """The name of the processor that is here, and what it can do."""
    return llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()


def here() -> str:
    """What an object depends on beside its text."""
    return "\n".join([llvmlite.__version__, llvm.get_default_triple(), *processor()])


def _machine() -> Any:
    if not hasattr(llvm, "create_pass_builder"):
        raise NotImplementedError(f"llvmlite {llvmlite.__version__} is too old")
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    cpu, features = processor()
    target = llvm.Target.from_triple(llvm.get_process_triple())
    how = {"opt": 3, "reloc": "default", "codemodel": "jitdefault", "jit": True}  # as Numba has it
    return target.create_target_machine(cpu=cpu, features=features, **how)


def object_of(text: str) -> bytes:
    """Compile LLVM's text for the processor that is here. Raises RuntimeError where LLVM does not take it."""
    machine = _machine()
    module = llvm.parse_assembly(f'target triple = "{llvm.get_process_triple()}"\n{text}')
    module.data_layout = str(machine.target_data)
    module.verify()
    builder = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=3))
    builder.getModulePassManager().run(module, builder)
    return machine.emit_object(module)


class Loaded:
    """The functions of an object, which are there as long as this is."""

    def __init__(self, content: bytes) -> None:
        """Raises RuntimeError for what is no object."""
        machine = _machine()
        empty = llvm.parse_assembly(f'target triple = "{llvm.get_process_triple()}"\n')
        self._engine = llvm.create_mcjit_compiler(empty, machine)
        self._engine.add_object_file(llvm.ObjectFileRef.from_data(content))
        self._engine.finalize_object()

    def address(self, name: str) -> int:
        """Of a function."""
        return int(self._engine.get_function_address(name))
