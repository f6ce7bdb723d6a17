"""A new system: a motor of ours and a controller of one's own, with a test, in a folder that runs where it lies."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from pathlib import Path

from ..build import build_all
from .files import require_free, require_name, write_whole

TEMPLATE = Path(__file__).parent / "system"
ENDING = ".txt"  # of the template's files, which are no code of this package
SCRIPT = "speed_controller.py"


def new_system(name: str, folder: Path, more: Mapping[str, str]) -> tuple[Path, list[tuple[str, str]]]:
    """Write a small system that works into `folder`/`name`; that folder, and commands for what comes next.

    `more`: the text of further files, by their path there. Raises NewComponentError for a name that is none or is
    taken, before anything is written, and BuildError if the FMU cannot be built: nothing is left then.
    """
    require_name(name, "system", "my_plant")
    target = folder.absolute() / name
    require_free(target)

    def fill(made: Path) -> None:
        for path in sorted(TEMPLATE.glob(f"*{ENDING}")):
            own = path.name.removesuffix(ENDING).replace("template", name)
            (made / own).write_text(path.read_text(encoding="utf-8").replace("template", name), encoding="utf-8")
        for place, text in more.items():
            (made / place).parent.mkdir(parents=True, exist_ok=True)
            (made / place).write_text(text, encoding="utf-8")
        build_all(made, (str(made / SCRIPT),))

    write_whole(target, fill)
    here = folder / name
    return target, [
        (f"cd {shlex.quote(str(here))}", "it runs where it lies"),
        (f"rovbrush run {name}.toml --out results", "figures, tables and a summary, in results/"),
        (f"rovbrush plan {name}.toml --svg {name}.svg", "rates, transfers, a block diagram"),
        ("pytest", f"what test_{name}.py claims"),
        (f"rovbrush build {SCRIPT} --fmus .", "after a change of the controller"),
    ]
