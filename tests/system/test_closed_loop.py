"""The closed loop: vehicle, brush and controller act on each other, from the approach to leaving the hull."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from helpers import Measured
from matplotlib.image import imread
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.paper.angular_momentum import balance
from rovbrush.orchestrator.paper.strategies import BAND, MODES, force_on_hull, held, strategies
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.results.signals import Signals
from rovbrush.orchestrator.results.summary.summary import summarize
from rovbrush.orchestrator.results.tables import Run, require_complete
from rovbrush.orchestrator.run.planned import planned
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.assemble import assemble
from rovbrush.orchestrator.system.file.reader import load_system

Table = dict[str, dict[str, dict[str, float]]]
PID, FEEDFORWARD, FORCE, OBSERVED = MODES


@pytest.fixture(scope="module")
def hull_pass(fmus: Path) -> Run:
    return require_complete(simulate(planned(assemble("hull_pass_paper", {}, fmus=fmus))))


@pytest.fixture(scope="module")
def passed(hull_pass: Run) -> Signals:
    return Signals(hull_pass)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("strategies")


@pytest.fixture(scope="module")
def table(fmus: Path, folder: Path) -> Table:
    return strategies(folder, {}, fmus).merits


def test_pass_starts_five_centimetres_off_touches_cleans_a_metre_and_leaves(passed: Signals) -> None:
    delta, phase, way = (passed[name].values for name in ("vehicle.delta", "mission.phase", "mission.s"))
    assert delta[0] == pytest.approx(-0.05, abs=1e-12)
    assert np.all(delta[phase == 0.0] < -0.04)
    cleaning = phase == 3.0
    assert np.all(delta[cleaning] > 0.0)
    assert np.ptp(way[cleaning]) == pytest.approx(1.0, abs=0.01)
    assert passed["vehicle.v_rov"].values[cleaning].mean() == pytest.approx(0.05, rel=0.01)
    assert delta[-1] == pytest.approx(-0.1, abs=1e-3) and np.all(delta[phase == 7.0] < -0.05)
    # once on the hull it stays there until it is told to leave
    first = int(np.argmax(delta > 0.0))
    assert np.all(delta[first:][phase[first:] <= 4.0] > 0.0)


def test_water_moves_against_the_pass(hull_pass: Run) -> None:
    inputs = hull_pass.plan.system.components["vehicle"].inputs
    assert float(inputs["v_c[1]"]) > 0.0  # the pass goes along -x
    assert Signals(hull_pass)["vehicle.x_n"].values[-1] < -0.9


def test_reactions_have_the_signs_of_table_3(passed: Signals) -> None:
    window = passed["mission.phase"].values == 3.0
    means = {name: passed[f"vehicle.{name}"].values[window].mean() for name in ("F_x", "F_z", "M_y", "v_rov")}
    assert means["F_x"] < 0.0 and means["F_z"] < 0.0 and means["M_y"] < 0.0 and means["v_rov"] > 0.0


def test_energy_of_the_whole_system_is_accounted_for(hull_pass: Run, measured: Measured) -> None:
    summary = summarize(hull_pass)
    books, hub = summary["energy_balance"], abs(Signals(hull_pass)["brush.W_hub"].values[-1])
    measured("hull_pass: energy residual over what was supplied", summary["energy_balance_relative"], "1e-2")
    measured("hull_pass: energy residual over the work of the brush hub", abs(books["residual_J"]) / hub, "1e-3")
    measured("hull_pass: energy made by the coupling over the work of the hub", abs(books["coupling_J"]) / hub, "1e-3")
    assert summary["energy_balance_relative"] < 1e-2
    # No-load losses of the motor are most of the supply: the brush is the sharper measure.
    assert abs(books["residual_J"]) < 1e-3 * hub and abs(books["coupling_J"]) < 1e-3 * hub
    assert books["supplied_J"] > 1e4 and hub > 1e3


def test_angular_momentum_of_the_whole_system_is_accounted_for(hull_pass: Run, measured: Measured) -> None:
    """Against the impulses of thrusters, water, weight and hull over the whole pass."""
    books = balance(hull_pass)
    measured("hull_pass: angular momentum about three axes, over the largest impulse", books.relative(), "1e-5")
    assert books.relative() < 1e-5
    assert np.max(np.abs(books.contact)) > 100.0 and np.max(books.spin[:, 1]) > 9.0


def test_ledger_of_the_coupling_is_what_the_components_disagree_by(hull_pass: Run, passed: Signals) -> None:
    made = {name: entry["made_J"] for name, entry in summarize(hull_pass)["coupling_energy"].items()}
    last = {
        name: passed[name].values[-1] for name in ("motor.W_shaft", "brush.W_hub", "vehicle.W_tool", "brush.W_hull")
    }
    # The motor gives W_shaft, the brush takes W_hub; the vehicle takes W_tool, the brush gives -W_hull.
    assert made["brush shaft"] == pytest.approx(last["brush.W_hub"] - last["motor.W_shaft"], abs=0.05)
    tool = made["tool along the normal"] + made["tool along the hull"] + made["motor housing"]
    assert tool == pytest.approx(last["vehicle.W_tool"] + last["brush.W_hull"], abs=0.05)
    # The housing turns with the vehicle, of which the brush knows nothing: the torque times the pitch rate.
    torque, rate = passed["vehicle.M_y"], passed["vehicle.q"]
    steps = torque.values[1:] * 0.5 * (rate.values[1:] + rate.values[:-1]) * np.diff(rate.time)
    assert made["motor housing"] == pytest.approx(steps.sum(), rel=1e-12)


def test_halving_the_periods_changes_the_pass_little(fmus: Path, measured: Measured) -> None:
    # The transient of touching and the edge of the slime are in the window, not only the steady force.
    system = planned(assemble("fouling_patch", {}, "13 s", fmus)).system
    runs = [
        Signals(require_complete(simulate(make_plan(system.with_periods(f))))) for f in (Fraction(1), Fraction(1, 2))
    ]
    time = np.arange(4.0, 12.9, 0.02)
    for name, bound in (("vehicle.theta", 0.01), ("vehicle.delta", 0.01), ("vehicle.x_n", 0.01)):
        coarse, fine = (np.interp(time, s[name].time, s[name].values) for s in runs)
        scale = np.ptp(fine)
        change = float(np.sqrt(np.mean((coarse - fine) ** 2)) / scale)
        measured(f"fouling_patch: rms change of {name} by halving every period, over its range", change, f"{bound:g}")
        assert change < bound


def test_five_milliseconds_are_enough_for_the_vehicle(fmus: Path, hull_pass: Run, measured: Measured) -> None:
    system = hull_pass.plan.system
    slow = ("vehicle", "mission", "controller")
    fine = {k: replace(c, period=c.period / 4) if k in slow else c for k, c in system.components.items()}
    means = [summarize(hull_pass), summarize(require_complete(simulate(make_plan(replace(system, components=fine)))))]
    for key in ("F_z_mean", "F_x_mean", "T_brush_mean", "delta_mean", "v_rov_mean"):
        change = abs(means[1][key] / means[0][key] - 1.0)
        measured(f"hull_pass: change of {key} with the vehicle at 1.25 ms", change, "5e-3")
        assert change < 5e-3


@pytest.mark.evidence
def test_force_control_holds_the_force_where_the_thrusters_can(table: Table, measured: Measured) -> None:
    for name, columns in table.items():
        measured(
            f"{name}: share of contact within 10 % of the force, force control", columns[FORCE]["force_within"], "0.9"
        )
        assert columns[FORCE]["force_within"] >= 0.9
        assert columns[FORCE]["saturated"] < 0.01


@pytest.mark.evidence
def test_force_is_held_without_a_force_sensor(table: Table, measured: Measured) -> None:
    for name, columns in table.items():
        share = columns[OBSERVED]["force_within"]
        measured(f"{name}: share of contact within 10 % of the force, by the observer", share, "0.9")
        assert share >= 0.9 and columns[OBSERVED]["saturated"] < 0.01


@pytest.mark.evidence
def test_force_control_has_a_third_of_the_force_error_of_pid(table: Table, measured: Measured) -> None:
    for name, columns in table.items():
        ratio = columns[PID]["force_error"] / columns[FORCE]["force_error"]
        measured(f"{name}: force error of PID over that of force control", ratio, "3")
        assert ratio >= 3.0


@pytest.mark.evidence
def test_feedforward_halves_position_and_attitude_error_of_pid(table: Table, measured: Measured) -> None:
    columns = table["fouling_patch"]
    for key in ("position_error", "attitude_error"):
        ratio = columns[PID][key] / columns[FEEDFORWARD][key]
        measured(f"fouling_patch: {key} of PID over that with feedforward", ratio, "2")
        assert ratio >= 2.0


@pytest.mark.evidence
def test_every_strategy_balances_its_energy(table: Table) -> None:
    assert all(column["energy_balance"] < 1e-2 for columns in table.values() for column in columns.values())


@pytest.mark.evidence
def test_comparison_is_written_with_figures(table: Table, folder: Path) -> None:
    assert json.loads((folder / "strategies.json").read_text())["systems"] == table
    for name in table:
        assert imread(folder / f"strategies_{name}.png").min() < 0.5


def test_averaged_force_of_a_constant_is_that_constant(passed: Signals) -> None:
    time = passed["vehicle.delta"].time
    force, wanted = force_on_hull(passed, time), held(passed["mission.F_n_ref"], time)
    steady = (time > 15.0) & (time < 25.0)
    assert np.all(np.abs(force - wanted)[steady] < BAND * 40.0)


def test_without_thrust_the_vehicle_leaves_the_hull(fmus: Path, measured: Measured) -> None:
    run = require_complete(simulate(planned(assemble("no_thrust", {}, fmus=fmus))))
    summary = summarize(run)
    measured("no_thrust: time in contact [s]", summary["contact_time"], "0.5")
    measured("no_thrust: distance from the hull after 10 s [m]", -summary["delta_end"], "0.1")
    assert 0.0 < summary["contact_time"] < 0.5 and summary["delta_end"] < -0.1
    assert np.all(Signals(run)["vehicle.delta"].values[-1000:] < 0.0) and summary["F_z_mean"] == 0.0
    assert summary["energy_balance_relative"] < 1e-2


def test_constant_speed_overestimates_friction_that_rises(fmus: Path, measured: Measured) -> None:
    def friction(system: str, scale: float) -> tuple[float, float]:
        values = {"brush.friction_scale": scale}
        summary = summarize(require_complete(simulate(planned(assemble(system, values, "5 s", fmus)))))
        return summary["F_x_mean"], summary["T_brush_mean"]

    for scale, low, high in ((1.0, -0.01, 0.01), (2.0, 0.05, 0.30)):
        for name, motor, drive in zip(
            ("F_x", "T_brush"), friction("test_stand", scale), friction("constant_speed", scale), strict=True
        ):
            excess = drive / motor - 1.0
            measured(f"constant speed: excess of {name} at friction {scale:g}", excess, f"{low:g} to {high:g}")
            assert low <= excess <= high


def test_start_inside_the_hull_is_refused_before_time_zero(fmus: Path) -> None:
    with pytest.raises(
        InputError, match=r"starts inside the hull.*vehicle.delta = 0.025 m at time 0.*hull_pass_paper.toml"
    ):
        simulate(planned(assemble("hull_pass_paper", {"vehicle.position_start": [0.0, 0.0, 0.02]}, fmus=fmus)))
    with pytest.raises(InputError, match=r"starts inside the hull"):
        simulate(planned(assemble("fouling_patch", {"vehicle.hull_point": [0.0, 0.0, 0.3]}, fmus=fmus)))


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('value = "vehicle.delta"', 'value = "vehicle.delat"', r"require: 'vehicle.delat' is no output.*vehicle.delta"),
        ("maximum = 0.0", 'maximum = "0"', r"maximum = '0' must be a number"),
        ('flow = "vehicle.q"', 'flow = "brush.theta_b"', r"bond motor housing: flow = 'brush.theta_b' is no connected"),
        ("sign = -1.0", "sign = -2.0", r"bond tool along the hull: sign = -2.0 must be 1 or -1"),
        (
            'lost = [\n  "motor.W_copper"',
            'lost = [\n  "motor.W_coper"',
            r"balance lost: 'motor.W_coper' is not recorded",
        ),
        ("end = 26.0", 'end = "late"', r"end = 'late' is not a number"),
    ],
)
def test_slips_in_the_system_file_are_found_before_the_run(
    fmus: Path, tmp_path: Path, old: str, new: str, message: str
) -> None:
    shipped = load_system("hull_pass_paper", fmus).path
    text = shipped.read_text(encoding="utf-8")
    assert old in text
    (tmp_path / "case.toml").write_text(text.replace(old, new), encoding="utf-8")
    with pytest.raises(InputError, match=message):
        planned(assemble(str(tmp_path / "case.toml"), {}, fmus=fmus))
