"""A component as a Python FMU: pythonfmu makes it, this module makes it self-contained and reproducible.

It carries the component under a package name with its content hash, so that two versions run side by side in one
process, and never the source tree's code. Dates, order and GUID follow from the content: two builds are
byte-identical.
"""

from __future__ import annotations

import ast
import importlib
import os
import re
import sys
import tempfile
from contextlib import suppress
from pathlib import Path
from typing import Any

from ...errors import BuildError
from ...lowering.errors import KernelError
from ...lowering.lower import lower
from ...lowering.source import parts_of
from ..component import class_in
from .archive import digest, documentation, repack

TOP = Path(__file__).parents[2]
SHARED = (
    "errors.py", "lowering/__init__.py", "lowering/lowered.py", "python/__init__.py", "python/kernel_cache.py",
    "python/kernels.py", "python/memory.py", "python/numba_files.py", "python/options.py", "python/parts.py",
    "python/slave.py", "python/stages.py", "python/state.py",
)  # fmt: skip
CARRIED_FOLDERS = ("declare", "library", "python/machine")
OUTSIDE = re.compile(rb"^([ \t]*)from rovbrush\.components(?:\.([\w.]+))? import ", re.MULTILINE)
# pythonfmu 0.7.0 executes this script for every instance and then drops a reference to its namespace that it does not
# own: without keep_alive the second instance fails and the process crashes at its end.
ENTRY_SCRIPT = """from {package}.{name}.fmu import {component}
from {package}.python.slave import keep_alive

keep_alive(globals())
__all__ = ["{component}"]
"""


def sources(component: Path, rows: int = 0) -> dict[str, bytes]:
    """The Python files that an FMU carries, by their path inside its package."""
    shared = [TOP / path for path in SHARED]
    shared += [path for folder in CARRIED_FOLDERS for path in sorted((TOP / folder).glob("*.py"))]
    files = {path.relative_to(TOP).as_posix(): path for path in shared}
    contents = {key: path.read_bytes() for key, path in files.items()} | {"__init__.py": b""}
    own = [path for path in sorted(component.glob("*.py")) if not path.name.startswith("behaviour")]
    contents |= {f"{component.name}/{path.name}": carried_text(path) for path in own}
    contents["python/options.py"] = re.sub(rb"ROWS = \d+", b"ROWS = %d" % rows, contents["python/options.py"])
    return needed(contents, [key for key in contents if not key.startswith("library/")])


def needed(files: dict[str, bytes], first: list[str]) -> dict[str, bytes]:
    """The `first` of the files, and those that they import, and so on: of the library what a kernel uses."""
    found, waiting = set[str](), [*first, "library/__init__.py"]
    while waiting:
        key = waiting.pop()
        if key in found or key not in files:
            continue
        found.add(key)
        folder = key.split("/")[:-1]
        for node in ast.walk(ast.parse(files[key])):
            if isinstance(node, ast.ImportFrom) and node.level:
                place = [*folder[: len(folder) + 1 - node.level], *(node.module or "").split(".")]
                module = "/".join(filter(None, place))
                waiting += [f"{module}.py", *(f"{module}/{name.name}.py" for name in node.names)]
    return {key: content for key, content in files.items() if key in found}


def carried_text(path: Path) -> bytes:
    """A component's file, in which imports from `rovbrush.components`, as a component outside has them, are relative.

    Raises BuildError for another import of rovbrush, which is not there where an FMU runs.
    """
    text = OUTSIDE.sub(lambda found: found[1] + b"from .." + (found[2] or b"") + b" import ", path.read_bytes())
    try:
        nodes = list(ast.walk(ast.parse(text)))
    except SyntaxError as error:
        raise BuildError(f"{path}:{error.lineno}: {error.msg}") from error
    for node in nodes:
        named = [a.name for a in node.names] if isinstance(node, ast.Import) else []
        named += [node.module or ""] if isinstance(node, ast.ImportFrom) and not node.level else []
        if any(name.split(".")[0] == "rovbrush" for name in named):
            line = f"{path}:{getattr(node, 'lineno', 1)}"
            raise BuildError(f"{line}: an FMU carries rovbrush.components only: `from rovbrush.components.x import y`")
    return text


def build_one(component: Path, folder: Path, rows: int = 0) -> Path:
    """Build one FMU in this process, from the copy of its sources that it carries."""
    from pythonfmu.builder import FmuBuilder

    name = component.name
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        package, model = carried(component, work, rows)
        _compile(model)
        script = work / f"{package}_slave.py"
        script.write_text(ENTRY_SCRIPT.format(package=package, name=name, component=model.__name__))
        (work / "documentation").mkdir()
        (work / "documentation" / "index.html").write_bytes(documentation(component))
        raw = FmuBuilder.build_FMU(
            script, work / "raw.fmu", project_files=[work / package], documentation_folder=work / "documentation"
        )
        return repack(Path(raw), folder / f"{name}.fmu")


def _compile(model: type[Any]) -> None:
    """Compile the kernel into the cache, so that whoever runs the FMU here need not; what is wrong shows there, too."""
    with suppress(Exception):
        instance = model(instance_name="first")
        instance.enter_initialization_mode()
        instance.exit_initialization_mode()


def carried(component: Path, work: Path, rows: int = 0) -> tuple[str, type[Any]]:
    """Put the copy of its sources that an FMU carries into `work`; its package name and the component class from it."""
    files = sources(component, rows)
    lowering = {f"lowering/{path.name}": path.read_bytes() for path in (TOP / "lowering").glob("*.py")}
    package = f"rovbrush_{component.name}_{digest(files | lowering)[:12]}"
    for key, content in files.items():
        path = work / package / key
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    sys.path.insert(0, str(work))
    try:
        declared = class_in(importlib.import_module(f"{package}.{component.name}.fmu"))
    except BuildError as error:
        raise BuildError(in_source(str(error), work / package, component)) from None
    taken = {v.name for v in declared.variables() if v.causality in ("parameter", "input")}
    for name in sorted(taken & {array.name for array in declared.arrays}):
        raise BuildError(f"{component.name}: '{name}' is a parameter or an input, and an array of the state or scratch")
    try:
        lower(*parts_of(declared.kernel)).write(work / package / component.name, work / package)
    except KernelError as error:
        raise BuildError(in_source(str(error), work / package, component)) from None
    return package, declared


def in_source(text: str, package: Path, component: Path) -> str:
    """A message about files of the copy that an FMU carries, with the names of those that it was made from."""
    return text.replace(f"{package / component.name}{os.sep}", f"{component}{os.sep}").replace(str(package), str(TOP))
