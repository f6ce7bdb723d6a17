"""The report's section on verification: references that nobody here wrote, orders of convergence, what is conserved."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from .. import angular_momentum, verification
from ..lab import Lab
from ..theory import elastica
from .rendering import image


def checks(lab: Lab, rows: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Tables (heading, rows) and numbers of the section; `rows` are the claims."""
    case = lab.case("nominal")
    bent = elastica.bending(case.calculated("brush.lambda_r", 3))
    reached = float(case.summary["max_deflection_ratio"])
    balance = next(row for row in rows if row["number"] == 24)
    return {
        "reference_error": elastica.reference_error(),
        "softer": 100.0 * (1.0 - bent.model_w[0] / (bent.load[0] / 3.0)),  # %; small loads: the beam's a/3
        "reached": reached,
        "elastica": verification.elastica_table(bent),
        "elastica_image": image(verification.elastica_figure(bent, reached)),
        "cantilever": verification.cantilever_table(case.calculated("brush.lambda_r", 6)),
        "thrust": verification.thrust_table(case),
        "stand": lab.stand().command,
        "convergence": verification.convergence_table(lab),
        "energies": [(c["quantity"], f"{c['computed']:.2g}", f"{c['paper']:g}") for c in balance["checks"]],
        "momenta": angular_momentum.closing(lab),
        "suite": [(s.subject, s.reference, s.command) for s in verification.SUITE],
    }
