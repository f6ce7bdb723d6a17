"""A component driven step by step, as kernel and as FMU of either version: the same calls, the same outputs."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from lives import Instance, component
from rovbrush.orchestrator.participant.here.exit_guard import end_before_library_destructors

COLLECTED = ctypes.POINTER(ctypes.c_double)


class DrivenKernel:
    """The kernel's functions without FMI, under Numba."""

    def __init__(self, name: str, functions: Any, parameters: Mapping[str, Any]) -> None:
        self.instance = Instance(component(name), functions, **parameters)

    def start(self, inputs: Mapping[str, Any]) -> None:
        self.instance.set(**inputs)
        self.instance.start()

    def run(self, rows: np.ndarray, layout: Mapping[str, slice], h: float) -> np.ndarray:
        """Outputs after every step, (steps, outputs); inputs from `rows` (steps, inputs)."""
        values, seen = self.instance.values, np.empty((len(rows), len(self.instance.values["y"])))
        for k, row in enumerate(rows):
            for name, place in layout.items():
                if place.stop - place.start > 1:
                    values[name][:] = row[place]
                else:
                    values[name] = float(row[place.start])
            values["t"] = k * h
            values["h"] = h
            self.instance.call("step")
            seen[k] = values["y"]
        return seen


class DrivenFmu:
    """An FMU of FMI 2.0 or 3.0, loaded by fmpy and called through its C functions."""

    def __init__(self, path: Path, folder: Path, parameters: Mapping[str, Any]) -> None:
        end_before_library_destructors()  # a Python FMU can abort the process at its end
        self.folder = folder if folder.exists() else extract(str(path), str(folder))  # a loaded library stays as it is
        self.description = read_model_description(self.folder)
        self.fmi3 = self.description.fmiVersion.startswith("3")
        keys = {
            "guid": self.description.guid,
            "modelIdentifier": self.description.coSimulation.modelIdentifier,
            "unzipDirectory": str(self.folder),
            "instanceName": "driven",
        }
        self.slave: Any = FMU3Slave(**keys) if self.fmi3 else FMU2Slave(**keys)
        self.slave.instantiate()
        if not self.fmi3:
            self.slave.setupExperiment()
        self.slave.enterInitializationMode()
        self.parameters = parameters

    def references(self, *causalities: str) -> list[int]:
        return [v.valueReference for v in self.description.modelVariables if v.causality in causalities]

    def start(self, inputs: Mapping[str, Any]) -> None:
        for name, value in {**self.parameters, **inputs}.items():
            self.set(name, value)
        self.slave.exitInitializationMode()

    def set(self, name: str, value: Any) -> None:
        """One variable by name; an array as a whole."""
        many = np.atleast_1d(np.asarray(value)).tolist()
        found = [v for v in self.description.modelVariables if v.name == name or v.name.startswith(f"{name}[")]
        kind = {"Integer": "Int32" if self.fmi3 else "Integer", "Real": "Real"}.get(found[0].type, found[0].type)
        getattr(self.slave, f"set{kind}")([v.valueReference for v in found], many)

    def run(self, rows: np.ndarray, layout: Mapping[str, slice], h: float) -> np.ndarray:
        """As DrivenKernel.run."""
        dll, c = self.slave.dll, self.slave.component
        targets = (ctypes.c_uint32 * len(layout))() if self.fmi3 else (ctypes.c_uint32 * rows.shape[1])()
        targets[:] = self.references("input")
        sources = self.references("output", "calculatedParameter")
        origins = (ctypes.c_uint32 * len(sources))(*sources)
        width = self.width()
        rows, seen = np.ascontiguousarray(rows), np.empty((len(rows), width))
        flags = [ctypes.byref(ctypes.c_bool()) for _ in range(3)] + [ctypes.byref(ctypes.c_double())]
        for k in range(len(rows)):
            given = ctypes.cast(rows.ctypes.data + k * rows.strides[0], COLLECTED)
            taken = ctypes.cast(seen.ctypes.data + k * seen.strides[0], COLLECTED)
            if self.fmi3:
                status = [
                    dll.fmi3SetFloat64(c, targets, len(targets), given, rows.shape[1]),
                    dll.fmi3DoStep(c, ctypes.c_double(k * h), ctypes.c_double(h), True, *flags),
                    dll.fmi3GetFloat64(c, origins, len(origins), taken, width),
                ]
            else:
                status = [
                    dll.fmi2SetReal(c, targets, len(targets), given),
                    dll.fmi2DoStep(c, ctypes.c_double(k * h), ctypes.c_double(h), 1),
                    dll.fmi2GetReal(c, origins, len(origins), taken),
                ]
            assert not any(status), (k, status)
        return seen

    def width(self) -> int:
        found = [v for v in self.description.modelVariables if v.causality in ("output", "calculatedParameter")]
        return sum(int(v.dimensions[0].start) if v.dimensions else 1 for v in found)

    def close(self) -> None:
        self.slave.terminate()
        self.slave.fmi2FreeInstance(self.slave.component) if not self.fmi3 else self.slave.fmi3FreeInstance(
            self.slave.component
        )


def input_layout(name: str) -> dict[str, slice]:
    """Columns of each input in a table of inputs."""
    layout, first = {}, 0
    for v in component(name).inputs:
        layout[v.name] = slice(first, first + len(v.start))
        first += len(v.start)
    return layout
