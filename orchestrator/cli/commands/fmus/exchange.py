"""The commands for FMUs that come from others or go to them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ....errors import InputError, counted
from ...console import print_table, tell
from ...guard import sheltered
from ...options import (
    FmusOption,
    OutsideOption,
    ParametersOption,
    SetOption,
    StartOption,
    StepOption,
    StopOption,
    SystemName,
    app,
)
from ...progress import share


@app.command()
def replay(
    fmu: Annotated[Path, typer.Argument(metavar="FMU", help="The file to drive alone, FMI 1.0, 2.0 or 3.0.")],
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="Where `run --record-boundary` wrote its files.")],
    name: Annotated[str, typer.Option("--name", help="Which recording, where DIR holds several.")] = "",
    map_: Annotated[Path | None, typer.Option("--map", help="Mapping file, where it has other names.")] = None,
    rtol: Annotated[
        float | None, typer.Option("--rtol", min=0.0, help="Of an output's magnitude; else RelTol of the recording.")
    ] = None,
    atol: Annotated[float, typer.Option("--atol", min=0.0, help="Error granted to every output, in its unit.")] = 0.0,
) -> None:
    """Drive an FMU with the recorded inputs of a component and compare its outputs with the recorded ones."""
    sheltered(fmu, replay_and_print, fmu, folder, name, map_, rtol, atol)


def replay_and_print(
    fmu: Path, folder: Path, name: str, map_: Path | None, rtol: float | None, atol: float
) -> None:  # in a process of its own
    """What was compared, as a table. Raises RunError if an output is outside its bound."""
    from ....exchange.recordings.replay import replay as drive

    with share(f"replaying {name or folder}") as progress:
        found = drive(fmu, folder, name, map_, rtol, atol, progress)
    for note in found.notes:
        tell(note)
    cells = [
        (
            f"{v.output} [{v.unit or '?'}]", f"{v.error:.3g}", f"{v.at:.6g}", f"{v.scale:.4g}", f"{v.bound:.3g}",
            f"{v.differing} of {found.steps + 1}", v.text,
        ) for v in found.verdicts
    ]  # fmt: skip
    title = f"{fmu.name} against the recording of {found.recording}, {counted(found.steps, 'step')}"
    headings = ("output", "largest\nerror", "at [s]", "of\nmagnitude", "bound", "differing", "verdict")
    print_table(title, headings, cells, words=(0, 6))
    found.require_within()


@app.command()
def export(
    system: SystemName,
    ssp: Annotated[bool, typer.Option("--ssp", help="As an SSP, for tools that read system structures.")] = False,
    fmu: Annotated[
        bool, typer.Option("--fmu", help="As one native FMU: the plan in C, with the bits of `run`.")
    ] = False,
    c: Annotated[
        Path | None, typer.Option("--c", metavar="DIR", help="As a C library and a program, with no FMI around it.")
    ] = None,
    container: Annotated[bool, typer.Option("--container", help="As one FMU that holds all the others.")] = False,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FILE", help="SYSTEM.ssp or SYSTEM.fmu if not given.")
    ] = None,
    ssp_version: Annotated[str, typer.Option("--ssp-version", help="1.0 or 2.0.")] = "1.0",
    fmi: Annotated[str, typer.Option("--fmi", help="2.0 or 3.0, of --fmu.")] = "2.0",
    set_: SetOption = [],  # noqa: B006
    parameters: ParametersOption = "",
    start: StartOption = "",
    stop: StopOption = "",
    step: StepOption = "",
    allow_outside: OutsideOption = [],  # noqa: B006
    fmus: FmusOption = None,
) -> None:
    """Write a whole system for other tools: as one file, or as C."""
    from ....exchange.export import export_container, export_ssp
    from ....run.planned import planned
    from ....system.assemble import assemble
    from ....system.request import assignments, changes_of

    if [ssp, fmu, c is not None, container].count(True) != 1:
        raise InputError("export: choose one of --ssp, --fmu, --c DIR and --container")
    if c is not None and out is not None:
        raise InputError(f"export: --c {c} is where the files go; leave out --out")
    changes = changes_of((), (), (), allow_outside, parameters)
    assembled = assemble(system, assignments(set_), stop, fmus, changes, step=step, start=start)
    if fmu or c is not None:
        from ....emit.export import export_c, export_fmu

        made = export_c(assembled, c) if c is not None else export_fmu(assembled, out, fmi)
        tell(f"wrote {made.path} ({made.kind})")
        for note in made.notes:
            tell(note)
        return
    plan = planned(assembled)
    if ssp:
        found = export_ssp(plan, out or Path(f"{plan.system.name}.ssp"), ssp_version)
    else:
        found = export_container(plan, out or Path(f"{plan.system.name}.fmu"))
    tell(f"wrote {found.path} ({found.kind}, {found.path.stat().st_size // 1000} kB)")
    for note in found.notes:
        tell(note)
