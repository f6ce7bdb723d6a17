"""Components of a system file that are no FMU, and the variables that they declare."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from ....errors import InputError, nearest
from ....fmu.outside.declared import Causality, Declared, DeclaredFmu, declared_fmu
from ....fmu.outside.python_file import EXAMPLE, PythonCode, annotated, arguments_of, is_compiled, line_of
from ....toml.file import TomlFile
from ...schema.checked import checked
from ...schema.keys.outside import DeclareTable, VariableTable
from ...schema.keys.system import ComponentTable

NAME = re.compile(r"[A-Za-z_]\w*")
DECLARING = ("python", "udp", "shared_memory")
KINDS = (*DECLARING, "ardusub")
FOR_FMUS = {  # keys that say how an FMU is run
    "kind", "isolation", "timeout", "logging", "tolerance", "event_mode", "clocks", "compile", "units", "direct",
}  # fmt: skip
CAUSALITY: dict[str, Causality] = {"inputs": "input", "outputs": "output", "parameters": "parameter"}


def outside_component(
    file: TomlFile, name: str, entry: Mapping[str, Any], table: ComponentTable, outside: Sequence[Path]
) -> DeclaredFmu | None:
    """What a component declares that is no FMU; None for an FMU. Raises InputError."""
    heading = f"components.{name}"
    given = [key for key in ("fmu", *KINDS) if key in entry]
    if len(given) > 1:
        raise file.fail(f"component {name}: {' and '.join(given)} exclude each other; keep one", given[1], heading)
    if not given:
        raise file.fail(f"component {name}: 'fmu' is missing", f"[{heading}]")
    if given[0] not in DECLARING and "declare" in entry:
        raise file.fail(
            f"component {name}: declare goes with {_either(DECLARING)}; {given[0]} says it", "declare", heading
        )
    if given == ["fmu"]:
        return None
    if wrong := sorted(FOR_FMUS & entry.keys()):
        raise file.fail(f"component {name}: {wrong[0]} is for FMUs, and {given[0]} is none", wrong[0], heading)
    if type(file) is not TomlFile:
        raise file.fail(f"component {name}: {given[0]} stands in system files (.toml) only", given[0], heading)
    stated = _stated(file, name, entry, heading)
    try:
        if table.python is not None:
            return _python(file, name, table.python, stated, outside)
        if table.ardusub is not None:
            from .autopilot import autopilot_of

            return autopilot_of(name, entry["ardusub"], table.period)
        from .links import link_component

        return link_component(file, name, entry, given[0], stated)
    except InputError as error:
        if file.path.name in str(error):
            raise
        raise file.fail(f"component {name}: {error}", given[0], heading) from None


def _either(words: Sequence[str]) -> str:
    return f"{', '.join(words[:-1])} or {words[-1]}"


def _stated(file: TomlFile, name: str, entry: Mapping[str, Any], heading: str) -> dict[str, list[Declared]]:
    """The variables that stand under `declare`, by inputs, outputs, parameters and states."""
    label = f"component {name}: declare"
    table = entry.get("declare", {})
    checked(DeclareTable, table, label, file, f"{heading}.declare")
    found: dict[str, list[Declared]] = {}
    seen: set[str] = set()
    for group in ("inputs", "outputs", "parameters", "states"):
        found[group] = []
        for key, value in table.get(group, {}).items():
            at = f"{heading}.declare.{group}" if isinstance(value, dict) else heading
            try:
                found[group].append(_variable(key, value, CAUSALITY.get(group, "parameter"), f"{label}.{group}.{key}"))
            except InputError as error:
                raise file.fail(str(error), key, at) from None
            if key in seen:
                raise file.fail(f"{label}: {key} is declared twice; each variable needs a name of its own", key, at)
            seen.add(key)
    return found


def _variable(name: str, value: Any, causality: Causality, label: str) -> Declared:
    """`"N"`, `0.5`, `"0.5 N"`, `true` or a table. Raises InputError."""
    if not NAME.fullmatch(name) or name in ("t", "h"):
        other = "; t and h are the time and the length of a step" if name in ("t", "h") else ""
        raise InputError(f"{label}: {name!r} is no name for a variable: letters, digits and _, no digit first{other}")
    unit, start = "", None
    if isinstance(value, str):
        first, _, rest = value.strip().partition(" ")
        try:
            start, unit = (float(first), rest.strip()) if rest else (None, first)
        except ValueError:
            unit = value.strip()
    elif isinstance(value, dict):
        found = checked(VariableTable, value, label)
        type_ = found.type or ("Boolean" if isinstance(found.start, bool) else "Real")
        start = float(found.start) if type_ == "Real" and type(found.start) is int else found.start
        if found.tunable and causality != "parameter":
            raise InputError(f"{label}: tunable is for parameters")
        return Declared(
            name, causality, type_, found.unit, start, found.min, found.max, found.description, found.tunable
        )
    elif isinstance(value, bool):
        return Declared(name, causality, "Boolean", start=value)
    elif isinstance(value, int | float):
        start = float(value)
    else:
        raise InputError(f'{label} must be a unit ("N"), a start value (0.5), both ("0.5 N"), or a table')
    return Declared(name, causality, "Real", unit, start)


def _python(
    file: TomlFile, name: str, stated_path: str, stated: Mapping[str, list[Declared]], outside: Sequence[Path]
) -> DeclaredFmu:
    where, colon, what = stated_path.rpartition(":")
    if not colon or not where.endswith(".py") or not NAME.fullmatch(what):
        raise InputError(f"python = {stated_path!r} must be a file and a name in it, as in {EXAMPLE}")
    path = allowed_path(file.path.parent, where, outside)
    try:
        content = path.read_bytes()
    except (OSError, ValueError) as error:
        raise InputError(f"{where} cannot be read: {getattr(error, 'strerror', None) or error}") from None
    if any(v.type != "Real" for v in stated["states"]):
        raise InputError("declare.states must be real numbers; a class may keep what it likes")
    code = PythonCode(path, what, content, tuple((v.name, float(v.start or 0.0)) for v in stated["states"]))
    found, helpers = code.loaded()
    label = f"{path.name}, line {line_of(found)}: {what}" + (".step" if isinstance(found, type) else "")
    if isinstance(found, type) and code.states:
        raise InputError(f"{label}: declare.states goes with a function; a class keeps its own in self")
    variables = _interface(found, label, stated)
    kind = "compiled Python function" if is_compiled(found) else "Python function"
    kind = "Python class" if isinstance(found, type) else kind
    made: DeclaredFmu = declared_fmu(name, variables, Path(path.name), kind, settings=code, content=content + helpers)
    return made


def _interface(found: Any, label: str, stated: Mapping[str, list[Declared]]) -> list[Declared]:
    """The variables that a step is given and gives: as declared, else as its annotations say. Raises InputError."""
    arguments = [a.name for a in arguments_of(found, label)]
    states = [v.name for v in stated["states"]]
    declared = {v.name: v for group in ("inputs", "parameters") for v in stated[group]}
    for variable in [*declared, *states]:
        if variable not in arguments:
            raise InputError(f"{label} takes no argument '{variable}', which is declared{nearest(variable, arguments)}")
    said = {v.name: v for v in annotated(found, label)}
    given = [declared.get(a) or said[a] for a in arguments if a not in ("t", "h", *states)]
    outputs = stated["outputs"] or [v for v in said.values() if v.causality == "output"]
    if not outputs:
        raise InputError(
            f'{label} has no outputs: declare them, [components.NAME.declare] outputs = {{ y = "V" }}, or annotate '
            f'what it returns, -> {{"y": "V"}}'
        )
    for v in outputs:
        if v.name in arguments:
            raise InputError(f"{label}: '{v.name}' is an argument and an output; give one of them another name")
    return [*given, *outputs]


def allowed_path(folder: Path, stated: str, outside: Sequence[Path]) -> Path:
    """A file in the folder of a system, or in one that is allowed. Raises InputError for one elsewhere."""
    path = (folder / stated).resolve()
    if not any(path.is_relative_to(allowed.resolve()) for allowed in (folder, *outside)):
        raise InputError(
            f"{stated} is not in the system's folder; copy it there, or allow its folder: --allow-outside {path.parent}"
        )
    if not path.is_file():
        beside = [p.name for p in path.parent.glob("*.py")] if path.parent.is_dir() else []
        raise InputError(f"there is no file {stated}{nearest(Path(stated).name, beside)}")
    return path
