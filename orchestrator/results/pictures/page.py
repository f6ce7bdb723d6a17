"""One HTML file that needs no network: signals that can be zoomed, with a table of figures of merit.

A ripple that is too fast to be seen is its mean in a band; a few lines of script show its samples where there is room.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...errors import InputError
from ...markup import element, safe
from ..signals import Signal
from .bands import COLUMNS, READABLE, band, ripple
from .comparison import MOST, Comparison, remarks
from .overview import Choice
from .shown import Shown, shown
from .traces import Traces

LARGEST = 40_000  # samples of a signal in a page; of more the extremes of short times are kept
TOGETHER, LEAST = 60_000, 1_500  # of all signals of a page; and what each has however many there are
EXACT = 1e-4  # of what a signal ranges over: numbers of half the length may be so far off
PANEL, GAP, HEAD = 190, 62, 70  # pixels: height of an axis, room for the legend above it, room above all
COLOURS = ("#1f77b4", "#ff7f0e", "#2ca02c", "#d62728", "#9467bd", "#8c564b", "#e377c2", "#7f7f7f", "#bcbd22", "#17becf")
DASHES = ("solid", "dash", "dashdot", "dot")
STYLE = """body{font:15px/1.4 system-ui,sans-serif;margin:1rem auto;max-width:1100px;padding:0 .7rem;color:#222}
h1{font-size:1.25rem}table{border-collapse:collapse;display:block;overflow-x:auto}
td,th{padding:.2rem .6rem;border-bottom:1px solid #ddd;text-align:right;white-space:nowrap}
th{white-space:normal;vertical-align:bottom}
td:first-child,th:first-child{text-align:left;position:sticky;left:0;background:#fff}p{color:#666;font-size:.85rem}
@media(max-width:600px){table{font-size:.72rem}td,th{padding:.15rem .3rem}
td:first-child{white-space:normal;overflow-wrap:anywhere;min-width:6rem}}"""
CLOSER = """var page = document.getElementById('{plot_id}'), wanted = %s;
function closer() {
  var range = page._fullLayout.xaxis.range, width = range[1] - range[0];
  var raw = wanted.filter(function (w) { return (width < w.width) !== w.raw; });
  if (!raw.length) return;
  var at = [], seen = [];
  raw.forEach(function (w) {
    w.raw = !w.raw;
    w.band.forEach(function (k) { at.push(k); seen.push(!w.raw); });
    at.push(w.line); seen.push(w.raw);
  });
  Plotly.restyle(page, {visible: seen}, at);
}
page.on('plotly_relayout', closer);"""


@dataclass(frozen=True)
class Panel:
    """One axis of the page: signals, what each is called, and the unit in which they are read."""

    label: str
    signals: Sequence[Signal]
    names: Sequence[str]
    read: Shown
    first: int = 0  # colour


def signals_page(found: Traces, choice: Choice) -> str:
    """The page of a result: the rows that were chosen. Raises InputError without plotly, or where there are none."""
    choice.require_rows(found)
    panels = [Panel(r.label, r.signals, [s.name for s in r.signals], r.read) for r in choice.rows]
    below = [element("p", safe(line)) for line in choice.words(found)]
    return html(found.title, [plot_html(panels), *below])


def comparison_page(found: Comparison) -> str:
    """The page of a comparison: the table, then each signal with its difference below it."""
    panels: list[Panel] = []
    drawn = found.compared if found.asked else found.compared[: 2 * MOST]
    for one in drawn:
        read = shown(one.signals[0].unit, [s.values for s in one.signals])
        small = shown(one.signals[0].unit, [d.values for d in one.differences])
        panels.append(Panel(read.label(one.name), one.signals, found.labels, read))
        names = [f"{label} less {found.labels[0]}" for label in found.labels[1:]]
        panels.append(Panel(small.label("difference"), one.differences, names, small, 1))
    below = [element("p", safe(line)) for line in remarks(found, len(drawn))]
    picture = [plot_html(panels)] if panels else [element("p", "all signals are equal")]
    return html(" and ".join(found.labels), [merits_table(found), *picture, *below])


def merits_table(found: Comparison) -> str:
    """Figures of merit with units, of each result, and what the others differ by from the first."""
    heads = ["", "unit", *found.labels, *(f"{label} less {found.labels[0]}" for label in found.labels[1:])]
    lines = [element("tr", [element("th", safe(head)) for head in heads])]
    for row in found.merits:
        cells = [row["name"], row["unit"], *map(number, row["values"]), *map(signed, row["differences"])]
        lines.append(element("tr", [element("td", safe(cell)) for cell in cells]))
    return element("table", lines) if found.merits else ""


def number(value: float | None) -> str:
    """Six digits; a dash for none."""
    return "-" if value is None else f"{value:.6g}"


def signed(value: float | None) -> str:
    """A difference, with its sign."""
    return "-" if value is None else f"{value:+.4g}" if value else "0"


def html(title: str, content: Sequence[str]) -> str:
    """The whole file."""
    head = '<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
    head += element("title", safe(title)) + element("style", STYLE)
    body = element("h1", safe(title)) + "".join(content)
    return f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head><body>{body}</body></html>\n'


def require_plotly() -> None:
    """Raise InputError with what to type where plotly is not installed."""
    try:
        import plotly.graph_objects  # noqa: F401
    except ImportError:
        raise InputError("a page that can be zoomed needs plotly: pip install 'rovbrush[report]'") from None


def plot_html(panels: Sequence[Panel]) -> str:
    """The panels one above the other over one time, with the script that they need."""
    require_plotly()
    import plotly.graph_objects as go
    import plotly.io
    from plotly.subplots import make_subplots

    height = HEAD + len(panels) * (PANEL + GAP)
    gap = GAP / (height - HEAD) if len(panels) > 1 else 0.0
    figure = make_subplots(rows=len(panels), cols=1, shared_xaxes=True, vertical_spacing=gap)
    most = max(LEAST, min(LARGEST, TOGETHER // sum(len(panel.signals) for panel in panels)))
    closer: list[dict[str, Any]] = []
    layout: dict[str, Any] = {}
    for row, panel in enumerate(panels, start=1):
        legend = f"legend{row}" if row > 1 else "legend"
        axis = figure.layout[f"yaxis{row}" if row > 1 else "yaxis"]
        layout[legend] = {"orientation": "h", "x": 0, "y": axis.domain[1], "yanchor": "bottom", "font": {"size": 11}}
        for k, (signal, name) in enumerate(zip(panel.signals, panel.names, strict=True)):
            style = {"color": COLOURS[(panel.first + k) % len(COLOURS)], "dash": DASHES[k % len(DASHES)]}
            traces, entry = signal_traces(signal, name, panel.read.factor, style, len(figure.data), most)
            for trace in traces:
                figure.add_trace(go.Scatter(**trace, legend=legend), row=row, col=1)
            closer += [entry] if entry else []
        figure.update_yaxes(title_text=safe(panel.label), title_font_size=12, row=row, col=1)
    figure.update_xaxes(title_text="time [s]", row=len(panels), col=1)
    layout |= {"margin": {"l": 70, "r": 10, "t": HEAD, "b": 45}, "height": height}
    figure.update_layout(hovermode="x", template="plotly_white", showlegend=True, **layout)
    script = CLOSER % json.dumps(closer).replace("</", "<\\/")
    config = {"displaylogo": False, "responsive": True, "scrollZoom": False}
    text: str = plotly.io.to_html(figure, config=config, full_html=False, include_plotlyjs=True, post_script=[script])
    return text


def signal_traces(
    signal: Signal, name: str, factor: float, style: Mapping[str, str], first: int, most: int = LARGEST
) -> tuple[list[dict[str, Any]], dict[str, Any] | None]:
    """What draws a signal; and of one with a ripple which of it to show at which width of the time axis."""
    about = {"name": safe(name), "legendgroup": f"{first}", "mode": "lines"}
    if signal.values.dtype.kind not in "fiub":
        texts = [value.hex() if isinstance(value, bytes) else str(value) for value in signal.values.tolist()]
        return [{**about, "x": signal.time, "y": list(map(safe, texts)), "line": {**style, "shape": "hv"}}], None
    values = factor * signal.values.astype(float)
    finite = np.isfinite(values)
    found = band(signal.time[finite], values[finite]) if np.count_nonzero(finite) > 1 else None
    swings = ripple(signal.time[finite], values[finite]) if found else None
    shape = "linear" if signal.values.dtype.kind == "f" else "hv"
    time, kept = thinned(signal.time, values, most)
    line = {**about, "x": time, "y": compact(kept), "line": {**style, "width": 1.3, "shape": shape}}
    if found is None or swings is None:
        return [line], None
    edge = {"legendgroup": about["legendgroup"], "mode": "lines", "showlegend": False, "hoverinfo": "skip"}
    red, green, blue = (int(style["color"][k : k + 2], 16) for k in (1, 3, 5))
    fill = {"fill": "tonexty", "fillcolor": f"rgba({red},{green},{blue},0.25)"}
    traces: list[dict[str, Any]] = [
        {**edge, "x": found.time, "y": compact(found.least), "line": {"width": 0}},
        {**edge, "x": found.time, "y": compact(found.largest), "line": {"width": 0}, **fill},
        {**about, "x": found.time, "y": compact(found.mean), "line": {**style, "width": 1.6}},
        {**line, "name": f"{about['name']}, samples", "visible": False, "showlegend": False, "opacity": 0.7},
    ]
    width = COLUMNS / READABLE * swings.period
    return traces, {"width": width, "raw": False, "band": [first, first + 1], "line": first + 3}


def thinned(time: np.ndarray, values: np.ndarray, most: int = LARGEST) -> tuple[np.ndarray, np.ndarray]:
    """At most `most` samples: the least and the largest of each short time, in their order."""
    if len(time) <= most:
        return time, values
    size = 2 * len(time) // most + 1
    whole = len(time) // size * size
    folded = np.where(np.isfinite(values[:whole]), values[:whole], 0.0).reshape(-1, size)
    firsts = np.arange(0, whole, size)
    places = np.sort(np.stack([firsts + folded.argmin(axis=1), firsts + folded.argmax(axis=1)], axis=1), axis=1).ravel()
    places = np.unique(np.concatenate([[0], places, np.arange(whole, len(time))]))
    return time[places], values[places]


def compact(values: np.ndarray) -> np.ndarray:
    """Numbers of half the length, where nobody could see the difference."""
    finite = values[np.isfinite(values)]
    with np.errstate(over="ignore"):
        small = finite.astype(np.float32)
    if not len(finite) or np.max(np.abs(small - finite)) > EXACT * np.ptp(finite):
        return values
    short: np.ndarray = values.astype(np.float32)
    return short
