"""The command line's application object, and the options that several commands share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ..errors import InputError

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="Multirate co-simulation by FMUs: any system of them, checked, planned, run.",
)

SYSTEM_HELP = "A shipped system (see `rovbrush systems`) or a .toml, .ssp or .ssd file."
SystemName = Annotated[str, typer.Argument(metavar="SYSTEM", help=SYSTEM_HELP)]
SetOption = Annotated[
    list[str],
    typer.Option(
        "--set", metavar="NAME=VALUE", help="Set a parameter or a free input, for instance motor.R=0.1; repeatable."
    ),
]
ReplaceOption = Annotated[
    list[str],
    typer.Option(
        "--replace", metavar="NAME=FMU", help="Another FMU in place of a component, for instance motor=their.fmu."
    ),
]
MapOption = Annotated[
    list[str],
    typer.Option(
        "--map", metavar="NAME=FILE", help="What the variables are called there, for instance motor=map.toml."
    ),
]
PeriodOption = Annotated[
    list[str], typer.Option("--period", metavar="NAME=TIME", help='Another period of a component: motor="1 ms".')
]
InputOption = Annotated[
    list[Path],
    typer.Option(
        "--input", metavar="FILE.csv", help="Inputs that follow tables: columns time and component.input; repeatable."
    ),
]
FmusOption = Annotated[Path | None, typer.Option("--fmus", help="Folder of the built FMUs.")]
OutOption = Annotated[Path, typer.Option("--out", help="Folder for the results.")]
StopOption = Annotated[str, typer.Option("--stop", help='Another stop time, for instance "2 s".')]
StepOption = Annotated[
    str, typer.Option("--step", metavar="TIME", help="The period of components for which an SSP states none.")
]


def assignments(options: list[str]) -> dict[str, object]:
    """`["motor.R=0.1"]` as a mapping; brackets hold a list: `beam.zeta=[0.02,0.03]`. Raises InputError."""
    values: dict[str, object] = {}
    for option in options:
        name, equals, text = option.partition("=")
        if not equals or "." not in name:
            raise InputError(f"--set {option}: write component.variable=value, for instance motor.R=0.1")
        text = text.strip()
        if text.startswith("[") != text.endswith("]"):
            raise InputError(f"--set {option}: a list needs both brackets, for instance beam.zeta=[0.02,0.03]")
        values[name.strip()] = [part.strip() for part in text[1:-1].split(",")] if text.startswith("[") else text
    return values
