"""A new component: a copy of `template/` under another name, in the package's own folder or anywhere else."""

from __future__ import annotations

import importlib.util
import keyword
import os
import re
import shlex
from pathlib import Path

from ..build import COMPONENTS, HERE
from ..describe.tables import describe_component
from ..errors import NewComponentError
from .files import require_free, require_name, write_whole

TEMPLATE = Path(__file__).parent / "template"
PACKAGE = "rovbrush.components"


def new_component(name: str, folder: Path) -> tuple[Path, list[tuple[str, str]]]:
    """Write a small component that works into `folder`/`name`; that folder, and commands for what comes next.

    Raises NewComponentError for a name that Python or FMI cannot have, or that is taken, before anything is written.
    """
    target = folder.absolute() / name
    _check_name(name)
    _check_place(target)

    def fill(made: Path) -> None:
        for path in sorted(TEMPLATE.iterdir()):
            if path.is_file():
                text = renamed(path.read_text(encoding="utf-8"), name, inside=_is_inside(target))
                (made / path.name).write_text(text, encoding="utf-8")

    write_whole(target, fill)
    describe_component(str(target))
    return target, _next_steps(name, folder, inside=_is_inside(target))


def _check_name(name: str) -> None:
    """A name is a Python module's and an FMI modelIdentifier, which is a C identifier; nobody else has it."""
    require_name(name, "component", "leaky_tank")
    if keyword.iskeyword(name) or keyword.issoftkeyword(name):
        raise NewComponentError(f"'{name}' is a word of Python; choose another name")
    if name in COMPONENTS:
        raise NewComponentError(f"there is a component {name} already; choose another name")
    if name in {path.stem for path in HERE.iterdir()}:
        raise NewComponentError(f"'{name}' is a part of {PACKAGE}, which every FMU carries; choose another name")


def _check_place(target: Path) -> None:
    """Nothing is there yet, and `import NAME` means nothing else."""
    require_free(target)
    if _is_inside(target):
        return
    try:
        taken = importlib.util.find_spec(target.name)
    except (ImportError, ValueError):
        taken = None
    if taken is not None:
        where = taken.origin or "a package"
        raise NewComponentError(f"Python has a module {target.name} already ({where}); choose another name")


def _is_inside(target: Path) -> bool:
    """Does it become a part of the package?"""
    return target.parent.resolve() == HERE.resolve()


def renamed(text: str, name: str, inside: bool) -> str:
    """A file of the template for a component of another name; outside of the package it imports by full names."""
    text = re.sub(r"\btemplate\b", name, text)
    text = re.sub(r"\bTemplate\b", _class_name(name), text)
    if inside:
        return text.replace("from ...", "from ..")
    text = re.sub(r"^from \.\.\.(.*\n)(?=from \.)(?!from \.\.\.)", rf"from {PACKAGE}.\1\n", text, flags=re.MULTILINE)
    return text.replace("from ...", f"from {PACKAGE}.")


def _class_name(name: str) -> str:
    """`leaky_tank` is `LeakyTank`."""
    made = "".join(part[:1].upper() + part[1:] for part in name.split("_"))
    return f"{made}Component" if made in ("ComponentSlave", "Inputs", "Outputs", "Parameters", "State") else made


def _next_steps(name: str, folder: Path, inside: bool) -> list[tuple[str, str]]:
    """What to type, and why."""
    component = shlex.quote(os.path.join(folder, name) if folder != Path() else f"./{name}")
    fmu = f"fmus/{name}.fmu"
    steps = [
        (f"rovbrush build {component} --fmus fmus", f"the Python FMU, {fmu}"),
        (f"rovbrush test-component {fmu} --as {component}", "does it do what behaviour.py claims?"),
        (f"rovbrush run {fmu} --set F=8", "run it alone, by its default experiment"),
        (f"rovbrush build {component} --fmus fmus --native", "in C, FMI 2.0 and 3.0: fmus/native/ (extra `native`)"),
        (f"rovbrush check fmus/native/fmi3/{name}.fmu", "is it fit to be exchanged?"),
        (f"python -m {PACKAGE}.describe {component}", "its README's tables, after each change"),
    ]
    if inside:
        steps.append(("", f"to ship it: {name} in COMPONENTS (components/build.py), beside its like in pyproject.toml"))
    return steps


