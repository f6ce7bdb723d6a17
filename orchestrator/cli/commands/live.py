"""The command that runs a system live, with a page to watch and touch it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ...extras import require
from ..options import (
    CoresOption,
    FifoOption,
    FmusOption,
    InputOption,
    MapOption,
    OutsideOption,
    ParametersOption,
    PeriodOption,
    ReplaceOption,
    SetOption,
    StartOption,
    StepOption,
    StopOption,
    SystemName,
    app,
)


@app.command()
def live(
    system: SystemName,
    out: Annotated[Path, typer.Option("--out", help="Folder for the results.")] = Path("live"),
    speed: Annotated[float, typer.Option("--speed", help="Times real time; 0: as fast as it goes.")] = 1.0,
    paused: Annotated[bool, typer.Option("--paused", help="Wait at the start until somebody presses start.")] = False,
    host: Annotated[
        str, typer.Option("--host", help="Where the page is; beyond this machine only with --token.")
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option("--port", help="Its port; 0: any that is free.")] = 8080,
    token: Annotated[str, typer.Option("--token", help="A word that browsers must know, in the address.")] = "",
    set_: SetOption = [],  # noqa: B006
    input_: InputOption = [],  # noqa: B006
    start: StartOption = "",
    stop: StopOption = "",
    replace: ReplaceOption = [],  # noqa: B006
    map_: MapOption = [],  # noqa: B006
    period: PeriodOption = [],  # noqa: B006
    parameters: ParametersOption = "",
    step: StepOption = "",
    allow_outside: OutsideOption = [],  # noqa: B006
    fifo: FifoOption = "",
    cores: CoresOption = "",
    fmus: FmusOption = None,
    stay: Annotated[
        bool, typer.Option("--stay/--no-stay", help="Keep the page when the run has ended, until Ctrl-C.")
    ] = True,
    force: Annotated[bool, typer.Option("--force", help="Replace results of others in the folder.")] = False,
) -> None:
    """Run a system in real time with a page in the browser: watch it, set its inputs, break its signals."""
    require("nicegui", "rovbrush live")
    from ...live.server import PageServer
    from ...system.request import Request

    request = Request(
        system, set_=tuple(set_), start=start, stop=stop, replace=tuple(replace), map_=tuple(map_),
        period=tuple(period), step=step, fmus=str(fmus or ""), input_=tuple(map(str, input_)),
        allow_outside=tuple(map(str, allow_outside)), parameters=parameters, fifo=fifo, cores=cores,
    )  # fmt: skip
    with PageServer(host, port, token) as server:  # it begins while the rest is loaded
        from ..live_system import live_system

        live_system(request, out, server, speed=speed, paused=paused, stay=stay, force=force)
