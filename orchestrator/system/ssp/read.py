"""An SSP as a system file: the same keys as TOML, so that the same reader checks them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ...clock import instant
from ...errors import InputError, listed
from ...fmu.tolerant.rules import Notes
from ...toml.file import TomlFile
from ..experiment import periods_of, stop_of, whole_stop
from ..inputs.free_inputs import lacking_starts
from ..model import FORMATS
from ..values import settable
from .files.annotations import CLOCKS, annotated
from .files.archive import Archive
from .files.document import Document, find
from .files.rules import NO_START, NOT_SETTABLE
from .parameters import Parameters
from .structure import Element, read_structure
from .values import Stated
from .wires import End, Wire, links_of, path_to, wires_of

OWN_KEYS = ("components", "connections", "description", "parameters")  # not to be had from annotations


class SspFile(TomlFile):
    """The data of an SSP (1.0 or 2.0), and where in its files they stand.

    `step`, `stop` and `start` are for what the files leave open: see `experiment`. `outside`: folders elsewhere whose
    files may be opened. Inputs that nothing drives keep the start values of their FMUs.

    Raises InputError for what is not supported, missing or contradictory; FmuError for FMUs that cannot be read.
    """

    def __init__(
        self, path: Path, step: str = "", stop: str = "", outside: tuple[Path, ...] = (), start: str = ""
    ) -> None:  # fmt: skip
        self.path, self.text = path, ""
        self.places: dict[tuple[str, str], str] = {}
        notes, remarks = Notes(), list[str]()
        archive = Archive.open(path, outside, notes)
        self.document = Document(
            archive.structure, archive.shown(archive.structure), "SystemStructureDescription", notes
        )
        root = read_structure(archive, self.document, Parameters({}).sized)
        self.components = {component.name: component for component in root.components()}
        if not self.components:
            raise InputError(f"{path.name} holds no component at all, only systems: there is nothing to simulate")
        wires = wires_of(root)
        self.driven = _driven_inputs(wires)
        parameters = Parameters(wires)
        stated = parameters.collect(root)
        links = list(links_of(wires))
        self.places |= {(str(link), ""): link.where for link in links}
        keys = self._own_keys()
        clocks = self._clock_connections(keys.pop(CLOCKS, []))
        tables = {name: self._component(component) for name, component in self.components.items()}
        self._times(tables, keys, step, stop, start, remarks)
        self._values(tables, stated)
        self.data: dict[str, Any] = {
            **keys,
            "description": self.document.root.get("description", ""),
            "components": tables,
            "connections": [*links, *clocks],
        }
        self.notes = {name: (component.note,) for name, component in self.components.items() if component.note}
        self.remarks = (*remarks, *_told(parameters.passed_over), *self._variants(archive))
        self.breaches = notes.all()

    @property
    def name(self) -> str:
        stated = self.document.root.get("name") or self.path.stem
        return "".join(c if c.isalnum() or c in "-_ " else "_" for c in stated) or "system"

    def at(self, needle: str, table: str = "") -> str:
        """Where a value, a connection or a component stands: `(vehicle.ssp/SystemStructure.ssd, line 12)`."""
        for key in ((needle, table), (needle, ""), ("", table), ("", needle.strip("[]"))):
            if key in self.places:
                return self.places[key]
        return f"({self.path.name})"

    def _own_keys(self) -> dict[str, Any]:
        """What our annotation of the whole holds."""
        keys = annotated(self.document, self.document.root)
        for key in keys.keys() & set(OWN_KEYS):
            raise self.document.fail(f"the annotation of the system cannot hold '{key}'", self.document.root)
        return {"format": FORMATS[0] if keys else FORMATS[-1]} | keys  # other tools knew no format, nor ours before

    def _clock_connections(self, found: object) -> list[str]:
        if not (isinstance(found, list) and all(isinstance(entry, str) and "->" in entry for entry in found)):
            raise self.document.fail(
                f"{CLOCKS} of the annotation of the system is no list of 'a.x -> b.y'", self.document.root
            )
        return [str(entry) for entry in found]

    def _component(self, component: Element) -> dict[str, Any]:
        assert component.fmu
        self.places["", f"components.{component.name}"] = component.document.at(component.xml)
        keys = annotated(component.document, component.xml)
        for key in keys.keys() & {"fmu", "parameters", "inputs"}:
            raise component.document.fail(f"the annotation of a component cannot hold '{key}'", component.xml)
        return {**keys, "fmu": str(component.fmu.path.absolute()), "parameters": {}, "inputs": {}}

    def _times(
        self, tables: dict[str, Any], keys: dict[str, Any], step: str, stop: str, start: str, remarks: list[str]
    ) -> None:  # fmt: skip
        """Put start, stop and the periods in their places."""
        experiment = next(iter(find(self.document.root, "DefaultExperiment")), None)
        stated = {} if experiment is None else experiment.attrib
        begin = instant(
            start or keys.pop("start_time", "") or stated.get("startTime", "0"), f"{self.path.name}: start time"
        )
        exact = keys.pop("stop_time", None)  # for times that are no double: 1/3 s
        text = str(stop or exact or stated.get("stopTime", ""))
        fmus = {name: component.fmu for name, component in self.components.items() if component.fmu}
        end = stop_of(text, begin, fmus, self.path.name, remarks)
        own = {name: str(table["period"]) for name, table in tables.items() if table.get("period")}
        steps = {name: own.get(name) or step or component.step for name, component in self.components.items()}
        periods = periods_of(fmus, steps, end - begin, remarks)
        for name, period in periods.items():
            tables[name]["period"] = own.get(name) or f"{period} s"
        fixed = [t for name, t in periods.items() if (fmu := self.components[name].fmu) and not fmu.can_vary_step]
        whole = end if stop or exact else whole_stop(begin, end, fixed, remarks)
        keys |= {"start_time": f"{begin} s", "stop_time": f"{whole} s"}

    def _values(self, tables: dict[str, Any], stated: Mapping[End, Stated]) -> None:
        """Put the values of parameters and inputs in their places; those of driven inputs are their drivers'."""
        for (element, name), value in stated.items():
            assert element.fmu
            scalars = element.fmu.expand(name)
            variable = element.fmu.variables[scalars[0]]
            if not settable(variable) or element.fmu.type_of(scalars[0]) is None:
                value.document.notes.add(NOT_SETTABLE, f"{element.name}.{name} {value.where}")
            elif variable.causality != "input":
                tables[element.name]["parameters"][name] = value.value(element, name)
            elif not self._driven(element, name):
                tables[element.name]["inputs"][name] = value.value(element, name)
            self.places[name, f"components.{element.name}"] = value.where
        for name, component in self.components.items():
            assert component.fmu
            driven = {scalar for scalar in component.fmu.names("input") if self._driven(component, scalar)}
            for scalar, start in lacking_starts(component.fmu, {*tables[name]["inputs"], *driven}):
                component.document.notes.add(NO_START, f"{name}.{scalar} {component.document.at(component.xml)}")
                tables[name]["inputs"][scalar] = start

    def _driven(self, component: Element, name: str) -> bool:
        """Whether a component drives an input, the array that it is an element of, or an element of it."""
        ends = self.driven.get(component, set())
        return not ends.isdisjoint({name, name.split("[")[0], f"{name}[]"})

    def _variants(self, archive: Archive) -> tuple[str, ...]:
        """That there are further structures in a package."""
        others = archive.others() if archive.packed else []
        if not others or "#" in str(self.path):
            return ()
        return (f"{self.path.name} holds further structures, {listed(others)}: run {self.path.name}#{others[0]}",)


def _driven_inputs(wires: Mapping[End, Wire]) -> dict[Element, set[str]]:
    """The inputs of each component that another one drives; `u[]` where it is elements of an array."""
    found: dict[Element, set[str]] = {}
    for element, name in wires:
        if element.fmu and path_to(wires, (element, name))[0].source[0].fmu:
            base = name.split("[")[0]
            found.setdefault(element, set()).update({name} if base == name else {name, f"{base}[]"})
    return found


def _told(passed_over: Mapping[str, str]) -> tuple[str, ...]:
    """That parameters were passed over, those first that were nearly meant."""
    names = sorted(passed_over, key=lambda name: not passed_over[name].startswith("(did"))
    if not names:
        return ()
    return (f"passed over, since nothing has them: parameters {listed(f'{n} {passed_over[n]}' for n in names)}",)
