"""A whole system as one FMU, by the containers of fmu-manipulation-toolbox.

A container steps its FMUs in parallel at one period, with inputs held from the beginning of each step: `jacobi` with
`hold`. Several periods nest: the container of the slowest components holds, as one more FMU, the container of all that
are faster, so each period must be a whole multiple of the next faster one. Parameters that the system sets and inputs
that nothing drives can be set from outside, as `component.variable`; so are all outputs named.

A container does not solve loops at time 0, and a nested one gives zeros until its first step: what slow components
hear of fast ones comes one slow period late. Inputs are to be set before steps, not before the initialization.
"""

from __future__ import annotations

import logging
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

from ..clock import seconds_text
from ..errors import InputError, RunError
from ..files import prepare_folder, write_file
from ..fmu.binary import as_text
from ..fmu.kinds import CO_SIMULATION, WORDS
from ..plan.plan import Plan
from ..system.component import Component
from ..system.inputs.series import refuse_series
from ..system.model import System
from ..system.replace.view import crossings_of

End = tuple[str, str]


@dataclass
class Level:
    """The components of one period, and the toolbox's node that becomes their container."""

    period: Fraction
    node: Any
    shown: set[End]  # ends of faster components for which this level's container has a port


def write_container(system: System, path: Path) -> list[str]:
    """Write the container; returns what the toolbox has to say of it.

    Raises InputError for what a container cannot hold, RunError where the toolbox fails.
    """
    if path.suffix != ".fmu" or not path.stem.isidentifier():
        raise InputError(f"--out {path}: the name must end in .fmu and be made of letters, digits and _")
    _check(system)
    try:
        from fmu_manipulation_toolbox.assembly import AssemblyError, AssemblyNode
        from fmu_manipulation_toolbox.container import FMUContainerError
    except ImportError:
        raise InputError("a container needs fmu-manipulation-toolbox: pip install 'rovbrush[check]'") from None
    prepare_folder(path.parent)
    levels = _levels(system, path.name, AssemblyNode)
    _wire(system, levels)
    version = max(int(component.fmu.description.fmiVersion[0]) for component in system.components.values())
    with tempfile.TemporaryDirectory(prefix="rovbrush_container_") as folder:
        try:
            with _warnings() as notes:
                levels[-1].node.make_fmu(Path(folder), fmi_version=version)
        except (AssemblyError, FMUContainerError, OSError) as error:
            raise RunError(f"the container of {system.name} cannot be built: {error}") from error
        content = (Path(folder) / path.name).read_bytes()
    write_file(path, lambda temporary: temporary.write_bytes(content))
    return notes


@contextmanager
def _warnings() -> Iterator[list[str]]:
    """The toolbox's warnings, each once, in place of lines on stderr."""
    found: list[str] = []
    handler = logging.Handler(logging.WARNING)
    handler.emit = lambda record: found.append(record.getMessage())  # type: ignore[method-assign]
    logger = logging.getLogger("fmu_manipulation_toolbox")
    logger.addHandler(handler)
    try:
        yield found
    finally:
        logger.removeHandler(handler)
        found[:] = dict.fromkeys(found)


def differences(plan: Plan) -> list[str]:
    """What the container does otherwise than the plan, for the user to know."""
    other = [c.label for c, choice in plan.choices.items() if choice.transfer != "hold"]
    notes = []
    if not plan.algorithm.parallel:
        notes.append(f"the container steps in parallel (jacobi), the plan by {plan.system.algorithm}")
    if other:
        notes.append(f"the container holds every signal; the plan has other transfers for {', '.join(other)}")
    notes += [f"{name} samples at the beginning of its step; in the container its outputs come one period later"
              for name in plan.samplers]  # fmt: skip
    notes += [f"{name} is read again at its instants; in the container it is read once, with the inputs of its step"
              for name in plan.instants.read_again(plan.cycle)]  # fmt: skip
    if len(set(plan.clock.periods.values())) > 1:
        notes.append("slow components hear of fast ones one slow period late: nested containers give zeros at time 0")
    return notes


def _check(system: System) -> None:
    refuse_series(system, "a container cannot hold")
    if system.events:
        raise InputError(
            f"a container cannot hold events, and the system has {system.events[0].name} {system.events[0].where}; "
            "export it without [[events]], or as an SSP (--ssp), where they are annotations of our own"
        )
    for name, component in system.components.items():
        if component.fmu.version == 1:
            raise InputError(
                f"component {name}: {component.fmu.path.name} is of FMI 1.0, and a container can hold FMI 2.0 and 3.0 "
                f"only; export it again as FMI 2.0, or the system as SSP"
            )
        if component.fmu.kind != CO_SIMULATION:
            raise InputError(
                f"component {name}: {component.fmu.path.name} is taken for {WORDS[component.fmu.kind]}, and a "
                f"container can hold co-simulation only; export it for that, or the system as SSP (--ssp)"
            )
        component.require_file("a container can hold FMUs only")
        if crossings_of(component.fmu):
            raise InputError(f"component {name} has its variables mapped, which a container cannot do")
        fmu = component.fmu
        if fmu.structure:
            sizes = ", ".join(f"{key} = {as_text(value)}" for key, value in fmu.structure.items())
            raise InputError(
                f"component {name}: a container cannot set structural parameters ({sizes}); export an SSP (--ssp)"
            )
        shown = (*fmu.names("output"), *component.parameters, *component.inputs)
        arrays = [v for v in shown if fmu.places[v].count > 1]
        if fmu.version == 3 and arrays:
            raise InputError(
                f"component {name}: {arrays[0].partition('[')[0]} is an array of FMI 3.0, which a container cannot "
                f"pass on; take an FMU of FMI 2.0, or export an SSP (--ssp)"
            )
        binary = [v for v in shown if fmu.variables[v].type == "Binary"]
        if binary:
            raise InputError(
                f"component {name}: {binary[0]} is Binary, which a container cannot pass on; export an SSP (--ssp)"
            )
    for connection in system.connections:
        if words := system.conversion(connection).words:
            raise InputError(
                f"connection {connection.label} converts {words}, which a container cannot do; put a component "
                f"between that does it {connection.where}"
            )
        if (connection.gain, connection.offset) != (1.0, 0.0):
            raise InputError(
                f"connection {connection.label} converts by {connection.gain:g} x + {connection.offset:g}, which a "
                f"container cannot do; put a component between that does it {connection.where}"
            )
    periods = sorted({component.period for component in system.components.values()})
    for fast, slow in pairwise(periods):
        if (slow / fast).denominator != 1:
            raise InputError(
                f"a container nests its periods, but {seconds_text(slow)} is no whole multiple of {seconds_text(fast)}"
            )


def _levels(system: System, name: str, node_type: Any) -> list[Level]:
    """Faster levels first, each inside the next; the last one is the file itself."""
    periods = sorted({component.period for component in system.components.values()})
    levels: list[Level] = []
    for k, period in enumerate(periods):
        file = name if k == len(periods) - 1 else f"level_{k}.fmu"
        node = node_type(file, float(period), auto_link=False, auto_input=False, auto_output=False)
        for component in system.components.values():
            if component.period == period:
                node.add_fmu(_inner(component.name), str(component.fmu.archive.absolute()))
        if levels:
            node.add_sub_node(levels[-1].node)
        levels.append(Level(period, node, set()))
    return levels


def _wire(system: System, levels: list[Level]) -> None:
    place = {name: next(k for k, level in enumerate(levels) if level.period == component.period)
             for name, component in system.components.items()}  # fmt: skip

    def port(end: End, at: int, output: bool) -> tuple[str, str]:
        """The FMU and port by which an end is reached at a level, through the containers of the faster ones."""
        owner, name = _inner(end[0]), end[1]
        for level in levels[place[end[0]] : at]:
            outside = ".".join(end)
            if end not in level.shown:
                level.shown.add(end)
                if output:
                    level.node.add_output(owner, name, outside)
                else:
                    level.node.add_input(outside, owner, name)
            owner, name = level.node.name, outside
        return owner, name

    top = len(levels) - 1
    for connection in system.connections:
        at = max(place[connection.source[0]], place[connection.target[0]])
        levels[at].node.add_link(*port(connection.source, at, True), *port(connection.target, at, False))
    for name, component in system.components.items():
        for variable in component.fmu.names("output"):
            levels[top].node.add_output(*port((name, variable), top, True), f"{name}.{variable}")
        for variable, text in _values(component):
            levels[place[name]].node.add_start_value(_inner(name), variable, text)
            levels[top].node.add_input(f"{name}.{variable}", *port((name, variable), top, False))


def _inner(name: str) -> str:
    """What a component's FMU is called in the container, where `motor.i` is to be the container's own output."""
    return f"{name}_fmu.fmu"


def _values(component: Component) -> Iterator[tuple[str, str]]:
    for variable, value in {**component.parameters, **component.inputs}.items():
        yield variable, str(value).lower() if isinstance(value, bool) else str(value)
