"""The commands that look at a system near an operating point: its linear model, the margins of its loops."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ...console import tell, wrote
from ...linear_tables import print_margins, print_model
from ...options import (
    FmusOption,
    MapOption,
    OutOption,
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
from ...progress import share

if TYPE_CHECKING:
    from ....studies.linear.options import Options
    from ....system.model import System

AtOption = Annotated[
    list[str], typer.Option("--at", metavar="TIME", help='Time of an operating point, "8 s"; repeatable.')
]
SampleOption = Annotated[
    str, typer.Option("--sample", metavar="TIME", help="Time between samples; by default that in which all repeats.")
]
LengthOption = Annotated[
    str, typer.Option("--length", metavar="TIME", help="Of a response; by default until it has died out.")
]
SizeOption = Annotated[
    list[str], typer.Option("--size", metavar="NAME=VALUE", help="How much is added to an input; repeatable.")
]
OrderOption = Annotated[int | None, typer.Option("--order", min=0, help="States of the model; found by default.")]
PeriodOfOption = Annotated[
    str, typer.Option("--period-of", metavar="ANGLE", help="Average whole turns of this signal, or a time.")
]
StartsOption = Annotated[int, typer.Option("--starts", min=1, help="Pulses over a period.")]
ResidualOption = Annotated[float, typer.Option("--residual", min=0.0, help="How far from steady a point may be.")]


@app.command()
def linearise(
    system: SystemName,
    inputs: Annotated[
        list[str], typer.Option("--inputs", metavar="NAMES", help='Free inputs, or connections "a.y -> b.u".')
    ] = [],  # noqa: B006
    outputs: Annotated[list[str], typer.Option("--outputs", metavar="NAMES", help="Signals, or patterns.")] = [],  # noqa: B006
    at: AtOption = [],  # noqa: B006
    out: OutOption = Path("results"),
    sample: SampleOption = "",
    length: LengthOption = "",
    size: SizeOption = [],  # noqa: B006
    order: OrderOption = None,
    period_of: PeriodOfOption = "",
    starts: StartsOption = 8,
    residual: ResidualOption = 0.02,
    method: Annotated[
        str, typer.Option("--method", help="states, pulses, or auto: states where FMUs show them.")
    ] = "auto",
    sampled: Annotated[
        bool, typer.Option("--sampled", help="A continuous model with its inputs held over a sample.")
    ] = False,
    set_: SetOption = [],  # noqa: B006
    start: StartOption = "",
    stop: StopOption = "",
    step: StepOption = "",
    replace: ReplaceOption = [],  # noqa: B006
    map_: MapOption = [],  # noqa: B006
    period: PeriodOption = [],  # noqa: B006
    parameters: ParametersOption = "",
    allow_outside: OutsideOption = [],  # noqa: B006
    fmus: FmusOption = None,
) -> None:
    """A, B, C, D of a system at times of a run: by states where FMUs show them, else by pulse responses."""
    from ....files import prepare_folder
    from ....studies.linear.linearise import linearise as study
    from ....studies.linear.statespace import write

    options = _options(at, sample, length, size, order, period_of, starts, residual, method, sampled)
    found = _system(system, set_, start, stop, step, replace, map_, period, parameters, allow_outside, fmus)
    prepare_folder(out)
    with share(f"{found.name}, linearised") as progress:
        models = study(found, _names(inputs), _names(outputs), options, progress)
    for model in models:
        print_model(model)
    wrote(write(models, out), out)


@app.command()
def margins(
    system: SystemName,
    break_: Annotated[
        list[str],
        typer.Option(
            "--break", metavar="PLACE", help='Where the loop is broken: "a.y -> b.u", or "a.y + a.u"; repeatable.'
        ),
    ],
    at: AtOption = [],  # noqa: B006
    out: OutOption = Path("results"),
    sample: SampleOption = "",
    length: LengthOption = "",
    size: SizeOption = [],  # noqa: B006
    order: OrderOption = None,
    period_of: PeriodOfOption = "",
    starts: StartsOption = 8,
    residual: ResidualOption = 0.02,
    verify: Annotated[
        bool, typer.Option("--verify", help="Look for the delay margin on runs too: a delay that makes a kick grow.")
    ] = False,
    set_: SetOption = [],  # noqa: B006
    start: StartOption = "",
    stop: StopOption = "",
    step: StepOption = "",
    replace: ReplaceOption = [],  # noqa: B006
    map_: MapOption = [],  # noqa: B006
    period: PeriodOption = [],  # noqa: B006
    parameters: ParametersOption = "",
    allow_outside: OutsideOption = [],  # noqa: B006
    fmus: FmusOption = None,
) -> None:
    """Gain, phase and delay margins of a loop that is broken at a connection, with Bode's and Nyquist's pictures."""
    from ....files import prepare_folder, write_file, write_json
    from ....studies.linear.margins.margins import margins as study
    from ....studies.linear.margins.margins import verified
    from ....studies.linear.margins.pictures import bode, nyquist

    options = _options(at, sample, length, size, order, period_of, starts, residual, "pulses", False)
    found = _system(system, set_, start, stop, step, replace, map_, period, parameters, allow_outside, fmus)
    prepare_folder(out)
    with share(f"{found.name}, the loop broken") as progress:
        loops = study(found, break_, options, progress)
    if verify:
        with share(f"{found.name}, with delays") as progress:
            loops = verified(found, loops, progress)
    print_margins(loops)
    content = [each.content() for each in loops]
    paths = [
        write_file(out / "margins.json", lambda p: write_json(p, content)),
        write_file(out / "bode.png", bode(loops).savefig),
        write_file(out / "nyquist.png", nyquist(loops).savefig),
    ]
    wrote(paths, out)


def _names(texts: Sequence[str]) -> list[str]:
    """Names from texts that may hold several, separated by commas outside of brackets."""
    found = [""]
    depth = 0
    for letter in ",".join(texts):
        depth += (letter == "[") - (letter == "]")
        if letter == "," and depth == 0:
            found.append("")
        else:
            found[-1] += letter
    return [name.strip() for name in found if name.strip()]


def _options(
    at: Sequence[str], sample: str, length: str, size: Sequence[str], order: int | None, period_of: str, starts: int,
    residual: float, method: str, sampled: bool,
) -> Options:  # fmt: skip
    from ....studies.linear.options import Options
    from ....system.request import assignments

    sizes = assignments(size, "--size")
    return Options(at, sample, length, sizes, order, period_of, starts, residual, method, sampled)


def _system(
    name: str, set_: list[str], start: str, stop: str, step: str, replace: list[str], map_: list[str],
    period: list[str], parameters: str, allow_outside: list[Path], fmus: Path | None,
) -> System:  # fmt: skip
    from ....system.assemble import assemble
    from ....system.request import assignments, changes_of

    changes = changes_of(replace, map_, period, allow_outside, parameters)
    found = assemble(name, assignments(set_), stop, fmus, changes, step=step, start=start)
    for component in found.components.values():
        for note in component.notes:
            tell(note)
    return found
