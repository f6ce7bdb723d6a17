"""Recorded rows as netCDF: one group per rate; variables carry unit and description.

A name that netCDF forbids, such as `tank.gain/y`, is stored as another one, and the variable's attribute
`recorded_name` holds what it is called; `open_results` gives every variable its own name back.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from ...clock import seconds_text
from ...errors import InputError
from ...plan.plan import Plan
from ..signals import Signals
from ..tables import Run
from .rows_file import RowsFile

if TYPE_CHECKING:
    import xarray

OWN_NAME = "recorded_name"


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


def stored(dataset: xarray.Dataset) -> xarray.Dataset:
    """A dataset as netCDF can hold it: variables whose names it forbids are called otherwise and say so."""
    other = {own: name for own, name in stored_names(map(str, dataset.data_vars)).items() if own != name}
    for own in other:
        dataset[own].attrs[OWN_NAME] = own
    return dataset.rename(other) if other else dataset


def stored_names(names: Iterable[str]) -> dict[str, str]:
    """What every variable of a table is called in the file: its own name, but for characters that are forbidden."""
    own = list(names)
    found = {name: "".join(_allowed(c) for c in name).rstrip(" ") for name in own}
    taken = {name for name in own if found[name] == name}
    for name, other in found.items():
        if other != name:
            number, unique = 2, other
            while unique in taken:
                unique, number = f"{other}_{number}", number + 1
            found[name] = unique
            taken.add(unique)
    return found


def _allowed(character: str) -> str:
    if character == "/":
        return "|"
    return character if character.isprintable() else "_"


def open_results(path: Path) -> dict[str, xarray.Dataset]:
    """The tables of a result.nc by the name of their group, every variable by its own name.

    Raises InputError if the file cannot be read.
    """
    import xarray

    try:
        with xarray.open_datatree(path, engine="h5netcdf") as tree:
            tables = {name: node.to_dataset().load() for name, node in tree.children.items()}
    except (OSError, RuntimeError, ValueError) as error:
        raise InputError(f"{path} cannot be read: {error}") from error
    for name, table in tables.items():
        own = {key: table[key].attrs[OWN_NAME] for key in table.data_vars if OWN_NAME in table[key].attrs}
        tables[name] = table.rename(own)
    return tables


def write_netcdf(run: Run, path: Path) -> None:
    """A group per table. Raises OSError if the disk refuses."""
    file = RowsFile(path, new=True)
    try:
        for group, dataset in datasets(run).items():
            file.create(group, stored(dataset))
        file.close()
    finally:
        file.give_up()


def group_name(plan: Plan, group: int) -> str:
    """Name of a rate's table in the results file."""
    if plan.adaptive:
        return "varying_steps"
    return "every_" + seconds_text(plan.clock.seconds(plan.groups[group].period)).replace(" ", "_").replace(
        "/", "_per_"
    )
