"""A battery as an equivalent circuit: open-circuit voltage, resistance, one RC pair (Plett 2015, chapter 2)."""

from math import exp

from .parameters import Parameters
from .records import Inputs, Outputs, State


def capacity(p: Parameters) -> float:
    """Charge of the full battery."""
    return p.n_parallel * p.Q_cell


def resistance(p: Parameters) -> float:
    """Ohmic resistance between the terminals, R_0."""
    return p.n_series * p.R_cell / p.n_parallel + p.R_leads


def polarisation_resistance(p: Parameters) -> float:
    """Resistance of the RC pair, R_1."""
    return p.n_series * p.R_1_cell / p.n_parallel


def within(soc: float) -> float:
    """The state of charge where the table has it: between 0 and 1."""
    return min(max(soc, 0.0), 1.0)


def open_circuit_voltage(soc: float, p: Parameters) -> float:
    """From the table of ten equal intervals, straight between its points; beyond its ends the end."""
    place = 10.0 * within(soc)
    k = min(int(place), 9)
    V_oc = p.n_series * (p.V_cell[k] + (place - k) * (p.V_cell[k + 1] - p.V_cell[k]))  # Eq. B4
    return V_oc


def chemical_energy(soc: float, p: Parameters) -> float:
    """The integral of the open-circuit voltage over the charge, from empty."""
    area = 0.0
    for k in range(10):
        share = within(10.0 * soc - k)
        area += 0.1 * (p.V_cell[k] * share + 0.5 * share * share * (p.V_cell[k + 1] - p.V_cell[k]))
    beyond = (soc - within(soc)) * open_circuit_voltage(soc, p)
    E = capacity(p) * (p.n_series * area + beyond)  # Eq. B5
    return E


def stored_energy(x: State, p: Parameters) -> float:
    """Chemical energy, and that in the capacitance tau_1/R_1 of the RC pair at the voltage R_1*i_1."""
    return chemical_energy(x.soc, p) + 0.5 * p.tau_1 * polarisation_resistance(p) * x.i_1 * x.i_1


def initialize(p: Parameters, x: State) -> None:
    """At rest: no polarisation."""
    x.soc = p.soc_start
    x.i_1 = 0.0
    x.W_terminals = 0.0
    x.W_ohmic = 0.0
    x.W_polarisation = 0.0
    x.E_start = stored_energy(x, p)


def outputs(u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Write voltages, charge, powers and energies."""
    i = u.i + u.i_other
    y.V_oc = open_circuit_voltage(x.soc, p)
    y.V = y.V_oc - polarisation_resistance(p) * x.i_1 - resistance(p) * i  # Eq. B3
    y.soc = x.soc
    y.charge = capacity(p) * (p.soc_start - x.soc)
    y.P = y.V * i
    y.P_loss = resistance(p) * i * i + polarisation_resistance(p) * x.i_1 * x.i_1
    y.empty = 0.0
    V_min = p.n_series * p.V_cell_min
    if x.soc <= 0.0 or V_min >= y.V:
        y.empty = 1.0
    y.W_terminals = x.W_terminals
    y.W_ohmic = x.W_ohmic
    y.W_polarisation = x.W_polarisation
    y.E_stored = stored_energy(x, p)
    y.energy_residual = x.E_start - x.W_terminals - x.W_ohmic - x.W_polarisation - y.E_stored


def step(h: float, u: Inputs, p: Parameters, x: State, y: Outputs) -> None:
    """Advance by h with constant currents, exactly: the charge runs off evenly, i_1 decays towards the current."""
    i = u.i + u.i_other
    R_1 = polarisation_resistance(p)
    decay = exp(-h / p.tau_1)
    ahead = x.i_1 - i
    before = chemical_energy(x.soc, p)
    x.soc -= h * i / capacity(p)  # Eq. B1
    x.i_1 = i + ahead * decay  # Eq. B2
    mean = p.tau_1 * ahead * (1.0 - decay)  # integral of i_1 - i over the step
    square = 0.5 * p.tau_1 * ahead * ahead * (1.0 - decay * decay)  # that of its square
    ohmic = resistance(p) * i * i * h
    x.W_ohmic += ohmic
    x.W_polarisation += R_1 * (i * i * h + 2.0 * i * mean + square)
    x.W_terminals += before - chemical_energy(x.soc, p) - R_1 * i * (i * h + mean) - ohmic
    outputs(u, p, x, y)
