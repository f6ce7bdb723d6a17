"""An SSP as a system file: the same keys as TOML, so that the same reader checks them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ...errors import InputError
from ...toml_file import TomlFile
from .annotations import annotated
from .archive import Archive
from .document import Document, find
from .parameters import Parameters
from .structure import MODEL_EXCHANGE, Element, read_structure
from .units import definitions
from .wires import links_of, path_to, wires_of

OWN_KEYS = ("components", "connections", "description", "parameters")  # not to be had from annotations


class SspFile(TomlFile):
    """The data of an SSP (1.0 or 2.0), and where in its files they stand.

    `step` and `stop` are for what the file leaves open: a component's period is that of our annotation, else `step`,
    else the step size of its FMU's default experiment; the stop time is that of the file's default experiment, or
    `stop`. Inputs that nothing drives keep the start values of their FMUs.

    Raises InputError for what is not supported, missing or contradictory; FmuError for FMUs that cannot be read.
    """

    def __init__(self, path: Path, step: str = "", stop: str = "") -> None:
        self.path, self.text = path, ""
        self.step, self.stop = step, stop
        self.places: dict[tuple[str, str], str] = {}
        archive = Archive.open(path)
        self.document = Document(archive.structure, archive.shown(archive.structure), "SystemStructureDescription")
        root = read_structure(archive, self.document)
        self.wires = wires_of(self.document, root)
        stated = Parameters(archive, self.document, self.wires).collect(root)
        links = list(links_of(self.wires, definitions(self.document)))
        self.places |= {(str(link), ""): link.where for link in links}
        tables = {component.name: self._component(component) for component in root.components()}
        self.notes = {
            component.name: (f"{component.name}: the SSP wants {MODEL_EXCHANGE}; the FMU is run in co-simulation",)
            for component in root.components()
            if component.xml.get("implementation") == MODEL_EXCHANGE
        }
        for (element, name), value in stated.items():
            assert element.fmu
            kind = "inputs" if element.fmu.variables[element.fmu.expand(name)[0]].causality == "input" else "parameters"
            tables[element.name][kind][name] = value.value(element, name)
            self.places[name, f"components.{element.name}"] = value.where
        for component in root.components():
            self._start_values(component, tables[component.name]["inputs"])
        keys = annotated(self.document, self.document.root)
        for key in keys.keys() & set(OWN_KEYS):
            raise self.document.fail(f"the annotation of the system cannot hold '{key}'", self.document.root)
        self.data: dict[str, Any] = {
            **keys,
            "description": self.document.root.get("description", ""),
            "stop_time": self._stop(keys),
            "components": tables,
            "connections": links,
        }

    @property
    def name(self) -> str:
        return "".join(c if c.isalnum() or c in "-_ " else "_" for c in self.document.root.get("name")) or "system"

    def at(self, needle: str, table: str = "") -> str:
        """Where a value, a connection or a component stands: `(vehicle.ssp/SystemStructure.ssd, line 12)`."""
        for key in ((needle, table), (needle, ""), ("", table), ("", needle.strip("[]"))):
            if key in self.places:
                return self.places[key]
        return f"({self.path.name})"

    def _component(self, component: Element) -> dict[str, Any]:
        assert component.fmu
        self.places["", f"components.{component.name}"] = self.document.at(component.xml)
        keys = annotated(self.document, component.xml)
        for key in keys.keys() & {"fmu", "parameters", "inputs"}:
            raise self.document.fail(f"the annotation of a component cannot hold '{key}'", component.xml)
        experiment = component.fmu.description.defaultExperiment
        period = keys.get("period") or self.step or (experiment and experiment.stepSize)
        if not period:
            raise self.document.fail(
                f"component '{component.name}' has no period: neither the file nor the FMU's default experiment "
                f'states one; give one with --step "1 ms" (of run, plan and export)',
                component.xml,
            )
        fmu = str(component.fmu.path.absolute())
        return {**keys, "fmu": fmu, "period": period, "parameters": {}, "inputs": {}}

    def _start_values(self, component: Element, inputs: dict[str, Any]) -> None:
        """Inputs without a driver and a value take the start values of their FMU."""
        assert component.fmu
        for name in component.fmu.names("input"):
            base = name.split("[")[0]
            ends = [(component, end) for end in (name, base) if (component, end) in self.wires]
            driven = [path_to(self.wires, end)[0].source[0].fmu for end in ends]
            start = component.fmu.variables[name].start
            if not any(driven) and name not in inputs and base not in inputs and start is not None:
                inputs[name] = start

    def _stop(self, keys: dict[str, Any]) -> str:
        experiment = next(iter(find(self.document.root, "ssd:DefaultExperiment")), None)
        start = "0" if experiment is None else experiment.get("startTime", "0")
        if float(start) != 0.0:
            raise self.document.fail(f"a start time of {start} s is not supported; runs begin at 0", experiment)
        exact = keys.pop("stop_time", None)  # for times that are no double: 1/3 s
        stated = exact or (experiment is not None and experiment.get("stopTime"))
        if not (self.stop or stated):
            raise InputError(f'{self.path.name} states no stop time; give one with --stop "10 s" (of run and export)')
        return str(self.stop or stated)
