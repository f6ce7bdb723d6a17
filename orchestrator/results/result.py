"""What a run leaves, for Python: datasets, figures of merit, files."""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import InputError, RunError, nearest
from ..extras import needed
from ..files import prepare_folder
from .files.netcdf import DATASETS, datasets, events_dataset, group_name
from .files.writing import write_results
from .summary.energy import require_energy
from .summary.figures_of_merit import figure_units
from .summary.summary import comparison, summarize
from .tables import Run

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure


PUBLIC = (
    "comparison", "dataset", "datasets", "events", "folder", "open", "plot", "require_good", "run", "save", "summary",
    "units",
)  # fmt: skip


class Result:
    """Datasets, figures of merit and files of a run."""

    folder: Path | None = None  #: where it is saved, if it is

    def __init__(self, run: Run) -> None:
        self.run = run

    def __dir__(self) -> list[str]:
        """What is meant to be used."""
        return sorted(PUBLIC)

    @staticmethod
    def open(folder: str | Path) -> Result:
        """What an earlier run left in a folder, complete or not. Raises InputError if that cannot be read."""
        from .opened import open_result

        return open_result(Path(folder))

    def require_good(self) -> Result:
        """The result itself; RunError, which carries it, if the run ended early or its bonds made too much energy."""
        try:
            if self.run.failure:
                raise RunError(self.run.failure)
            require_energy(self.run)
        except RunError as error:
            error.result = self
            raise
        return self

    @cached_property
    def datasets(self) -> dict[str, xarray.Dataset]:
        """One xarray dataset per rate, by a name such as `every_500_us`; variables carry unit and description."""
        return datasets(self.run)

    @cached_property
    def events(self) -> xarray.Dataset:
        """What happened in the run: time, number within the instant, what it was, and all recorded signals there."""
        return events_dataset(self.run)

    @cached_property
    def dataset(self) -> xarray.Dataset:
        """All signals in one dataset. Of several rates each has a time of its own, such as `time_500_us`."""
        needed("xarray", DATASETS)
        import xarray

        found = self.datasets
        if len(found) == 1:
            return next(iter(found.values()))
        named = {name: f"time_{name.removeprefix('every_')}" for name in found}
        parts = [table.rename(time=named[name]) for name, table in found.items()]
        variables = {key: variable for part in parts for key, variable in part.data_vars.items()}
        return xarray.Dataset(variables, attrs={"complete": int(all(t.attrs["complete"] for t in found.values()))})

    def __getitem__(self, name: str) -> xarray.DataArray:
        """One signal over its own times, `result["motor.i"]`; of a component alone `result["i"]` will do.

        Raises InputError for a name that is not recorded.
        """
        known = [str(key) for table in self.datasets.values() for key in table]
        owners = {key.partition(".")[0] for key in known if not key.startswith("coupling.")}
        names = (name, f"{next(iter(owners))}.{name}") if len(owners) == 1 else (name,)
        for table in self.datasets.values():
            for key in names:
                if key in table and key != "time":
                    return table[key].assign_attrs(period=table.attrs["period"])
        raise InputError(f"no recorded signal '{name}'{nearest(name, known)}")

    def _ipython_key_completions_(self) -> list[str]:
        """What can stand in brackets, for the tab key."""
        return [str(key) for table in self.datasets.values() for key in table]

    def _repr_html_(self) -> str:
        """In a notebook: the figures of merit with their units, the signals in small, and where it is saved."""
        from .html import result_html

        return result_html(self)

    @cached_property
    def units(self) -> dict[str, str]:
        """The units of those figures of merit that are single numbers."""
        return figure_units(self.run.plan.system)

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The figures of merit that the system file asks for, and what the run took."""
        found: dict[str, Any] = dict(summarize(self.run))
        return found

    def save(self, folder: str | Path) -> list[Path]:
        """Write what `rovbrush run --out` writes; the paths. Raises InputError or RunError if that is not possible."""
        prepare_folder(Path(folder), "another folder")
        self.folder = Path(folder)
        return write_results(self.run, Path(folder), {**self.summary, "comparison": self.comparison})

    def plot(self, *signals: str, begin: float | None = None, end: float | None = None) -> Figure:
        """A picture of signals, names or patterns such as `motor.*`, between two instants [s]; `.savefig(path)`.

        Without names what is connected. Ripples too fast to be seen are bands with their mean, on the right is a closer
        look; angles in degrees, short lengths in millimetres. Raises InputError for an unknown name, or an empty span.
        """
        from .pictures.overview import choose, picture
        from .pictures.traces import traces

        found = traces(self)
        return picture(found, choose(found, signals, begin, end))

    @property
    def comparison(self) -> list[dict[str, Any]]:
        """The run's numbers beside those of the system file."""
        keys = ("label", "unit", "reference", "value", "ratio", "within")
        return [{key: row[key] for key in keys} for row in comparison(self.run, self.summary)]

    @property
    def shown(self) -> list[str]:
        """The signals that the system file draws, first of all."""
        figures = self.run.plan.system.reporting["figures"]
        return list(dict.fromkeys(name for entry in figures for name in entry.get("signals", ())))

    @property
    def title(self) -> str:
        """What was run."""
        return self.run.plan.system.name

    def __repr__(self) -> str:
        shown = [group_name(self.run.plan, g) for g in range(len(self.run.plan.groups))]
        return f"<Result of {self.run.plan.system.name} to {self.run.end:g} s: {', '.join(shown)}>"
