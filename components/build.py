"""components -> fmus/*.fmu: pythonfmu makes the FMU, this module makes it self-contained and reproducible.

Each FMU is built in its own process. It carries the component under a package name with its content hash, so that
two versions run side by side in one process, and never the source tree's code. Dates, order and GUID follow from the
content: two builds are byte-identical.
"""

from __future__ import annotations

import difflib
import importlib
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .archive import digest, documentation, repack
from .errors import BuildError, UnknownComponentError
from .lowering.errors import KernelError
from .lowering.lower import lower
from .lowering.source import parts_of

HERE = Path(__file__).parent
COMPONENTS = ("filament_brush", "dc_motor", "rov_vehicle", "rov_controller", "mission", "constant_speed")
SHARED = (
    "errors.py", "interface.py", "kernel_cache.py", "kernels.py", "lowered.py", "model_description.py", "options.py",
    "slave.py", "state.py", "thrusters.py",
)  # fmt: skip
CARRIED_FOLDERS = ("declare", "library")
# pythonfmu 0.7.0 executes this script for every instance and then drops a reference to its namespace that it does not
# own: without keep_alive the second instance fails and the process crashes at its end.
ENTRY_SCRIPT = """from {package}.{name}.fmu import {component}
from {package}.slave import keep_alive

keep_alive(globals())
__all__ = ["{component}"]
"""
NATIVE = ("fmi2", "fmi3")  # the folders of native FMUs


def build_all(
    folder: Path,
    names: tuple[str, ...] = COMPONENTS,
    rows: int = 0,
    platforms: tuple[str, ...] = (),
    missing: Callable[[str], None] | None = None,
) -> list[Path]:
    """Build the FMUs of `names` into `folder`, each in its own process; returns their paths.

    `rows`: how many rows of an array with columns are outputs of their own (the brush: per-filament outputs).
    `platforms`: build native FMUs with binaries for these (`linux64`, `win64`) instead, into `folder`/native.
    `missing`: hears of platforms without a compiler, which are left out unless there is no other; None: an error.

    Raises UnknownComponentError for a wrong name, BuildError for an unwritable folder or a failing build. An FMU
    appears under its final name only when it is complete.
    """
    for name in names:
        if name not in COMPONENTS:
            close = difflib.get_close_matches(name, COMPONENTS, n=1)
            hint = f"did you mean '{close[0]}'?" if close else f"there are {', '.join(COMPONENTS)}"
            raise UnknownComponentError(f"no component '{name}'; {hint}")
    if platforms and missing is not None:
        from .native.compile import available

        platforms = available(platforms, missing)
    return [path for name in names for path in build(HERE / name, folder, rows, platforms)]


def build(component: Path, folder: Path, rows: int = 0, platforms: tuple[str, ...] = ()) -> list[Path]:
    """Build the FMUs of one component from its folder, wherever that is, in a process of its own; see `build_all`."""
    targets = [folder / "native" / version for version in NATIVE] if platforms else [folder]
    for target in targets:
        try:
            target.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise BuildError(
                f"cannot create the folder {target}: {error.strerror}; choose another with --fmus"
            ) from error
        if not os.access(target, os.W_OK):
            raise BuildError(f"cannot write to the folder {target}; choose another with --fmus")
    command = [sys.executable, "-m", __name__, str(component), str(folder), str(rows), *platforms]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        lines = run.stderr.strip().splitlines()
        known = next((k for k, line in enumerate(lines) if "BuildError: " in line), None)
        text = (
            "\n".join([lines[known].split("BuildError: ", 1)[1], *lines[known + 1 :]])
            if known is not None
            else run.stderr
        )
        raise BuildError(f"building {component.name}.fmu failed: {text.strip()}")
    return [target / f"{component.name}.fmu" for target in targets]


def sources(component: Path, rows: int = 0) -> dict[str, bytes]:
    """The Python files that an FMU carries, by their path inside its package."""
    shared = [HERE / path for path in SHARED]
    shared += [path for folder in CARRIED_FOLDERS for path in sorted((HERE / folder).glob("*.py"))]
    files = {path.relative_to(HERE).as_posix(): path for path in shared}
    own = [path for path in sorted(component.glob("*.py")) if not path.name.startswith("behaviour")]
    files |= {f"{component.name}/{path.name}": path for path in own}
    contents = {key: path.read_bytes() for key, path in files.items()} | {"__init__.py": b""}
    contents["options.py"] = re.sub(rb"ROWS = \d+", b"ROWS = %d" % rows, contents["options.py"])
    return contents


def build_one(component: Path, folder: Path, rows: int = 0) -> Path:
    """Build one FMU in this process, from the copy of its sources that it carries."""
    from pythonfmu.builder import FmuBuilder

    name = component.name
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        package, model = carried(component, work, rows)
        script = work / f"{package}_slave.py"
        script.write_text(ENTRY_SCRIPT.format(package=package, name=name, component=model.__name__))
        (work / "documentation").mkdir()
        (work / "documentation" / "index.html").write_bytes(documentation(component))
        raw = FmuBuilder.build_FMU(
            script, work / "raw.fmu", project_files=[work / package], documentation_folder=work / "documentation"
        )
        return repack(Path(raw), folder / f"{name}.fmu")


def carried(component: Path, work: Path, rows: int = 0) -> tuple[str, type[Any]]:
    """Put the copy of its sources that an FMU carries into `work`; its package name and the component class from it."""
    files = sources(component, rows)
    lowering = {f"lowering/{path.name}": path.read_bytes() for path in (HERE / "lowering").glob("*.py")}
    package = f"rovbrush_{component.name}_{digest(files | lowering)[:12]}"
    for key, content in files.items():
        path = work / package / key
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    sys.path.insert(0, str(work))
    model = importlib.import_module(f"{package}.{component.name}.fmu")
    declared: type[Any] = next(
        x for x in vars(model).values() if isinstance(x, type) and x.__module__ == model.__name__
    )
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
    return text.replace(f"{package / component.name}{os.sep}", f"{component}{os.sep}").replace(str(package), str(HERE))


if __name__ == "__main__":
    if sys.argv[4:]:
        from .native.build import build_one_native

        build_one_native(Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]), tuple(sys.argv[4:]))
    else:
        build_one(Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]))
