"""What an FMU says that it can do."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from fmpy.model_description import ModelDescription

from .kinds import CO_SIMULATION, Kind, interface_of

SENSIBLE = 1e-30, 1e30  # s; a step beyond is none (`1e999999999` would be a number of as many digits)


class Capabilities:
    """The part of an FMU that tells what may be asked of it."""

    description: ModelDescription
    kind: Kind

    @property
    def interface(self) -> Any:
        """What the description says about the kind that the FMU is taken for."""
        return interface_of(self.description, self.kind)

    @property
    def can_save_state(self) -> bool:
        """Whether its state can be saved and restored, as rollback needs it."""
        return bool(self.interface.canGetAndSetFMUstate)

    @property
    def can_serialize_state(self) -> bool:
        """Whether its state can be written to disk, as a checkpoint needs it."""
        return self.can_save_state and bool(self.interface.canSerializeFMUstate)

    @property
    def can_vary_step(self) -> bool:
        """Whether steps of different lengths are allowed."""
        return self.kind != CO_SIMULATION or bool(self.interface.canHandleVariableCommunicationStepSize)

    @property
    def recommended_step(self) -> Fraction | None:
        """The communication step that its maker had in mind [s]."""
        experiment = self.description.defaultExperiment
        return _step(experiment.stepSize if experiment is not None else None)

    @property
    def internal_step(self) -> Fraction | None:
        """The step that it makes inside (FMI 3 fixedInternalStepSize) [s]; a communication step is a multiple of it."""
        return _step(getattr(self.interface, "fixedInternalStepSize", None))


def _step(stated: object) -> Fraction | None:
    """A step as it is written; None where there is none, or none that a clock could keep."""
    text = str(stated or "").strip()
    try:
        return Fraction(text) if SENSIBLE[0] < float(text) < SENSIBLE[1] else None
    except ValueError:
        return None
