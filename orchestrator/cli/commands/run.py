"""The commands that build, show and run systems."""

from __future__ import annotations

from importlib.metadata import entry_points
from pathlib import Path
from typing import Annotated, Any

import typer

from ...errors import InputError
from .. import completion
from ..console import leave_stdout, tell
from ..options import (
    SYSTEM_HELP,
    CoresOption,
    DeadlinesOption,
    EventOption,
    FifoOption,
    FmusOption,
    InputOption,
    MapOption,
    ObserveEveryOption,
    ObserveOption,
    ObserveSignalsOption,
    OutOption,
    OutsideOption,
    ParametersOption,
    PeriodOption,
    RealTimeOption,
    ReplaceOption,
    ScenarioOption,
    SetOption,
    StartOption,
    StepOption,
    StopOption,
    SystemName,
    WorkersOption,
    app,
)
from .built import raise_ours

PLATFORMS = ("linux64", "win64")  # of native FMUs


@app.command()
def build(
    names: Annotated[
        list[str] | None,
        typer.Argument(metavar="[COMPONENT]...", help="Components to build, or folders of others; all by default."),
    ] = None,
    fmus: FmusOption = None,
    rows: Annotated[
        int, typer.Option("--rows", min=0, help="Per-element outputs for this many rows, of a component that has such.")
    ] = 0,
    native: Annotated[
        bool, typer.Option("--native", help="FMUs with no Python inside, FMI 2.0 and 3.0, into the subfolder native.")
    ] = False,
    platform: Annotated[
        list[str],
        typer.Option(
            "--platform",
            help="Binaries of native FMUs: linux64, win64; repeatable; by default those there is a compiler for.",
        ),
    ] = [],  # noqa: B006
    jobs: Annotated[
        int, typer.Option("--jobs", min=0, help="How many are built at a time; 0: as many as there are processors.")
    ] = 0,
) -> None:
    """Build the components into FMUs, and compile the kernels of Python FMUs for this machine."""
    from ...fmu.files.places import fmu_folder
    from ...loop.machine.compiled import begin

    loop = None if native else begin()  # beside the components
    found = list(entry_points(group="rovbrush.builders"))
    if not found:
        raise InputError("no components are installed that could be built; install the whole rovbrush package")
    for builder in found:
        try:
            chosen: dict[str, Any] = {"names": tuple(names)} if names else {}
            platforms = (tuple(platform) or PLATFORMS) if native else ()
            chosen |= {"missing": None if platform else lambda why: tell(f"left out: {why}")}
            paths = builder.load()(fmus or fmu_folder(), **chosen, rows=rows, platforms=platforms, jobs=jobs)
        except Exception as error:
            raise_ours(error)
        for path in paths:
            tell(f"built {path} ({path.stat().st_size // 1000} kB)")
    if loop is not None and not loop.wait():
        tell("compiled the loop")


@app.command()
def plan(
    system: SystemName,
    all_operations: Annotated[bool, typer.Option("--all", help="Show every operation.")] = False,
    svg: Annotated[
        Path | None,
        typer.Option("--svg", metavar="FILE.svg", help="Draw it too: blocks with rates, arrows with transfers."),
    ] = None,
    set_: SetOption = [],  # noqa: B006
    input_: InputOption = [],  # noqa: B006
    replace: ReplaceOption = [],  # noqa: B006
    map_: MapOption = [],  # noqa: B006
    period: PeriodOption = [],  # noqa: B006
    parameters: ParametersOption = "",
    scenario: ScenarioOption = [],  # noqa: B006
    event: EventOption = [],  # noqa: B006
    start: StartOption = "",
    stop: StopOption = "",
    step: StepOption = "",
    allow_outside: OutsideOption = [],  # noqa: B006
    fmus: FmusOption = None,
    real_time: RealTimeOption = "",
    deadlines: DeadlinesOption = "",
    workers: WorkersOption = "",
) -> None:
    """Print what a run would do, without running it: of the FMUs only algebraic loops at the start are tried."""
    from ...plan.diagram.file import require_svg, write_diagram
    from ...plan.explain import explain
    from ...plan.plan import make_plan
    from ...run.pacing.asked import pace_of
    from ...run.start.initialize import begin_text, loop_residuals
    from ...system.assemble import assemble_request
    from ...system.request import Request

    request = Request(
        system, set_=tuple(set_), start=start, stop=stop, replace=tuple(replace), map_=tuple(map_),
        period=tuple(period), step=step, fmus=str(fmus or ""), input_=tuple(map(str, input_)),
        allow_outside=tuple(map(str, allow_outside)), parameters=parameters, real_time=real_time, deadlines=deadlines,
        scenario=tuple(map(str, scenario)), event=tuple(event), workers=workers,
    )  # fmt: skip
    pace = pace_of(request)
    if svg is not None:
        require_svg(svg)
    planned = make_plan(assemble_request(request), pace.every if pace else None)
    if svg is not None:
        write_diagram(planned, svg)
    tell(explain(planned, None if all_operations else 40))
    for loop, residual in loop_residuals(planned).items():
        tell(f"\nat {begin_text(planned.clock)}, {loop}: residual {residual:.3g}, relative to the inputs")
    if planned.system.workers == "auto" and planned.together.groups:
        from ...run.first_steps import first_steps

        tell(f"\n{first_steps(planned) or 'workers: no step was measured'}")
    if svg is not None:
        tell(f"\nwrote {svg}")


@app.command()
def run(
    system: Annotated[str, typer.Argument(metavar="SYSTEM", help=SYSTEM_HELP, autocompletion=completion.systems)] = "",
    out: OutOption = Path("results"),
    set_: SetOption = [],  # noqa: B006
    input_: InputOption = [],  # noqa: B006
    start: StartOption = "",
    stop: StopOption = "",
    replace: ReplaceOption = [],  # noqa: B006
    map_: MapOption = [],  # noqa: B006
    period: PeriodOption = [],  # noqa: B006
    parameters: ParametersOption = "",
    scenario: ScenarioOption = [],  # noqa: B006
    event: EventOption = [],  # noqa: B006
    record_boundary: Annotated[
        list[str],
        typer.Option(
            "--record-boundary",
            metavar="NAME",
            autocompletion=completion.components,
            help="Record a component's inputs and outputs to replay it.",
        ),
    ] = [],  # noqa: B006
    record: Annotated[
        list[str],
        typer.Option(
            "--record",
            metavar="PATTERN",
            autocompletion=completion.recorded,
            help="Record these, not what the system file says: motor.*; repeatable.",
        ),
    ] = [],  # noqa: B006
    step: StepOption = "",
    allow_outside: OutsideOption = [],  # noqa: B006
    fmus: FmusOption = None,
    csv_per_rate: Annotated[
        bool, typer.Option("--csv-per-rate", help="Write a CSV file for each rate too, every_1_ms.csv: no empty cells.")
    ] = False,
    checkpoint: Annotated[
        str,
        typer.Option(
            "--checkpoint", metavar="TIME", help='Keep the state of the run every so often, for --resume: "5 s".'
        ),
    ] = "",
    resume: Annotated[
        Path | None,
        typer.Option(
            "--resume", metavar="DIR", help="Go on with the run whose results folder this is, from its checkpoint."
        ),
    ] = None,
    real_time: RealTimeOption = "",
    realtime_policy: Annotated[
        str,
        typer.Option(
            "--realtime-policy",
            metavar="warn|stop|skip",
            help="After a missed deadline: catch up, end the run, or give up the time that was lost.",
        ),
    ] = "",
    deadlines: DeadlinesOption = "",
    fifo: FifoOption = "",
    cores: CoresOption = "",
    workers: WorkersOption = "",
    observe: ObserveOption = [],  # noqa: B006
    observe_signals: ObserveSignalsOption = [],  # noqa: B006
    observe_every: ObserveEveryOption = "",
    check: Annotated[
        bool, typer.Option("--check", help="Exit with 1 if a compared value is outside its bound.")
    ] = False,
    force: Annotated[
        bool,
        typer.Option("--force", help="Replace results of others in the folder; resume with another version or CPU."),
    ] = False,
    strict: Annotated[
        bool,
        typer.Option("--strict", help="An FMU that breaks the standard is an error, also where a run can do without."),
    ] = False,
) -> None:
    """Run a system and write results, figures and a summary."""
    from ...observers.watched import Watching
    from ...system.request import Request
    from ..run_system import resume_system, run_system

    request = Request(
        system, tuple(set_), stop, tuple(replace), tuple(map_), tuple(period), tuple(record_boundary), tuple(record),
        step, str(fmus or ""), checkpoint, tuple(map(str, input_)), "rates" if csv_per_rate else "",
        tuple(map(str, allow_outside)), start, parameters, real_time, realtime_policy, deadlines, fifo, cores,
        tuple(map(str, scenario)), tuple(event), workers,
    )  # fmt: skip
    watching = Watching(tuple(observe), tuple(observe_signals), observe_every)
    if "csv=-" in observe:
        leave_stdout()
    if resume is not None:
        resume_system(resume, request, check, force, watching)
    elif not system:
        raise InputError("which system? `rovbrush systems` lists the shipped ones; or go on with --resume DIR")
    else:
        run_system(request, out, check, force, strict, watching)
