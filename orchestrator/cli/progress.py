"""How far something is: a bar on a terminal, a line now and then elsewhere."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager

from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

from .console import console

PLAIN_INTERVAL = 5.0  # s between progress lines where there is no terminal


@contextmanager
def progress(total: float, what: str, unit: str = "s", begin: float = 0.0) -> Iterator[Callable[[float], None]]:
    """A bar on a terminal, a line now and then elsewhere; the callback takes what is reached of `total` units."""
    started, first = time.monotonic(), float(begin)
    if not console.is_terminal:
        last = started
        simulated = unit == "s"  # the pace of a run counts from its first report: FMUs are loaded and compiled before

        def line(reached: float) -> None:
            nonlocal started, first, last, simulated
            now = time.monotonic()
            if simulated and reached > first:
                started, first, simulated = now, reached, False
            elif now - last >= PLAIN_INTERVAL and reached > first:
                last = now
                left = (now - started) * (total - reached) / (reached - first)
                console.print(
                    f"{what}: {f'{reached:.3g}' if unit == 's' else reached} of {total:g} {unit}, {left:.0f} s left"
                )

        yield line
        return
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TextColumn(
            "{task.completed:.2f}/{task.total:g} s" if unit == "s" else f"{{task.completed:g}}/{{task.total:g}} {unit}"
        ),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task(what, total=total, completed=int(begin))
        yield lambda reached: bar.update(task, completed=reached)


@contextmanager
def share(what: str) -> Iterator[Callable[[float], None]]:
    """As `progress`, for work of which is known what share of it is done, 0 to 1."""
    with progress(100.0, what, "%") as report:
        yield lambda done: report(round(100.0 * done, 1))


@contextmanager
def counting(what: str, unit: str) -> Iterator[Callable[[int, int], None]]:
    """As `progress`, where the first call of the callback says how many units are done already, and of how many."""
    with ExitStack() as stack:
        begun: list[Callable[[float], None]] = []

        def reached(done: int, total: int) -> None:
            if not begun:
                begun.append(stack.enter_context(progress(total, what, unit, done)))
            begun[0](done)

        yield reached
