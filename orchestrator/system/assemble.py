"""The only path from what was asked for to a checked system: its file, other FMUs, values, tables, what is recorded."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from ..clock import duration, instant, require_span
from ..errors import FmuError, InputError, nearest
from ..fmu.fmu import Fmu
from .file.events.added import with_scenarios
from .file.events.numbers import is_of_event, with_event_numbers
from .file.events.read import events_again
from .file.reader import load_system
from .file.recorded import select_recorded
from .inputs.free_inputs import require_values
from .inputs.series_file import with_files
from .model import System
from .one_fmu import component_name, is_fmu
from .replace.mapping import VariableMapping, load_mapping
from .replace.replacement import replace_component
from .request import UNCHANGED, Changes, Request, assignments, changes_of
from .workers import with_workers


def assemble(
    name: str,
    values: Mapping[str, object] | None = None,
    stop: str = "",
    fmus: Path | None = None,
    changes: Changes = UNCHANGED,
    boundaries: Sequence[str] = (),
    step: str = "",
    record: Sequence[str] = (),
    inputs: Sequence[Path] = (),
    start: str = "",
) -> System:
    """A system by the name of a shipped one or by the path of its file (or of an FMU), with what is to be different.

    `values`: parameters and free inputs, as of `--set`. `start`, `stop`: other times. `fmus`: the folder of built FMUs.
    `changes`: FMUs in the place of others, periods, a parameter set, events. `boundaries`: components of which every
    input and output is recorded. `step`: see `load_system`. `record`: patterns of what is recorded instead of what the
    system says. `inputs`: CSV files whose columns inputs follow. Raises InputError or FmuError.
    """
    if is_fmu(Path(name)):  # its steps are those of its period, and decide where it ends
        alone = component_name(Path(name))
        given = [text for owner, text in changes.periods if owner in ("", alone)]
        if len(given) > 1:
            raise InputError(f"--period {given[1]}: {alone} has {given[0]} already")
        step = given[0] if given else step
        changes = replace(changes, periods=tuple(p for p in changes.periods if p[0] not in ("", alone)))
    outside = tuple(map(Path, changes.outside))
    loaded = load_system(name, fmus, step, stop, outside, start, values, False, changes.parameters)
    own = {name: value for name, value in (values or {}).items() if not is_of_event(loaded, name)}
    system = apply_changes(loaded, changes).with_values(own, "--set")
    system = system if is_fmu(Path(name)) else over(system, start, stop)
    system = with_scenarios(system, map(Path, changes.scenarios), changes.events)
    system = with_event_numbers(system, values or {}, "--set")
    system = with_files(system, inputs)
    system = require_values(system, lambda message, table: InputError(f"{message} ({system.path.name}, {table})"))
    if record:
        system = select_recorded(system, record)
    for component in boundaries:
        if component not in system.components:
            raise InputError(f"--record-boundary: no component '{component}'{nearest(component, system.components)}")
        once = replace(system.components[component], direct="off")  # a replay sets its inputs, steps, and reads once
        system = system.with_component(once)
    return replace(system, record=(*system.record, *(f"{component}.*" for component in boundaries)))


def over(
    system: System, start: object = "", stop: object = "", options: Sequence[str] = ("--start", "--stop")
) -> System:
    """A copy that runs from `start` to `stop`, "2 s" or 2.0; an empty text leaves it as it is. Raises InputError."""
    begin = system.start if start == "" else instant(start, options[0])
    end = system.stop if stop == "" else instant(stop, options[1])
    if (begin, end) != (system.start, system.stop):
        require_span(begin, end)
    return replace(system, start=begin, stop=end)


def assemble_request(request: Request) -> System:
    """What the command line asked for. Raises InputError or FmuError."""
    system = assemble(
        request.system, assignments(request.set_), request.stop, Path(request.fmus) if request.fmus else None,
        changes_of(
            request.replace, request.map_, request.period, request.allow_outside, request.parameters,
            request.scenario, request.event,
        ),
        request.record_boundary, request.step, request.record, tuple(map(Path, request.input_)), request.start,
    )  # fmt: skip
    return with_workers(system, request.workers) if request.workers else system


def apply_changes(system: System, changes: Changes) -> System:
    """With other FMUs in the place of components, and other periods. Raises InputError or FmuError."""
    fmus = _by_component(system, "--replace", changes.fmus)
    mappings = _by_component(system, "--map", changes.mappings)
    given = _by_component(system, "--period", changes.periods)
    periods = {name: duration(text, f"--period {name}") for name, text in given.items()}
    for name in mappings.keys() - fmus.keys():
        raise InputError(f"--map {name}: nothing replaces {name}; give --replace {name}=their.fmu too")
    for name, path in fmus.items():
        mapping = load_mapping(Path(mappings[name])) if name in mappings else VariableMapping()
        system = replace_component(system, name, Fmu.open(Path(path)), mapping)
    if fmus and system.events:
        system = replace(system, events=events_again(system))
    return _with_periods(system, periods)


def _by_component(system: System, option: str, pairs: Sequence[tuple[str, str]]) -> dict[str, str]:
    """What is asked for by component; where there is one it needs no name."""
    found: dict[str, str] = {}
    first, *others = system.components
    for name, value in pairs:
        owner = first if not name and not others else name
        if not owner:
            said = value if option == "--period" else Path(value).name
            quoted = f'"{said}"' if " " in said else said
            raise InputError(
                f"{option} {said}: write component=value, for instance {option} {first}={quoted}; there are "
                f"{', '.join(system.components)}"
            )
        if owner not in system.components:
            raise InputError(f"{option}: no component '{owner}'{nearest(owner, system.components)}")
        if owner in found:
            raise InputError(f"{option} {value}: {owner} has {found[owner]} already")
        found[owner] = value
    return found


def _with_periods(system: System, periods: Mapping[str, Fraction]) -> System:
    """With other periods; a stated order goes on putting fast before slow."""
    components = {name: replace(c, period=periods.get(name, c.period)) for name, c in system.components.items()}
    order = tuple(sorted(system.order, key=lambda name: components[name].period))
    return replace(system, components=components, order=order if periods else system.order)


def strictly(system: System) -> System:
    """The system, to be run only if neither its file nor its FMUs break a standard. Raises FmuError naming where."""
    lines = {f"{system.path.name}: {note.found}; {note.rule.mend}" for note in system.breaches}
    lines |= {
        f"FMU {component.fmu.path}: {note.found}; {note.rule.mend}"
        for component in system.components.values()
        for note in component.fmu.notes
    }
    if lines:
        raise FmuError("\n".join(sorted(lines)))
    return replace(system, strict=True)
