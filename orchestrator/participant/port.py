"""Several scalars of a participant in this process, exchanged by one call: for drivers that need no compiled loop."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import chain
from typing import Any

from ..fmu.types import Value, function_type
from .here.loaded import LoadedInstance


class Port:
    """Scalars of one type; the elements of an array are named as in FMI 2.0: `u[1]`, `u[2]` ..."""

    def __init__(self, instance: LoadedInstance, names: Sequence[str]) -> None:
        self.instance, self.names, fmu = instance, names, instance.fmu
        scalars = list(dict.fromkeys(chain.from_iterable(fmu.arrays[name] for name in names)))
        self.references = [fmu.places[name].reference for name in scalars if fmu.places[name].index == 0]
        self.places = [scalars.index(name) for name in names]
        self.turned = [fmu.places[name].turned for name in names]
        self.values: list[Any] = [fmu.start(name) for name in scalars]
        self.kind = function_type(fmu.version, fmu.variables[names[0]].type) if names else ""

    def put(self, values: Iterable[Any]) -> None:
        """Set them, in the order of the names."""
        for place, turned, value in zip(self.places, self.turned, values, strict=True):
            self.values[place] = turned(value)
        if self.names:
            self.instance.put(", ".join(self.names), self.kind, self.references, self.values)

    def take(self) -> list[Any]:
        """Get them, in the order of the names."""
        if not self.names:
            return []
        values = self.instance.take(", ".join(self.names), self.kind, self.references, len(self.values))
        return [turned(values[place]) for place, turned in zip(self.places, self.turned, strict=True)]


class Ports:
    """Scalars of any types, exchanged by one call for each type that is there."""

    def __init__(self, instance: LoadedInstance, names: Sequence[str]) -> None:
        fmu, kinds = instance.fmu, dict[str, list[str]]()
        for name in names:
            kinds.setdefault(function_type(fmu.version, fmu.variables[name].type), []).append(name)
        self.names = names
        self.ports = [Port(instance, group) for group in kinds.values()]

    def put(self, values: Iterable[Any]) -> None:
        """Set them, in the order of the names."""
        given = dict(zip(self.names, values, strict=True))
        for port in self.ports:
            port.put(given[name] for name in port.names)

    def take(self) -> list[Value]:
        """Get them, in the order of the names, as numbers, truth values, texts and bytes."""
        found: dict[str, Value] = {}
        for port in self.ports:
            found |= zip(port.names, map(READ.get(port.kind, _same), port.take()), strict=True)
        return [found[name] for name in self.names]


def _same(value: Any) -> Any:
    return value


def _text(value: bytes | str | None) -> str:
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else value or ""


def _bytes(value: bytes | None) -> bytes:
    return bytes(value or b"")


READ: dict[str, Callable[[Any], Value]] = {"Boolean": bool, "String": _text, "Binary": _bytes}
