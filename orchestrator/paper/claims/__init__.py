"""The paper's claims 1 to 25, one function each; importing this package fills the registry `CLAIMS`."""

from . import coupling, filament, sensitivity, table3, transients, vehicle
from .claim import CLAIMS, VERDICTS, Check, Claim, Finding

__all__ = [
    "CLAIMS",
    "VERDICTS",
    "Check",
    "Claim",
    "Finding",
    "coupling",
    "filament",
    "sensitivity",
    "table3",
    "transients",
    "vehicle",
]
