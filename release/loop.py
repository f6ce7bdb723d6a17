"""The loop's libraries for the wheel: what Numba makes of `run.run` for any x86-64, linked for each system.

A run with them needs neither Numba nor LLVM, and compiles nothing. Beside the loop they hold the filters of the FMUs'
messages. LLVM's text says nothing of a system but its name and the layout of its data.

python -m release.loop FOLDER [PLATFORM...] writes them below a folder, for ROVBRUSH_LOOP; `--text` writes the loop's
text beside its sources (`orchestrator/loop/machine/written.py`), which is due after every change of them.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from rovbrush.components.native.compile import PLATFORMS, compile_library
from rovbrush.orchestrator.loop.machine import written
from rovbrush.orchestrator.loop.machine.shipped import file_name
from rovbrush.orchestrator.loop.machine.wrapped import NOTHING_TO_FREE, text_of

TRIPLES = {"linux64": "x86_64-unknown-linux-gnu", "win64": "x86_64-w64-windows-gnu"}
LAYOUT = "e-m:{mangling}-p270:32:32-p271:32:32-p272:64:64-i64:64-i128:128-f80:128-n8:16:32:64-S128"
MANGLING = {"linux64": "e", "win64": "w"}
NOTHING = f"void {NOTHING_TO_FREE}(void *array) {{ (void)array; }}\n"


def build(folder: Path, platforms: tuple[str, ...] = tuple(PLATFORMS)) -> None:
    """Write the libraries below a folder: machine/libraries of the loop's. Raises BuildError."""
    texts = _texts()
    for name in platforms:
        target = folder / file_name(texts["digest"], name)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(_linked(texts, name))
        print(f"built the loop for {name} ({target.stat().st_size / 1e3:.0f} kB)", flush=True)


def _linked(texts: dict[str, str], name: str) -> bytes:
    import llvmlite.binding as llvm

    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple(TRIPLES[name]).create_target_machine(
        cpu="x86-64", opt=3, reloc="pic", codemodel="small"
    )
    module = llvm.parse_assembly(_for_system(texts["loop"], name))
    for filters in (texts["filter2"], texts["filter3"]):
        module.link_in(llvm.parse_assembly(_for_system(filters, name)))
    module.verify()
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        (folder / "loop.o").write_bytes(machine.emit_object(module))
        (folder / "nothing.c").write_text(NOTHING)
        return compile_library(folder, ("loop.o", "nothing.c"), PLATFORMS[name])


def _for_system(text: str, name: str) -> str:
    """LLVM's text with the name of a system, and the layout of its data, in place of its own or of none."""
    kept = re.sub(r"(?m)^target (datalayout|triple) = .*\n", "", text)
    layout = LAYOUT.format(mangling=MANGLING[name])
    return f'target datalayout = "{layout}"\ntarget triple = "{TRIPLES[name]}"\n{kept}'


def _texts() -> dict[str, str]:
    """LLVM's texts of the loop and of the filters, and the hash of the loop's sources: from a process of its own,
    which compiles for no processor in particular and keeps that apart from what is compiled for this one."""
    with tempfile.TemporaryDirectory() as cache:
        environment = {**os.environ, "NUMBA_CPU_NAME": "x86-64", "NUMBA_CPU_FEATURES": "", "NUMBA_CACHE_DIR": cache}
        command = [sys.executable, "-m", "release.loop", "--into", cache]
        subprocess.run(command, check=True, env=environment, cwd=Path(__file__).parent.parent)
        return {path.stem: path.read_text() for path in Path(cache).glob("*.ll")}


def _write_texts(folder: Path) -> None:
    from rovbrush.orchestrator.loop.machine import compiled
    from rovbrush.orchestrator.participant.here.message_filter import machine_text

    compiled.IN_CHILD = True
    made: Any = compiled.compiled_loop()
    (folder / "loop.ll").write_text(text_of(made))
    (folder / "digest.ll").write_text(compiled.own_hash())
    for version in (2, 3):
        (folder / f"filter{version}.ll").write_text(machine_text(version))


if __name__ == "__main__":
    if sys.argv[1] == "--into":
        _write_texts(Path(sys.argv[2]))
    elif sys.argv[1] == "--text":
        texts = _texts()
        print(f"wrote {written.write(texts['digest'], texts['loop'])}")
    else:
        build(Path(sys.argv[1]), tuple(sys.argv[2:]) or tuple(PLATFORMS))
