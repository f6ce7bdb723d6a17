"""Step sizes as the annotations of the Open Simulation Platform, which libcosim reads and SSP itself lacks."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from lxml import etree

from .annotations import annotation

TYPE = "com.opensimulationplatform"
NAMESPACE = "http://opensimulationplatform.com/SSP/OSPAnnotations"


def hint_step(component: Any, period: Fraction) -> None:
    """The step size of one component."""
    _add(annotation(component, TYPE), "StepSizeHint", value=repr(float(period)))


def hint_base_step(experiment: Any, period: Fraction) -> None:
    """The step size of the fixed-step master."""
    algorithm = _add(annotation(experiment, TYPE), "Algorithm")
    _add(algorithm, "FixedStepAlgorithm", baseStepSize=repr(float(period)))


def _add(parent: Any, tag: str, **attributes: str) -> Any:
    return etree.SubElement(parent, f"{{{NAMESPACE}}}{tag}", **attributes)
