"""What a sensitivity study leaves beside its sweep: sensitivity.json, sensitivity.csv and sensitivity.png."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...files import write_file, write_json
from .indices import CONFIDENCE, Estimate, Indices
from .picture import draw

if TYPE_CHECKING:
    from .sensitivity import Sensitivity

HEAD = ("figure", "unit", "index", "parameter", "with", "value", "low", "high", "blocks")


def write_indices(found: Sensitivity, out: Path) -> tuple[Path, ...]:
    """The files, numbers first. Raises RunError if the disk refuses."""
    paths = [
        write_file(out / "sensitivity.json", lambda path: write_json(path, as_json(found))),
        write_file(out / "sensitivity.csv", lambda path: _write_csv(found, path)),
    ]
    if (picture := draw(found)) is not None:
        paths.append(write_file(out / "sensitivity.png", lambda path: picture.savefig(path, format="png")))
    return tuple(paths)


def as_json(found: Sensitivity) -> dict[str, Any]:
    """Everything, ready for JSON: an interval is `[low, high]`."""
    table, names = found.swept.table, found.parameters
    return {
        "method": found.method, "title": table.title, "seed": table.design.seed, "runs": len(table.design),
        "confidence": CONFIDENCE, "made with": list(table.made_with), "complete": not any(table.errors()),
        "without effect": list(found.idle),
        "figures": {indices.figure: _figure(indices, names) for indices in found.indices},
    }  # fmt: skip


def _figure(indices: Indices, names: list[str]) -> dict[str, Any]:
    entry: dict[str, Any] = {"unit": indices.unit, "blocks": indices.blocks, "incomplete blocks": indices.lost}
    if indices.without:
        return {**entry, "no indices": indices.without}
    parameters = {
        names[k]: {key: _number(estimates[k]) for key, estimates in indices.of.items()} for k in indices.order()
    }
    entry |= {"parameters": parameters, "more samples needed": [names[k] for k in indices.undecided()]}
    if indices.second:
        entry["pairs"] = [{"of": [names[j], names[k]], **_number(e)} for (j, k), e in indices.second.items()]
    return entry


def _number(estimate: Estimate) -> dict[str, Any]:
    interval = {} if estimate.half != estimate.half else {"interval": [estimate.low, estimate.high]}
    return {"value": estimate.value, **interval}


def _write_csv(found: Sensitivity, path: Path) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEAD)
        for indices in found.indices:
            for row in _rows(indices, found.parameters):
                writer.writerow(row)


def _rows(indices: Indices, names: list[str]) -> Iterator[list[object]]:
    for key, estimates in indices.of.items():
        unit = "1" if key in ("S1", "ST") else indices.unit
        for k in indices.order():
            yield [indices.figure, unit, key, names[k], "", *_cells(estimates[k]), indices.blocks]
    for (j, k), estimate in indices.second.items():
        yield [indices.figure, "1", "S2", names[j], names[k], *_cells(estimate), indices.blocks]


def _cells(estimate: Estimate) -> list[str]:
    ends = [repr(estimate.low), repr(estimate.high)] if estimate.half == estimate.half else ["", ""]
    return [repr(estimate.value), *ends]
