"""Machine code from LLVM's text as the bytes of an object file, kept in the cache, and such an object loaded.

The name of what is kept holds a hash of the text, of LLVM's version and of this processor: what was made of anything
else is never taken. `components/python/machine/objects.py` does the same for kernels; neither imports from the other.
"""

# mypy: disable-error-code="no-untyped-call, no-any-return, unused-ignore"
# llvmlite has no types.

from __future__ import annotations

import hashlib
import uuid
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from ...cache.cache import grew, mark_used, place

DIGEST = hashlib.sha256().digest_size
KIND, FILE = "loops", "code.o"  # of an entry of the cache


class Loaded:
    """The functions of an object, which are there as long as this is."""

    def __init__(self, content: bytes) -> None:
        """Raises RuntimeError for what is no object."""
        import llvmlite.binding as llvm

        self._engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine())
        self._engine.add_object_file(llvm.ObjectFileRef.from_data(content))
        self._engine.finalize_object()

    def address(self, name: str) -> int:
        """Of a function."""
        return int(self._engine.get_function_address(name))


@cache
def here() -> str:
    """What an object depends on beside its text."""
    import llvmlite
    import llvmlite.binding as llvm

    processor = llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()
    return "\n".join([llvmlite.__version__, llvm.get_default_triple(), *processor])


def _machine(level: int = 2) -> Any:
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    llvm.initialize_native_asmparser()  # for texts with instructions of the processor in them
    target = llvm.Target.from_triple(llvm.get_process_triple())
    features = llvm.get_host_cpu_features().flatten()
    return target.create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=features, opt=level, reloc="default", codemodel="jitdefault", jit=True
    )


def object_of(text: str, level: int = 2) -> bytes:
    """Compile LLVM's text for the processor that is here. Raises RuntimeError where LLVM does not take it."""
    import llvmlite.binding as llvm

    machine = _machine(level)
    module = llvm.parse_assembly(f'target triple = "{llvm.get_process_triple()}"\n{text}')
    module.data_layout = str(machine.target_data)
    module.verify()
    if hasattr(llvm, "create_pass_builder"):  # an older llvmlite has none; the code is right without, and slower
        builder = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=level))
        builder.getModulePassManager().run(module, builder)
    return machine.emit_object(module)


def data_layout() -> str:
    """How this processor lays out data, as LLVM writes it."""
    return str(_machine().target_data)


def machine_code(module: Any) -> bytes:
    """The object of a module that is optimised already. Raises RuntimeError where it is not right."""
    module.verify()
    return _machine(3).emit_object(module)


def name_of(what: str, text: str) -> str:
    """Of the entry that keeps the object of a text."""
    return f"{what}_{hashlib.sha256(chr(0).join([text, here()]).encode()).hexdigest()[:24]}"


def kept(name: str) -> bytes | None:
    """An object that was kept; None where it is not there, or damaged. Raises FmuError for a folder that others can
    write to."""
    folder = place(KIND, name)
    content = read_whole(folder / FILE)
    if content is not None:
        mark_used(folder)
    return content


def keep(name: str, content: bytes) -> None:
    """Keep an object; where that fails nothing is."""
    folder = place(KIND, name)
    with suppress(OSError):
        folder.mkdir(mode=0o700, exist_ok=True)
        write_whole(folder / FILE, content)
        mark_used(folder)
        grew(len(content))


def read_whole(path: Path) -> bytes | None:
    """What `write_whole` wrote; None where it is not there, or damaged."""
    try:
        content = path.read_bytes()
    except OSError:
        return None
    return content[:-DIGEST] if hashlib.sha256(content[:-DIGEST]).digest() == content[-DIGEST:] else None


def write_whole(path: Path, content: bytes) -> None:
    """Write a file with the hash of its content behind it; where that fails there is none."""
    temporary = path.with_name(f"{uuid.uuid4().hex[:12]}.tmp")
    with suppress(OSError):
        temporary.write_bytes(content + hashlib.sha256(content).digest())
        temporary.replace(path)


def loaded_from(path: Path) -> Loaded | None:
    """The object in such a file; None where there is none that is whole."""
    content = read_whole(path)
    try:
        return None if content is None else Loaded(content)
    except RuntimeError:
        return None
