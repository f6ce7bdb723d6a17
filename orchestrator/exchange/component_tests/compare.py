"""The interface of an FMU beside the one that a component declares."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from ...errors import InputError, nearest
from ...fmu.binary import as_text
from ...fmu.fmu import Fmu
from ...fmu.types import REALS
from ...system.replace.fit import CALLED, can_be
from ...system.replace.mapping import VariableMapping
from .binding import WHOLES, Binding, bind
from .opened import whole_variables
from .suites import Declared, Suite

Finding = Literal["fits", "converted", "noted", "absent", "surplus", "failed"]


@dataclass(frozen=True)
class Row:
    """What was found of one variable: ours, theirs (either can be missing), the finding and its reason."""

    ours: str
    theirs: str
    finding: Finding
    text: str = ""


@dataclass(frozen=True)
class Comparison:
    """All rows, and the bindings of those variables that can be used."""

    rows: tuple[Row, ...]
    bindings: dict[str, Binding]

    @property
    def failures(self) -> list[Row]:
        return [row for row in self.rows if row.finding == "failed"]


def compare(fmu: Fmu, suite: Suite, mapping: VariableMapping) -> Comparison:
    """Bind every declared variable to theirs. Raises InputError for a mapping file that names what nobody has."""
    ours = [v.name for v in suite.interface]
    elements = [f"{v.name}[{k + 1}]" for v in suite.interface for k in range(v.size)]
    mapping.check([*ours, *elements], [*whole_variables(fmu), *fmu.variables], suite.name, fmu.path.name)
    rows: list[Row] = []
    bindings: dict[str, Binding] = {}
    for v in suite.interface:
        try:
            binding = bind(v, fmu, mapping)
        except InputError as error:
            rows.append(Row(v.name, mapping.entry(v.name).name, "failed", str(error).removeprefix(f"{v.name}: ")))
            continue
        if binding is None:
            rows.append(_missing(v, suite, fmu, mapping))
            continue
        row = _fit(v, binding, suite)
        rows.append(row)
        if row.finding not in ("failed", "absent"):
            bindings[v.name] = binding
    rows += _feedthrough(fmu, suite, bindings)
    rows += _surplus(fmu, bindings, mapping)
    return Comparison(tuple(rows), bindings)


def _missing(v: Declared, suite: Suite, fmu: Fmu, mapping: VariableMapping) -> Row:
    if v.name not in suite.essential:
        return Row(v.name, "", "absent", "tests that need it do not apply")
    if mapping.states(v.name) and mapping.entry(v.name).absent and v.causality != "output":
        return Row(v.name, "", "absent", f"as {mapping.file} says; a system does without")
    causality = [name for name in fmu.base_names(v.causality)]
    hint = nearest(v.name, causality).removeprefix("; ")
    known = "" if mapping.states(v.name) else f"; if it has another name there, say so in a mapping file ({hint})"
    return Row(v.name, "", "failed", f"no such {v.causality}, and a system needs it{known}")


def _fit(v: Declared, binding: Binding, suite: Suite) -> Row:
    theirs = binding.theirs[0]
    name = binding.name
    causality = theirs.causality or "local"
    if not can_be(v.causality, theirs):
        if v.causality in CALLED or (v.causality == "output" and v.name not in suite.essential):
            return Row(v.name, name, "absent", f"is {_a(causality)} there, {_a(v.causality)} here: not used")
        return Row(v.name, name, "failed", f"is {_a(causality)} there; {_a(v.causality)} is needed")
    if theirs.type not in (*REALS, *WHOLES, "Boolean"):
        return Row(v.name, name, "failed", f"is of type {theirs.type}, which holds no number")
    if v.kind == "Real" and theirs.type not in REALS:
        if v.causality in ("input", "output"):
            return Row(v.name, name, "failed", f"is of type {theirs.type}; Real is needed")
        return Row(v.name, name, "noted", f"is of type {theirs.type}: takes whole numbers only")
    conversion = next((c for c in binding.crossings if not c.exact), None)
    if conversion is not None:
        return Row(v.name, name, "converted", f"{v.unit} becomes {conversion}")
    if binding.crossings[0].unit is None and v.kind == "Real":
        return Row(v.name, name, "noted", f"states no unit; taken as {v.unit}")
    return Row(v.name, name, "fits")


def _feedthrough(fmu: Fmu, suite: Suite, bindings: dict[str, Binding]) -> list[Row]:
    """Outputs that inputs act on at once, though the declaration has no such path: they can close algebraic loops."""
    inputs = {t.name: v.name for v in suite.interface if v.causality == "input" and v.name in bindings
              for t in bindings[v.name].theirs}  # fmt: skip
    stated = {unknown.variable.name: unknown.dependencies for unknown in fmu.description.outputs}
    rows = []
    for v in suite.interface:
        if v.causality != "output" or v.name not in bindings:
            continue
        theirs = bindings[v.name].theirs
        lists = [stated.get(t.name) for t in theirs]
        if any(dependencies is None for dependencies in lists):
            if set(inputs.values()) - set(v.depends):
                rows.append(Row(v.name, bindings[v.name].name, "noted", "does not say which inputs act on it at once"))
            continue
        through = {inputs[d.name] for dependencies in lists for d in dependencies or () if d.name in inputs}
        extra = sorted(through - set(v.depends))
        if extra:
            text = f"{', '.join(extra)} acts on it at once: the loop may need iteration"
            rows.append(Row(v.name, bindings[v.name].name, "noted", text))
    return rows


def _surplus(fmu: Fmu, bindings: dict[str, Binding], mapping: VariableMapping) -> list[Row]:
    used = {t.name for binding in bindings.values() for t in binding.theirs}
    rows = []
    for v in fmu.description.modelVariables:
        if v.name in used or v.causality not in ("input", "output", "parameter"):
            continue
        held = {**mapping.inputs, **mapping.parameters}
        values = [value for name, value in held.items() if name == v.name or name.startswith(f"{v.name}[")]
        if values:
            value = as_text(values[0]) if len(values) == 1 else f"{len(values)} values"
            rows.append(Row("", v.name, "surplus", f"{_a(v.causality)}; held at {value} by the mapping file"))
        elif v.causality == "input":
            text = f"an input; stays at its start value {v.start}, or at one under [inputs] of a mapping file"
            rows.append(Row("", v.name, "surplus", text))
        else:
            rows.append(Row("", v.name, "surplus", _a(v.causality)))
    return rows


def _a(causality: str) -> str:
    return f"{'an' if causality[0] in 'aeiou' else 'a'} {causality}"
