"""What a spinning tool does to the vehicle that holds it, and the vehicle's angular momentum and what changes it."""

from __future__ import annotations

import numpy as np

from ...testing.behaviour import Running, Unit, close, go_on, holds, read, run, values
from .at_rest import FREE, TILTED, WEIGHTLESS, H, rotation

POSE, VELOCITY = ("x_n", "y_n", "z_n"), ("u", "v", "w", "p", "q", "r")
ROUND = {"I": (0.2,) * 3, "added_inertia": (0.1,) * 3, "r_g": (0.0,) * 3, "r_b": (0.0,) * 3}
SPINNING = {"H_x": 1.0, "H_y": 9.0, "H_z": -2.0}


def momenta(unit: Unit, seen: Running, current: tuple[float, ...] = (0.0, 0.0, 0.0)) -> np.ndarray:
    """Angular momentum about the world origin from mass, inertia and velocities: of the body over ground, of the added
    mass through the water."""
    m, I, I_products, r_g, added, added_I = values(unit, "m", "I", "I_products", "r_g", "added_mass", "added_inertia")
    xy, xz, yz = I_products
    inertia = np.diag(I) + np.array([[0.0, xy, xz], [xy, 0.0, yz], [xz, yz, 0.0]]) + np.diag(added_I)
    R, v, omega = rotation(seen), *np.split(read(seen, *VELOCITY), 2)
    linear = m * (v + np.cross(omega, r_g)) + np.asarray(added) * (v - R.T @ current)
    angular = inertia @ omega + m * np.cross(r_g, v)
    return np.asarray(R @ angular + np.cross(read(seen, *POSE), R @ linear))


def test_turning_a_spinning_tool_takes_the_gyroscopic_moment(unit: Unit) -> None:
    """M_gyro = -omega x R H, for any mounting."""
    mounting = (0, 0, 1, 0, 1, 0, -1, 0, 0)
    seen = unit.new(SPINNING, **TILTED | {"R_tool_body": mounting})
    spin = np.reshape(mounting, (3, 3)) @ np.array([*SPINNING.values()])
    close(unit, "gyroscopic moment", seen["M_gyro"], -np.cross(read(seen, "p", "q", "r"), spin), 1e-14)


def test_spinning_tool_makes_the_vehicle_nutate(unit: Unit) -> None:
    """Without other moments a body of inertia I in all directions turns its rate about the spin axis with H/I."""
    seen = unit.new({"H_y": 6.0}, rates_start=(0.3, 0.2, -0.1), **ROUND, **FREE, **WEIGHTLESS)
    go_on(seen, 1.0, H)
    cos, sin = np.cos(6.0 / 0.3), np.sin(6.0 / 0.3)
    expected = (0.3 * cos - 0.1 * sin, 0.2, -0.1 * cos - 0.3 * sin)
    # 20 rad in steps of at most a twentieth of one, of fourth order: 20*0.05^4/120.
    close(unit, "body rates", read(seen, "p", "q", "r"), expected, 2e-6, 1.0)


def test_spin_does_no_work(unit: Unit) -> None:
    """Tumbling freely with a spinning tool, the energy of the vehicle stays: the moment is across the motion."""
    seen = unit.new(SPINNING, **TILTED, **FREE)
    before = float(np.sum(read(seen, "E_kinetic", "E_potential")))
    go_on(seen, 5.0, H)
    close(unit, "energy", np.sum(read(seen, "E_kinetic", "E_potential")), before, 1e-5, 5.0)


def test_angular_momentum_with_the_spin_is_conserved_without_forces(unit: Unit) -> None:
    """L + R H stays, in all three axes, while the vehicle tumbles."""
    seen = unit.new(SPINNING, **TILTED, **FREE, **WEIGHTLESS)
    spin = np.array([*SPINNING.values()])
    before = seen["L"] + rotation(seen) @ spin
    turned = 0.0
    for _ in range(40):
        go_on(seen, 0.1, H)
        close(unit, "angular momentum", seen["L"] + rotation(seen) @ spin, before, 2e-6)
        turned = max(turned, float(np.max(np.abs(rotation(seen) @ spin - before))))
    holds(turned > 1.0, f"the spin has turned by {turned:.3g} N.m.s only")


def test_angular_momentum_is_that_of_body_and_added_mass(unit: Unit) -> None:
    """L about the world origin from masses, inertias and velocities, with a current too."""
    current = (0.3, -0.2, 0.1)
    seen = run(unit, 0.5, H, {"v_c": current, **SPINNING}, position_start=(0.3, -1.0, 2.0), **TILTED)
    close(unit, "angular momentum", seen["L"], momenta(unit, seen, current), 1e-13)


def test_angular_impulses_account_for_the_angular_momentum(unit: Unit) -> None:
    """L changes by J_tool + J_other with everything at work, and when the current changes."""
    inputs = {"F_x": -20.0, "F_z": -30.0, "M_y": -3.0, "v_c": (0.3, -0.2, 0.1), "F_external": (1.0, 2.0, 3.0)}
    inputs |= {"u_thruster": (0.3, -0.2, 0.4, 0.1, 0.6, 0.5, -0.3, 0.2), "H_y": 9.0}
    seen = unit.new(inputs, position_start=(0.3, -1.0, 2.0), **TILTED)
    before = seen["L"]
    for part in range(2):
        go_on(seen, 2.0, H)
        names = ("J_tool", "J_other")
        size = max(float(np.max(np.abs(seen[name]))) for name in names)
        holds(all(np.max(np.abs(seen[name])) > 1.0 for name in names), "tool and all else were to give impulses")
        close(unit, "angular momentum", seen["L"] - before, seen["J_tool"] + seen["J_other"], 2e-6, size)
        if part == 0:
            seen.set(v_c=(-0.4, 0.3, 0.0))


def test_tool_without_spin_has_no_gyroscopic_moment(unit: Unit) -> None:
    """With H = 0 the vehicle is as one without a spinning tool."""
    seen = run(unit, 0.5, H, {"M_y": -3.0}, **TILTED)
    close(unit, "gyroscopic moment", seen["M_gyro"], 0.0, 1e-300, 1.0)
