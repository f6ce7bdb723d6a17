"""What instances of FMI 2.0 and 3.0 in this process have in common: a library loaded by fmpy, and its states."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from typing import Any

from ..errors import FmuError
from ..fmu.fmu import Fmu
from ..fmu.types import function_type
from .base import Instance, Value


class LoadedInstance(Instance):
    """An instance whose library is in this process; `slave` is fmpy's."""

    slave: Any

    def __init__(self, fmu: Fmu, name: str) -> None:
        super().__init__(fmu, name)
        self.arrays: dict[int, list[Value]] = {}  # values of arrays by reference: one element needs all the others

    @property
    def pointer(self) -> int:
        return int(self.slave.component)

    def address(self, function: str) -> int:
        try:
            return ctypes.cast(getattr(self.slave.dll, function), ctypes.c_void_p).value or 0
        except AttributeError:
            raise FmuError(f"component {self.name}: {self.fmu.path.name} has no function {function}") from None

    def set_own(self, values: Mapping[str, Value]) -> None:
        fmu = self.fmu.own
        for name, value in values.items():
            place, v = fmu.places[name], fmu.variables[name]
            setter = getattr(self.slave, f"set{function_type(self.fmu.version, v.type)}")
            sent = [value]
            if place.count > 1:
                known = self.arrays.setdefault(place.reference, [fmu.start(s) for s in fmu.arrays[name]])
                known[place.index] = value
                sent = known
            self.call(f"set {name} = {value}", setter, [place.reference], sent)

    def get_own(self, name: str) -> Any:
        place, v = self.fmu.own.places[name], self.fmu.own.variables[name]
        getter = getattr(self.slave, f"get{function_type(self.fmu.version, v.type)}")
        count = [place.count] if place.count > 1 else []
        value = self.call(f"get {name}", getter, [place.reference], *count)[place.index]
        if v.type == "Boolean":
            return bool(value)
        return value.decode("utf-8", "replace") if isinstance(value, bytes) else "" if value is None else value

    def save(self) -> int:
        self.require_state()
        return int(self.call("save its state", self.slave.getFMUState).value)

    def restore(self, state: int) -> None:
        self.call("restore its state", self.slave.setFMUState, ctypes.c_void_p(state))

    def forget(self, state: int) -> None:
        self.call("forget a state", self.slave.freeFMUState, ctypes.c_void_p(state))

    def serialize(self, state: int) -> bytes:
        return bytes(self.call("write its state", self.slave.serializeFMUState, ctypes.c_void_p(state)))

    def close(self, terminate: bool = True) -> None:
        """The library stays loaded: unloading one with Python inside is not safe."""
        if self.dead:
            return
        try:
            if terminate:
                self.slave.terminate()
            self.free()
        except Exception as error:
            self.messages.append(f"closing failed: {error}")
        self.dead = True

    def free(self) -> None:
        """Free the instance."""
        raise NotImplementedError
