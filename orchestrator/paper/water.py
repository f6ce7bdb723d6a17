"""What the water changes on a brush at constant speed, and what each approximation of it is worth: run, not stated."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import log10, pi, sqrt

import numpy as np

from ..system.file.parameter_sets import shipped_sets
from ..system.file.shipped import SYSTEMS
from ..toml.file import TomlFile
from .lab import Case, Lab
from .theory.beam import quadrature, shape
from .theory.blade import blade

Rows = list[tuple[str, ...]]
BRUSHES = ("paper", "roller")  # sets of parameters, as far as they are shipped
C_D, C_PADDLE = 1.1, 1.2  # a cylinder across a stream at Re of 80 to 1500, a flat plate
EVERYWHERE, NOWHERE = 1e9, 0.0  # linear_below
DRY: Mapping[str, object] = {"C_d": 0.0, "C_a": 0.0, "pack_drag": 0.0, "C_paddle": 0.0}
EFFECTS = ["with", "F_z [N]", "F_x [N]", "T_brush [N.m]", "P_hub [W]", "change of these [%]"]
ERRORS = ["approximation or assumption", "error of F_z, F_x, T_brush, P_hub [%]"]
SIGNALS = ("F_z", "F_x", "T_brush", "P_hub")


@dataclass(frozen=True)
class Brush:
    """A brush of a parameter set in water, and how much of its speed the water within it takes on."""

    name: str
    values: Mapping[str, object]
    shielding: float
    co_rotation: float

    @property
    def wet(self) -> dict[str, object]:
        """Drag along the bristles and added mass."""
        shielding, co_rotation = round(self.shielding, 4), round(self.co_rotation, 3)
        return {"C_d": C_D, "C_a": 1.0, "shielding": shielding, "co_rotation": co_rotation}

    def run(self, lab: Lab, values: Mapping[str, object]) -> Case:
        """The brush at constant speed."""
        given = {**self.values, **DRY, **values}
        return lab.case("constant_speed", {f"brush.{name}": value for name, value in given.items()})


def brushes(lab: Lab) -> list[Brush]:
    """Those whose sets are shipped."""
    return [_brush(lab, name) for name in BRUSHES if name in shipped_sets()]


def _brush(lab: Lab, name: str) -> Brush:
    values = TomlFile(SYSTEMS / f"{name}.toml").data["brush"]
    case = Brush(name, values, 1.0, 0.0).run(lab, {})
    shielding = strip_share(case)
    return Brush(name, values, shielding, share_of_speed(case, shielding))


def strip_share(case: Case) -> float:
    """Shielding with which a bundle, as wide as the brush, feels what a strip of that width does."""
    value = case.parameter
    return min(1.0, value("brush.width") / (value("brush.bristles_per_filament") * value("brush.d")))


def share_of_speed(case: Case, shielding: float) -> float:
    """Share of the brush's speed that the water within it takes on.

    Bristles give it the torque a ((1 - share) omega_b)^2, and the water around takes b (share omega_b)^2 from it, as
    from a rough cylinder (Theodorsen and Regier 1944; rough enough that C does not depend on the speed).
    """
    value = case.parameter
    R, rho_w = value("brush.R_brush"), value("brush.rho_w")
    R_h = case.run.calculated["brush.R_h"]
    bristles = value("brush.n") * value("brush.bristles_per_filament")
    a = bristles * shielding * 0.125 * rho_w * C_D * value("brush.d") * (R**4 - R_h**4)
    C = (2.12 + 4.07 * log10(R / value("brush.pack_roughness"))) ** -2
    b = C * pi * rho_w * R**4 * value("brush.width")
    return 1.0 / (1.0 + sqrt(b / a))


def effects(lab: Lab, brush: Brush) -> Rows:
    """Forces, torque and power without and with each effect of the water."""
    dry = brush.run(lab, {})
    variants: tuple[tuple[str, Mapping[str, object]], ...] = (
        ("dry", {}),
        ("added mass, C_a = 1", {"C_a": 1.0}),
        (f"drag along the bristles and added mass, {brush.co_rotation:.2f} of the speed in the water", brush.wet),
        ("the pack as a rough cylinder, no drag along the bristles", {"pack_drag": 1.0}),
        ("the bundles as paddles, no drag along the bristles",
         {"C_paddle": C_PADDLE, "co_rotation": round(brush.co_rotation, 3)}),
    )  # fmt: skip
    rows: Rows = []
    for text, values in variants:
        case = brush.run(lab, values)
        numbers = tuple(f"{case.mean(f'brush.{name}'):.4g}" for name in SIGNALS)
        rows.append((text, *numbers, "" if case is dry else changes(case, dry)))
    return rows


def changes(case: Case, base: Case) -> str:
    """Of the four means [%]."""
    return ", ".join(f"{100.0 * (case.mean(f'brush.{n}') / base.mean(f'brush.{n}') - 1.0):+.2g}" for n in SIGNALS)


def errors(lab: Lab, brush: Brush) -> Rows:
    """What approximations change against drag in full all over, and what assumptions are worth."""
    full = brush.run(lab, brush.wet | {"linear_below": NOWHERE})
    share, shielding = brush.co_rotation, brush.shielding
    variants: tuple[tuple[str, dict[str, object]], ...] = (
        ("drag linear off the hull where the tip's own speed is below half the flow's (default)", {}),
        ("drag linear off the hull all over", {"linear_below": EVERYWHERE}),
        ("C_d 20 % less", {"C_d": round(0.8 * C_D, 3), "linear_below": NOWHERE}),
        ("the water within has 0.03 more of the speed",
         {"co_rotation": round(share + 0.03, 3), "linear_below": NOWHERE}),
        ("bristles shielded by half as much again",
         {"shielding": round(min(1.5 * shielding, 1.0), 4), "linear_below": NOWHERE}),
        ("added mass twice as large, C_a = 2", {"C_a": 2.0, "linear_below": NOWHERE}),
    )  # fmt: skip
    rows: Rows = [(text, changes(brush.run(lab, brush.wet | values), full)) for text, values in variants]
    bent = static_deflection(full)
    exact = blade(8.0 * bent)
    errors_of_blade = (bent / exact.deflection - 1.0, 1.0 / exact.effective_length - 1.0)
    few = points_error(full.calculated("brush.lambda_r", 3))
    return [
        *rows,
        (f"linear bending under the flow's steady drag, which deflects the tip by {bent:.2g} of the length: "
         "of deflection, of drag",
         ", ".join(f"{100.0 * one:+.2g}" for one in errors_of_blade)),
        ("six points along a bristle, its own speed up to the flow's: of the drag on a mode, at most",
         f"{100.0 * few:.2g}"),
    ]  # fmt: skip


def static_deflection(case: Case) -> float:
    """Tip deflection over L of a beam under the flow at R_brush, all along it: a bound from above."""
    value = case.parameter
    L, d = value("brush.L"), value("brush.d")
    U = (1.0 - value("brush.co_rotation")) * case.mean("motor.omega_b") * value("brush.R_brush")
    load = 0.5 * value("brush.rho_w") * value("brush.C_d") * value("brush.shielding") * d * U**2
    return load * L**3 / (8.0 * value("brush.E") * pi * d**4 / 64.0)


def points_error(lam: np.ndarray) -> float:
    """Largest error of the modal drags over the largest of them, six points of Gauss against sixty-four."""
    nodes, weights = np.polynomial.legendre.leggauss(6)
    rules = (0.5 * (nodes + 1.0), 0.5 * weights), quadrature()
    worst = 0.0
    for own in np.linspace(-1.0, 1.0, 41):
        few, many = (_modal_drag(own, lam, *rule) for rule in rules)
        worst = max(worst, float(np.max(np.abs(few - many)) / np.max(np.abs(many))))
    return worst


def _modal_drag(own: float, lam: np.ndarray, xi: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Of a flow that grows as from R_h to R_brush, the tip moving by itself in mode 1 with `own` times its speed."""
    shapes = np.array([shape(value, xi) for value in lam])
    v = 0.47 + 0.53 * xi + own * shapes[0] / 2.0
    result: np.ndarray = shapes @ (weights * np.abs(v) * v)
    return result
