"""An OspSystemStructure.xml as a system file: the same keys as TOML, so that the same reader checks them."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ...clock import duration, instant
from ...errors import InputError, shown
from ...fmu.tolerant.rules import Notes
from ...toml.file import TomlFile
from ..experiment import periods_of, stop_of, whole_stop
from ..inputs.free_inputs import lacking_starts
from ..model import FORMATS
from ..ssp.files.rules import NO_START
from .connections import Network, Wire
from .document import OspDocument, find
from .functions import functions_of, sum_fmu
from .groups import Groups
from .simulators import Simulator, simulators_of

FILE = "OspSystemStructure.xml"
# The standard's words for algorithms, ours, and whether power bonds choose the steps.
ALGORITHMS = (("", "jacobi", False), ("fixedstep", "jacobi", False), ("ecco", "ecco", True))
ECCO = {
    "SafetyFactor": "safety", "MinimumStepSize": "minimum", "MaximumStepSize": "maximum", "MinimumChangeRate": "shrink",
    "MaximumChangeRate": "grow", "ProportionalGain": "proportional", "IntegralGain": "integral",
    "RelativeTolerance": "relative", "AbsoluteTolerance": "tolerance",
}  # fmt: skip


class OspFile(TomlFile):
    """The data of an OspSystemStructure.xml, or of the folder that holds one, and where in it they stand.

    `step`, `stop` and `start` are for what the file leaves open: see `experiment`. Raises InputError for what is not
    supported, missing or contradictory; FmuError for FMUs that cannot be read.
    """

    def __init__(self, path: Path, step: str = "", stop: str = "", start: str = "") -> None:
        file = path / FILE if os.path.isdir(path) else path
        if not os.path.isfile(file):
            raise InputError(f"system file {path} does not exist")
        self.path, self.text = file, ""
        self.places: dict[tuple[str, str], str] = {}
        notes, remarks = Notes(), list[str]()
        self.document = document = OspDocument(file, "OspSystemStructure", notes)
        simulators = simulators_of(document, remarks)
        functions = functions_of(document, find(document.root, "Functions"))
        network = Network(document, simulators, functions, Groups(file.parent, notes))
        sums = self._sums(network, simulators)
        links = list(network.links(sums))
        self.places |= {(str(link), ""): link.where for link, _ in links}
        tables = {s.component: self._component(s) for s in simulators.values()}
        for simulator in simulators.values():
            driven = {link.input_ for link, _ in links if link.target == simulator.component}
            self._values(simulator, tables[simulator.component], driven)
        begin = instant(start or document.text("StartTime") or "0", f"{file.name}: StartTime")
        end = stop_of(stop or document.text("EndTime"), begin, self._fmus(simulators), file.name, remarks)
        steps = {s.component: s.step or step for s in simulators.values()}
        periods = periods_of(self._fmus(simulators), steps, end - begin, remarks)
        for name, period in periods.items():
            tables[name]["period"] = f"{period} s"
        shortest = min(periods.values())
        tables |= {name: {"fmu": f"sum {name}", "period": f"{shortest} s"} for name in sums.values()}
        if too_long := [name for name, period in periods.items() if period > end - begin]:
            raise InputError(f"{file.name}: the steps of {', '.join(too_long)} are longer than the run")
        fixed = [period for name, period in periods.items() if not self._fmus(simulators)[name].can_vary_step]
        end = end if stop else whole_stop(begin, end, fixed, remarks)
        self.data: dict[str, Any] = {
            "format": FORMATS[-1],
            **self._algorithm([(wire, str(link)) for link, wire in links]),
            "description": document.text("Description"),
            "start_time": f"{begin} s",
            "stop_time": f"{end} s",
            "components": tables,
            "connections": [link for link, _ in links],
        }
        self.remarks, self.breaches = tuple(remarks), notes.all()

    @property
    def name(self) -> str:
        return self.path.absolute().parent.name if self.path.name == FILE else self.path.stem

    def at(self, needle: str, table: str = "") -> str:
        for key in ((needle, table), (needle, ""), ("", table), ("", needle.strip("[]"))):
            if key in self.places:
                return self.places[key]
        return f"({self.path.name})"

    def _sums(self, network: Network, simulators: Mapping[str, Simulator]) -> dict[str, str]:
        """The components that functions are which add several signals, by the names of the functions."""
        taken = {s.component for s in simulators.values()}
        found: dict[str, str] = {}
        self.made = {}
        for name, function in network.sums().items():
            component = "".join(c if c.isalnum() else "_" for c in name)
            while component in taken:
                component += "_sum"
            taken.add(component)
            found[name] = component
            terms = {out: connected for out in function.terms if (connected := network.connected(function, out))}
            self.made[component] = sum_fmu(component, terms)
        return found

    @staticmethod
    def _fmus(simulators: Mapping[str, Simulator]) -> dict[str, Any]:
        return {s.component: s.fmu for s in simulators.values()}

    def _component(self, simulator: Simulator) -> dict[str, Any]:
        self.places["", f"components.{simulator.component}"] = self.document.at(simulator.xml)
        return {"fmu": str(simulator.fmu.path.absolute()), "parameters": {}, "inputs": {}}

    def _values(self, simulator: Simulator, table: dict[str, Any], driven: set[str]) -> None:
        """Put initial values in their places; those of driven inputs are their drivers'."""
        fmu = simulator.fmu
        for name, text in simulator.values.items():
            scalars = fmu.expand(name)
            if scalars and fmu.variables[scalars[0]].causality == "input":
                if not {name, *scalars} & driven:
                    table["inputs"][name] = text
            else:
                table["parameters"][name] = text
        for name, start in lacking_starts(fmu, {*table["inputs"], *driven}):
            self.document.notes.add(NO_START, f"{simulator.name}.{name} {self.document.at(simulator.xml)}")
            table["inputs"][name] = start

    def _algorithm(self, wires: list[tuple[Wire, str]]) -> dict[str, Any]:
        """The algorithm, and what it needs: all at once for fixed steps; power bonds and settings for ECCO."""
        stated = self.document.text("Algorithm")
        ours, by_bonds = next(
            ((ours, bonds) for word, ours, bonds in ALGORITHMS if word == stated.lower()), ("", False)
        )
        if not ours:
            raise InputError(
                f"{self.path.name}: the algorithm '{shown(stated)}' is not supported; fixedStep and ecco are"
            )
        found: dict[str, Any] = {"algorithm": ours}
        if not by_bonds:
            return found
        bonds: dict[str, list[str]] = {}
        for wire, link in wires:
            if wire.bond:
                bonds.setdefault(wire.bond, []).append(link.partition(" -> ")[2])
        for name, ends in bonds.items():
            if len(ends) != 2:
                raise InputError(f"{self.path.name}: power bond '{shown(name)}' needs two connections, not {len(ends)}")
        found["bonds"] = [{"name": name, "effort": a, "flow": b} for name, (a, b) in bonds.items()]
        for xml in find(self.document.root, "EccoConfiguration/*")[:50]:
            key = ECCO.get(str(xml.tag).rpartition("}")[2])
            if key:
                number = self.document.number((xml.text or "").strip(), key, xml)
                value = f"{duration(number, key)} s" if key in ("minimum", "maximum") else number
                found.setdefault(ours, {})[key] = value
        return found
