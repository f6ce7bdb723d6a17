"""A sensitivity study: blocks of points computed as a sweep computes them, and the indices of each figure of merit."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from ...errors import InputError, counted
from ..sweep.design.blocks import LEVELS, block_shares, block_size, require_salib
from ..sweep.design.design import Design
from ..sweep.design.sampling import Choices, choices
from ..sweep.merits import require_known, written_out
from ..sweep.options import Options
from ..sweep.request import Request
from ..sweep.sweep import Swept, sweep
from .indices import Indices, estimated, without_effect
from .written import write_indices

METHODS = {"sobol": 256, "morris": 20}  # and how many blocks are computed where nobody says


@dataclass(frozen=True)
class Sensitivity:
    """The indices of each figure of merit, and the sweep that they come from."""

    method: str
    second: bool
    indices: tuple[Indices, ...]
    idle: tuple[str, ...]  # parameters that change nothing, to the last bit
    swept: Swept
    paths: tuple[Path, ...]

    @property
    def parameters(self) -> list[str]:
        return [axis.name for axis in self.swept.table.design.axes]


def sensitivity(
    name: str,
    out: Path,
    options: Options,
    method: str = "sobol",
    samples: int = 0,
    second: bool = False,
    figures: Sequence[str] = (),
    tell: Callable[[str], None] = lambda _line: None,
    progress: Callable[[int, int], None] = lambda _done, _of: None,
) -> Sensitivity:
    """Indices of `figures` (all of the system, if none) over the ranges of `options.vary` and of a sweep file.

    `samples` blocks of points are computed (see `sweep/design`), as many as METHODS says where it is 0; those of Sobol
    are raised to a power of 2. All parameters are independent, uniform in their range (its logarithm with `:log`, the
    entries of a list). What is computed already in `out` is not computed again. Raises InputError before anything is
    computed; RunError after an interruption.
    """
    require_salib()
    if method not in METHODS:
        raise InputError(f"--method {method}: write one of {', '.join(METHODS)}")
    if second and method != "sobol":
        raise InputError("--second-order is of Sobol's indices; leave it out, or choose --method sobol")
    if options.points or options.random or options.design:
        raise InputError("a sensitivity study chooses its points; leave --points, --random and --design out")
    count = samples or METHODS[method]
    if count < 4:
        raise InputError(f"--samples {count}: an interval needs 4 at least")
    if method == "sobol" and count & (count - 1):
        tell(f"--samples {count} is no power of 2, which Sobol's sequence needs: {1 << count.bit_length()} are taken")
        count = 1 << count.bit_length()
    kind = "morris" if method == "morris" else "saltelli2" if second else "saltelli"

    def check(request: Request, design: Design) -> None:
        require_known(figures, request.units, "--figure")
        if method == "morris":
            _require_levels(request)
        size = block_size(kind, len(design.axes))
        tell(f"{counted(len(design), 'run')}: {count} blocks of {size} for {counted(len(design.axes), 'parameter')}")

    asked = replace(options, random=count, blocks=kind, figures={**options.figures, **written_out(figures)})
    swept = sweep(name, out, asked, tell, progress, check)
    table = swept.table
    axes, seed = table.design.axes, table.design.seed or 0
    shares = block_shares(kind, len(axes), count, seed)
    chosen = list(figures) or list(table.figures)
    columns = [table.column(figure) for figure in table.figures]
    found = tuple(
        estimated(kind, figure, table.figures[figure][0], table.column(figure), shares, seed) for figure in chosen
    )
    idle = tuple(axes[k].name for k in without_effect(kind, columns, shares))
    made = Sensitivity(method, second, found, idle, swept, ())
    return replace(made, paths=write_indices(made, out))


def _require_levels(request: Request) -> None:
    """Raise InputError for a list of which the levels of Morris would leave entries out."""
    for name, text in request.vary.items():
        found = choices(request.system, request.system.full_name(name), text)
        if isinstance(found, Choices) and len(found.items) > LEVELS:
            raise InputError(
                f"--vary {name}={text}: Morris takes {LEVELS} values of each parameter, and of "
                f"{len(found.items)} entries it would never take some; write a range or {LEVELS} entries at most, or "
                "choose --method sobol"
            )
