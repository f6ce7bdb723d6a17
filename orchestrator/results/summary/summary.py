"""What a run is summarized by: figures of merit, energies, how the coupling did; and figures beside references."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from ...processes import peak_memory
from ...system.file.merits import merit
from ...system.model import System
from ..signals import Signals
from ..tables import AT_START, Run
from .energy import Ledger, balance, ledger, over_limits, require_energy
from .figures_of_merit import figure_of_merit, steady_window
from .ranges import left_range

ROUNDING = 1e-9  # relative, of a number of steps
MOST_TOLD = 1000  # lines of what happened


def summarize(run: Run) -> dict[str, Any]:
    """All figures of merit of a run, as JSON-ready numbers; incomplete runs say so."""
    signals = Signals(run)
    merits, window, (begin, end, turns, steady) = _merits(signals)
    result: dict[str, Any] = {"complete": not run.failure}
    if run.failure:
        result["failure"] = run.failure
    if run.ended:
        result["ended"] = run.ended
    if run.notes:
        result["notes"] = list(run.notes)
    if run.events:
        result["events"] = happened(run)
    if waited := did_not_happen(run):
        result["did_not_happen"] = waited
    if lines := left_range(run, signals):
        result["left_range"] = lines
    result |= merits
    ledgers = [ledger(signals, bond) for bond in run.plan.system.bonds]
    if ledgers:
        result["coupling_energy_relative"] = _relative(ledgers)
        result["coupling_energy"] = {
            x.name: {
                "effort_side_J": x.effort_side, "flow_side_J": x.flow_side, "made_J": x.made,
                "within": not over_limits([x], [bond]),
            } for x, bond in zip(ledgers, run.plan.system.bonds, strict=True)
        }  # fmt: skip
    entry = run.plan.system.reporting["balance"]
    if entry:
        books = balance(signals, entry, ledgers)
        result["energy_balance_relative"] = books.relative
        result["energy_balance"] = {
            f"{key}_J": getattr(books, key) for key in ("supplied", "lost", "stored", "coupling", "residual")
        }
    result["window_s"] = [begin, end]
    if window:
        result["steady"] = steady
    if "angle" in window:
        result["window_turns"] = turns
    result |= coupling(run, signals)
    result |= {
        "simulated_s": run.simulated, "wall_s": run.wall,
        "real_time_factor": run.simulated / run.wall if run.wall else 0.0,
    }  # fmt: skip
    if run.lateness:
        result["real_time"] = run.lateness.content()
    return result | {"start_s": run.start, "peak_memory_MB": peak_memory(), "fmus": which_fmus(run.plan.system)}


def figures(run: Run) -> dict[str, float]:
    """The figures of merit of a complete run that are single numbers: those of `figure_units`, as `summarize` has them.

    Raises RunError if the coupling made or lost more energy than the bonds of the system allow.
    """
    require_energy(run)
    signals = Signals(run)
    found, ledgers = _merits(signals)[0], [ledger(signals, bond) for bond in run.plan.system.bonds]
    if ledgers:
        found["coupling_energy_relative"] = _relative(ledgers)
    if entry := run.plan.system.reporting["balance"]:
        found["energy_balance_relative"] = balance(signals, entry, ledgers).relative
    return found


def _merits(signals: Signals) -> tuple[dict[str, float], Mapping[str, Any], tuple[float, float, int, bool]]:
    """What `[summary]` asks for, its window as it is stated, and what that is in the run: see `steady_window`."""
    specification = dict(signals.run.plan.system.reporting["summary"])
    window = specification.pop("window", {})
    begin, end, turns, steady = steady_window(signals, window)
    found = {}
    for key, text in specification.items():
        operation, names = merit(text)
        found[key] = figure_of_merit(operation, [signals[name] for name in names], begin, end)
    return found, window, (begin, end, turns, steady)


def _relative(ledgers: Sequence[Ledger]) -> float:
    """What the coupling made at the worst bond, by the energy that the largest carried."""
    carried = max(x.carried for x in ledgers)
    return max(abs(x.made) for x in ledgers) / carried if carried else 0.0


def which_fmus(system: System) -> str:
    """Which FMUs ran: shipped with the package, built, or files; by component where they differ."""
    found: dict[str, list[str]] = {}
    for name, component in system.components.items():
        found.setdefault(component.fmu.origin, []).append(name)
    if len(found) == 1:
        return next(iter(found))
    return "; ".join(f"{', '.join(names)}: {kind}" for kind, names in found.items())


def happened(run: Run) -> list[str]:
    """What happened in the run, one a line: the first MOST_TOLD, and how many more there are."""
    lines, more = list[str](), 0
    for row in run.events:
        if row.what in ("", AT_START):
            continue
        if len(lines) < MOST_TOLD:
            lines.append(f"t = {row.time:.9g} s: {row.what}")
        else:
            more += 1
    return [*lines, f"and {more} more, all in the group `events` of result.nc"] if more > 0 else lines


def did_not_happen(run: Run) -> list[str]:
    """The events of the system that had no cause in the run, by name."""
    events = run.plan.system.events
    waiting = [event.name for event in events if event.at is not None or event.when or event.by_hand]
    for row in run.events if waiting else ():
        for text in row.what.split("; "):
            waiting = [name for name in waiting if not text.startswith(f"{name}: ")]
    return waiting


def coupling(run: Run, signals: Signals) -> dict[str, Any]:
    """How many macro steps the run took, and how the algorithm did: iterations, residuals, loops at time 0."""
    clock = run.plan.clock
    count = run.simulated / float(clock.seconds(min(clock.periods.values())))
    steps = math.ceil(count * (1 - ROUNDING))  # the last one may be shorter
    found: dict[str, Any] = {"macro_steps": len(run.ticks_of(0)) - 1 if run.plan.adaptive else steps}
    found |= run.plan.algorithm.figures(lambda name: signals[f"coupling.{name}"].values)
    if run.started.loops:
        found["initial_loops"] = run.started.loops
        found["initial_loop_residual"] = max(run.started.loops.values())
    return found


def comparison(run: Run, summary: Mapping[str, Any]) -> list[dict[str, Any]]:
    """One row per `[[compare]]` entry: label, unit, reference, value, ratio, and whether it is within its tolerance.

    Of a run that did not become steady nothing can be said: `within` is None.
    """
    rows = []
    for entry in run.plan.system.reporting["compare"]:
        value, reference = summary[entry["value"]], float(entry["reference"])
        ratio = value / reference if reference else math.nan
        tolerance = entry.get("tolerance")
        unknown = tolerance is None or not summary.get("steady", True)
        within = None if unknown else bool(abs(ratio - 1) <= tolerance)
        rows.append({**entry, "key": entry["value"], "value": value, "ratio": ratio, "within": within})
    return rows
