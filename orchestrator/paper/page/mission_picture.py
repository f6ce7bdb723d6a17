"""Vehicle, brush and hull in motion, with force arrows and plots that follow: an interactive figure."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from .motion import Motion, seen

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

BOX = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
       (1, 5, 7), (1, 7, 3)]  # fmt: skip
PLOTS = (
    (("brush.F_z", "F_z", 1.0, "#6c3483"), ("brush.F_x", "F_x", 1.0, "#d68910")),
    (("vehicle.delta", "delta", 1e3, "#1f5f8b"),),
    (("motor.omega_b", "omega_b", 1.0, "#1f5f8b"),),
    (("vehicle.theta", "pitch", 57.29577951308232, "#1f5f8b"),),
)
# On a narrow screen the plots stand under the scene and its slider, not beside it; a screen that is turned changes it.
ON_A_PHONE = r"""
(function () {
  var plot = document.getElementById("{plot_id}"), narrow = window.matchMedia("(max-width: 800px)");
  var one = {height: 1120, "margin.t": 130, "scene.domain.x": [0, 1], "scene.domain.y": [0.56, 1],
    "legend.orientation": "h", "legend.y": 1.01, "legend.yanchor": "bottom", "legend.font.size": 10,
    "updatemenus[0].xanchor": "left", "updatemenus[0].y": 0.555, "sliders[0].y": 0.515,
    "sliders[0].x": 0, "sliders[0].len": 1,
    "scene.camera.eye": {x: 0.95, y: -1.75, z: 0.7}};
  ["", "2", "3", "4"].forEach(function (k, row) {
    one["xaxis" + k + ".domain"] = [0.16, 1];
    one["yaxis" + k + ".domain"] = [0.305 - 0.1 * row, 0.39 - 0.1 * row];
    one["yaxis" + k + ".title.font.size"] = 11;
  });
  var other = {};
  Object.keys(one).forEach(function (key) {
    other[key] = key.split(/[.[\]]+/).filter(String).reduce(function (at, name) {
      return at === undefined || at === null ? null : at[name] === undefined ? null : at[name]; }, plot.layout);
  });
  function lay() {
    plot.style.height = plot.parentElement.style.height = (narrow.matches ? one : other).height + "px";
    Plotly.relayout(plot, narrow.matches ? one : other);
  }
  narrow.addEventListener("change", lay);
  if (narrow.matches) { lay(); }
})();
"""
AXES = ("force [N]", "delta [mm]", "omega_b [rad/s]", "pitch [deg]")


def columns(points: np.ndarray) -> dict[str, list[float | None]]:
    """x, y, z of points, rounded to a tenth of a millimetre; a gap is None."""
    return {name: [None if np.isnan(v) else round(float(v), 4) for v in points[:, c]] for c, name in enumerate("xyz")}


def moving(motion: Motion, k: int) -> Iterator[dict[str, Any]]:
    """The coordinates of every moving trace at instant k, in the order of `mission_figure`."""
    yield columns(motion.box(k))
    yield columns(motion.brush(k))
    for which in ("brush", "thrust"):
        yield columns(motion.arrow(k, which))
        foot, head = motion.arrow(k, which)
        way = head - foot
        length = max(float(np.linalg.norm(way)), 1e-9)
        yield {**columns(head[None, :]), **{u: [float(v / length)] for u, v in zip("uvw", way, strict=True)}}
    for _ in PLOTS:
        yield {"x": [round(float(motion.time[k]), 4)] * 2}


def mission_figure(motion: Motion) -> Figure:
    """The animation with a time slider; four plots beside it with a line at the instant shown."""
    import plotly.graph_objects as go
    from plotly.subplots import make_subplots

    rows, shown = len(PLOTS), len(motion.time) // 2
    specs: list[list[dict[str, Any] | None]] = [
        [{"type": "scene", "rowspan": rows} if r == 0 else None, {"type": "xy"}] for r in range(rows)
    ]
    figure = make_subplots(rows=rows, cols=2, specs=specs, column_widths=[0.6, 0.4], vertical_spacing=0.05,
                           horizontal_spacing=0.07, shared_xaxes=True)  # fmt: skip
    box, brush, pull, pull_head, push, push_head, *cursors = moving(motion, shown)
    i, j, k = zip(*BOX, strict=True)
    path = seen(motion.position)
    traces = [
        go.Mesh3d(
            **box, i=i, j=j, k=k, color="#3c78b4", opacity=0.55, flatshading=True, name="vehicle", showlegend=True
        ),
        go.Scatter3d(**brush, mode="lines", line={"color": "#555", "width": 3}, name="brush"),
        *arrow_traces(pull, pull_head, "#c0392b", "brush force on the vehicle"),
        *arrow_traces(push, push_head, "#1e8449", "thrust"),
    ]
    hull = columns(motion.hull())
    still = [
        go.Mesh3d(**hull, i=[0, 0], j=[1, 3], k=[3, 2], color="#b9a37e", opacity=0.6, name="hull", showlegend=True),
        go.Scatter3d(**columns(path), mode="lines", line={"color": "#3c78b4", "width": 2, "dash": "dot"}, name="path"),
    ]
    for trace in (*traces, *still):
        figure.add_trace(trace, row=1, col=1)
    cursor_at, times = [], np.round(motion.time, 4).tolist()
    for row, (signals, cursor) in enumerate(zip(PLOTS, cursors, strict=True), start=1):
        drawn = [(label, factor * motion.average(name), color) for name, label, factor, color in signals]
        for label, values, color in drawn:
            line = go.Scatter(x=times, y=np.round(values, 4).tolist(), mode="lines", name=label, line={"color": color},
                              showlegend=len(drawn) > 1)  # fmt: skip
            figure.add_trace(line, row=row, col=2)
        low, high = min(float(v.min()) for _, v, _ in drawn), max(float(v.max()) for _, v, _ in drawn)
        cursor_at.append(len(figure.data))
        figure.add_trace(go.Scatter(x=cursor["x"], y=[low, high], mode="lines", showlegend=False, hoverinfo="skip",
                                    line={"color": "black", "width": 1}), row=row, col=2)  # fmt: skip
        figure.update_yaxes(title_text=AXES[row - 1], row=row, col=2)
    figure.update_xaxes(title_text="time [s]", row=rows, col=2)
    kinds = [type(trace) for trace in traces] + [go.Scatter] * rows
    indices = [*range(len(traces)), *cursor_at]
    figure.frames = [
        go.Frame(name=f"{t:.2f}", traces=indices,
                 data=[kind(**xyz) for kind, xyz in zip(kinds, moving(motion, n), strict=True)])
        for n, t in enumerate(motion.time)
    ]  # fmt: skip
    lay_out(figure, motion)
    return figure


def arrow_traces(line: dict[str, Any], head: dict[str, Any], color: str, name: str) -> list[Any]:
    """Shaft and head of an arrow."""
    import plotly.graph_objects as go

    return [
        go.Scatter3d(**line, mode="lines", line={"color": color, "width": 7}, name=name),
        go.Cone(**head, sizemode="absolute", sizeref=0.12, anchor="tip", colorscale=[[0, color], [1, color]],
                showscale=False, hoverinfo="skip"),
    ]  # fmt: skip


def lay_out(figure: Figure, motion: Motion) -> None:
    """Axes of fixed range, slider and buttons."""
    around = np.concatenate([seen(motion.position), motion.hull(), *(motion.brush(k)[:37] for k in (0, -1))])
    low, high = around.min(axis=0) - 0.15, around.max(axis=0) + 0.3
    scene = {
        f"{axis}axis": {"title": {"text": title}, "range": [float(low[c]), float(high[c])]}
        for c, (axis, title) in enumerate((("x", "north [m]"), ("y", "west [m]"), ("z", "up [m]")))
    }
    play: dict[str, Any] = {
        "frame": {"duration": 60, "redraw": True},
        "fromcurrent": True,
        "transition": {"duration": 0},
    }
    jump = {"mode": "immediate", "frame": {"duration": 0, "redraw": True}, "transition": {"duration": 0}}
    figure.update_layout(
        height=720, margin={"l": 10, "r": 20, "t": 30, "b": 10}, template="plotly_white", legend={"x": 0.0, "y": 1.0},
        scene={**scene, "aspectmode": "data", "camera": {"eye": {"x": 1.02, "y": -1.98, "z": 0.8}}},
        updatemenus=[{
            "type": "buttons", "direction": "left", "x": 0.0, "y": -0.02, "yanchor": "top", "showactive": False,
            "buttons": [
                {"label": "play", "method": "animate", "args": [None, play]},
                {"label": "pause", "method": "animate", "args": [[None], jump]},
            ],
        }],
        sliders=[{
            "active": len(figure.frames) // 2, "x": 0.17, "len": 0.83, "y": -0.02, "yanchor": "top",
            "currentvalue": {"prefix": "time [s]: "},
            "steps": [{"label": frame.name, "method": "animate", "args": [[frame.name], jump]}
                      for frame in figure.frames],
        }],
    )  # fmt: skip
