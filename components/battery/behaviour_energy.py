"""What a battery does with energy: losses, accounts, and what goes in and does not come out again."""

from __future__ import annotations

import numpy as np

from ..testing.behaviour import Unit, close, go_on, holds, read, run, values


def capacity(unit: Unit) -> float:
    """Charge of the full battery [A.s]."""
    n_parallel, Q_cell = values(unit, "n_parallel", "Q_cell")
    return float(n_parallel * Q_cell)


def resistances(unit: Unit) -> tuple[float, float]:
    """R_0 and R_1 between the terminals [Ohm]."""
    n_series, n_parallel, R_cell, R_1_cell, R_leads = values(
        unit, "n_series", "n_parallel", "R_cell", "R_1_cell", "R_leads"
    )
    return float(n_series * R_cell / n_parallel + R_leads), float(n_series * R_1_cell / n_parallel)


def test_energy_is_accounted_for(unit: Unit) -> None:
    """energy_residual stays 0 while loads come and go, whatever the step, past empty too."""
    seen = unit.new({"i": 0.0, "i_other": 0.0}, soc_start=0.12)
    for k, h in enumerate((1e-3, 0.7, 30.0, 120.0) * 5):
        seen.set(i=(90.0, -20.0, 30.0)[k % 3], i_other=4.0)
        seen.step(h)
    holds(seen["soc"] < 0.0, f"the battery was not emptied: soc = {seen['soc']:.4g}")
    close(unit, "energy not accounted for", seen["energy_residual"], 0.0, 1e-12, abs(seen["W_terminals"]))


def test_energy_delivered_is_the_integral_of_the_power(unit: Unit) -> None:
    """W_terminals grows at the rate P = V*(i + i_other), the losses at the rate P_loss."""
    seen = run(unit, 5.0, 0.5, {"i": 55.0, "i_other": 5.0}, soc_start=0.85)
    close(unit, "power", seen["P"], 60.0 * seen["V"], 1e-15)
    powers, before, h = [read(seen, "P", "P_loss")], _energies(seen), 0.02
    for _ in range(500):
        seen.step(h)
        powers.append(read(seen, "P", "P_loss"))
    grown = h * (np.sum(powers, axis=0) - 0.5 * (powers[0] + powers[-1]))
    # The trapezoidal rule at a thousandth of tau_1; the energies are sums of differences of a megajoule.
    close(unit, "energies", _energies(seen) - before, grown, 1e-8)


def _energies(seen: object) -> np.ndarray:
    """What was delivered, and what was lost."""
    W_terminals, W_ohmic, W_polarisation = read(seen, "W_terminals", "W_ohmic", "W_polarisation")  # type: ignore[arg-type]
    return np.array([W_terminals, W_ohmic + W_polarisation])


def test_stored_energy_is_that_of_the_open_circuit_voltage(unit: Unit) -> None:
    """E_stored at rest is Q times the area under V_oc from empty to soc."""
    V_cell, n_series = values(unit, "V_cell", "n_series")
    points = np.linspace(0.0, 1.0, 11)
    for soc in (0.0, 0.05, 0.5, 0.73, 1.0):
        fine = np.union1d(points[points <= soc], [soc])
        area = np.trapezoid(np.interp(fine, points, V_cell), fine)
        scale = capacity(unit) * n_series * float(np.mean(V_cell))
        expected = capacity(unit) * n_series * float(area)
        close(unit, "stored energy", unit.new({"i": 0.0}, soc_start=soc)["E_stored"], expected, 1e-13, scale)


def test_what_is_charged_does_not_all_come_out_again(unit: Unit) -> None:
    """Drawn for 60 s and charged back for 60 s, the battery has taken in more than it gave, by the losses."""
    seen = go_on(unit.new({"i": 40.0, "i_other": 0.0}, soc_start=0.5), 60.0, 1.0)
    seen.set(i=-40.0)
    go_on(seen, 60.0, 1.0)
    close(unit, "state of charge", seen["soc"], 0.5, 1e-12)
    holds(seen["W_terminals"] < 0.0, f"a round trip gave {seen['W_terminals']:.4g} J")
    holds(seen["W_ohmic"] > 0.0 and seen["W_polarisation"] > 0.0, "nothing was lost")


def test_losses_are_heat_whatever_the_direction(unit: Unit) -> None:
    """P_loss = R_0 i^2 at the start, when it is drawn from and when it is charged."""
    R_0, _ = resistances(unit)
    for i in (50.0, -20.0):
        close(unit, "loss", unit.new({"i": i, "i_other": 0.0}, soc_start=0.5)["P_loss"], R_0 * i * i, 1e-14)
