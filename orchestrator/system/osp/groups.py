"""Groups of variables: an FMU's OspModelDescription.xml, in the FMU, beside it, or beside the system's file."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ...errors import InputError, nearest, shown
from ...fmu.tolerant.rules import Notes
from .document import OspDocument, find, local
from .simulators import Simulator

FILE = "OspModelDescription.xml"


@dataclass(frozen=True)
class Group:
    """A group: its kind (Force, LinearMechanicalPort, ...), its variables, and the groups in it."""

    name: str
    kind: str
    variables: tuple[str, ...]
    groups: tuple[Group, ...] = ()

    def all(self) -> Iterator[Group]:
        """This one and those in it."""
        yield self
        for group in self.groups:
            yield from group.all()


class Groups:
    """The groups of all simulators, each description read when it is needed."""

    def __init__(self, folder: Path, notes: Notes) -> None:
        self.folder, self.notes = folder, notes
        self._known: dict[str, list[Group]] = {}

    def group(self, simulator: Simulator, name: str, label: str) -> Group:
        """A group of a simulator by name. Raises InputError."""
        if simulator.name not in self._known:
            self._known[simulator.name] = self._read(simulator, label)
        found = [group for top in self._known[simulator.name] for group in top.all()]
        for group in found:
            if group.name == name:
                return group
        raise InputError(
            f"{label}: '{simulator.name}' has no group '{shown(name)}'{nearest(name, (g.name for g in found))}"
        )

    def _read(self, simulator: Simulator, label: str) -> list[Group]:
        for path in self._places(simulator):
            if path.is_file():
                root = OspDocument(path, "OspModelDescription", self.notes).root
                return [_group(child) for child in (find(root, "VariableGroups") or [()])[0]]
        model = simulator.fmu.description.modelName
        raise InputError(
            f"{label}: the groups of '{simulator.name}' are not known; put {model}_{FILE} beside its FMU or beside the "
            f"system's file"
        )

    def _places(self, simulator: Simulator) -> Iterator[Path]:
        """Where a description may be, the closest to the FMU first."""
        fmu, beside = simulator.fmu, simulator.fmu.path.parent
        names = [f"{name}_{FILE}" for name in (fmu.description.modelName, fmu.path.stem, simulator.name)]
        for folder in (beside, self.folder):
            yield from (folder / name for name in names)
        for inside in ("", "resources", "extra/com.opensimulationplatform", "extra"):
            yield fmu.folder / inside / FILE
            yield from (fmu.folder / inside / name for name in names)


def _group(element: Any) -> Group:
    variables = [child.get("ref") or child.get("name") or "" for child in element if local(child) == "Variable"]
    groups = [_group(child) for child in element if local(child) != "Variable"]
    kind = element.get("type") or local(element)
    return Group(element.get("name") or "", kind, tuple(variables), tuple(groups))


def pairs(a: Group, b: Group, label: str) -> list[tuple[str, str]]:
    """The variables of two groups that belong together: in their order, and in groups in them by kind, else by order.

    Raises InputError where one has more than the other.
    """
    if len(a.variables) != len(b.variables) or len(a.groups) != len(b.groups):
        counts = [f"{len(g.variables)} variables and {len(g.groups)} groups" for g in (a, b)]
        raise InputError(f"{label}: '{a.name}' has {counts[0]}, '{b.name}' {counts[1]}")
    found = list(zip(a.variables, b.variables, strict=True))
    kinds = {group.kind: group for group in b.groups}
    by_kind = len(kinds) == len(b.groups) and {group.kind for group in a.groups} == set(kinds)
    for group, other in zip(a.groups, b.groups, strict=True):
        found += pairs(group, kinds[group.kind] if by_kind else other, label)
    return found
