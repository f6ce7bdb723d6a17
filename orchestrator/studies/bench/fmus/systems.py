"""The systems that `rovbrush bench` measures: rings of feedthrough FMUs, native and made by pythonfmu, and nominal."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

from ....errors import InputError
from ....fmu.files.places import fmu_folder
from ....system.file.reader import load_system
from ....system.model import System
from .mixed import mixed_ring
from .native import ring

TRIVIAL_FMU = """
from pythonfmu import Fmi2Causality, Fmi2Slave, Fmi2Variability, Real


class Feedthrough(Fmi2Slave):
    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.u = 0.0
        self.y = 0.0
        self.register_variable(Real("u", causality=Fmi2Causality.input, variability=Fmi2Variability.continuous))
        self.register_variable(Real("y", causality=Fmi2Causality.output, variability=Fmi2Variability.continuous))

    def do_step(self, current_time, step_size):
        self.y = self.u
        return True
"""

PYTHON4 = """
format = 2
description = "four trivial Python FMUs in a ring"
stop_time = "20 s"
record = ["*"]
connections = ["a.y -> b.u", "b.y -> c.u", "c.y -> d.u", "d.y -> a.u"]
""" + "".join(f'[components.{name}]\nfmu = "Feedthrough.fmu"\nperiod = "1 ms"\n' for name in "abcd")


@dataclass(frozen=True)
class Case:
    """A system to measure, and for how many macro steps in another master (0: it cannot run there)."""

    name: str
    system: System
    steps_elsewhere: int = 0


def native_folder(fmus: Path | None) -> Path:
    """Where the native FMUs of the components are. Raises InputError where there are none."""
    native = (fmus or fmu_folder()) / "native" / "fmi2"
    if not native.is_dir():
        raise InputError(f"there are no native FMUs in {native}; build them with `rovbrush build --native`")
    return native


def cases(folder: Path, fmus: Path | None) -> list[Case]:
    """All systems, with what they need built in `folder`. Raises RunError without a C compiler, InputError without
    the native FMUs of the components."""
    native = native_folder(fmus)
    # Every other master steps in parallel with held inputs.
    alike = [
        Case("feedthrough4", load_system(str(ring(folder, 4, stop="200 s"))), 20_000),
        Case("signals20", load_system(str(ring(folder, 2, 20, stop="200 s"))), 20_000),
        Case("chain400", load_system(str(ring(folder, 400, stop="5 s"))), 300),
        Case("python4", trivial_system(folder), 3_000),
        Case("feedthrough4 of FMI 1.0, 2.0, 3.0", load_system(str(mixed_ring(folder, stop="200 s")))),
    ]
    return [
        *(replace(case, system=replace(case.system, algorithm="jacobi")) for case in alike),
        Case("nominal", load_system("nominal", fmus)),
        Case("nominal, native", load_system("nominal", native)),
    ]


def trivial_system(folder: Path) -> System:
    """Four feedthrough FMUs made by pythonfmu as they come, in a ring."""
    from pythonfmu.builder import FmuBuilder

    script = folder / "feedthrough_slave.py"
    script.write_text(TRIVIAL_FMU)
    FmuBuilder.build_FMU(script, folder / "Feedthrough.fmu")
    path = folder / "python4.toml"
    path.write_text(PYTHON4)
    return load_system(str(path))


def alone(system: System, component: str, period: Fraction) -> System:
    """One component of a system by itself: its inputs stay at their start values, 2 000 steps of `period` [s]."""
    chosen = system.components[component]
    driven = {c.target[1]: c for c in system.connections if c.target[0] == component}
    starts = {name: chosen.fmu.start(name) for name in driven if name not in chosen.inputs}
    kept = replace(chosen, period=period, inputs={**chosen.inputs, **starts})
    return replace(
        system, components={component: kept}, connections=(), bonds=(), requirements=(), record=(), order=(),
        stop=2000 * period, reporting={},
    )  # fmt: skip
