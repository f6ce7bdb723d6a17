"""Step sizes, which SSP itself lacks: the annotations of OSP, which we write too, and those of OMSimulator."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from lxml import etree

from .annotations import annotation
from .document import find, is_finite

# Elements of annotations and their attribute, the closest to what is meant first.
STEPS = (
    ("StepSizeHint", "value"),
    ("FixedStepMaster", "stepSize"),
    ("FixedStepSolver", "stepSize"),
    ("VariableStepMaster", "maximumStepSize"),
    ("VariableStepSolver", "maximumStepSize"),
    ("FixedStepAlgorithm", "baseStepSize"),
)
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


def stated_step(element: Any) -> str:
    """The step [s] that annotations of other tools on an element, or on its experiment, state; else empty.

    Of drafts of the standard what they said in its own words.
    """
    annotations = [*find(element, "Annotations"), *find(element, "DefaultExperiment/Annotations")]
    annotations += find(element, "SimulationInformation")
    found = [child for annotation in annotations for child in annotation.iter(etree.Element)]
    for name, attribute in STEPS:
        for child in found:
            text = str(child.get(attribute, "")).strip()
            if _named(child, name) and is_finite(text) and float(text) > 0:
                return text
    return ""


def _named(element: Any, name: str) -> bool:
    """Whether an element has a name, in whatever namespace, or with a prefix that nothing declares."""
    return str(etree.QName(element).localname).rpartition("_")[2].rpartition(":")[2] == name
