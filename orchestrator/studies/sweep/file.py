"""Sweeps as TOML files: the shipped ones by name, anyone's own by path.

description = "what for"
system = "nominal"                 # a shipped system, or a path beside this file (.toml, .ssp, .ssd, .fmu)
stop_time = "5 s"                  # optional, as the rest; also start_time
parameters = "roller"              # another parameter set than the system's
random = 50                        # random points in place of a grid, drawn with `seed`
seed = 1
design = "sobol"                   # how they are drawn: "random" if not given, "latin", "sobol"
[set]                              # values of all points
"motor.L_a" = 0.001
[vary]
"motor.R" = "0.07:0.09:7"          # or a list [0.07, 0.08], with units ["70 mOhm"], items of an enumeration by name
[summary]                          # figures of merit beside those of the system
i_peak = "peak motor.i"
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from ...errors import InputError, nearest
from ...system.file.shipped import SWEEPS, SYSTEMS, shipped_systems
from ...system.formats import ENDINGS, is_system_file
from ...system.request import set_name
from ...system.schema.checked import checked
from ...system.schema.keys.sweep import SweepTable
from ...toml.file import TomlFile


@dataclass(frozen=True)
class SweepFile:
    """What a sweep file says; of a plain system only its name."""

    name: str
    system: str
    description: str = ""
    stop: str = ""
    random: int = 0
    seed: int = 1
    values: dict[str, object] = field(default_factory=dict)
    vary: dict[str, object] = field(default_factory=dict)
    summary: dict[str, str] = field(default_factory=dict)
    design: str = ""
    start: str = ""
    parameters: str = ""


def shipped_sweeps() -> list[str]:
    """Names of the sweeps that come with the package."""
    return sorted(path.stem for path in SWEEPS.glob("*.toml"))


def sweep_file(name: str) -> SweepFile:
    """A shipped sweep, a sweep file by path, or a system to sweep over. Raises InputError."""
    if is_system_file(name) and not name.endswith(".toml"):
        return SweepFile(Path(name).stem, str(Path(name).resolve()))
    path = Path(name) if name.endswith(".toml") else SWEEPS / f"{name}.toml"
    if not name.endswith(".toml") and not path.is_file():
        if not (SYSTEMS / f"{name}.toml").is_file():
            known = [*shipped_sweeps(), *shipped_systems()]
            raise InputError(
                f"no sweep or system '{name}'{nearest(name, known)}, or give the path of a .toml, .ssp, .ssd or .fmu "
                "file"
            )
        return SweepFile(name, name)
    file = TomlFile(path)
    if "vary" not in file.data:
        return SweepFile(path.stem, str(path.resolve()))
    table = checked(SweepTable, file.data, "", file)
    beside = table.system.endswith(ENDINGS) or is_system_file(str(path.resolve().parent / table.system))
    return SweepFile(
        path.stem, str(path.resolve().parent / table.system) if beside else table.system, table.description,
        _text(table.stop_time), table.random, table.seed, dict(table.set), dict(table.vary), dict(table.summary),
        table.design, _text(table.start_time), set_name(table.parameters, path.resolve().parent),
    )  # fmt: skip


def _text(time: str | float | None) -> str:
    return "" if time is None else str(time)
