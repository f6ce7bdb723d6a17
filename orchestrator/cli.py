"""The command `rovbrush`. Exit codes: 0 success, 1 a failed check or run, 2 usage."""

from __future__ import annotations

import sys
from importlib.metadata import entry_points
from pathlib import Path
from typing import Annotated

import typer

from .errors import InputError, RovbrushError, RunError

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="Multirate co-simulation of a hull-cleaning underwater vehicle, by FMUs.",
)

SystemName = Annotated[
    str, typer.Argument(metavar="SYSTEM", help="A shipped system (see `rovbrush systems`) or the path of a .toml file.")
]
SetOption = Annotated[
    list[str],
    typer.Option(
        "--set", metavar="NAME=VALUE", help="Set a parameter or a free input, for instance motor.R=0.1; repeatable."
    ),
]
FmusOption = Annotated[Path | None, typer.Option("--fmus", help="Folder of the built FMUs.")]
OutOption = Annotated[Path, typer.Option("--out", help="Folder for the results.")]
StopOption = Annotated[str, typer.Option("--stop", help='Another stop time, for instance "2 s".')]


def main() -> None:
    """Entry point: every error that a user can meet becomes one message on stderr and an exit code."""
    arguments = [a for a in sys.argv[1:] if a != "--debug"]
    debug = len(arguments) < len(sys.argv) - 1
    try:
        code = app(arguments, standalone_mode=False)
    except RovbrushError as error:
        if debug:
            raise
        print(f"error: {error}", file=sys.stderr)
        code = error.exit_code
    except typer.Exit as stop:
        code = stop.exit_code
    except (typer.Abort, KeyboardInterrupt):
        print("error: interrupted", file=sys.stderr)
        code = 1
    except Exception as error:
        if hasattr(error, "format_message"):  # a usage error found by the command line's own parser
            print(f"error: {error.format_message()} (see `rovbrush --help`)", file=sys.stderr)
            code = 2
        elif debug:
            raise
        else:
            print(
                f"error: unexpected {type(error).__name__}: {error}; run again with --debug for the traceback",
                file=sys.stderr,
            )
            code = 1
    sys.stdout.flush()
    sys.exit(code if isinstance(code, int) else 0)


def assignments(options: list[str]) -> dict[str, object]:
    """`["motor.R=0.1"]` as a mapping; brackets hold a list: `brush.zeta=[0.02,0.03]`. Raises InputError."""
    values: dict[str, object] = {}
    for option in options:
        name, equals, text = option.partition("=")
        if not equals or "." not in name:
            raise InputError(f"--set {option}: write component.variable=value, for instance motor.R=0.1")
        text = text.strip()
        values[name.strip()] = [part.strip() for part in text[1:-1].split(",")] if text.startswith("[") else text
    return values


@app.command()
def build(
    names: Annotated[
        list[str] | None, typer.Argument(metavar="[COMPONENT]...", help="Components to build; all by default.")
    ] = None,
    fmus: FmusOption = None,
    rows: Annotated[
        int, typer.Option("--rows", min=0, help="Per-element outputs for this many rows: filaments of the brush.")
    ] = 0,
) -> None:
    """Build the components into FMUs."""
    from .reader import fmu_folder

    found = list(entry_points(group="rovbrush.builders"))
    if not found:
        raise InputError("no components are installed that could be built; install the whole rovbrush package")
    for builder in found:
        try:
            paths = builder.load()(fmus or fmu_folder(), **({"names": tuple(names)} if names else {}), rows=rows)
        except Exception as error:
            if type(error).__name__ == "BuildError":
                raise RunError(str(error)) from error
            raise
        for path in paths:
            print(f"built {path} ({path.stat().st_size // 1000} kB)")


@app.command()
def systems() -> None:
    """List the shipped systems."""
    from .reader import SYSTEMS, shipped_systems, system_description

    for name in shipped_systems():
        print(f"{name:<14} {system_description(SYSTEMS / f'{name}.toml')}")


@app.command()
def plan(
    system: SystemName,
    all_operations: Annotated[bool, typer.Option("--all", help="Show every operation.")] = False,
    set_: SetOption = [],  # noqa: B006
    fmus: FmusOption = None,
) -> None:
    """Print what a run would do, without running it."""
    from .explain import explain
    from .plan import make_plan
    from .reader import load_system

    print(
        explain(
            make_plan(load_system(system, fmus).with_values(assignments(set_), "--set")), None if all_operations else 40
        )
    )


@app.command()
def run(
    system: SystemName,
    out: OutOption = Path("results"),
    set_: SetOption = [],  # noqa: B006
    stop: StopOption = "",
    fmus: FmusOption = None,
    check: Annotated[
        bool, typer.Option("--check", help="Exit with 1 if a compared value is outside its bound.")
    ] = False,
) -> None:
    """Run a system and write results, figures and a summary."""
    from .studies.single import run_system

    run_system(system, out, assignments(set_), stop, fmus, check)


@app.command()
def calibrate(
    out: Annotated[
        Path | None, typer.Option("--out", help="The parameter file to write; the shipped one by default.")
    ] = None,
    fmus: FmusOption = None,
) -> None:
    """Fit the free parameters of the nominal system to the paper's Table 3 and write the parameter file."""
    from .studies.calibration import calibrate as fit

    fit(out, fmus)


@app.command()
def converge(
    system: SystemName = "nominal",
    out: OutOption = Path("results"),
    fmus: FmusOption = None,
) -> None:
    """Rerun a system with every period halved and quartered, and show how far its summary moves."""
    from .studies.convergence import converge as study

    study(system, out, fmus)


@app.command()
def bench(
    json_file: Annotated[Path | None, typer.Option("--json", help="Write the rows to this file.")] = None,
    fmus: FmusOption = None,
) -> None:
    """Measure the cost of the master beside plain fmpy calls, in one run."""
    from .studies.bench import bench as measure

    measure(json_file, fmus)
