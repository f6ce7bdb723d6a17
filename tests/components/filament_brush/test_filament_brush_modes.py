"""Mode shapes, centrifugal stiffness and base reactions of the filament against known solutions of the beam."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest
from helpers import ROOT, Measured
from lives import Instance, component
from machine_life import machine
from rovbrush.components.declare.layout import cells_shape, over
from rovbrush.components.declare.record import fields_of
from rovbrush.components.filament_brush.modes import stiffness
from rovbrush.components.filament_brush.reactions import base_reactions
from rovbrush.components.filament_brush.records import Constants, Load, Scratch, Stage, Stiffness
from rovbrush.components.python.kernels import compiled
from scipy.integrate import quad

DECLARED = component("filament_brush")
P = DECLARED.parameters()
REFERENCE = ROOT / "tests" / "reference"
LAMBDA = (1.875104068711961, 4.694091132974175, 7.854757438237613,
          10.995540734875467, 14.137168391046471, 17.278759532088237)  # fmt: skip


def brush(**parameters: Any) -> Instance:
    instance = Instance(DECLARED, machine(DECLARED.kernel), **parameters)
    instance.start()
    return instance


def printed_slope(lam: float, xi: float) -> float:
    """L Y_r' as Eq. 3 prints it; its cancellation costs about 1e-16 cosh(lam), harmless for three modes."""
    sigma = (np.sinh(lam) - np.sin(lam)) / (np.cosh(lam) + np.cos(lam))
    x = lam * xi
    return lam * (np.sinh(x) + np.sin(x) - sigma * (np.cosh(x) - np.cos(x)))


def test_eigenvalues_solve_the_frequency_equation(measured: Measured) -> None:
    measured("cantilever: error of lambda_1..6", np.abs(brush()["lambda_r"] - LAMBDA).max(), "1e-10")
    assert brush()["lambda_r"] == pytest.approx(LAMBDA, rel=1e-14)
    # cos x + 1/cosh x has slope 1 at its roots: the residual is the error of the root.
    assert np.max(np.abs(np.cos(brush()["lambda_r"]) + 1.0 / np.cosh(brush()["lambda_r"]))) < 1e-14


def test_natural_frequencies_follow_from_table_2(measured: Measured) -> None:
    seen = ", ".join(f"{omega:.2f}" for omega in brush()["omega_r"][:3])
    measured("cantilever: omega_1..3 [rad/s]", seen, "162.71, 1019.70, 2855.18")
    assert brush()["omega_r"][:3] == pytest.approx((162.71, 1019.70, 2855.18), abs=5e-3)


def test_added_mass_lowers_the_frequencies() -> None:
    ratio = brush(C_a=1.0)["omega_r"] / brush()["omega_r"]
    assert ratio == pytest.approx(np.sqrt(P.rho / (P.rho + P.rho_w)), rel=1e-14)


def test_slope_integrals_match_quadrature_of_the_printed_mode_shapes() -> None:
    instance = brush()
    r_A = instance["R_h"] * np.cos(P.alpha) / P.L
    for r in range(3):
        for s in range(3):

            def product(xi: float, r: int = r, s: int = s) -> float:
                return printed_slope(LAMBDA[r], xi) * printed_slope(LAMBDA[s], xi)

            def tensioned(xi: float, r: int = r, s: int = s) -> float:
                return product(xi, r, s) * (r_A * (1.0 - xi) + 0.5 * (1.0 - xi * xi))

            # products of modes have values around 20, quad is good to 1e-12 of that
            assert instance.arrays["G"][r, s] * P.L == pytest.approx(quad(product, 0.0, 1.0)[0], abs=1e-9)
            assert instance.arrays["S"][r, s] == pytest.approx(quad(tensioned, 0.0, 1.0)[0], abs=1e-9)


def test_slope_integrals_of_high_modes_are_symmetric_and_resolved() -> None:
    # For i = j: int Y'^2 dx L = sigma lam (2 + sigma lam), the closed form for a cantilever (Blevins 1979).
    sigma = np.array([compiled(DECLARED.kernel).mode_sigma(x) for x in LAMBDA])
    closed = sigma * np.array(LAMBDA) * (2.0 + sigma * np.array(LAMBDA))
    G = brush(N_m=6).arrays["G"] * P.L
    assert np.diag(G) == pytest.approx(closed, rel=1e-10)
    assert np.max(np.abs(G - G.T)) < 1e-12


def constants(**known: float) -> Constants:
    """Constants of a step, 0 unless known; of the length L."""
    return Constants(*[({"L": P.L} | known).get(name, 0.0) for name in fields_of(Constants)])


def stiffness_at(speed: float, instance: Instance) -> tuple[np.ndarray, float]:
    """K of six modes at a speed, with the bound on the frequencies."""
    K, s = np.zeros((6, 6)), instance.record(Scratch)
    k = over(Stiffness, None, {"K": K, "load": np.zeros(6)})
    p = dataclasses.replace(instance.parameters, N_m=6)
    return K, stiffness(0.0, k, p, constants(speed_2=speed**2, chi=1.0), s.modes, s.S)


@pytest.mark.parametrize("row", np.loadtxt(REFERENCE / "rotating_cantilever.csv", delimiter=",", skiprows=4).tolist())
def test_rotating_frequencies_match_the_reference_table(row: list[float], measured: Measured) -> None:
    # Zero hub radius: tips at R_brush = L. In the plane of rotation omega^2 is lower by Omega^2. Six modes.
    instance = brush(R_brush=P.L, alpha=0.0, N_m=6)
    unit = instance["omega_r"][0] / LAMBDA[0] ** 2
    speed = row[0] * unit
    K, _ = stiffness_at(speed, instance)
    in_plane = np.sort(np.linalg.eigvalsh(K))
    flap = np.sqrt(in_plane + speed**2) / unit
    for mode in (0, 1):
        error = flap[mode] / row[1 + mode] - 1.0
        measured(f"rotating cantilever: relative error of frequency {mode + 1}, six modes", error, "5e-3")
    assert flap[:2] == pytest.approx(row[1:3], rel=5e-3)


def test_frequency_bound_is_above_all_frequencies() -> None:
    instance = brush()
    for speed in (0.0, 15.7, 500.0):
        K, bound = stiffness_at(speed, instance)
        assert np.sqrt(np.max(np.linalg.eigvalsh(K))) <= bound


@pytest.mark.parametrize(("N_m", "share"), [(3, 1.207), (4, 0.843)])
def test_plain_base_shear_of_a_static_load_converges_slowly(N_m: int, share: float, measured: Measured) -> None:
    shear, _, _ = static_reactions(N_m, mode_acceleration=False)
    measured(f"statics: base shear over P by the plain sum of {N_m} modes", -shear, f"{share}")
    assert shear == pytest.approx(-share, abs=5e-4)  # in units of the load; the share is given to three digits


@pytest.mark.parametrize("N_m", range(1, 7))
def test_mode_acceleration_is_exact_in_statics(N_m: int, measured: Measured) -> None:
    shear, moment, deflection = static_reactions(N_m, mode_acceleration=True)
    measured("statics: relative error of the tip deflection, 1 to 6 modes", deflection - 1.0, "1e-6")
    measured("statics: relative error of the base shear, 1 to 6 modes", shear + 1.0, "1e-6")
    assert (shear, moment, deflection) == pytest.approx((-1.0, 1.0, 1.0), rel=1e-12)


def static_reactions(N_m: int, mode_acceleration: bool) -> tuple[float, float, float]:
    """Base shear, base moment and tip deflection under a tip load P, in units of P, P L and P L^3/(3 E I_zz)."""
    instance = brush(N_m=N_m)
    EI = P.E * np.pi * P.d**4 / 64.0
    m = P.rho * np.pi * P.d**2 / 4.0
    modes, load = instance.record(Scratch).modes, 0.01
    f = over(Stage, np.zeros(cells_shape(Stage)), {})
    f.eta[:N_m] = load * modes.Y_L[:N_m] / (m * P.L * modes.omega_r[:N_m] ** 2)
    p = dataclasses.replace(instance.parameters, bristles_per_filament=1.0, mode_acceleration=mode_acceleration)
    base = base_reactions(f, Load(0.0, load, 0.0), p, constants(M=m * P.L, chi=1.0, x_a=P.L), modes)
    return base.shear / load, base.moment / (load * P.L), base.y / (load * P.L**3 / (3.0 * EI))


def test_a_pressed_filament_at_rest_obeys_beam_statics(measured: Measured) -> None:
    # Linear beam, no friction, no rotation: the tip is loaded across by -F_n sin(psi) alone. After 0.6 s with half of
    # critical damping, exp(-0.5 * 163 * 0.6) is left of the transient.
    instance = Instance(
        DECLARED, machine(DECLARED.kernel), n=1, alpha=0.0, theta_b_0=0.2, zeta=(0.5,) * 6, foreshortening=False
    )
    instance.set(delta=6e-3, friction_scale=0.0)
    instance.values["k_v"] = 0.0
    instance.start()
    for _ in range(600):
        instance.step(1e-3)
    phi, F_n, F_f, deflection = (instance.arrays[f"filament_{key}"][0] for key in ("phi", "F_n", "F_f", "y"))
    load = -F_n * np.sin(phi)
    EI = P.bristles_per_filament * P.E * np.pi * P.d**4 / 64.0
    assert F_n > 1.0 and F_f == 0.0
    bending = deflection / (load * P.L**3 / (3.0 * EI)) - 1.0
    measured("pressed filament: relative error of the tip deflection", bending, "1e-6")
    measured("pressed filament: relative error of the base shear", instance["F_y_eq11"] / -load - 1.0, "1e-6")
    assert deflection == pytest.approx(load * P.L**3 / (3.0 * EI), rel=1e-6)
    assert instance["F_y_eq11"] == pytest.approx(-load, rel=1e-6)
    assert instance["M_b_eq12"] == pytest.approx(load * P.L, rel=1e-6)


def test_large_deflection_stays_close_to_the_elastica() -> None:
    # The bounds are the README's: linear bending is too soft, foreshortening of second order slightly too small.
    table = np.loadtxt(REFERENCE / "elastica_tip_load.csv", delimiter=",", skiprows=3)
    instance = brush(N_m=6)
    modes, G = instance.record(Scratch).modes, instance.arrays["G"]
    m = P.rho * np.pi * P.d**2 / 4.0
    EI = P.E * np.pi * P.d**4 / 64.0
    for row, softness, shortness in zip(table[:2], (0.03, 0.11), (0.012, 0.035), strict=True):
        eta = row[0] * EI / P.L**2 * modes.Y_L / (m * P.L * modes.omega_r**2)
        w = float(modes.Y_L @ eta) / P.L
        s = 0.5 * float(eta @ G @ eta) / P.L
        assert 1.0 < w / row[1] < 1.0 + softness
        assert 1.0 - shortness < s * (row[1] / w) ** 2 / row[2] < 1.0  # at equal deflection
