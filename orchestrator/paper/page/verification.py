"""The report's section on verification."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from .. import elastica, verification
from ..lab import Lab
from .html import Html, element, image, join, table


def checks(lab: Lab, rows: Sequence[dict[str, Any]]) -> Html:
    """References that nobody here wrote, orders of convergence, closing energies."""
    case = lab.case("nominal")
    bent = elastica.bending(case.calculated("brush.lambda_r", 3))
    reached = float(case.summary["max_deflection_ratio"])
    balance = next(row for row in rows if row["number"] == 24)
    return join([
        element("p", "Computed now:"),
        element("h3", "Large deflection: the exact elastica"),
        element("p", "A cantilever under a transverse tip load, three modes of the brush FMU against the closed form "
                     f"of the elastica, which agrees with the published table to {elastica.reference_error():.0e}. "
                     "Linear and foreshortened beam bend alike under a transverse load; only the latter's tip moves "
                     f"inwards. Three modes bend {100 * (1 - bent.model_w[0] / (bent.load[0] / 3)):.2f} % less than "
                     f"the whole sum. The largest deflection in the nominal run is |y(L)|/L = {reached:.3f}."),
        table(*verification.elastica_table(bent), class_="numbers"),
        image(verification.elastica_figure(bent, reached), "Errors of the bending model over the deflection"),
        element("h3", "Rotating cantilever"),
        element("p", "Zero hub radius, out of plane; Omega and omega in units of sqrt(EI/(mu L^4)), computed / "
                     "published. Six modes."),
        table(*verification.cantilever_table(case.calculated("brush.lambda_r", 6)), class_="numbers"),
        element("h3", "Thruster"),
        element("p", "The vehicle FMU's thrust curve beside the published table at 12 V, dead band not modelled."),
        table(*verification.thrust_table(case), class_="numbers"),
        element("h3", "Convergence"),
        element("p", "The test stand with other numbers of modes, tolerances of the micro-steps and communication "
                     f"periods; changes against {lab.stand().command}."),
        table(*verification.convergence_table(lab), class_="numbers"),
        element("h3", "Closing energies"),
        table(["level", "residual [1]", "bound [1]"],
              [(c["quantity"], f"{c['computed']:.2g}", f"{c['paper']:g}") for c in balance["checks"]], "numbers"),
        element("h3", "By the test suite"),
        element("p", "Each command prints the measured numbers beside their bounds at its end."),
        table(["check", "reference", "command"],
              [(s.subject, s.reference, element("code", s.command)) for s in verification.SUITE]),
    ])  # fmt: skip
