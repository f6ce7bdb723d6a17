"""Claims about one bristle: eigenvalues, frequencies, shapes, shares of the modes, stiffening (1-5, 21)."""

from __future__ import annotations

import numpy as np

from ..lab import Case, Lab
from ..theory.beam import centrifugal_frequencies, shape
from .claim import Finding, at_least, claim, near, within


@claim(1, "Eigenvalues of the first three cantilever modes: 1.875, 4.694, 7.855.", "Table 1")
def eigenvalues(lab: Lab) -> Finding:
    lam = lab.case("nominal").calculated("brush.lambda_r", 3)
    checks = [
        within(f"lambda_{r + 1}", p, lam[r], "1", 5e-4, "half of the last printed digit")
        for r, p in enumerate((1.875, 4.694, 7.855))
    ]
    return Finding(tuple(checks), note="Equal to the printed digits.")


@claim(2, "Natural frequencies of the first three modes: 47.2, 132.1, 294.3 rad/s.", "Table 1")
def frequencies(lab: Lab) -> Finding:
    case = lab.case("nominal")
    omega, lam = case.calculated("brush.omega_r", 3), case.calculated("brush.lambda_r", 3)
    printed = (47.2, 132.1, 294.3)
    why = "printed to 0.1 %; ten times that for the digits of Table 2"
    checks = [near(f"omega_{r + 1}", p, omega[r], "rad/s", 0.01, why) for r, p in enumerate(printed)]
    return Finding(
        tuple(checks),
        f"omega_2/omega_1 = (lambda_2/lambda_1)^2 = {(lam[1] / lam[0]) ** 2:.2f} for any E, d, L and rho, printed "
        f"{printed[1] / printed[0]:.2f}; omega_3/omega_1 = {(lam[2] / lam[0]) ** 2:.2f}, printed "
        f"{printed[2] / printed[0]:.2f}",
        f"Table 2 in the formula below Eq. 4 gives {omega[0]:.1f} rad/s = {omega[0] / (2 * np.pi):.1f} Hz for mode 1. "
        "The paper prints 47.2 as rad/s in Table 1 and as 47 Hz in the text.",
    )


@claim(3, "Mode shapes: mode 1 has its one antinode at the tip, higher modes have interior nodes.", "Fig. 2")
def mode_shapes(lab: Lab) -> Finding:
    lam = lab.case("nominal").calculated("brush.lambda_r", 3)
    xi = np.linspace(0.0, 1.0, 20001)
    shapes = [shape(value, xi) for value in lam]
    nodes = [xi[1:-1][np.flatnonzero(np.diff(np.sign(y[1:])) != 0)] for y in shapes]
    checks = [
        within(f"interior nodes of mode {r + 1}", r, len(found), "1", 0.0, "a number of nodes is whole")
        for r, found in enumerate(nodes)
    ]
    antinode = float(xi[np.argmax(np.abs(shapes[0]))])
    checks.append(within("x/L of the antinode of mode 1", 1.0, antinode, "1", 0.0, "at the tip itself"))
    places = "; ".join(", ".join(f"{x:.3f}" for x in found) for found in nodes[1:])
    return Finding(tuple(checks), note=f"Nodes of modes 2 and 3 at x/L = {places}.")


def share(case: Case, modes: int) -> float:
    """Share of the first modes in the kinetic energy relative to the hub, weighted by that energy over the window."""
    energy = case.signals["brush.E_kinetic"]
    inside = energy.time >= case.window[0]
    of_modes = sum(case.signals[f"brush.kinetic_fraction[{r}]"].values for r in range(1, modes + 1))
    return float(np.sum((of_modes * energy.values)[inside]) / np.sum(energy.values[inside]))


@claim(4, "Mode 1 carries around 78 % of the kinetic energy.", "section 3.5")
def share_of_mode_1(lab: Lab) -> Finding:
    case = lab.case("nominal")
    omega = case.calculated("brush.omega_r", 3)
    at_start = case.signals["brush.kinetic_fraction[1]"].values[1]
    static = omega**-2 / np.sum(omega**-2)
    around = "'around': as far as 5 % to either side"
    return Finding(
        (within("share of mode 1, energy-weighted over the steady window", 0.78, share(case, 1), "1", 0.05, around),),
        f"a tip load held against the bending stiffness fills the modes as 1/omega_r^2: {100 * static[0]:.1f} % in "
        f"mode 1; an ideal blow fills three modes alike: 33.3 %; here modes 2 and 3 decay {omega[1] / omega[0]:.1f} "
        f"and {omega[2] / omega[0]:.1f} times faster than mode 1, which holds {100 * share(case, 1):.2f} %",
        f"At first touch the share passes through every value from {100 * at_start:.0f} % upwards, within 10 ms.",
    )


@claim(5, "Three modes capture more than 95 % of the kinetic energy.", "sections 3.6, 6.2")
def share_of_three_modes(lab: Lab) -> Finding:
    case = lab.stand({"brush.N_m": 6})
    third, fourth = case.calculated("brush.omega_r", 4)[2:] / (2 * np.pi)
    return Finding(
        (at_least("share of modes 1 to 3 of six, energy-weighted", 0.95, share(case, 3), "1"),),
        note=f"Mode 3 has {third:.0f} Hz, inside the paper's 0-500 Hz; mode 4 has {fourth:.0f} Hz.",
    )


@claim(21, "Centrifugal stiffening significantly increases stiffness and natural frequencies.", "section 3.5")
def centrifugal_stiffening(lab: Lab) -> Finding:
    on, off = lab.stand(), lab.stand({"brush.centrifugal": "false"})
    at_rest, speed = on.calculated("brush.omega_r", 6), on.mean("motor.omega_b")
    L, alpha, R_h = on.parameter("brush.L"), on.parameter("brush.alpha"), on.run.calculated["brush.R_h"]
    turning = centrifugal_frequencies(on.calculated("brush.lambda_r", 6), at_rest, speed, R_h * np.cos(alpha) / L)
    rise = float(turning[0] / at_rest[0] - 1.0)
    force = on.summary["F_z_mean"] / off.summary["F_z_mean"] - 1.0
    significant = "'significantly', without a number: at least what nylon's modulus differs by from batch to batch"
    return Finding(
        (at_least("rise of omega_1 at the loaded speed, in plane", 0.05, rise, "1", significant),),
        f"(omega_b/omega_1)^2 = ({speed:.1f}/{at_rest[0]:.1f})^2 = {(speed / at_rest[0]) ** 2:.4f}: omega_1 rises by "
        f"{100 * rise:.1f} %, below what counts as significant here (5 %)",
        f"With stiffening switched off in the brush FMU the mean F_z changes by {-100 * force:+.1f} %.",
    )
