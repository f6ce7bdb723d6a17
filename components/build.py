"""components -> fmus/*.fmu: pythonfmu makes the FMU, this module makes it self-contained and reproducible.

Each FMU is built in its own process. It carries the component under a package name with its content hash, so that
two versions run side by side in one process, and never the source tree's code. Dates, order and GUID follow from the
content: two builds are byte-identical.
"""

from __future__ import annotations

import difflib
import hashlib
import importlib
import os
import re
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path
from xml.sax.saxutils import escape

from .model_description import GUID_PLACEHOLDER

HERE = Path(__file__).parent
COMPONENTS = ("filament_brush", "dc_motor", "rov_vehicle", "rov_controller", "mission", "constant_speed")
SHARED = ("interface.py", "kernels.py", "model_description.py", "options.py", "slave.py", "thrusters.py")
# pythonfmu 0.7.0 executes this script for every instance and then drops a reference to its namespace that it does not
# own: without keep_alive the second instance fails and the process crashes at its end.
ENTRY_SCRIPT = """from {package}.{name}.fmu import {component}
from {package}.slave import keep_alive

keep_alive(globals())
__all__ = ["{component}"]
"""
FIXED_DATE = (1980, 1, 1, 0, 0, 0)


class BuildError(Exception):
    """An FMU could not be built; the text says which and why."""


class UnknownComponentError(BuildError):
    """There is no component of that name."""


def build_all(folder: Path, names: tuple[str, ...] = COMPONENTS, rows: int = 0) -> list[Path]:
    """Build the FMUs of `names` into `folder`, each in its own process; returns their paths.

    `rows`: how many rows of an array with columns are outputs of their own (the brush: per-filament outputs).

    Raises UnknownComponentError for a wrong name, BuildError for an unwritable folder or a failing build. An FMU
    appears under its final name only when it is complete.
    """
    for name in names:
        if name not in COMPONENTS:
            close = difflib.get_close_matches(name, COMPONENTS, n=1)
            hint = f"did you mean '{close[0]}'?" if close else f"there are {', '.join(COMPONENTS)}"
            raise UnknownComponentError(f"no component '{name}'; {hint}")
    return [build(HERE / name, folder, rows) for name in names]


def build(component: Path, folder: Path, rows: int = 0) -> Path:
    """Build `<component>.fmu` from the folder of one component, wherever that is, in a process of its own."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BuildError(f"cannot create the folder {folder}: {error.strerror}; choose another with --fmus") from error
    if not os.access(folder, os.W_OK):
        raise BuildError(f"cannot write to the folder {folder}; choose another with --fmus")
    command = [sys.executable, "-m", __name__, str(component), str(folder), str(rows)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        raise BuildError(f"building {component.name}.fmu failed:\n{run.stderr.strip()}")
    return folder / f"{component.name}.fmu"


def sources(component: Path, rows: int = 0) -> dict[str, bytes]:
    """The Python files that an FMU carries, by their path inside its package."""
    files = {path: HERE / path for path in SHARED if (HERE / path).exists()}
    files |= {f"{component.name}/{path.name}": path for path in sorted(component.glob("*.py"))}
    contents = {key: path.read_bytes() for key, path in files.items()} | {"__init__.py": b""}
    contents["options.py"] = re.sub(rb"ROWS = \d+", b"ROWS = %d" % rows, contents["options.py"])
    return contents


def digest(files: dict[str, bytes]) -> str:
    """SHA-256 over names and contents, independent of order."""
    total = hashlib.sha256()
    for key in sorted(files):
        total.update(f"{key}\0{len(files[key])}\0".encode() + files[key])
    return total.hexdigest()


def build_one(component: Path, folder: Path, rows: int = 0) -> Path:
    """Build one FMU in this process, from the copy of its sources that it carries."""
    from pythonfmu.builder import FmuBuilder

    name, files = component.name, sources(component, rows)
    package = f"rovbrush_{name}_{digest(files)[:12]}"
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        for key, content in files.items():
            path = work / package / key
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        sys.path.insert(0, temporary)
        model = importlib.import_module(f"{package}.{name}.fmu")
        classes = [
            key for key, value in vars(model).items() if isinstance(value, type) and value.__module__ == model.__name__
        ]
        script = work / f"{package}_slave.py"
        script.write_text(ENTRY_SCRIPT.format(package=package, name=name, component=classes[0]))
        documentation = work / "documentation"
        documentation.mkdir()
        write_documentation(component, documentation)
        raw = FmuBuilder.build_FMU(
            script, work / "raw.fmu", project_files=[work / package], documentation_folder=documentation
        )
        return repack(Path(raw), folder / f"{name}.fmu")


def write_documentation(component: Path, folder: Path) -> None:
    """The component's README as the FMU's documentation/index.html (FMI 2.0.4, section 2.3)."""
    from markdown_it import MarkdownIt

    text = (component / "README.md").read_text(encoding="utf-8")
    body = MarkdownIt("commonmark").enable("table").render(text)
    head = f"<head><meta charset='utf-8'><title>{escape(component.name)}</title></head>"
    page = f"<!DOCTYPE html>\n<html lang='en'>{head}<body>\n{body}</body></html>\n"
    (folder / "index.html").write_text(page, encoding="utf-8")


def repack(raw: Path, target: Path) -> Path:
    """Write `raw` again with sorted entries, fixed dates and a GUID that is the hash of the content."""
    with zipfile.ZipFile(raw) as archive:
        entries = {name: archive.read(name) for name in sorted(archive.namelist())}
    guid = f"{{{digest(entries)}}}"
    entries["modelDescription.xml"] = entries["modelDescription.xml"].replace(GUID_PLACEHOLDER.encode(), guid.encode())
    temporary = target.with_name(f"{target.name}.{os.getpid()}.tmp")
    with zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in entries.items():
            info = zipfile.ZipInfo(name, FIXED_DATE)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            archive.writestr(info, content)
    temporary.replace(target)
    return target


if __name__ == "__main__":
    build_one(Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]))
