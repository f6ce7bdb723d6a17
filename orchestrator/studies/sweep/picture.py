"""What a sweep draws of itself: lines over one parameter, maps over two, a scatter matrix of other points, a tornado.

Made of sweep.nc alone, so that it can be drawn again at any time.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...errors import InputError, RovbrushError, RunError, nearest
from ...files import reason, write_file
from ...results.files.hdf5 import OWN_NAME
from ...results.pictures.canvas import caption
from ...results.pictures.charts import Axis, Figures, heat_maps, lines, scatter_matrix
from ...results.pictures.tornado import tornado
from ...system.file.recorded import matching

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

SWEEP, PICTURE, TORNADO = "sweep.nc", "sweep.png", "sweep_tornado.png"
MOST = 12  # figures of merit in a picture
SERIES = 4  # of them in a tornado
FEWEST = 8  # points from which a correlation says something


def draw_sweep(source: Path | xarray.Dataset, names: Sequence[str] = ()) -> Figure:
    """The picture of a sweep, by its folder or its dataset; of the figures of merit `names`, or the first MOST.

    Raises InputError if it cannot be read, has no such figure of merit, or no point.
    """
    table = read_sweep(source) if isinstance(source, Path) else source
    axes, figures, left_out = _parts(table, names)
    grid = table.attrs.get("design") == "grid"
    title = str(table.attrs.get("title", "sweep"))
    long = [axis for axis in axes if len(np.unique(axis.values)) > 1]
    if grid and len(axes) == 1:
        figure = lines(title, axes[0], figures)
    elif grid and len(axes) == 2:
        figure = heat_maps(title, axes, figures)
    elif len(long) == 1 and not grid:
        figure = lines(title, long[0], figures)
    else:
        figure = scatter_matrix(title, long or axes, figures)
    caption(figure, _remarks(table, left_out))
    return figure


def draw_tornado(source: Path | xarray.Dataset, names: Sequence[str] = ()) -> Figure | None:
    """What matters most: of points that differ from one in a single parameter each the figure of merit at both ends;
    of other points its correlations with the parameters. None for a grid, or too few points."""
    table = read_sweep(source) if isinstance(source, Path) else source
    axes, figures, _ = _parts(table, names)
    axes = [axis for axis in axes if axis.values.dtype.kind in "fiub" and len(np.unique(axis.values)) > 1]
    if table.attrs.get("design") == "grid" or len(axes) < 2 or not figures:
        return None
    title = str(table.attrs.get("title", "sweep"))
    name = next(iter(figures))
    ends = one_at_a_time(axes, figures[name][0])
    if ends is not None:
        base, low, high = ends
        series = {"at its lowest": low, "at its highest": high}
        labels = [axis.name for axis in axes]
        return tornado(f"{title}: one at a time", labels, series, _label(name, figures[name][1]), base=base)
    if table.sizes["point"] < FEWEST:
        return None
    chosen = {key: [correlation(axis.values, values) for axis in axes] for key, (values, _) in figures.items()}
    steady = {key: row for key, row in chosen.items() if any(np.isfinite(row))}
    series = dict(list(steady.items())[:SERIES])
    label = "correlation with the parameter [1]"
    return tornado(title, [axis.name for axis in axes], series, label, beside=True) if series else None


def one_at_a_time(axes: Sequence[Axis], values: np.ndarray) -> tuple[float, list[float], list[float]] | None:
    """The value at the point from which all others differ in one parameter, and by parameter that at its lowest and
    at its highest value; None for other points."""
    points = np.stack([axis.values.astype(float) for axis in axes], axis=1)
    centre = np.array([_commonest(column) for column in points.T])
    differs = points != centre
    at = np.flatnonzero(~differs.any(axis=1))
    if not len(at) or np.max(differs.sum(axis=1)) != 1 or len(points) < 3:
        return None
    base = float(values[at[0]])
    ends: tuple[list[float], list[float]] = ([], [])
    for k in range(len(axes)):
        rows = np.flatnonzero(differs[:, k])
        for end, found in zip(ends, (points[rows, k] < centre[k], points[rows, k] > centre[k]), strict=True):
            inside = rows[found]
            far = inside[np.argmax(np.abs(points[inside, k] - centre[k]))] if len(inside) else at[0]
            end.append(float(values[far]))
    return base, *ends


def correlation(x: np.ndarray, y: np.ndarray) -> float:
    """Pearson's, over the points that have both; NaN where one does not vary."""
    x, y = x.astype(float), y.astype(float)
    both = np.isfinite(x) & np.isfinite(y)
    x, y = x[both], y[both]
    if len(x) < 3 or np.ptp(x) == 0.0 or np.ptp(y) <= 1e-12 * np.max(np.abs(y)):
        return float("nan")
    return float(np.corrcoef(x, y)[0, 1])


def read_sweep(folder: Path) -> xarray.Dataset:
    """The dataset in a folder, each variable by its own name. Raises InputError."""
    import xarray

    path = folder / SWEEP
    try:
        with xarray.open_dataset(path, engine="h5netcdf", decode_times=False) as file:
            table = file.load()
    except (OSError, ValueError, RuntimeError, LookupError) as error:
        raise InputError(f"{path} cannot be read: {reason(error)}") from error
    own = {str(name): str(v.attrs[OWN_NAME]) for name, v in table.variables.items() if OWN_NAME in v.attrs}
    return table.rename(own)


def _parts(table: xarray.Dataset, names: Sequence[str]) -> tuple[list[Axis], Figures, list[str]]:
    """The varied parameters, the figures of merit to draw, and those that are left out."""
    order = table.dims if table.attrs.get("design") == "grid" else table.coords
    axes = [_axis(str(name), table[name]) for name in order if str(name) != "point"]
    known = [str(name) for name in table.data_vars if str(name) != "error"]
    for name in names:
        if not matching(name, known):
            raise InputError(f"no figure of merit '{name}' in the sweep{nearest(name, known)}")
    wanted = list(dict.fromkeys(hit for name in names for hit in matching(name, known)))
    if not wanted:
        wanted = [name for name in known if table[name].dtype.kind in "fiub" and _varies(table[name].values)] or known
    if not axes or not wanted:
        raise InputError("the sweep has nothing to draw")
    figures: dict[str, tuple[np.ndarray, str]] = {}
    for name in wanted if names else wanted[:MOST]:
        values = np.asarray(table[name].transpose(*table.dims).values, dtype=float)
        figures[name] = (values, str(table[name].attrs.get("units", "")))
    return axes, figures, [name for name in known if name not in figures]


def _axis(name: str, column: xarray.DataArray) -> Axis:
    values = np.asarray(column.values)
    items = dict(zip(np.atleast_1d(column.attrs.get("flag_values", ())).tolist(),
                     str(column.attrs.get("flag_meanings", "")).split(), strict=False))  # fmt: skip
    if items:
        values = np.array([items.get(v, str(v)) for v in values.tolist()], dtype=object)
    return Axis(name, str(column.attrs.get("units", "")), values)


def _remarks(table: xarray.Dataset, left_out: Sequence[str]) -> list[str]:
    errors = [str(text) for text in np.asarray(table["error"].values).ravel()] if "error" in table else []
    failed = [text for text in errors if text]
    lines = [f"{len(failed)} of {len(errors)} points have no values: {failed[0][:200]}"] if failed else []
    return [*lines, f"not drawn: {', '.join(left_out)}"[:400]] if left_out else lines


def _varies(values: np.ndarray) -> bool:
    finite = values[np.isfinite(values.astype(float))]
    return len(finite) > 0 and bool(np.ptp(finite.astype(float)) > 0.0)


def _commonest(values: np.ndarray) -> float:
    found, counts = np.unique(values, return_counts=True)
    return float(found[np.argmax(counts)])


def _label(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit else name


@dataclass
class Pictures:
    """What was drawn, and why something could not be."""

    paths: list[Path] = field(default_factory=list)
    failures: list[str] = field(default_factory=list)

    def require_all(self) -> None:
        """Raise RunError for a picture that could not be made; the numbers are there."""
        if self.failures:
            raise RunError("\n".join(self.failures))


def write_pictures(table: xarray.Dataset, folder: Path) -> Pictures:
    """sweep.png, and sweep_tornado.png where there is one, beside the numbers; a failure is kept as a message."""
    found = Pictures()
    for name, make in ((PICTURE, draw_sweep), (TORNADO, draw_tornado)):
        try:
            figure = make(table)
            if figure is not None:
                found.paths.append(write_file(folder / name, figure.savefig))
            else:
                (folder / name).unlink(missing_ok=True)  # that of an earlier sweep
        except RovbrushError as error:
            found.failures.append(f"{name}: {error}")
        except Exception as error:  # a fault of ours must not cost the other one
            found.failures.append(f"{name} could not be made: unexpected {type(error).__name__}: {error}")
    return found
