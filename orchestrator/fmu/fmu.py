"""One FMU as its description tells it: variables, types, and what it can do. Instances are in `instances.py`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from pathlib import Path

from attrs import evolve
from fmpy.model_description import CoSimulation, ModelDescription, ModelVariable

from ..errors import InputError
from .archive import unpack
from .crossing import Crossing
from .description import platform_folder, read_description, scalars_of
from .types import TYPES, FmiType


@dataclass(frozen=True)
class Place:
    """Where a scalar lives in its FMU: the value reference, and its position in an array of `count` values."""

    reference: int
    index: int
    count: int


@dataclass(frozen=True)
class Fmu:
    """An unpacked FMI 2.0 or 3.0 co-simulation FMU and what its model description says."""

    path: Path
    folder: Path
    digest: str
    description: ModelDescription
    texts: dict[str, list[str]]  # start values of FMI 3 String variables, which can be arrays
    # Somebody else's FMU in the place of a component: the variables that the system sees, and where they cross.
    presented: tuple[ModelVariable, ...] = ()
    crossings: Mapping[str, Crossing] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)  # of scalars, where the description leaves them out

    @classmethod
    def open(cls, path: Path) -> Fmu:
        """Unpack and read an FMU. Raises FmuError if it is missing, corrupt, or no FMU that can be run here."""
        folder, digest = unpack(path)
        fmu = cls(path, folder, digest, *read_description(path, folder))
        _ = fmu.places  # an array that cannot be laid out is refused now
        return fmu

    @property
    def version(self) -> int:
        """2 or 3."""
        return int(self.description.fmiMajorVersion)

    @property
    def interface(self) -> CoSimulation:
        """What the description says about co-simulation."""
        assert self.description.coSimulation is not None
        return self.description.coSimulation

    @property
    def library(self) -> Path:
        """Folder of the binary for this machine."""
        return self.folder / "binaries" / platform_folder(self.description)

    @cached_property
    def _elements(self) -> dict[str, dict[str, ModelVariable]]:
        """The scalars of every variable, by its own name."""
        return {v.name: scalars_of(self.path, v, self.texts) for v in self.description.modelVariables}

    @cached_property
    def variables(self) -> dict[str, ModelVariable]:
        """All scalar variables by name; the elements of an FMI 3 array are scalars `u[1]`, `u[2]`...

        Of a foreign FMU those that the system sees (see `swap.py`).
        """
        if self.presented:
            return {v.name: v for v in self.presented}
        found = {name: v for elements in self._elements.values() for name, v in elements.items()}
        return found | {name: evolve(found[name], unit=unit) for name, unit in self.units.items()}

    @cached_property
    def own(self) -> Fmu:
        """The FMU under its own names, which are others where it is presented as a component."""
        return replace(self, presented=(), crossings={}) if self.presented else self

    @cached_property
    def _ours(self) -> dict[str, str]:
        """Names in the system by the FMU's own."""
        return {crossing.name: name for name, crossing in self.crossings.items()}

    @cached_property
    def places(self) -> dict[str, Place]:
        """Where every scalar lives."""
        if self.presented:
            return {name: self.own.places[crossing.name] for name, crossing in self.crossings.items()}
        return {
            name: Place(v.valueReference, k, len(elements))
            for elements in self._elements.values()
            for k, (name, v) in enumerate(elements.items())
        }

    @cached_property
    def arrays(self) -> dict[str, list[str]]:
        """For every scalar the scalars that are set and got together with it, in their order."""
        if self.presented:
            return {name: self._together(name) for name in self.crossings}
        return {name: list(elements) for elements in self._elements.values() for name in elements}

    def _together(self, name: str) -> list[str]:
        theirs = self.own.arrays[self.crossings[name].name]
        lacking = [x for x in theirs if x not in self._ours]
        if lacking:
            raise InputError(
                f"{self.path.name}: '{lacking[0]}' belongs to the same array as '{self.crossings[name].name}' and is "
                f"not mapped; map the whole array"
            )
        return [self._ours[x] for x in theirs]

    def type_of(self, name: str) -> FmiType | None:
        """The type of a scalar; None for one that cannot be exchanged (Binary, Clock)."""
        return TYPES[self.version].get(self.variables[name].type)

    def is_real(self, name: str) -> bool:
        """Whether a scalar is floating point; every other signal is held."""
        kind = self.type_of(name)
        return kind is not None and kind.real

    def names(self, *causalities: str) -> list[str]:
        """Names of the scalars with one of the causalities, in the order of the description."""
        return [name for name, v in self.variables.items() if v.causality in causalities]

    def expand(self, name: str) -> list[str]:
        """The scalars behind a name: itself, or the elements `name[1]`, `name[2]` ... of an array; [] if unknown."""
        if name in self.variables:
            return [name]
        return [v for v in self.variables if v.startswith(f"{name}[") and v.endswith("]")]

    def base_names(self, *causalities: str) -> list[str]:
        """Names without their element index, for suggestions."""
        return list(dict.fromkeys(name.split("[")[0] for name in self.names(*causalities)))

    def start(self, name: str) -> float | int | bool | str:
        """The start value of a scalar; zero, false or empty where the description gives none."""
        v, kind = self.variables[name], self.type_of(name)
        empty = "" if kind is None or kind.dtype.kind == "O" else "0"
        value = v.start if v.start is not None else empty
        return parse_value(v, value, f"{self.path.name}: start value of {name}", kind)

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
        return bool(self.interface.canHandleVariableCommunicationStepSize)

    @property
    def recommended_step(self) -> Fraction | None:
        """The communication step that its maker had in mind [s]."""
        experiment = self.description.defaultExperiment
        return Fraction(experiment.stepSize) if experiment is not None and experiment.stepSize else None

    @property
    def internal_step(self) -> Fraction | None:
        """The step that it makes inside (FMI 3 fixedInternalStepSize) [s]; a communication step is a multiple of it."""
        step = self.interface.fixedInternalStepSize
        return Fraction(str(step)) if step is not None and float(step) > 0 else None

    def feedthrough(self, initial: bool = False) -> dict[str, frozenset[str]]:
        """For each output the inputs on which it depends at once; all of them where the description does not say.

        `initial`: the dependencies during initialization instead of those while stepping; an output with an exact
        start value has none then.
        """
        if self.presented:
            known = self.own.feedthrough(initial)
            return {
                name: frozenset(self._ours[x] for x in known[self.crossings[name].name] if x in self._ours)
                for name in self.names("output")
            }
        inputs = frozenset(self.names("input"))
        stated = self.description.initialUnknowns if initial else self.description.outputs
        given = {
            u.variable.name: frozenset(name for d in u.dependencies for name in self._elements[d.name]) & inputs
            for u in stated
            if u.dependencies is not None
        }
        owners = {name: v for v, elements in self._elements.items() for name in elements}
        fixed = {name for name, v in self.variables.items() if initial and v.initial == "exact"}
        return {
            name: given.get(owners[name], frozenset() if name in fixed else inputs) for name in self.names("output")
        }


def parse_value(
    variable: ModelVariable, value: object, label: str, kind: FmiType | None = None
) -> float | int | bool | str:
    """A parameter or start value in the variable's type and range. Raises InputError saying what is allowed."""
    unit = f" {variable.unit}" if variable.unit not in (None, "", "1") else ""
    real = variable.type in ("Real", "Float64", "Float32")
    try:
        if variable.type in ("String", "Binary"):
            return str(value)
        if variable.type == "Boolean":
            return {"true": True, "1": True, "1.0": True, "false": False, "0": False, "0.0": False}[
                str(value).strip().lower()
            ]
        number: float | int = float(str(value)) if real else _whole(str(value))
        if number != number or abs(number) == float("inf"):
            raise ValueError
    except (ValueError, KeyError, OverflowError):
        what = "a finite number" if real else "true or false" if variable.type == "Boolean" else "a whole number"
        raise InputError(f"{label} = {value!s} is not {what}") from None
    low, high = _bounds(variable, real, kind or TYPES[2].get(variable.type) or TYPES[3].get(variable.type))
    if not low <= number <= high:
        shown = f"{number:g}" if real else f"{number}"
        raise InputError(f"{label} = {shown}{unit} is out of range: {_text(low)} to {_text(high)}{unit} are allowed")
    return number


def _whole(text: str) -> int:
    """A whole number, exact to 64 bits; `3.0` is one."""
    try:
        return int(text)
    except ValueError:
        if float(text) != int(float(text)):
            raise ValueError from None
        return int(float(text))


def _bounds(variable: ModelVariable, real: bool, kind: FmiType | None) -> tuple[float | int, float | int]:
    """The allowed range: what the variable declares, within what its type can hold."""
    if real:
        low = float(variable.min) if variable.min is not None else -float("inf")
        return low, float(variable.max) if variable.max is not None else float("inf")
    limits = kind.range if kind else (-(2**63), 2**63 - 1)
    low = max(limits[0], int(variable.min)) if variable.min is not None else limits[0]
    return low, min(limits[1], int(variable.max)) if variable.max is not None else limits[1]


def _text(bound: float | int) -> str:
    return f"{bound:g}" if isinstance(bound, float) else f"{bound}"
