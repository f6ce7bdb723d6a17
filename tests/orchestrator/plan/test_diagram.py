"""The block diagram: every component and connection is in it, nothing lies on anything else, and names are text."""

from __future__ import annotations

import itertools
import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from xml.etree import ElementTree

import pytest
from helpers import rovbrush, system_text
from rovbrush.orchestrator.api import Model
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.fmu.mock import mock_fmu
from rovbrush.orchestrator.plan.diagram.blocks import flows_of, merged
from rovbrush.orchestrator.plan.diagram.draw import block_diagram
from rovbrush.orchestrator.plan.diagram.file import write_diagram
from rovbrush.orchestrator.plan.diagram.ink import shortened
from rovbrush.orchestrator.plan.diagram.labels import names_in
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.system.component import Component
from rovbrush.orchestrator.system.connection import Bond, Connection
from rovbrush.orchestrator.system.model import System

SVG = "{http://www.w3.org/2000/svg}"
HOSTILE = "<script>alert('&\"')</script>\x07"


def system_of(
    parts: Mapping[str, tuple[str, Sequence[str], Sequence[str]]], wires: Sequence[str], name: str = "case"
) -> System:
    """Components with period [s], inputs and outputs; `a.y -> b.u`."""
    components = {
        part: Component(part, mock_fmu(part, inputs=inputs, outputs=outputs), Fraction(period))
        for part, (period, inputs, outputs) in parts.items()
    }
    ends = [tuple(tuple(end.strip().split(".", 1)) for end in wire.split("->")) for wire in wires]
    connections = tuple(Connection(source, target) for source, target in ends)
    reporting = {"summary": {}, "balance": {}, "compare": [], "figures": []}
    return System(
        name, Path(f"{name}.toml"), "", Fraction(1), "gauss-seidel", (), components, connections, reporting=reporting
    )


def everybody_to_everybody(count: int) -> Plan:
    """The worst that there can be of so many components."""
    names = [f"component_{k}" for k in range(count)]
    parts = {name: ("1/100", [f"u_{other}" for other in names], [f"y_{other}" for other in names]) for name in names}
    wires = [f"{a}.y_{b} -> {b}.u_{a}" for a in names for b in names if a != b]
    return make_plan(system_of(parts, wires))


def boxes(svg: str) -> list[tuple[float, float, float, float]]:
    """Left, top, right and bottom of all blocks and labels."""
    found = ElementTree.fromstring(svg).iter(f"{SVG}rect")
    sides = [tuple(float(one.attrib[key]) for key in ("x", "y", "width", "height")) for one in found]
    return [(x, y, x + wide, y + high) for x, y, wide, high in sides]


@pytest.mark.parametrize("count", [2, 5, 12])
def test_no_box_lies_on_another_and_no_line_runs_through_one(count: int) -> None:
    svg = block_diagram(everybody_to_everybody(count))
    found = boxes(svg)
    assert len(found) == count + count * (count - 1)
    for a, b in itertools.combinations(found, 2):
        assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1], (a, b)
    width, height = (float(ElementTree.fromstring(svg).attrib[key]) for key in ("width", "height"))
    assert all(left >= 0 and top >= 0 and right <= width and bottom <= height for left, top, right, bottom in found)
    lines = re.findall(r"M([\d.]+) ([\d.]+)L([\d.]+) ([\d.]+)", svg)
    for x, y, u, v in (map(float, line) for line in lines):
        left, right, top, bottom = min(x, u), max(x, u), min(y, v), max(y, v)
        for box in found:
            inside = left < box[2] - 0.2 and right > box[0] + 0.2 and top < box[3] - 0.2 and bottom > box[1] + 0.2
            assert not inside, (box, (x, y, u, v))


def test_every_component_has_its_period_and_every_pair_its_transfers() -> None:
    parts = {
        "fast": ("1/2000", ["u"], ["y", "z"]),
        "slow": ("1/50", ["a", "b", "v[1]", "v[2]", "v[3]"], ["c"]),
        "array": ("1/50", [], ["w[1]", "w[2]", "w[3]"]),
    }
    wires = ["fast.y -> slow.a", "fast.z -> slow.b", "slow.c -> fast.u", *(f"array.w[{k}] -> slow.v[{k}]" for k in (1, 2, 3))]  # fmt: skip  # noqa: E501
    plan = make_plan(system_of(parts, wires))
    texts = [one.text for one in ElementTree.fromstring(block_diagram(plan)).iter(f"{SVG}text")]
    assert {"fast", "slow", "every 500 us", "every 20 ms", "y, z", "mean", "c", "hold", "w[1..3]"} <= set(texts)
    pairs = {(plan.order[f.source], plan.order[f.target]): f for f in flows_of(plan)}
    assert pairs["fast", "slow"].signals == (("mean", ("y", "z")),)
    assert pairs["slow", "fast"].signals == (("hold", ("c",)),)
    assert "fast.y -> slow.a: mean" in pairs["fast", "slow"].about


def test_where_a_power_bond_crosses_the_frame_is_thick() -> None:
    system = system_of({"a": ("1/100", ["F"], ["v"]), "b": ("1/100", ["v"], ["F"])}, ["a.v -> b.v", "b.F -> a.F"])
    bond = Bond("strut", ("b.F", "a.F"), ("a.v", "b.v"), 1.0)
    plan = make_plan(System(**{**vars(system), "bonds": (bond,)}))
    assert all(flow.bond for flow in flows_of(plan)) and "power bond strut" in block_diagram(plan)


def test_a_component_that_feeds_itself_is_drawn() -> None:
    plan = make_plan(system_of({"a": ("1/100", ["u"], ["y"]), "b": ("1/100", [], [])}, ["a.y -> a.u"]))
    assert len(boxes(block_diagram(plan))) == 3 and [f.source == f.target for f in flows_of(plan)] == [True]


def test_names_of_strangers_are_text() -> None:
    parts = {HOSTILE: ("1/100", ["u"], [f"y{HOSTILE}"]), "b": ("1/100", ["u" * 300], ["y"])}
    system = system_of(parts, [], HOSTILE)
    wires = (Connection((HOSTILE, f"y{HOSTILE}"), ("b", "u" * 300)), Connection(("b", "y"), (HOSTILE, "u")))
    model = Model(System(**{**vars(system), "connections": wires}))
    html = model._repr_html_()
    assert "<script" not in html and "alert(&#x27;&amp;&quot;" in html
    root = ElementTree.fromstring(html)
    assert {one.tag for one in root.iter()} == {"div", *(f"{SVG}{tag}" for tag in ("svg", "g", "title", "rect", "text", "path"))}  # fmt: skip  # noqa: E501
    assert float(next(root.iter(f"{SVG}svg")).attrib["width"]) < 900


def test_lines_and_words_take_the_colour_of_the_page() -> None:
    svg = block_diagram(everybody_to_everybody(2))
    words = [one.attrib["fill"] for one in ElementTree.fromstring(svg).iter(f"{SVG}text")]
    assert "currentColor" in words and "style" not in svg and "#000" not in svg and "#fff" not in svg


def test_a_file_of_its_own_has_a_background_for_light_and_dark(tmp_path: Path) -> None:
    path = write_diagram(everybody_to_everybody(2), tmp_path / "new" / "case.svg")
    style = next(ElementTree.parse(path).iter(f"{SVG}style")).text
    assert style is not None and "prefers-color-scheme:dark" in style and "background" in style


def test_many_names_are_counted_and_long_ones_shortened() -> None:
    assert names_in(["x", "y", "z"], 20) == "x, y, z"
    assert names_in([f"signal_{k}" for k in range(9)], 20) == "signal_0, +8"
    assert names_in(["a_very_long_name_of_one"], 12) == shortened("a_very_long_name_of_one", 12) == "a_very_…_one"
    assert merged(["u[1]", "u[2]", "u[3]", "v", "v", "w[2,3]"]) == ["u[1..3]", "v", "w[2,3]"]


def test_the_same_plan_is_the_same_picture() -> None:
    assert block_diagram(everybody_to_everybody(4)) == block_diagram(everybody_to_everybody(4))


@pytest.mark.parametrize("name", ["nominal.toml", "folder.svg", "picture", "x.png"])
def test_what_is_no_picture_is_not_written_over(name: str, tmp_path: Path) -> None:
    (tmp_path / "nominal.toml").write_text("kept")
    (tmp_path / "folder.svg").mkdir()
    with pytest.raises(InputError, match=r"is no name for a picture; take one that ends with \.svg"):
        write_diagram(everybody_to_everybody(2), tmp_path / name)
    assert (tmp_path / "nominal.toml").read_text() == "kept" and len(list(tmp_path.iterdir())) == 2


def test_plan_draws_it(fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "case.toml"
    path.write_text(system_text({"w": ("wave", "1 ms"), "i": ("integrator", "5 ms")}, ["w.y -> i.u"]))
    assert rovbrush(monkeypatch, "plan", path, "--fmus", fmus, "--svg", tmp_path / "case.svg") == 0
    assert "every 5 ms" in (tmp_path / "case.svg").read_text()
    assert rovbrush(monkeypatch, "plan", path, "--fmus", fmus, "--svg", path) == 2
    assert path.read_text().startswith("stop_time")
