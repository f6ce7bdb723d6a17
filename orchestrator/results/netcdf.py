"""Recorded rows as netCDF: one group per rate; variables carry unit and description."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..clock import seconds_text
from ..plan.plan import Plan
from .signals import Signals
from .tables import Run

if TYPE_CHECKING:
    import xarray


def datasets(run: Run) -> dict[str, xarray.Dataset]:
    """One dataset per rate, by a name such as `every_500_us`."""
    import xarray

    signals = Signals(run)
    found = {}
    for g, group in enumerate(run.plan.groups):
        variables = {}
        for name in (".".join(key) for key in group.columns):
            signal = signals[name]
            units = {"units": signal.unit} if signal.unit else {}
            variables[name] = ("time", signal.values, {**units, "long_name": signal.description})
        time = ("time", signals.times(g), {"units": "s", "long_name": "time"})
        period = "varies" if run.plan.adaptive else seconds_text(run.plan.clock.seconds(group.period))
        attributes = {"period": period, "complete": int(not run.failure)}
        found[group_name(run.plan, g)] = xarray.Dataset(variables, {"time": time}, attributes)
    return found


def group_name(plan: Plan, group: int) -> str:
    """Name of a rate's table in the results file."""
    if plan.adaptive:
        return "varying_steps"
    return "every_" + seconds_text(plan.clock.seconds(plan.groups[group].period)).replace(" ", "_").replace(
        "/", "_per_"
    )
