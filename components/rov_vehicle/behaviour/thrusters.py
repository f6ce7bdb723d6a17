"""What the thrusters do beyond Eq. 20: delay, dead band, published table, current, and loss near the hull."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...testing.behaviour import Unit, close, go_on, holds, read, run, same, values
from .at_rest import H
from .motion import POSE, VELOCITY

ONE = (1.0, 0, 0, 0, 0, 0, 0, 0)
AT_ONCE: dict[str, Any] = {"thruster_lag": 0.0}
# Newtons of the published table of September 2019: at 12 and 16 V and at these microseconds of pulse.
PULSES = (1100, 1300, 1400, 1600, 1700, 1800, 1900)
PUBLISHED = {
    12.0: (-28.48, -10.01, -3.11, 3.87, 12.54, 24.15, 36.42), 16.0: (-39.91, -14.10, -4.72, 5.92, 17.88, 33.54, 51.44)
}  # fmt: skip
ZERO_BAND = {12.0: (1464, 1536), 16.0: (1472, 1528)}


def thrust_at(unit: Unit, u: float, **more: Any) -> float:
    """Thrust of the first thruster a step after a constant command."""
    inputs = {"u_thruster": (u, 0, 0, 0, 0, 0, 0, 0), "V_thruster": more.pop("V", 12.0)}
    return float(run(unit, H, H, inputs, **AT_ONCE | more)["thrust"][0])


def test_thrust_is_that_of_the_published_table(unit: Unit) -> None:
    """With thrust_table the thrust at the published pulses is the published one, at 12 and at 16 V."""
    for V, newtons in PUBLISHED.items():
        for pulse, N in zip(PULSES, newtons, strict=True):
            seen = thrust_at(unit, (pulse - 1500) / 400, V=V, thrust_table=True)
            close(unit, f"thrust at {pulse} us and {V:g} V", seen, N, 1e-13)


def test_table_gives_no_thrust_within_its_dead_band(unit: Unit) -> None:
    """Between the published pulses of the zero band the thrust is 0, and a little beyond it is not."""
    for V, band in ZERO_BAND.items():
        for side, pulse in zip((-1.0, 1.0), band, strict=True):
            edge = (pulse - 1500) / 400
            same("thrust within", thrust_at(unit, edge - 1e-9 * side, V=V, thrust_table=True), 0.0)
            beyond = thrust_at(unit, edge + 0.02 * side, V=V, thrust_table=True) * side
            holds(0.0 < beyond < 0.1, f"{beyond:.3g} N at 8 us beyond the band")


def test_any_dead_band_of_the_table_gives_no_thrust_within(unit: Unit) -> None:
    """However many points of the table it holds: 0 within, then rising to the next point; none at rest."""
    for band in (0.0, 0.2, 0.25, 0.3, 0.5, 0.9):
        bands: dict[str, Any] = {"thrust_table": True, "dead_band_12V": band, "dead_band_16V": band}
        same("thrust at rest", thrust_at(unit, 0.0, **bands), 0.0)
        for side in (-1.0, 1.0):
            same("thrust at the edge", thrust_at(unit, side * band, **bands), 0.0)
            risen = [side * thrust_at(unit, side * u, **bands) for u in np.linspace(band, 1.0, 9)]
            holds(bool(np.all(np.diff(risen) > 0.0)), f"thrust falls somewhere behind a dead band of {band:g}")
            same("thrust at full command", thrust_at(unit, side, **bands), thrust_at(unit, side, thrust_table=True))


def test_thrust_of_the_table_rises_with_command_and_voltage(unit: Unit) -> None:
    """Between the points too, and from 8 to 18 V; forward thrust never turns into reverse thrust."""
    commands = np.linspace(-1.0, 1.0, 41)
    volts = (8.0, 10.0, 13.0, 16.0, 18.0)
    rows = np.array([[thrust_at(unit, u, V=V, thrust_table=True) for u in commands] for V in volts])
    holds(np.all(np.diff(rows, axis=1) >= 0.0), "thrust falls somewhere as the command rises")
    holds(np.all(np.diff(np.abs(rows), axis=0) >= 0.0), "thrust falls somewhere as the voltage rises")
    holds(np.all(rows * commands >= 0.0), "thrust against the command")
    same("thrust without voltage", thrust_at(unit, 1.0, V=0.0, thrust_table=True), 0.0)


def test_voltage_matters_with_the_table_only(unit: Unit) -> None:
    """k_T sgn(u) u^2 is that of one voltage, whatever V_thruster is."""
    same("thrust", thrust_at(unit, 0.7, V=8.0), thrust_at(unit, 0.7, V=16.0))


def test_small_commands_give_no_thrust_within_the_dead_band(unit: Unit) -> None:
    """Below thruster_dead_band nothing, above it the whole of k_T u^2."""
    forward, reverse = values(unit, "k_T_forward", "k_T_reverse")
    for u, expected in ((0.0749, 0.0), (-0.0749, 0.0), (0.0751, forward * 0.0751**2), (-0.0751, -reverse * 0.0751**2)):
        close(unit, "thrust", thrust_at(unit, u, thruster_dead_band=0.075), expected, 1e-13, 1.0)


def test_current_is_that_of_the_published_data(unit: Unit) -> None:
    """At full command 17 A at 12 V and 24 A at 16 V, nothing at rest; thrusters add up."""
    for V, full in ((12.0, 17.0), (16.0, 24.0)):
        for u in (1.0, -1.0):
            seen = run(unit, H, H, {"u_thruster": (u, 0, 0, 0, 0, 0, 0, 0), "V_thruster": V}, **AT_ONCE)
            close(unit, "current at full command", seen["i_thruster"], full, 0.01)
    one, all_ = (run(unit, 1.0, H, {"u_thruster": u, "V_thruster": 14.8}) for u in (ONE, (1.0,) * 8))
    close(unit, "current of eight", all_["i_thruster"], 8.0 * one["i_thruster"], 1e-12)
    same("current at rest", unit.new({})["i_thruster"], 0.0)


def test_current_follows_with_the_lag_of_the_thrust(unit: Unit) -> None:
    """1 - exp(-t/thruster_lag) of the steady current, whatever the steps."""
    steady = run(unit, H, H, {"u_thruster": ONE}, **AT_ONCE)["i_thruster"]
    for h in (5e-3, 1e-2):
        seen = run(unit, 0.02, h, {"u_thruster": ONE}, thruster_lag=0.02)
        close(unit, "current", seen["i_thruster"], steady * (1.0 - np.exp(-1.0)), 1e-12)


def commanded(unit: Unit, times: tuple[float, ...], **parameters: Any) -> np.ndarray:
    """Outputs at the end of steps that end at these times, commands being a function of the time alone."""
    seen = unit.new({}, **parameters)
    for t, after in zip((0.0, *times[:-1]), times, strict=True):
        k = np.floor(t / 0.02 + 1e-6)  # a controller at 50 Hz
        seen.set(u_thruster=np.sin(1.3 * k + np.arange(8.0)))
        seen.step(after - t)
    return read(seen, *POSE, *VELOCITY, "thrust", "i_thruster", "W_thruster")


def test_delay_is_the_same_for_any_communication_step(unit: Unit) -> None:
    """A delay that no step divides: steps of 20, 5 and 1 ms and unequal ones lead to the same motion and thrust."""
    grids = [np.arange(1, 1 + round(0.4 / h)) * h for h in (0.02, 0.005, 0.001)]
    grids.append(np.unique(np.concatenate([grids[0], 0.02 * np.arange(20) + 0.0137])))
    for delay in (0.0137, 0.05):
        ends = [commanded(unit, tuple(map(float, grid)), thruster_delay=delay, max_step=5e-4) for grid in grids]
        for end in ends[1:]:
            close(unit, "motion and thrust", end, ends[0], 1e-9)  # fourth order in other internal steps


def test_delayed_command_acts_when_its_time_has_come(unit: Unit) -> None:
    """Nothing until thruster_delay, then the lag from there on; a later command waits for its own time."""
    forward = unit.parameter("k_T_forward")
    seen = run(unit, 0.030, H, {"u_thruster": ONE}, thruster_delay=0.0325, thruster_lag=0.02)
    same("thrust before", seen["thrust"][0], 0.0)
    seen.set(u_thruster=(0.0,) * 8)
    go_on(seen, 0.030, H)
    close(unit, "thrust", seen["thrust"][0], forward * (1.0 - np.exp(-0.0275 / 0.02)), 1e-12)
    risen = forward * (1.0 - np.exp(-0.030 / 0.02))
    close(unit, "thrust", go_on(seen, 0.0125, 0.0125)["thrust"][0], risen * np.exp(-0.010 / 0.02), 1e-12)


def test_commands_on_their_way_are_part_of_the_state(unit: Unit) -> None:
    """Saved between the giving of a command and its acting, and restored, the same happens to the last bit."""
    seen = run(unit, 0.02, H, {"u_thruster": ONE}, thruster_delay=0.05)
    kept = seen.save()
    ends = []
    for other in (0.3, 0.9):
        seen.set(u_thruster=(other,) * 8)
        go_on(seen, 0.03, H)
        seen.restore(kept)
        seen.set(u_thruster=(0.5,) * 8)
        ends.append(go_on(seen, 0.1, H)["thrust"])
        seen.restore(kept)
    same("thrust", ends[1], ends[0])
    holds(ends[0][0] > 0.0, "no command has acted")


def test_more_commands_than_can_wait_are_not_lost(unit: Unit) -> None:
    """Where more than 128 changes are on their way, the last one still acts, and stays."""
    seen = unit.new({}, thruster_delay=0.5, **AT_ONCE)
    for k in range(400):
        seen.set(u_thruster=(0.001 * k,) * 8)
        seen.step(1e-3)
    seen.set(u_thruster=(0.6,) * 8)
    close(unit, "thrust", go_on(seen, 1.0, H)["thrust"], unit.parameter("k_T_forward") * 0.36, 1e-12)


def test_thrusters_lose_thrust_as_they_come_near_the_hull(unit: Unit) -> None:
    """Each keeps 1 - hull_loss exp(-d/hull_loss_length) of its thrust, d from it to the hull; force and power too."""
    r, d = (np.reshape(x, (8, 3)) for x in values(unit, "thruster_position", "thruster_direction"))
    plane = {"hull_point": (0.0, 0.0, 0.445), "hull_normal": (0, 0, -1), "hull_loss_length": 0.2}
    inputs = {"u_thruster": (0.5,) * 8}
    free, near = (run(unit, H, H, inputs, **AT_ONCE, **plane, hull_loss=loss) for loss in (0.0, 0.4))
    # The thrust is told at the end of the step, in which the vehicle moves by a tenth of a millimetre.
    kept = 1.0 - 0.4 * np.exp(-(0.445 - r[:, 2]) / 0.2)
    close(unit, "thrust", near["thrust"], free["thrust"] * kept, 1e-3)
    close(unit, "force", near["F_control"], near["thrust"] @ d, 1e-13)
    close(unit, "energy not accounted for", go_on(near, 1.0, H)["energy_residual"], 0.0, 1e-9, 10.0)


def test_loss_near_the_hull_fades_with_the_distance(unit: Unit) -> None:
    """Ten lengths off the hull there is none to speak of, and within it no more than hull_loss."""
    for z, expected in ((-10.0, 1.0), (3.0, 0.6)):
        seen = run(unit, H, H, {"u_thruster": ONE}, **AT_ONCE, hull_loss=0.4, position_start=(0.0, 0.0, z))
        close(unit, "thrust", seen["thrust"][0], expected * unit.parameter("k_T_forward"), 1e-9)
