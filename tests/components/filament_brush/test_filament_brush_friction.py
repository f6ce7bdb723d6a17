"""The friction laws that keep the static peak: smoothed Eq. 9 with its peak (1) and LuGre (2)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from lives import Instance, component
from machine_life import machine
from rovbrush.components.filament_brush.contact import growth_of_contact
from rovbrush.components.library.friction import lugre, stribeck, stribeck_with_peak
from scipy.integrate import solve_ivp

DECLARED = component("filament_brush")
KERNEL = machine(DECLARED.kernel)
SIGMA_0, SIGMA_1 = 1e4, 1.0


def laws(number: int) -> np.ndarray:
    """Rows of mu_s >= mu_c, v_0, v_eps: 0.05 to 3, down to 0, and 1e-4 to 1 m/s."""
    draw = np.random.default_rng(15)
    mu_s = draw.uniform(0.05, 3.0, number)
    return np.column_stack(
        [mu_s, mu_s * draw.uniform(0.0, 1.0, number), *(10.0 ** draw.uniform(-4.0, 0.0, (2, number)))]
    )


def test_smoothing_as_the_paper_eats_the_static_peak_and_the_kept_one_is_mu_s() -> None:
    v = np.linspace(0.0, 0.3, 30001)
    assert max(stribeck(x, 0.6, 0.4, 0.05, 0.044149, 0.02)[0] for x in v) == pytest.approx(0.517, abs=5e-4)
    assert max(stribeck_with_peak(x, 0.6, 0.4, 0.05, 0.0, 0.02)[0] for x in v) == 0.6


def test_largest_coefficient_is_mu_s_exactly_for_any_parameters() -> None:
    for mu_s, mu_c, v_0, v_eps in laws(300):
        near = v_eps * (1.0 + np.arange(-40, 41) * 2.0**-52)  # as rounding may have it
        speeds = np.concatenate([near, np.geomspace(1e-6, 50.0, 200)])
        found = [stribeck_with_peak(float(x), mu_s, mu_c, v_0, 0.0, v_eps)[0] for x in (*speeds, *-speeds)]
        assert max(found) == mu_s
        assert min(found) == -mu_s
        assert stribeck_with_peak(float(v_eps), mu_s, mu_c, v_0, 0.0, v_eps)[0] == mu_s


def test_kept_peak_is_smooth_and_its_slope_is_that_of_the_law() -> None:
    for mu_s, mu_c, v_0, v_eps in laws(100):
        for k_v in (0.0, 0.1):
            law = (mu_s, mu_c, v_0, k_v, v_eps)
            d = 1e-6 * min(v_0, v_eps)
            for v_s in (0.0, 0.3 * v_eps, -0.9 * v_eps, v_eps, 1.1 * v_eps, v_eps + 0.7 * v_0, v_eps + 3.0 * v_0):
                right, left = (stribeck_with_peak(v_s + side, *law)[0] for side in (d, -d))
                slope = stribeck_with_peak(v_s, *law)[1]
                scale = mu_s / min(v_0, v_eps)
                assert abs(right - left) / (2.0 * d) <= slope + 1e-5 * scale + 1e-12
                falls = 2.0 * k_v if abs(v_s) > v_eps else 0.0  # the bound adds a fall and a rise by their size
                assert slope <= abs(right - left) / (2.0 * d) + falls + 1e-5 * scale


def bent(v_of: Callable[[float], float], growth_of: Callable[[float], float], end: float, z: float = 0.0) -> np.ndarray:
    """Rows of t, F_f/F_n without k_v, z, for a sliding speed and a growth of the normal force over time."""

    def law(t: float, z: float) -> tuple[float, float, float, float, float]:
        return lugre(v_of(t), z, max(growth_of(t), 0.0), 0.6, 0.4, 0.05, SIGMA_0, SIGMA_1)

    t = np.linspace(0.0, end, 4001)
    found = solve_ivp(lambda t, z: [law(t, float(z[0]))[1]], (0.0, end), [z], "Radau", t, rtol=1e-9, atol=1e-14)
    assert found.success
    return np.array([(at, law(at, float(z))[0], z) for at, z in zip(t, found.y[0], strict=True)])


@pytest.mark.parametrize("v_s", [0.001, 0.05, 2.0, -0.05])
def test_lugre_slides_as_equation_9(v_s: float) -> None:
    expected = np.sign(v_s) * (0.4 + 0.2 * np.exp(-((v_s / 0.05) ** 2)))
    settled = 25.0 * 0.6 / (SIGMA_0 * abs(v_s))  # time constants of z
    assert bent(lambda t: v_s, lambda t: 0.0, settled)[-1, 1] == pytest.approx(expected, rel=1e-7)


def test_lugre_breaks_away_at_mu_s() -> None:
    slowly = bent(lambda t: 2e-4 * t, lambda t: 0.0, 4.0)
    # Half of the damping at the peak is all that may be on top.
    assert np.max(slowly[:, 1]) == pytest.approx(0.6, rel=1e-3)


def test_lugre_gives_no_more_work_than_it_stores_whatever_speed_and_normal_force_do() -> None:
    """F_f v_s - d/dt(F_n sigma_0 z^2/2) >= 0, by the law itself: for any z that it can reach, speed and growth."""
    draw = np.random.default_rng(16)
    for _ in range(20000):
        v_s = float(draw.choice([-1.0, 1.0]) * 10.0 ** draw.uniform(-6.0, 1.0))
        sigma_1 = float(10.0 ** draw.uniform(-2.0, 3.0))
        z = float(draw.uniform(-0.6, 0.6) / SIGMA_0)
        growth = float(draw.choice([-1.0, 1.0]) * 10.0 ** draw.uniform(-2.0, 5.0))
        mu, z_dot, *_ = lugre(v_s, z, max(growth, 0.0), 0.6, 0.4, 0.05, SIGMA_0, sigma_1)
        stored = SIGMA_0 * z * z_dot + 0.5 * growth * SIGMA_0 * z * z  # its rate, over F_n
        assert mu * v_s - stored >= -1e-12 * (abs(mu * v_s) + abs(stored))


def test_growth_is_that_of_the_law_of_contact() -> None:
    Delta, rate = 1e-3, 0.3
    d = 1e-7
    force = [(Delta + side * d) ** 1.5 for side in (-1.0, 1.0)]
    assert growth_of_contact(Delta, rate) == pytest.approx((force[1] - force[0]) / (2.0 * d) * rate / Delta**1.5)
    assert growth_of_contact(Delta, -rate) == 0.0


def held(law: int) -> tuple[float, float]:
    """Sideways force over the normal force after 0.5 s and after 4 s, of a leaning filament that is pressed at rest."""
    brush = Instance(DECLARED, KERNEL, n=1, alpha=-0.3, friction_law=law, zeta=(0.2,) * 6)
    brush.set(omega_b=0.0, delta=5e-3)
    brush.start()
    found = []
    for steps in (500, 3500):
        for _ in range(steps):
            brush.step(1e-3)
        found.append(brush["F_x"] / brush["F_z"])
    return found[0], found[1]


def test_lugre_holds_where_the_smoothed_laws_creep() -> None:
    early, late = held(2)
    assert abs(early) > 0.05
    assert late == pytest.approx(early, rel=1e-3)
    for law in (0, 1):
        early, late = held(law)
        assert abs(late) < 0.5 * abs(early) + 1e-3


def test_micro_steps_of_lugre_stay_stable_and_energy_closes(measured: Callable[..., None]) -> None:
    for sigma_0, omega_b in ((1e4, 15.7), (1e5, 0.3), (1e6, 0.05)):
        brush = Instance(DECLARED, KERNEL, n=8, friction_law=2, sigma_0=sigma_0, alpha=0.3)
        brush.set(omega_b=omega_b, delta=5e-3, v_rov=0.05)
        brush.start()
        for _ in range(400):
            brush.step(1e-3)
        assert brush["deflection_ratio_max"] < 0.6
        scale = brush["W_friction"] + brush["W_hull"]
        measured(f"brush: energy not accounted for with LuGre, sigma_0 = {sigma_0:g}", brush["energy_residual"] / scale,
                 "1e-4")  # fmt: skip
        assert abs(brush["energy_residual"]) < 1e-4 * scale
