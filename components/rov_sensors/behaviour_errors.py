"""Errors by chance and by digits: noise against its theory, samples that are lost, steps between readings."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..testing.behaviour import Unit, close, holds, read, same

COUNT = 2000  # samples
RATE = 100.0
NAMES = ("u_m", "v_m", "w_m", "p_m", "q_m", "r_m", "F_tool_m", "M_tool_m")  # twelve columns
SIGMA = np.repeat([0.01, 0.02, 0.5, 0.1], 3)
NOISE = {"rate_dvl": RATE, "rate_gyro": RATE, "rate_force": RATE, "noise_dvl": 0.01, "noise_gyro": 0.02,
         "noise_force": 0.5, "noise_moment": 0.1}  # fmt: skip
NOTHING = dict.fromkeys(("u", "v", "w", "p", "q", "r"), 0.0) | {"F_tool": np.zeros(3), "M_tool": np.zeros(3)}


def samples(unit: Unit, count: int, h: float = 1.0 / RATE, **parameters: Any) -> np.ndarray:
    """Readings of a vehicle that does not move, one row after each step, in standard deviations."""
    seen = unit.new(NOTHING, **NOISE | parameters)
    rows = []
    for _ in range(count):
        seen.step(h)
        rows.append(read(seen, *NAMES))
    return np.divide(rows, SIGMA)


def test_noise_has_the_mean_and_the_deviation_asked_for(unit: Unit) -> None:
    """Over 2000 samples mean and variance are those asked for, within five times what chance allows."""
    z = samples(unit, COUNT)
    chance = 5.0 / np.sqrt(COUNT)
    close(unit, "mean, in standard deviations", z.mean(axis=0), 0.0, chance, 1.0)
    close(unit, "variance", z.var(axis=0), 1.0, chance * np.sqrt(2.0), 1.0)


def test_noise_is_gaussian(unit: Unit) -> None:
    """Of 24000 numbers as many lie beyond one, two and three standard deviations as the normal distribution has."""
    z = np.abs(samples(unit, COUNT)).ravel()
    for limit, share in ((1.0, 0.3173105), (2.0, 0.0455003), (3.0, 0.0026998)):
        chance = 5.0 * np.sqrt(share * (1.0 - share) / z.size)
        close(unit, f"share beyond {limit:g} standard deviations", np.mean(z > limit), share, chance, 1.0)


def test_noise_of_one_channel_says_nothing_of_another_or_of_the_next_sample(unit: Unit) -> None:
    """Channels are not correlated with each other, nor samples with the ones before."""
    z = samples(unit, COUNT)
    both = np.corrcoef(np.hstack([z[1:], z[:-1]]).T)
    np.fill_diagonal(both, 0.0)
    # The largest of 276 correlations: chance gives 3.0 standard deviations.
    close(unit, "correlation", both.ravel(), 0.0, 5.0 / np.sqrt(COUNT), 1.0)


def test_seed_decides_the_noise(unit: Unit) -> None:
    """The same seed gives the same bits, another seed other ones in every sample."""
    one, again, other = (samples(unit, 50, seed=seed) for seed in (7, 7, 8))
    same("readings with the same seed", again, one)
    holds(not np.any(one == other), "two seeds have a reading in common")


def test_noise_does_not_depend_on_the_communication_step(unit: Unit) -> None:
    """Steps of a fifth, of one and of five sampling periods show the same bits at the same instants."""
    lost = {"dropout_dvl": 0.3}
    fine = samples(unit, 500, 0.002, **lost)
    same("readings with steps of 10 ms", samples(unit, 100, 0.01, **lost), fine[4::5])
    same("readings with steps of 50 ms", samples(unit, 20, 0.05, **lost), fine[24::25])


def test_noise_of_a_sensor_does_not_depend_on_the_others(unit: Unit) -> None:
    """What the others are set to changes no bit of a sensor's noise."""
    other = {"rate_gyro": 3.0, "noise_gyro": 0.0, "dropout_force": 0.5, "noise_depth": 1.0, "delay_force": 0.2}
    same("velocity", samples(unit, 50, **other)[:, :3], samples(unit, 50)[:, :3])


def test_readings_are_multiples_of_the_quantum(unit: Unit) -> None:
    """Every reading is the multiple of the quantum that is nearest to the truth."""
    seen = unit.new({"z_n": 0.0, "phi": 0.0}, quantum_depth=0.25, quantum_attitude=0.01)
    for z_n, phi in ((0.124, 0.004), (0.126, -0.006), (-3.3, 1.2345), (7.51, 3.0)):
        seen.set(z_n=z_n, phi=phi)
        same("depth", seen["z_n_m"], 0.25 * np.round(z_n / 0.25))
        close(unit, "roll angle", seen["phi_m"], 0.01 * np.round(phi / 0.01), 1e-15, 1.0)


def test_delayed_readings_without_samples_are_multiples_of_the_quantum(unit: Unit) -> None:
    """Between two instants too: the multiple that is nearest to the truth of the instant that is shown."""
    seen = unit.new({"z_n": 0.0}, quantum_depth=0.25, delay_depth=0.013)
    for k in range(200):
        seen.set(z_n=0.01 * k)
        seen.step(0.005)
        if k > 10:
            steps = 200.0 * (0.005 * k - 0.013)  # a held input is seen at the instant at which it was set
            holds(abs(seen["z_n_m"] - 0.01 * steps) <= 0.125 + 1e-9, f"{seen['z_n_m']} m where {0.01 * steps:g} m is")
            same("rest", seen["z_n_m"] % 0.25, 0.0)


def test_lost_samples_hold_the_last_one(unit: Unit) -> None:
    """Of 2000 samples the share asked for is lost, within five times what chance allows; the last one holds."""
    seen = unit.new({"z_n": 0.0}, rate_depth=RATE, dropout_depth=0.3)
    shown = [0.0]
    for k in range(COUNT):
        seen.set(z_n=float(k + 1))
        seen.step(1.0 / RATE)
        shown.append(seen["z_n_m"])
    numbers = np.array(shown)
    lost = numbers[1:] != np.arange(1, COUNT + 1)
    same("readings of lost samples", numbers[1:][lost], numbers[:-1][lost])
    close(unit, "share of lost samples", np.mean(lost), 0.3, 5.0 * np.sqrt(0.3 * 0.7 / COUNT), 1.0)


def test_a_sensor_that_loses_everything_shows_the_start(unit: Unit) -> None:
    """With all samples lost the reading of the start holds."""
    seen = unit.new({"z_n": 4.0}, rate_depth=RATE, dropout_depth=1.0)
    for k in range(20):
        seen.set(z_n=float(k))
        seen.step(0.01)
        same("depth", seen["z_n_m"], 4.0)
