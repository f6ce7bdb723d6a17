"""Where the project's own FMUs are: built by the user, or shipped with the package; and which of them one is."""

from __future__ import annotations

import os
import re
from contextlib import suppress
from difflib import get_close_matches
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING

from ...errors import FmuError

if TYPE_CHECKING:
    from fmpy.model_description import ModelDescription

HERE = Path(__file__).parent.parent.parent.parent  # a checkout, or the folder of the installed package
NATIVE = Path("native") / "fmi2"  # which of the shipped ones run


def is_checkout() -> bool:
    """Whether this is run from a checkout (an editable install too)."""
    return (HERE / "pyproject.toml").is_file()


def fmu_folder() -> Path:
    """Where built FMUs are: $ROVBRUSH_FMUS, the checkout's fmus/, or the user's data folder."""
    chosen = os.environ.get("ROVBRUSH_FMUS")
    if chosen:
        return Path(chosen)
    if is_checkout():
        return HERE / "fmus"
    from platformdirs import user_data_path

    return user_data_path("rovbrush") / "fmus"


def shipped_folder() -> Path | None:
    """The folder of the native FMUs that came with the package; None in a checkout, and where none came."""
    found = HERE / "fmus" / NATIVE
    return found if not is_checkout() and any(found.glob("*.fmu")) else None


def named_fmu(name: str, fmus: Path | None) -> Path:
    """The file of one of the project's own FMUs by its name, there or not.

    `fmus`, or $ROVBRUSH_FMUS: in that folder and nowhere else. Otherwise one that the user built comes before the
    shipped one of that name.
    """
    built = (fmus or fmu_folder()) / f"{name}.fmu"
    shipped = None if fmus or os.environ.get("ROVBRUSH_FMUS") else shipped_folder()
    if shipped is not None and not os.path.isfile(built) and os.path.isfile(shipped / f"{name}.fmu"):
        return shipped / f"{name}.fmu"
    return built


def absent(path: Path, kind: str = "FMU") -> FmuError:
    """That a file is not there, and which one may be meant: one of ours by its name, or one that lies beside it."""
    named = path.with_suffix("")
    ours = named_fmu(path.name, None) if path.suffix == "" and path.name == str(path) else path
    if os.path.isfile(ours):
        return FmuError(f"{kind} {path} does not exist; that of ours is {ours}")
    with suppress(OSError):
        beside = [other.name for other in path.parent.iterdir() if other.suffix.lower() == (path.suffix or ".fmu")]
        if close := get_close_matches(named.name + (path.suffix or ".fmu"), beside, 1):
            return FmuError(f"{kind} {path} does not exist; did you mean '{path.parent / close[0]}'?")
    return FmuError(f"{kind} {path} does not exist; build the project's own with `rovbrush build`")


def is_shipped(path: Path) -> bool:
    """Whether an FMU is one of those that came with the package."""
    return shipped_folder() == path.parent


def require_of_this_version(path: Path, description: ModelDescription) -> None:
    """Raise FmuError for a shipped FMU of another version than the package: half of an update, or a mixed folder."""
    made, own = made_by(description), version("rovbrush")
    if is_shipped(path) and made != own:
        raise FmuError(
            f"FMU {path} came with rovbrush {made or 'of a version that is not known'}, and this is rovbrush {own}; "
            f"build your own with `rovbrush build`, or install rovbrush again: "
            f"python -m pip install --force-reinstall --no-deps rovbrush"
        )


def not_for_here(path: Path) -> str:
    """What to say of a shipped FMU that has no library for this machine; empty of any other."""
    if not is_shipped(path):
        return ""
    import fmpy

    return (
        f"the FMUs that come with rovbrush are for 64-bit Linux and Windows on x86 processors, and this is "
        f"{fmpy.platform_tuple}; with a C compiler, --compile makes libraries of the sources that they carry"
    )


def origin(path: Path, description: ModelDescription) -> str:
    """Which FMU it is, in the words of a summary: `shipped native of rovbrush 0.1.0`, `built, Python`, or a file.

    Those that `rovbrush build` made say so themselves, wherever they are; one of another version says of which.
    """
    made = made_by(description)
    if not made:
        return "file"
    kind = "Python" if is_python(description) else "native"
    if is_shipped(path):
        return f"shipped {kind} of rovbrush {made}"
    return f"built, {kind}" + ("" if made == version("rovbrush") else f", by rovbrush {made}")


def is_python(description: ModelDescription) -> bool:
    """Whether `rovbrush build` made it with pythonfmu."""
    return bool(made_by(description)) and "pythonfmu" in description.generationTool


def made_by(description: ModelDescription) -> str:
    """The version of rovbrush that built an FMU; empty of others' FMUs."""
    found = re.match(r"rovbrush (\S+)", description.generationTool or "")
    return found[1] if found else ""
