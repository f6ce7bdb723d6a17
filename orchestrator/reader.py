"""TOML system file -> checked System. Every error names the file, the line where it can be found, and the mend."""

from __future__ import annotations

import os
import re
import tomllib
from fractions import Fraction
from pathlib import Path
from typing import Any

from .clock import duration
from .errors import InputError, nearest
from .fmu import Fmu
from .system import Bond, Component, Connection, System, checked_values
from .units import conversion

SYSTEMS = Path(__file__).parent / "systems"
KEYS = {"description", "stop_time", "algorithm", "order", "parameters", "components", "connections", "bonds", "record", "summary", "compare", "figures"}
COMPONENT_KEYS = {"fmu", "period", "parameters", "inputs"}
KINDS: dict[type[Any], str] = {dict: "a table", list: "a list", str: "text"}
ALGORITHMS = ("gauss-seidel", "jacobi")


def shipped_systems() -> list[str]:
    """Names of the systems that come with the package."""
    return sorted(path.stem for path in SYSTEMS.glob("*.toml") if "[components." in path.read_text(encoding="utf-8"))


def fmu_folder() -> Path:
    """Where built FMUs are: $ROVBRUSH_FMUS, the checkout's fmus/, or the user's data folder."""
    chosen = os.environ.get("ROVBRUSH_FMUS")
    if chosen:
        return Path(chosen)
    checkout = Path(__file__).parent.parent
    if (checkout / "pyproject.toml").is_file():
        return checkout / "fmus"
    from platformdirs import user_data_path

    return user_data_path("rovbrush") / "fmus"


class _File:
    """The text of a TOML file, for finding lines."""

    def __init__(self, path: Path) -> None:
        self.path = path
        try:
            self.text = path.read_text(encoding="utf-8")
            self.data: dict[str, Any] = tomllib.loads(self.text)
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(f"system file {path} cannot be read: {error}") from error
        except tomllib.TOMLDecodeError as error:
            raise InputError(f"{path.name} is not valid TOML: {error}") from error

    def at(self, needle: str, table: str = "") -> str:
        """`(nominal.toml, line 31)`: the first line that holds the needle as a word, below the heading of `table`."""
        word = re.compile(rf"(?<![\w.]){re.escape(needle)}(?!\w)")
        inside = not table
        for number, line in enumerate(self.text.splitlines(), 1):
            heading = re.match(r"\s*\[+([^\[\]]+)\]", line)
            if heading and table:
                inside = f"{heading[1]}.".startswith(f"{table}.")
            if inside and word.search(line.partition("#")[0]):
                return f"({self.path.name}, line {number})"
        return self.at(needle) if table else f"({self.path.name})"

    def fail(self, message: str, needle: str, table: str = "") -> InputError:
        return InputError(f"{message} {self.at(needle, table)}")

    def entry(self, kind: type[Any], key: str, within: dict[str, Any] | None = None, table: str = "") -> Any:
        """An optional entry of the file, or of one of its tables: empty where it is missing. Raises InputError for a wrong type."""
        value = (self.data if within is None else within).get(key, kind())
        if not isinstance(value, kind):
            raise self.fail(f"{f'{table}: ' if table else ''}{key} must be {KINDS[kind]}", key, table)
        return value

    def entries(self, kind: type[Any], key: str) -> list[Any]:
        """An optional list, all of one type."""
        values: list[Any] = self.entry(list, key)
        if not all(isinstance(value, kind) for value in values):
            raise self.fail(f"{key} must be a list, each entry {KINDS[kind]}", key)
        return values


def load_system(name: str, fmus: Path | None = None) -> System:
    """Read and check a system, by the name of a shipped one or by the path of a TOML file.

    Raises InputError or FmuError for whatever could make the run wrong: see `tests/orchestrator`.
    """
    path = Path(name)
    if path.suffix != ".toml":
        path = SYSTEMS / f"{name}.toml"
        if not path.is_file():
            raise InputError(f"no system '{name}'{nearest(name, shipped_systems())}, or give the path of a .toml file")
    file = _File(path)
    data = file.data
    for key in data.keys() - KEYS:
        raise file.fail(f"unknown key '{key}'{nearest(key, KEYS)}", key)
    for key in ("stop_time", "components"):
        if key not in data or data[key] == {}:
            raise InputError(f"{path.name}: '{key}' is missing")
    algorithm = data.get("algorithm", ALGORITHMS[0])
    if algorithm not in ALGORITHMS:
        raise file.fail(f"unknown algorithm '{algorithm}'{nearest(str(algorithm), ALGORITHMS)}", "algorithm")
    tables = file.entry(dict, "components")
    components = {key: _component(file, key, file.entry(dict, key, tables, "components"), fmus) for key in tables}
    order = tuple(file.entries(str, "order"))
    if order and sorted(order) != sorted(components):
        raise file.fail(f"order must name every component once: {', '.join(components)}", "order")
    connections = tuple(c for entry in file.entry(list, "connections") for c in _connections(file, components, entry))
    _check_drivers(file, components, connections)
    system = System(
        name=path.stem, path=path, description=str(data.get("description", "")),
        stop=_duration(file, data["stop_time"], "stop_time"), algorithm=algorithm, order=order,
        components=components, connections=connections,
        bonds=tuple(_bond(file, connections, entry) for entry in file.entries(dict, "bonds")),
        record=tuple(file.entries(str, "record")) if "record" in data else ("*",),
        reporting={"summary": file.entry(dict, "summary")} | {key: file.entries(dict, key) for key in ("compare", "figures")},
    )  # fmt: skip
    return _with_parameter_file(file, system)


def _duration(file: _File, value: object, what: str, table: str = "") -> Fraction:
    try:
        return duration(value, what)
    except InputError as error:
        raise file.fail(str(error), what.split()[-1], table) from None


def _component(file: _File, name: str, table: dict[str, Any], fmus: Path | None) -> Component:
    heading = f"components.{name}"
    if not re.fullmatch(r"\w+", name):
        raise file.fail(f"component name '{name}': only letters, digits and _ are allowed", name)
    for key in table.keys() - COMPONENT_KEYS:
        raise file.fail(f"component {name}: unknown key '{key}'{nearest(key, COMPONENT_KEYS)}", key, heading)
    for key in ("fmu", "period"):
        if key not in table:
            raise file.fail(f"component {name}: '{key}' is missing", f"[{heading}]")
    path = Path(str(table["fmu"]))
    if path.suffix == ".fmu":
        path = path if path.is_absolute() else file.path.parent / path
    else:
        path = (fmus or fmu_folder()) / f"{path}.fmu"
    component = Component(name, Fmu.open(path), _duration(file, table["period"], f"component {name}: period", heading))
    for kind, causality in (("parameters", "parameter"), ("inputs", "input")):
        for key, value in file.entry(dict, kind, table, heading).items():
            origin = f"{kind} of {name} {file.at(key, heading)}"
            found = checked_values(component, key, value, origin)
            if component.fmu.variables[next(iter(found))].causality != causality:
                raise InputError(f"{origin}: {name}.{key} is no {causality}")
            for scalar, scalar_value in found.items():
                component = component.with_value(scalar, scalar_value)
    return component


def _connections(file: _File, components: dict[str, Component], entry: object) -> list[Connection]:
    from .transfer import TRANSFERS

    match = re.fullmatch(r"(\w+)\.(\S+)\s*->\s*(\w+)\.(\S+)(?:\s+\((\S+)\))?", str(entry).strip())
    if match is None:
        raise file.fail(f"connection {entry!r} is not of the form \"a.output -> b.input\" or \"a.output -> b.input (mean)\"", str(entry))
    source, output, target, input_, transfer = match.groups()
    label, where = f"connection {source}.{output} -> {target}.{input_}", file.at(str(entry))
    if transfer and transfer not in TRANSFERS:
        raise InputError(f"{label}: unknown transfer '{transfer}'{nearest(transfer, TRANSFERS)} {where}")
    ends = []
    for name, variable, causality, article in ((source, output, "output", "no output"), (target, input_, "input", "no input")):
        if name not in components:
            raise InputError(f"{label}: no component '{name}'{nearest(name, components)} {where}")
        fmu = components[name].fmu
        scalars = [s for s in fmu.expand(variable) if fmu.variables[s].causality == causality]
        if not scalars:
            raise InputError(f"{label}: {fmu.description.modelName} has {article} '{variable}'{nearest(variable, fmu.base_names(causality))} {where}")
        for s in scalars:
            if fmu.variables[s].type != "Real":
                raise InputError(f"{label}: {name}.{s} is of type {fmu.variables[s].type}; Real is needed {where}")
        ends.append(scalars)
    if len(ends[0]) != len(ends[1]):
        raise InputError(f"{label}: {len(ends[0])} elements cannot drive {len(ends[1])} {where}")
    found = []
    for a, b in zip(*ends, strict=True):
        units = [components[source].fmu.variables[a].unit, components[target].fmu.variables[b].unit]
        try:
            gain, offset = conversion(units[0], units[1], label)
        except InputError as error:
            raise InputError(f"{error} {where}") from None
        found.append(Connection((source, a), (target, b), transfer or "", gain, offset, where))
    return found


def _check_drivers(file: _File, components: dict[str, Component], connections: tuple[Connection, ...]) -> None:
    """Every input has exactly one origin: one connection, or a value in the file."""
    driver: dict[tuple[str, str], Connection] = {}
    for connection in connections:
        label = ".".join(connection.target)
        if connection.target in driver:
            raise InputError(f"input {label} is driven twice: by {driver[connection.target].label} and by {connection.label} {connection.where}")
        if connection.target[1] in components[connection.target[0]].inputs:
            raise file.fail(f"input {label} is driven by {connection.label} and has a value too; remove one", connection.target[1].split("[")[0], f"components.{connection.target[0]}")
        driver[connection.target] = connection
    for component in components.values():
        for name in component.fmu.names("input"):
            if (component.name, name) not in driver and name not in component.inputs:
                start = component.fmu.variables[name].start
                base = name.split("[")[0]
                raise file.fail(
                    f"input {component.name}.{name} has no driver; connect it, or give it a value under "
                    f"[components.{component.name}.inputs], for instance {base} = {start}", f"[components.{component.name}]")  # fmt: skip


def _bond(file: _File, connections: tuple[Connection, ...], entry: dict[str, Any]) -> Bond:
    """`effort` and `flow` name the connected inputs that carry them; they must cross between the same components."""
    by_target = {".".join(c.target): c for c in connections}
    ends = []
    for key in ("effort", "flow"):
        if entry.get(key) not in by_target:
            raise file.fail(f"bond {entry.get('name')}: {key} = {entry.get(key)!r} is no connected input{nearest(str(entry.get(key)), by_target)}", str(entry.get(key)))
        ends.append(by_target[entry[key]])
    if ends[0].source[0] != ends[1].target[0] or ends[0].target[0] != ends[1].source[0]:
        raise file.fail(f"bond {entry.get('name')}: effort and flow do not cross between the same two components", str(entry["effort"]))
    pairs = [(".".join(c.source), ".".join(c.target)) for c in ends]
    if entry.get("sign", 1.0) not in (1.0, -1.0):
        raise file.fail(f"bond {entry.get('name', entry['effort'])}: sign = {entry['sign']!r} must be 1 or -1", "sign", "bonds")
    return Bond(str(entry.get("name", entry["effort"])), pairs[0], pairs[1], float(entry.get("sign", 1.0)))


def _with_parameter_file(file: _File, system: System) -> System:
    """Values of the parameter file come under those of the system file itself."""
    name = file.data.get("parameters")
    if name is None:
        return system
    if not isinstance(name, str):
        raise file.fail("parameters must be the name of a file", "parameters")
    table = _File(file.path.parent / name)
    values = {f"{c}.{key}": value for c, entries in table.data.items() if isinstance(entries, dict) and c in system.components for key, value in entries.items()}
    own = {f"{c.name}.{key}": value for c in system.components.values() for key, value in {**c.parameters, **c.inputs}.items()}
    return system.with_values(values, table.path.name).with_values(own, file.path.name)


def system_description(path: Path) -> str:
    """The first words of a system file about itself."""
    return str(_File(path).data.get("description", ""))
