"""A fit as a TOML file, for several experiments that differ in more than their data.

system = "test_stand"                          # a shipped system, or a path beside this file
match = ["drive.y", "drive.w"]           # or "drive.y=current" where the column is called otherwise
[vary]
"drive.R" = "0.05:0.2"                         # low:high, or low:high:log
[[experiments]]
data = "loaded.csv"                            # beside this file; columns of free inputs drive them
stop_time = "2 s"                              # otherwise the last time of the data
set = { "load.x" = 0.004 }
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from ...system.formats import ENDINGS, is_system_file
from ...system.request import set_name
from ...system.schema.checked import checked
from ...system.schema.keys.fit import ExperimentTable, FitTable
from ...toml.file import TomlFile
from .experiment import Recipe
from .fit import Options


def fit_file(path: Path, options: Options) -> tuple[str, list[Recipe], Options]:
    """The system, experiments and options of a file, to which those of a command are added. Raises InputError."""
    file = TomlFile(path)
    table = checked(FitTable, file.data, "", file)
    folder = path.resolve().parent
    beside = table.system.endswith(ENDINGS) or is_system_file(str(folder / table.system))
    recipes = []
    for number, entry in enumerate(table.experiments, 1):
        one = checked(ExperimentTable, _plain(entry), f"experiment {number}", file, "experiments")
        recipes.append(Recipe(folder / one.data, dict(one.set), _text(one.start_time), _text(one.stop_time)))
    changes = options.changes
    if table.parameters and not changes.parameters:
        changes = replace(changes, parameters=set_name(table.parameters, folder))
    return (
        str(folder / table.system) if beside else table.system,
        recipes,
        replace(
            options, vary=[*(f"{name}={text}" for name, text in table.vary.items()), *options.vary],
            match=[*table.match, *options.match], values={**table.set, **options.values},
            sigma={**table.sigma, **options.sigma}, loss=table.loss if options.loss == "linear" else options.loss,
            changes=changes,
        ),
    )  # fmt: skip


def _plain(entry: Any) -> dict[str, Any]:
    """A table within a checked one, which stays as it is."""
    return dict(entry)


def is_fit_file(name: str) -> bool:
    """Whether a name is that of a file that says what is fitted, not of a system."""
    path = Path(name)
    return path.suffix == ".toml" and path.is_file() and "experiments" in TomlFile(path).data


def _text(instant: str | float | None) -> str:
    return "" if instant is None else str(instant)
