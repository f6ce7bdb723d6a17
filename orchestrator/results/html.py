"""A result as a notebook shows it: did it reach its end, its figures of merit with units, its signals in small."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..markup import boxed, element, safe, table
from .spark import spark

if TYPE_CHECKING:
    import numpy as np
    import xarray

    from .result import Result

SIGNALS = 8  # that are drawn
MOST_ROWS = 5_000_000  # of a signal that is drawn: a notebook should not wait for it
TIMES = {"simulated_s": "{:.4g} s simulated", "wall_s": "computed in {:.3g} s"}
RED, GREEN = "#c2372d", "#2a9d64"  # legible on white and black


def result_html(result: Result) -> str:
    """All texts are escaped; lines and words take the colour of the page."""
    summary = result.summary
    return boxed(_head(result, summary), _merits(result, summary), _signals(result), _foot(result))


def _head(result: Result, summary: dict[str, Any]) -> str:
    complete = bool(summary.get("complete"))
    said = element("span", "complete" if complete else "incomplete", style=f"color:{GREEN if complete else RED}")
    spans = [words.format(summary[key]) for key, words in TIMES.items() if isinstance(summary.get(key), float)]
    lines = [element("b", safe(result.title)), f" {said}", safe("".join(f" · {text}" for text in spans))]
    why = summary.get("failure") or summary.get("ended") or ""
    if summary.get("steady") is False:
        lines.append(safe(" · not steady: no verdict"))
    problem = element("div", safe(why), style=f"color:{RED}" if summary.get("failure") else "") if why else ""
    return element("div", lines) + problem


def _merits(result: Result, summary: dict[str, Any]) -> str:
    """Figures of merit, beside their references where the system file states some."""
    named = {str(row["label"]): row for row in result.comparison}
    rows = [
        [safe(name), number(summary[name]), safe(_unit(unit))]
        for name, unit in result.units.items()
        if isinstance(summary.get(name), (int, float))
    ]
    parts = [table(("figure of merit", "value", "unit"), rows, (0, 2))] if rows else []
    if named:
        compared = [
            [safe(label), number(row["value"]), number(row["reference"]), safe(_unit(str(row["unit"]))), _verdict(row)]
            for label, row in named.items()
        ]
        parts.append(table(("compared", "value", "reference", "unit", ""), compared, (0, 3, 4)))
    return "".join(parts)


def _verdict(row: dict[str, Any]) -> str:
    within = row.get("within")
    if within is None:
        return ""
    return element("span", "within" if within else "outside", style=f"color:{GREEN if within else RED}")


def _signals(result: Result) -> str:
    known = {str(name): data[name] for data in result.datasets.values() for name in data}
    drawn = [name for name in result.shown if name in known]
    drawn += [name for name in known if name not in drawn]
    drawn = sorted(drawn[: 4 * SIGNALS], key=lambda name: _is_constant(known[name].values))  # what happens comes first
    rows = [_signal(name, known[name]) for name in drawn[:SIGNALS]]
    return table(("signal", "lowest", "highest", "at the end", "unit", ""), rows, (0, 4, 5)) if rows else ""


def _is_constant(values: np.ndarray) -> bool:
    return not values.size or bool((values == values[0]).all())


def _signal(name: str, data: xarray.DataArray) -> list[str]:
    values, unit = data.values, safe(_unit(str(data.attrs.get("units", ""))))
    if not values.size:
        return [safe(name), "", "", "", unit, ""]
    if values.dtype.kind not in "fiub":
        return [safe(name), "", "", safe(str(values[-1])[:20]), unit, ""]
    drawn = spark(data["time"].values, values) if values.size <= MOST_ROWS else ""
    return [safe(name), number(values.min()), number(values.max()), number(values[-1]), unit, drawn]


def _foot(result: Result) -> str:
    count = sum(len(data) for data in result.datasets.values())
    where = f"saved in {result.folder}" if result.folder else 'not saved: result.save("DIR")'
    rates = ", ".join(result.datasets)
    words = f'{count} signals ({rates}), each by result["NAME"]; {where}'
    return element("div", safe(words), style="opacity:0.75;font-size:90%")


def number(value: Any) -> str:
    """A number as a person reads it."""
    return safe(f"{float(value):.5g}" if not isinstance(value, bool) else value)


def _unit(unit: str) -> str:
    return "" if unit == "1" else unit
