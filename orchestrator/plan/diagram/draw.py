"""The block diagram: blocks on a diagonal, what goes on above it, what is fed back below it.

This is the N2 chart of systems engineering (R. J. Lano, 1977), as a block diagram (A. B. Lambe and
J. R. R. A. Martins, Structural and Multidisciplinary Optimization 46, 2012): a line leaves a block sideways, passes the
names of what it carries, and turns into the block that takes them. No two arrows can be mistaken for one another,
however many there are.
"""

from __future__ import annotations

from ...clock import seconds_text
from ...errors import listed
from ...markup import boxed, element, safe
from ..plan import Plan
from ..schedule.formulas import ITERATED
from .blocks import Block, Flow, blocks_of, flows_of
from .ink import shortened, text, width
from .labels import Label, label_of
from .place import Grid, grid_of

NAME, SMALL = 13.0, 10.5  # sizes of letters
RATES = ("#2f7ebc", "#2a9d64", "#c77d0a", "#b3487f", "#7a5bc4", "#5f7d8c")  # fast to slow; legible on white and black
KINDS = {
    "hold": ("#7d8590", "keeps its value"),
    "mean": ("#2f7ebc", "averaged over the step of what takes it"),
    "linear": ("#c77d0a", "extrapolated by a line"),
    "quadratic": ("#c2552d", "extrapolated by a parabola"),
    "interpolate": ("#2a9d64", "interpolated, its source is ahead"),
    **{
        transfer: ("#7a5bc4", f"solved: {how}")
        for transfer, how in zip(ITERATED, ("mean of both ends", "value at the end", "a line to the end"), strict=True)
    },
    "continuous": ("#b3487f", "solved in each evaluation"),
    "tick": ("#5f7d8c", "ticks with it"),
}
LONGEST_NAME = 22  # characters of a block's name
OTHER = ("#7d8590", "")


def block_diagram(plan: Plan, alone: bool = False) -> str:
    """The diagram of a plan as SVG: blocks with their periods, arrows with signals and transfers.

    Lines and words have the colour of the text around them, so that it is legible on light and dark pages; `alone` is
    for a file of its own, which brings a background for either. All names are escaped.
    """
    blocks, flows = blocks_of(plan), flows_of(plan)
    labels = {(f.source, f.target): label_of(f, len(blocks)) for f in flows}
    grid = grid_of([_block_size(block) for block in blocks], {k: _label_size(label) for k, label in labels.items()})
    tints = {period: RATES[min(k, len(RATES) - 1)] for k, period in enumerate(sorted({b.period for b in blocks}))}
    drawn = _lines(grid, flows)
    drawn += [_label(grid, flow, labels[flow.source, flow.target]) for flow in flows]
    drawn += [_block(grid, k, block, tints[block.period]) for k, block in enumerate(blocks)]
    foot, legend = _legend(plan, flows, grid.height)
    across = max(grid.width, *(width(line, SMALL, False) + 16.0 for line in foot), 220.0)
    height = grid.height + legend[1]
    title = element("title", safe(f"block diagram of {plan.system.name}"))
    return element(
        "svg", [title, *(_page() if alone else []), *drawn, legend[0]], xmlns="http://www.w3.org/2000/svg",
        width=round(across), height=round(height), viewBox=f"0 0 {across:.0f} {height:.0f}", role="img",
        **({"class_": "alone"} if alone else {}),
    )  # fmt: skip


def diagram_html(plan: Plan) -> str:
    """The diagram for a notebook or a page, in a box that is scrolled where it is too narrow."""
    return boxed(block_diagram(plan))


def _page() -> list[str]:
    """Colours of a file of its own, by what its reader likes."""
    rules = (
        ".alone{color:#1f2328;background:#fff}"
        "@media (prefers-color-scheme:dark){.alone{color:#e6edf3;background:#0d1117}}"
    )
    return [element("style", rules)]


def _block_size(block: Block) -> tuple[float, float]:
    name = width(shortened(block.name, LONGEST_NAME), NAME)
    return max(name * 1.04, width(block.rate, SMALL, False)) + 24.0, 46.0


def _label_size(label: Label) -> tuple[float, float]:
    wide = max(width(f"{names}  {transfer}", SMALL) for names, transfer in label.lines)
    return wide + 14.0, 16.0 * len(label.lines) + 6.0


def _block(grid: Grid, k: int, block: Block, tint: str) -> str:
    x, y = grid.x[k], grid.y[k]
    wide, high = grid.block[k]
    return element("g", [
        element("title", safe(block.about)),
        element("rect", x=x - wide / 2, y=y - high / 2, width=wide, height=high, rx=5.0, fill=tint, fill_opacity=0.18,
                stroke=tint, stroke_width=1.6),
        text(shortened(block.name, LONGEST_NAME), x, y - 3.0, NAME, text_anchor="middle", font_weight=600),
        text(block.rate, x, y + 13.0, SMALL, mono=False, text_anchor="middle", fill_opacity=0.85),
    ])  # fmt: skip


def _lines(grid: Grid, flows: list[Flow]) -> list[str]:
    """Each sideways out of its source, through its label, and into the target; what several share is drawn once."""
    pieces = dict.fromkeys(piece for flow in flows for piece in grid.pieces(flow.source, flow.target))
    lines = "".join(f"M{x:.1f} {y:.1f}L{u:.1f} {v:.1f}" for x, y, u, v in pieces)
    tips = dict.fromkeys(
        (*grid.tip(f.source, f.target), -7 if f.source < f.target else 7) for f in flows if f.source != f.target
    )
    heads = "".join(f"M{x:.1f} {y:.1f}l-3.5 {high}h7z" for x, y, high in tips)  # from above, or from below
    return [
        element("path", d=lines, fill="none", stroke="currentColor", stroke_opacity=0.55, stroke_width=1.2),
        element("path", d=heads, fill="currentColor", fill_opacity=0.8),
    ]


def _label(grid: Grid, flow: Flow, label: Label) -> str:
    x, y = grid.corner(flow.source, flow.target)
    wide, high = _label_size(label)
    left, top = x - wide / 2, y - high / 2
    colour = KINDS.get(label.lines[0][1], OTHER)[0]
    drawn = [
        element("title", safe(flow.about)),
        element("rect", x=left, y=top, width=wide, height=high, rx=high / 2 if len(label.lines) == 1 else 8.0,
                fill=colour, fill_opacity=0.1, stroke=colour, stroke_opacity=0.7,
                stroke_width=2.4 if flow.bond else 0.9),
    ]  # fmt: skip
    for k, (names, transfer) in enumerate(label.lines):
        line = top + 15.0 + 16.0 * k
        drawn.append(text(names, left + 7.0, line, SMALL))
        tint = KINDS.get(transfer, OTHER)[0]
        drawn.append(text(transfer, left + wide - 7.0, line, SMALL, text_anchor="end", fill=tint, font_weight=600))
    return element("g", drawn)


def _legend(plan: Plan, flows: list[Flow], top: float) -> tuple[list[str], tuple[str, float]]:
    """What the words mean, below; its lines, and them drawn with their height."""
    system, clock = plan.system, plan.clock
    again = seconds_text(clock.seconds(clock.hyperperiod))
    lines = [
        f"{system.algorithm}: " + ("the steps vary" if plan.adaptive else f"repeats every {again}")
        + f", to {seconds_text(system.stop)}",
    ]  # fmt: skip
    if any(f.source > f.target for f in flows):
        lines.append("above the diagonal: onwards in the order of steps; below: back")
    kinds = list(dict.fromkeys(transfer for flow in flows for transfer, _ in flow.signals))
    lines += [f"{kind}: {KINDS.get(kind, OTHER)[1]}" for kind in kinds if KINDS.get(kind, OTHER)[1]]
    if any(flow.bond for flow in flows):
        lines.append(f"thick frame: power bond {listed((bond.name for bond in system.bonds), 3)}")
    lines = [shortened(line, 90) for line in lines]
    drawn = [
        text(line, 8.0, top + 12.0 + 15.0 * k, SMALL, mono=False, fill_opacity=0.75) for k, line in enumerate(lines)
    ]
    return lines, ("".join(drawn), 12.0 + 15.0 * len(lines))
