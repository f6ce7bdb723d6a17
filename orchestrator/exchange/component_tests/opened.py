"""What differs between FMI 2.0 and 3.0 in tests of a single component: an array of FMI 3.0 is one variable."""

from __future__ import annotations

from fmpy.model_description import ModelVariable

from ...fmu.fmu import Fmu


def whole_variables(fmu: Fmu) -> dict[str, ModelVariable]:
    """Variables as the description has them: an FMI 3.0 array is one."""
    return {v.name: v for v in fmu.description.modelVariables}
