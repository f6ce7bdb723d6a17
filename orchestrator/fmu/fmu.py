"""One FMU as its description tells it: variables, types, and what it can do. `participant/` loads and runs it."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from pathlib import Path

from attrs import evolve
from fmpy.model_description import ModelDescription, ModelVariable

from ..cache.cache import cache_folder
from ..units import Definition, Unit
from .attributes import start_value
from .capabilities import Capabilities
from .files.archive import opened
from .files.binary import find_library
from .files.places import absent, origin, require_of_this_version
from .files.unpacked import archive_of, unpack
from .files.windows import platform_of
from .kinds import CO_SIMULATION, Kind, kinds_of, require_kind, usual_kind
from .reading.aliases import other_names
from .reading.clocks import ClockVariable, read_clocks
from .reading.description import read_description
from .reading.details import Details
from .reading.structure import resize, resized_variables
from .reading.terminals import Terminal
from .tolerant.rules import Note, Notes
from .types import REALS, TYPES, FmiType, Value
from .variables import Elements, Place, elements_of

SETTLED = 0.1  # s; a file that was written later could be written again without a later date


@dataclass(frozen=True)
class Fmu(Capabilities):
    """An unpacked FMI 1.0, 2.0 or 3.0 FMU, what its model description says, and the kind that it is taken for."""

    path: Path
    folder: Path
    digest: str
    description: ModelDescription
    texts: dict[str, list[str]]  # start values of FMI 3 texts and bytes, which can be arrays
    definitions: Mapping[str, Definition] = field(default_factory=dict)  # of its units, by name
    notes: tuple[Note, ...] = ()  # where it breaks the standard, and how that was taken
    negated: frozenset[str] = frozenset()  # variables that are another one with the other sign (FMI 1.0)
    details: Details = field(default_factory=dict)  # what else is said of variables (FMI 3.0), by name
    terminals: Mapping[str, Terminal] = field(default_factory=dict)  # by name, with those inside of others
    units: Mapping[str, str] = field(default_factory=dict)  # of scalars, where the description leaves them out
    kind: Kind = CO_SIMULATION
    compiled: bool = False  # its sources may be compiled where it brings no library for this machine
    structure: Mapping[str, Value] = field(default_factory=dict)  # structural parameters that are not at their start
    resized: tuple[str, ...] = ()  # the arrays that have another size by that
    elsewhere: bool = False  # it runs on another machine: no library for this one is needed, and none is looked for

    @classmethod
    def open(cls, path: Path, compiled: bool = False, elsewhere: bool = False) -> Fmu:
        """Unpack and read an FMU, each file once. `compiled`: from its sources, where it brings no library for here;
        `elsewhere`: to be run by another machine, whatever this one is.

        Raises FmuError: missing, corrupt, or none that can be run.
        """
        try:
            status = path.stat()
        except (OSError, ValueError):
            raise absent(path) from None
        unchanged = status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns, status.st_ctime_ns
        if path.is_dir() or time.time() - max(status.st_mtime, status.st_ctime) < SETTLED:
            return _read(path, compiled, elsewhere)
        fmu = _read_once(path, cache_folder(), unchanged, compiled, elsewhere)
        there = elsewhere or fmu.library.is_file()
        return fmu if there else _read(path, compiled, elsewhere)  # the cache was emptied by hand

    @property
    def archive(self) -> Path:
        """Its archive: the file, or what was made of an unpacked folder."""
        return archive_of(self.path, self.folder)

    @property
    def origin(self) -> str:
        """Whether it was shipped with the package, built with it, or is another file: see `files.places.origin`."""
        return origin(self.path, self.description)

    @property
    def standard(self) -> str:
        """What it is, in words: by which standard, or that it is no FMU."""
        return f"FMI {self.description.fmiVersion}"

    @property
    def is_file(self) -> bool:
        """Whether there is a file of it that another tool could take; see `outside.declared` for what has none."""
        return True

    @cached_property
    def version(self) -> int:
        """1, 2 or 3."""
        return int(self.description.fmiMajorVersion)

    @property
    def kinds(self) -> tuple[Kind, ...]:
        """The kinds that it could be taken for."""
        return kinds_of(self.description)

    def of_kind(self, kind: Kind) -> Fmu:
        """The same FMU taken for a kind. Raises FmuError if it is not of that kind, or cannot be run so."""
        require_kind(self.path, self.description, kind)
        return replace(self, kind=kind)

    def with_structure(self, values: Mapping[str, Value]) -> Fmu:
        """The same FMU with structural parameters set, and its arrays laid out by them.

        `values`: of their types, by name. Raises FmuError for arrays that are too large.
        """
        own = self.own
        changed = {name: value for name, value in values.items() if value != own.start(name)}
        if not changed:
            return self
        description, texts = resize(self.description, self.texts, changed)
        found = replace(
            self, description=description, texts=texts, structure={**self.structure, **changed},
            resized=(*self.resized, *resized_variables(self.description, description)),
        )  # fmt: skip
        _ = found.places  # an array that cannot be laid out is refused now
        return found

    @cached_property
    def library(self) -> Path:
        """The binary for this machine: a file in the folder `binaries`, or what its sources were compiled to."""
        return find_library(self.path, self.folder, self.description, self.interface, compiled=self.compiled)

    @cached_property
    def windows(self) -> str:
        """win64 or win32, if its library is for Windows and wine runs it here; else empty."""
        return "" if self.elsewhere else platform_of(self.library)

    @cached_property
    def _elements(self) -> Elements:
        """The scalars of every variable, by its own name."""
        return elements_of(self.path, self.description.modelVariables, self.texts)

    @cached_property
    def variables(self) -> dict[str, ModelVariable]:
        """All scalar variables by name; the elements of an FMI 3 array are scalars `u[1]`, `u[2]`..."""
        found = {name: v for elements in self._elements.values() for name, v in elements.items()}
        return found | {name: evolve(found[name], unit=unit) for name, unit in self.units.items()}

    @property
    def own(self) -> Fmu:
        """The FMU under its own names; a view of it in a component's place has others."""
        return self

    def own_name(self, name: str) -> str:
        """The FMU's own name of a variable."""
        return name

    def to_own(self, name: str, value: Value) -> Value:
        """A value of a variable as the FMU has it."""
        return value

    def from_own(self, name: str, value: Value) -> Value:
        """The FMU's value of a variable as the system has it."""
        return value

    @cached_property
    def places(self) -> dict[str, Place]:
        """Where every scalar lives."""
        return {
            name: Place(v.valueReference, k, len(elements), name in self.negated)
            for elements in self._elements.values()
            for k, (name, v) in enumerate(elements.items())
        }

    @cached_property
    def clocks(self) -> dict[str, ClockVariable]:
        """The clocks of FMI 3.0, by all of their names."""
        return read_clocks(self.description.modelVariables, self.details) if self.version == 3 else {}

    def clocks_of(self, name: str) -> tuple[str, ...]:
        """The clocks at whose ticks alone a scalar may be set and got, outside of initialization."""
        return tuple(clock.name for clock in self.variables[name].clocks or ())

    @cached_property
    def aliases(self) -> dict[str, str]:
        """The scalars that are other names, and of which scalar each is one."""
        others = other_names(self.description.modelVariables, self.negated).items()
        pairs = (zip(self._elements[name], self._elements[of], strict=True) for name, of in others)
        return dict(pair for found in pairs for pair in found)

    @cached_property
    def arrays(self) -> dict[str, list[str]]:
        """For every scalar the scalars that are set and got together with it, in their order."""
        return {name: list(elements) for elements in self._elements.values() for name in elements}

    def detail(self, name: str, attribute: str) -> str | None:
        """What else the description says of a scalar (see `details`), or of the array that it is in."""
        return self.details.get(self._owners.get(name, ""), {}).get(attribute)

    @cached_property
    def _owners(self) -> dict[str, str]:
        """The variable that each scalar is, or is an element of; of an alias that of which it is one."""
        owners = {name: v for v, elements in self._elements.items() for name in elements}
        return owners | {name: owners[of] for name, of in self.aliases.items()}

    def type_of(self, name: str) -> FmiType | None:
        """The type of a scalar; None for one that is not exchanged (Clock)."""
        return TYPES[self.version].get(self.variables[name].type)

    def unit(self, name: str) -> Unit | None:
        """The unit of a scalar, as this FMU means it; None where it has none."""
        v = self.variables[name]
        return self.unit_called(v.unit, name) if v.unit and v.type in REALS else None

    def unit_called(self, unit: str, name: str) -> Unit:
        """What a unit means beside this FMU, for values of a scalar: by the FMU's own definition where it has one."""
        return Unit(unit, self.definitions.get(unit), bool(self.variables[name].relativeQuantity))

    def is_real(self, name: str) -> bool:
        """Whether a scalar is floating point; every other signal is held."""
        kind = self.type_of(name)
        return kind is not None and kind.real

    def names(self, *causalities: str, aliases: bool = False) -> list[str]:
        """Names of the scalars with one of the causalities, in the order of the description; of outputs all of their
        names, of others those that are aliases too only where these are asked for."""
        known = self.aliases
        return [
            name
            for name, v in self.variables.items()
            if v.causality in causalities and (aliases or v.causality == "output" or name not in known)
        ]

    def expand(self, name: str) -> list[str]:
        """The scalars behind a name: itself, or the elements `name[1]`, `name[2]` ... of an array; [] if unknown.

        Behind an alias are those of the variable that it is.
        """
        if name in self.variables:
            return [self.main_name(name)]
        return [self.main_name(v) for v in self.variables if v.startswith(f"{name}[") and v.endswith("]")]

    def main_name(self, name: str) -> str:
        """The name of the variable itself where `name` is an alias of it."""
        return self.aliases.get(name, name)

    def base_names(self, *causalities: str) -> list[str]:
        """Names without their element index, for suggestions."""
        return list(dict.fromkeys(name.split("[")[0] for name in self.names(*causalities)))

    def start(self, name: str) -> Value:
        """The start value of a scalar; zero, false or empty where the description gives none."""
        return start_value(self.variables[name], f"{self.path.name}: start value of {name}")

    def feedthrough(self, initial: bool = False, unstated: bool = True) -> dict[str, frozenset[str]]:
        """For each output the inputs on which it depends at once; all of them where the description does not say.

        `initial`: the dependencies during initialization instead of those while stepping; an output with an exact
        start value has none then. `unstated`: False for none where the description does not say.
        """
        inputs = frozenset(self.names("input"))
        stated = self.description.initialUnknowns if initial else self.description.outputs
        given = {
            u.variable.name: frozenset(self.main_name(x) for d in u.dependencies for x in self._elements[d.name])
            & inputs
            for u in stated
            if u.dependencies is not None
        }
        owners = self._owners
        known = initial and self.version > 1  # before FMI 2.0 nothing can be read until all is set
        fixed = {name for name, v in self.variables.items() if known and v.initial == "exact"}
        return {
            name: given.get(owners[name], frozenset() if name in fixed or not unstated else inputs)
            for name in self.names("output")
        }


def _read(path: Path, compiled: bool, elsewhere: bool) -> Fmu:
    folder, digest = unpack(path)
    notes = Notes()
    with opened(archive_of(path, folder), notes=notes):  # what is wrong with it was lost when it was unpacked
        found = read_description(path, folder, compiled, elsewhere)
    require_of_this_version(path, found.description)
    kind = usual_kind(found.description)
    found = found._replace(notes=(*notes.all(), *found.notes))
    fmu = Fmu(path, folder, digest, *found, kind=kind, compiled=compiled, elsewhere=elsewhere)
    if not elsewhere:
        _ = fmu.library  # looked for while it is known to be there
    _ = fmu.places  # an array that cannot be laid out is refused now
    return fmu


@cache
def _read_once(path: Path, _cache: Path, _unchanged: tuple[int, ...], compiled: bool, elsewhere: bool) -> Fmu:
    return _read(path, compiled, elsewhere)
