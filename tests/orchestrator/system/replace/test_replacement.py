"""An FMU with other names, units and directions in the place of a component: the rest of the system sees no change."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from helpers import edited, read_system
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.summary.energy import ledger
from rovbrush.orchestrator.results.tables import Run, require_complete
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import apply_changes
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.request import changes_of

PARTS = {
    "w": ("wave", "1 ms", {"c0": 0.3, "a": 2.0, "w": 9.0}),
    "g": ("gain", "5 ms", {"k": 2.0, "offset": 0.5, "count": 5, "weights": [0.25, 0.5]}),
    "x": ("integrator", "1 ms"),
}
WIRES = ["w.y -> g.u", "g.y -> x.u"]
RENAMED = {'name="u"': 'name="force"', 'name="y"': 'name="thrust"', 'name="weights[': 'name="shares['}
DEGREES = {
    "</UnitDefinitions>": '<Unit name="deg"><BaseUnit rad="1" factor="0.017453292519943295"/></Unit></UnitDefinitions>',
    'causality="output" variability="continuous" initial="calculated">\n\t\t\t<Real unit="1"/>': (
        'causality="output" variability="continuous" initial="calculated">\n\t\t\t<Real unit="deg"/>'
    ),
}


def swapped(tmp_path: Path, fmus: Path, xml: dict[str, str], mapping: str, **keys: object) -> Plan:
    """The plan with the gain replaced by one of another description."""
    read_system(tmp_path, fmus, PARTS, WIRES, stop="1 s", **keys)
    edited(fmus / "gain.fmu", tmp_path / "their.fmu", {}, xml)
    (tmp_path / "map.toml").write_text(mapping, encoding="utf-8")
    changes = changes_of([f"g={tmp_path / 'their.fmu'}"], [f"g={tmp_path / 'map.toml'}"], [])
    return make_plan(apply_changes(load_system(str(tmp_path / "case.toml"), fmus), changes))


def original(tmp_path: Path, fmus: Path, **keys: object) -> Run:
    return require_complete(simulate(make_plan(read_system(tmp_path, fmus, PARTS, WIRES, stop="1 s", **keys))))


@pytest.mark.parametrize("algorithm", ["jacobi", "gauss-seidel"])
def test_other_names_change_no_bit(algorithm: str, tmp_path: Path, fmus: Path) -> None:
    text = '[variables]\nu = "force"\ny = "thrust"\nweights = "shares"\n'
    plan = swapped(tmp_path, fmus, RENAMED, text, algorithm=algorithm)
    found, wanted = require_complete(simulate(plan)), original(tmp_path, fmus, algorithm=algorithm)
    assert [t.tobytes() for t in found.tables] == [t.tobytes() for t in wanted.tables]
    assert not plan.layout.foreign_inputs and not plan.layout.foreign_outputs


def test_both_directions_reversed_are_the_gain_with_the_other_offset(tmp_path: Path, fmus: Path) -> None:
    plan = swapped(tmp_path, fmus, {}, "[variables]\nu = { sign = -1 }\ny = { sign = -1 }\nheld = { sign = -1 }\n")
    signals = Signals(require_complete(simulate(plan)))
    np.testing.assert_allclose(signals["g.y"].values, 2.0 * signals["g.u"].values - 0.5, rtol=0, atol=1e-15)
    assert np.ptp(signals["g.y"].values) > 1.0


def test_units_are_converted_and_results_keep_ours(tmp_path: Path, fmus: Path) -> None:
    plan = swapped(tmp_path, fmus, DEGREES, "[variables]\nheld = ''\n")
    signals = Signals(require_complete(simulate(plan)))
    wanted = np.radians(2.0 * signals["g.u"].values + 0.5)  # their number of degrees as a plain number
    np.testing.assert_allclose(signals["g.y"].values, wanted, rtol=1e-15, atol=0)
    assert signals["g.y"].unit == "1"


def test_a_parameter_is_set_in_their_unit(tmp_path: Path, fmus: Path) -> None:
    xml = {'<Real unit="N"': '<Real unit="kN"', '<Unit name="N">': '<Unit name="kN"/><Unit name="N">'}
    plan = swapped(tmp_path, fmus, xml, "")
    assert plan.system.components["g"].parameters["offset"] == 0.5  # N
    signals = Signals(require_complete(simulate(plan)))
    np.testing.assert_allclose(signals["g.y"].values, 2.0 * signals["g.u"].values + 0.5e-3, rtol=1e-14)


def test_compiled_loop_and_interpreter_agree_on_what_crosses(tmp_path: Path, fmus: Path) -> None:
    plan = swapped(tmp_path, fmus, DEGREES, "[variables]\nheld = ''\nu = { sign = -1 }\n")
    runs = [require_complete(simulate(plan, interpreted)) for interpreted in (False, True)]
    assert [t.tobytes() for t in runs[0].tables] == [t.tobytes() for t in runs[1].tables]


def test_the_plan_tells_what_crosses_and_what_is_lost(tmp_path: Path, fmus: Path) -> None:
    xml = {
        'name="held"': 'name="warmth"',
        'name="count"': 'name="turns"',
        '<Boolean start="true"/>': '<Boolean start="false"/>',
        **RENAMED,
    }
    text = "[variables]\nu = { name = 'force', sign = -1 }\ny = 'thrust'\ncount = ''\nweights = 'shares'\n"
    shown = explain(swapped(tmp_path, fmus, xml, text))
    for line in (
        "their.fmu in place of gain.fmu, mapped by map.toml",
        "g.u is force, times -1",
        "g: their.fmu has no such parameter, its value is not used: count = 5",
        "g: their.fmu has no such output, it is not recorded: held",
        "'force' of their.fmu = g.u (times -1 plus 0)",
        "g.y is thrust",
        "g.on is False there, True here; theirs is kept",
    ):
        assert line in shown, shown


def test_an_input_that_they_do_not_have_takes_its_connection_along(tmp_path: Path, fmus: Path) -> None:
    plan = swapped(tmp_path, fmus, {'name="u"': 'name="force"'}, "[variables]\nu = ''\n[inputs]\nforce = 3.0\n")
    assert [c.label for c in plan.system.connections] == ["g.y -> x.u"]
    assert "g: their.fmu has no such input, the connection w.y -> g.u is left out" in explain(plan)
    signals = Signals(require_complete(simulate(plan)))
    assert set(signals["g.y"].values) == {6.5}


def test_reports_that_need_what_they_lack_are_left_out_and_told(tmp_path: Path, fmus: Path) -> None:
    system = read_system(tmp_path, fmus, PARTS, WIRES, stop="1 s")
    path = tmp_path / "case.toml"
    path.write_text(system.path.read_text() + '[summary]\nmean_held = "mean g.held"\nmean_y = "mean g.y"\n')
    edited(fmus / "gain.fmu", tmp_path / "their.fmu", {}, {'name="held"': 'name="warmth"'})
    (tmp_path / "map.toml").write_text("[variables]\nheld = ''\n")
    changes = changes_of([f"g={tmp_path / 'their.fmu'}"], [f"g={tmp_path / 'map.toml'}"], [])
    changed = apply_changes(load_system(str(path), fmus), changes)
    assert list(changed.reporting["summary"]) == ["mean_y"]
    assert "g: summary mean_held is left out, for want of g.held" in changed.components["g"].notes


def test_a_bond_sees_the_same_power(tmp_path: Path, fmus: Path) -> None:
    """The chassis of the quarter car with its force and speed counted the other way round."""
    parts = {"w": ("wheel", "1 ms"), "c": ("chassis", "5 ms")}
    wires = ["c.v_c -> w.v_c", "w.F -> c.F"]
    path = tmp_path / "case.toml"
    read_system(tmp_path, fmus, parts, wires, stop="200 ms")
    path.write_text(path.read_text() + '[[bonds]]\nname = "spring"\neffort = "c.F"\nflow = "w.v_c"\n')
    plain = load_system(str(path), fmus)
    (tmp_path / "map.toml").write_text("[variables]\nF = { sign = -1 }\nv_c = { sign = -1 }\nz_c = { sign = -1 }\n")
    changes = changes_of([f"c={fmus / 'chassis.fmu'}"], [f"c={tmp_path / 'map.toml'}"], [])
    runs = [require_complete(simulate(make_plan(system))) for system in (plain, apply_changes(plain, changes))]
    energies = [ledger(Signals(run), run.plan.system.bonds[0]) for run in runs]
    # The chassis is linear and starts at rest: mirrored twice it is the same.
    assert energies[0].flow_side == pytest.approx(energies[1].flow_side, rel=1e-12)
    assert abs(energies[0].flow_side) > 0


def test_all_that_is_missing_is_named_at_once(tmp_path: Path, fmus: Path) -> None:
    xml = {'name="u"': 'name="force"', 'name="y"': 'name="thrust"', 'name="k"': 'name="factor"'}
    with pytest.raises(InputError) as error:
        swapped(tmp_path, fmus, xml, "")
    lines = str(error.value).splitlines()
    for words in ("input 'force' that nothing drives", "no input 'u'", "no output 'y'", "no parameter 'k'"):
        assert sum(words in line for line in lines) == 1, words


def test_what_a_connection_and_a_bond_lack_is_named_once_as_what_it_is(tmp_path: Path, fmus: Path) -> None:
    """With the names that there are for it."""
    parts = {"w": ("wheel", "1 ms"), "c": ("chassis", "5 ms")}
    read_system(tmp_path, fmus, parts, ["c.v_c -> w.v_c", "w.F -> c.F"], stop="200 ms")
    path = tmp_path / "case.toml"
    path.write_text(path.read_text() + '[[bonds]]\nname = "spring"\neffort = "c.F"\nflow = "w.v_c"\n')
    fmu = edited(fmus / "chassis.fmu", tmp_path / "their.fmu", {}, {'name="F"': 'name="load"'})
    with pytest.raises(InputError) as error:
        apply_changes(load_system(str(path), fmus), changes_of([f"c={fmu}"], [], []))
    lines = [line for line in str(error.value).splitlines() if "'F'" in line]
    assert len(lines) == 1 and "has no input 'F', which the power bond spring needs; there are load" in lines[0]


def test_an_input_of_theirs_that_none_of_ours_stands_for_keeps_its_start_value(tmp_path: Path, fmus: Path) -> None:
    plan = swapped(tmp_path, fmus, {'name="u"': 'name="force"'}, "[variables]\nu = ''")
    notes = plan.system.components["g"].notes
    assert "g: nothing drives force = 0.0 of their.fmu: the start values are kept" in notes


def test_a_counter_that_they_do_not_have_leaves_the_usual_mean(tmp_path: Path, fmus: Path) -> None:
    """An error that says how to do without; then the mean is by the trapezoidal rule, and that is told."""
    parts = {"s": ("push", "1 ms"), "t": ("mass1", "5 ms")}
    edited(fmus / "push.fmu", tmp_path / "their.fmu", {}, {'name="p"': 'name="their_p"'})
    (tmp_path / "map.toml").write_text('[variables]\np = ""\n', encoding="utf-8")
    system = read_system(tmp_path, fmus, parts, ["s.F -> t.F (mean of s.p)"], stop="50 ms")
    with pytest.raises(InputError, match=r"no output 'p', which counts the mean of s\.F"):
        apply_changes(system, changes_of([f"s={tmp_path / 'their.fmu'}"], [], []))
    changes = changes_of([f"s={tmp_path / 'their.fmu'}"], [f"s={tmp_path / 'map.toml'}"], [])
    plan = make_plan(apply_changes(system, changes))
    assert "their.fmu has no p, the mean of s.F is by the trapezoidal rule" in explain(plan)
    usual = make_plan(read_system(tmp_path, fmus, parts, ["s.F -> t.F (mean)"], stop="50 ms"))
    found, wanted = (Signals(require_complete(simulate(p)))["t.F"].values for p in (plan, usual))
    assert found.tobytes() == wanted.tobytes()


def test_a_counter_that_a_bond_lacks_is_named(tmp_path: Path, fmus: Path) -> None:
    parts = {"w": ("wheel", "1 ms"), "c": ("chassis", "1 ms")}
    bond = {"name": "strut", "effort": "c.F", "flow": "w.v_c", "sign": -1.0, "impulse": "w.J"}
    system = read_system(tmp_path, fmus, parts, ["c.v_c -> w.v_c", "w.F -> c.F"], bonds=[bond])
    edited(fmus / "wheel.fmu", tmp_path / "their.fmu", {}, {'name="J"': 'name="their_J"'})
    with pytest.raises(InputError, match="no output 'J', which the power bond strut needs"):
        apply_changes(system, changes_of([f"w={tmp_path / 'their.fmu'}"], [], []))
