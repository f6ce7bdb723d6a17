"""The loops behind `hosts`: one system, one other master, so many steps; run as a process of its own."""

from __future__ import annotations

import ctypes
import json
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ....clock import seconds_text
from ....errors import InputError, RunError
from ....fmu.files.unpacked import unpack
from ....participant.here.fmi2 import Fmi2Instance
from ....system.file.reader import load_system
from ....system.model import System

Output = tuple[str, str]


def load_tbb() -> bool:
    """Load the library that Ecos is linked to: the system's, or that of the package tbb in this environment."""
    for name in ("libtbb.so.12", str(Path(sys.prefix) / "lib" / "libtbb.so.12")):
        try:
            ctypes.CDLL(name, ctypes.RTLD_GLOBAL)
        except OSError:
            continue
        return True
    return False


def _libcosimpy(system: System, ssp: Path, steps: int, recording: bool) -> tuple[float, dict[str, float]]:
    from libcosimpy.CosimEnums import CosimVariableType
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
    from libcosimpy.CosimObserver import CosimObserver

    log_output_level(CosimLogLevel.ERROR)
    period = next(iter(system.components.values())).period * 10**9  # libcosim counts nanoseconds
    if period.denominator != 1:
        raise InputError(f"libcosim counts nanoseconds; a period of {seconds_text(period / 10**9)} is no whole number")
    execution = CosimExecution.from_ssp_file(str(unpack(ssp, "SSP")[0]), int(period))
    index = {name: execution.slave_index_from_instance_name(name) for name in system.components}
    references = {
        (name, output): component.fmu.variables[output].valueReference
        for name, component in system.components.items()
        for output in _outputs(component.fmu)
    }
    if recording:
        series = CosimObserver.create_time_series(buffer_size=steps + 1)
        execution.add_observer(series)
        for (name, _), reference in references.items():
            series.start_time_series(index[name], reference, CosimVariableType.REAL)
    execution.step(1)  # initializes as well
    begin = time.perf_counter()
    if not execution.step(steps - 2):
        raise RunError("libcosim stopped early")
    wall = time.perf_counter() - begin
    last = CosimObserver.create_last_value()  # costs something at every step, so only in the last
    execution.add_observer(last)
    execution.step(1)
    values = {
        f"{name}.{output}": last.last_real_values(index[name], [reference])[0]
        for (name, output), reference in references.items()
    }
    return wall / (steps - 2), values


def _ecospy(system: System, ssp: Path, steps: int, recording: bool) -> tuple[float, dict[str, float]]:
    load_tbb()
    from ecospy import EcosLib, EcosSimulation

    EcosLib.set_log_level("err")
    period = float(next(iter(system.components.values())).period)
    simulation = EcosSimulation(step_size=period, ssp_path=str(ssp))
    if recording:
        simulation.add_csv_writer(str(ssp.with_name("recorded.csv")))
    simulation.init(parameter_set=system.name)
    begin = time.perf_counter()
    simulation.step(steps)
    wall = time.perf_counter() - begin
    values = {
        f"{name}.{output}": simulation.get_real(f"{name}::{output}")
        for name, component in system.components.items()
        for output in _outputs(component.fmu)
    }
    return wall / steps, values


def _fmpy(system: System, _ssp: Path, steps: int, recording: bool) -> tuple[float, dict[str, float]]:
    """The textbook: all inputs, then all steps, then all outputs; written without the plan, to compare it with."""
    instances = {name: Fmi2Instance(component.fmu, name) for name, component in system.components.items()}
    outputs = {name: _outputs(component.fmu) for name, component in system.components.items()}
    numbers = {name: [instances[name].fmu.variables[o].valueReference for o in outputs[name]] for name in instances}
    into = {name: [c for c in system.connections if c.target[0] == name] for name in instances}
    inputs = {name: [instances[name].fmu.variables[c.target[1]].valueReference for c in into[name]] for name in into}
    values: dict[Output, float] = {}

    def exchange(name: str) -> None:
        given = [values.get(c.source, 0.0) * c.gain + c.offset for c in into[name]]
        if given:
            instances[name].slave.setReal(inputs[name], given)

    def read(name: str) -> None:
        got = instances[name].slave.getReal(numbers[name])
        values.update({(name, output): value for output, value in zip(outputs[name], got, strict=True)})

    for name, component in system.components.items():
        instances[name].set_up(None)
        instances[name].set_all({**component.parameters, **component.inputs})
        instances[name].enter_initialization()
    for name in instances:
        read(name)
    for _ in instances:  # outputs at time 0 may depend on inputs, one component after the other
        for name in instances:
            exchange(name)
            read(name)
    for instance in instances.values():
        instance.exit_initialization()
    period, recorded = next(iter(system.components.values())).period, []
    times = [float(k * period) for k in range(steps)]
    begin = time.perf_counter()
    for now in times:
        for name in instances:
            exchange(name)
        for instance in instances.values():
            instance.slave.doStep(now, float(period))
        for name in instances:
            read(name)
        if recording:
            recorded.append(dict(values))
    wall = time.perf_counter() - begin
    for instance in instances.values():
        instance.close()
    return wall / steps, {".".join(output): value for output, value in values.items()}


def _outputs(fmu: Any) -> list[str]:
    return [name for name in fmu.names("output") if fmu.variables[name].type == "Real"]


LOOPS: dict[str, Callable[[System, Path, int, bool], tuple[float, dict[str, float]]]]
LOOPS = {"libcosimpy": _libcosimpy, "ecospy": _ecospy, "fmpy": _fmpy}


MEMORY = 8_000_000_000  # bytes that a host may take


def main(host: str, ssp: str, steps: str, recording: str, answer: str) -> None:
    """The process of its own: run the host and leave the answer in a file."""
    if sys.platform != "win32":  # an allocation that fails ends this process, not the machine's others
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, resource.getrlimit(resource.RLIMIT_AS)[1]))
    system = load_system(ssp)
    seconds, outputs = LOOPS[host](system, Path(ssp), int(steps), recording == "1")
    Path(answer).write_text(json.dumps({"seconds_per_step": seconds, "outputs": outputs}), encoding="utf-8")
    sys.stdout.flush()
    os._exit(0)  # libraries with Python inside may abort while they are taken down; the answer is on disk


if __name__ == "__main__":
    main(*sys.argv[1:])
