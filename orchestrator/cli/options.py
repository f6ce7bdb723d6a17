"""The command line's application object, and the options that several commands share."""

from __future__ import annotations

from importlib.metadata import version
from pathlib import Path
from typing import Annotated

import typer

from . import completion

app = typer.Typer(
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    help="Multirate co-simulation by FMUs: any system of them, checked, planned, run.",
)


def _version(wanted: bool) -> None:
    if wanted:
        print(f"rovbrush {version('rovbrush')}")
        raise typer.Exit


@app.callback()
def every_command(
    debug: Annotated[
        bool, typer.Option("--debug", help="Tracebacks of unexpected errors; may stand anywhere.")
    ] = False,
    compile_: Annotated[
        bool,
        typer.Option(
            "--compile", help="Compile FMUs that bring sources and no library for this machine; may stand anywhere."
        ),
    ] = False,
    version_: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """Options of all commands: `--debug` and `--compile` are taken away before the command line is read."""


SYSTEM_HELP = (
    "A shipped system (see `rovbrush systems`), a .toml, .ssp, .ssd, .fmu or OspSystemStructure.xml, or a folder."
)
SystemName = Annotated[str, typer.Argument(metavar="SYSTEM", help=SYSTEM_HELP, autocompletion=completion.systems)]
SetOption = Annotated[
    list[str],
    typer.Option(
        "--set",
        metavar="NAME=VALUE",
        autocompletion=completion.settable,
        help="Set a parameter or a free input, for instance motor.R=0.1; repeatable.",
    ),
]
ReplaceOption = Annotated[
    list[str],
    typer.Option(
        "--replace",
        metavar="NAME=FMU",
        autocompletion=completion.assigned,
        help="Another FMU in place of a component, for instance motor=their.fmu.",
    ),
]
MapOption = Annotated[
    list[str],
    typer.Option(
        "--map",
        metavar="NAME=FILE",
        autocompletion=completion.assigned,
        help="What the variables are called there, for instance motor=map.toml.",
    ),
]
PeriodOption = Annotated[
    list[str],
    typer.Option(
        "--period",
        metavar="NAME=TIME",
        autocompletion=completion.assigned,
        help='Another period of a component: motor="1 ms"; of a component alone "1 ms".',
    ),
]
ParametersOption = Annotated[
    str,
    typer.Option(
        "--parameters",
        metavar="SET",
        autocompletion=completion.sets,
        help="Another parameter set: its name, or its file (see `rovbrush systems`).",
    ),
]
InputOption = Annotated[
    list[Path],
    typer.Option(
        "--input", metavar="FILE.csv", help="Inputs that follow tables: columns time and component.input; repeatable."
    ),
]
OutsideOption = Annotated[
    list[Path],
    typer.Option(
        "--allow-outside",
        metavar="FOLDER",
        help="An SSP, or `python =` in a system file, may take files from this folder too; repeatable.",
    ),
]
ScenarioOption = Annotated[
    list[Path],
    typer.Option("--scenario", metavar="FILE.toml", help="A file of [[events]] that happen too; repeatable."),
]
EventOption = Annotated[
    list[str],
    typer.Option(
        "--event",
        metavar="WHEN:WHAT",
        help='One more event: "2 s: motor.V_in = 0", "motor.i > 20 A: loss motor.T_load for 1 s"; repeatable.',
    ),
]
ObserveOption = Annotated[
    list[str],
    typer.Option(
        "--observe",
        metavar="KIND=WHERE",
        help="Rows as they come: csv=FILE or -, mcap=FILE, ros2=FILE, foxglove=PORT, rerun=FILE.rrd, udp=HOST:PORT, "
        "mqtt=HOST; repeatable.",
    ),
]
ObserveSignalsOption = Annotated[
    list[str],
    typer.Option("--observe-signals", metavar="PATTERN", help="What they see: motor.*; repeatable; else all."),
]
ObserveEveryOption = Annotated[
    str, typer.Option("--observe-every", metavar="TIME", help='Only rows so far apart, for instance "20 ms".')
]
FmusOption = Annotated[Path | None, typer.Option("--fmus", help="Folder of the built FMUs.")]
OutOption = Annotated[Path, typer.Option("--out", help="Folder for the results.")]
StopOption = Annotated[str, typer.Option("--stop", help='Another stop time, for instance "2 s".')]
StartOption = Annotated[
    str, typer.Option("--start", help='Another start time, for instance "-5 ms"; the stop stays where it is.')
]
StepOption = Annotated[
    str,
    typer.Option("--step", metavar="TIME", help="The period of components for which nothing states one."),
]
RealTimeOption = Annotated[
    str,
    typer.Option(
        "--real-time",
        metavar="[FACTOR]",
        help="Keep pace with the clock on the wall, or with a multiple of it: 1 where no number is given.",
    ),
]
FifoOption = Annotated[
    str, typer.Option("--fifo", metavar="PRIORITY", help="Run with SCHED_FIFO, 1 to 99, where that is allowed.")
]
WorkersOption = Annotated[
    str,
    typer.Option(
        "--workers", metavar="N|auto", help='Threads that step FMUs at the same instant; "auto": as many as pay.'
    ),
]
CoresOption = Annotated[
    str, typer.Option("--cores", metavar="N,...", help="Hold the run on these processors, for instance 1 or 0,1.")
]
DeadlinesOption = Annotated[
    str, typer.Option("--deadlines", metavar="TIME", help='Time between two deadlines, for instance "20 ms".')
]
