"""Build components: all, by name or by folder, each in a process of its own; `python/` and `native/` make the FMUs."""

from __future__ import annotations

import difflib
import os
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from .errors import BuildError, UnknownComponentError

HERE = Path(__file__).parent
COMPONENTS = (
    "filament_brush", "cup_brush", "dc_motor", "rov_vehicle", "rov_controller", "mission", "constant_speed", "battery",
    "rov_sensors", "tool_frame", "hull_fouling",
)  # fmt: skip
NATIVE = ("fmi2", "fmi3")  # the folders of native FMUs


def build_all(
    folder: Path,
    names: tuple[str, ...] = COMPONENTS,
    rows: int = 0,
    platforms: tuple[str, ...] = (),
    missing: Callable[[str], None] | None = None,
    jobs: int = 0,
) -> list[Path]:
    """Build the FMUs of `names` into `folder`, each in its own process; returns their paths.

    `names`: shipped components, folders of others (see `new/`), or scripts of pythonfmu's (NAME.py).
    `rows`: how many elements of the vectors that can be shown are outputs (the brush: per-filament outputs).
    `platforms`: build native FMUs with binaries for these (`linux64`, `win64`) instead, into `folder`/native.
    `jobs`: how many are built at a time; 0: as many as there are processors.
    `missing`: hears of platforms without a compiler, which are left out unless there is no other; None: an error.

    Raises UnknownComponentError for a wrong name, BuildError for an unwritable folder or a failing build. An FMU
    appears under its final name only when it is complete.
    """
    components = [folder_of(name) for name in names]
    if platforms and missing is not None:
        from .native.compile import available

        platforms = available(platforms, missing)
    with ThreadPoolExecutor(jobs or os.cpu_count() or 1) as pool:
        made = [pool.submit(build, component, folder, rows, platforms) for component in components]
        try:
            return [path for one in made for path in one.result()]
        finally:
            for one in made:
                one.cancel()  # after an error nothing new is begun


def folder_of(name: str) -> Path:
    """The folder of a component: of a shipped one by its name, else the folder, or the script, that is named.

    Raises UnknownComponentError where there is none.
    """
    if name in COMPONENTS:
        return HERE / name
    folder = Path(name)
    if folder.suffix == ".py" and folder.is_file():
        if not folder.stem.isidentifier():
            raise UnknownComponentError(f"{folder}: a script of an FMU has a name of letters, digits and _")
        return folder.resolve()
    if (folder / "fmu.py").is_file():
        if not folder.resolve().name.isidentifier():
            raise UnknownComponentError(f"{folder}: a component's folder has a name of letters, digits and _")
        return folder.resolve()
    if folder.is_dir() or len(folder.parts) > 1:
        raise UnknownComponentError(f"{folder} is no component: it has no fmu.py; `rovbrush new-component` writes one")
    close = difflib.get_close_matches(name, COMPONENTS, n=1)
    hint = f"did you mean '{close[0]}'?" if close else f"there are {', '.join(COMPONENTS)}, and folders of your own"
    raise UnknownComponentError(f"no component '{name}'; {hint}")


def build(component: Path, folder: Path, rows: int = 0, platforms: tuple[str, ...] = ()) -> list[Path]:
    """Build the FMUs of one component from its folder, wherever that is, in a process of its own; see `build_all`."""
    if component.suffix == ".py" and (platforms or rows):
        raise BuildError(f"{component.name} is a script of pythonfmu's: there is no C of it, and no --rows")
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
        raise BuildError(f"building {component.stem}.fmu failed: {text.strip()}")
    return [target / f"{component.stem}.fmu" for target in targets]


if __name__ == "__main__":
    if sys.argv[1].endswith(".py"):
        from .python.building.script import build_script

        build_script(Path(sys.argv[1]), Path(sys.argv[2]))
    elif sys.argv[4:]:
        from .native.build import build_one_native

        build_one_native(Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]), tuple(sys.argv[4:]))
    else:
        from .python.building.build import build_one

        build_one(Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]))
