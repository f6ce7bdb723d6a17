"""What a system shows of its components: parameters, inputs that nothing drives, outputs, as `component.variable`."""

from __future__ import annotations

from dataclasses import dataclass

from fmpy.model_description import ModelVariable

from ...fmu.types import BINARY, TEXT, TYPES, FmiType, Value
from ...plan.plan import Plan
from ...system.inputs.free_inputs import left_alone

PARAMETER, TUNABLE, INPUT, OUTPUT, CALCULATED, HIDDEN = (
    "parameter",
    "tunable",
    "input",
    "output",
    "calculated",
    "hidden",
)


@dataclass(frozen=True)
class Exposed:
    """One scalar. `given`: it is set at the start; `slot`: its cell, or -1; of an array of FMI 3.0 its place in it.

    `hidden`: the system gives it a value, and nobody else may.
    """

    name: str
    component: int
    variable: ModelVariable | None  # None: the coupling makes it
    kind: FmiType
    causality: str
    start: Value
    given: bool
    slot: int
    reference: int
    index: int
    count: int
    description: str
    unit: str | None


def exposed(plan: Plan) -> list[Exposed]:
    """All that a system shows, component by component: what is set first, in the order in which `run` sets it."""
    found: list[Exposed] = []
    free = left_alone(plan.system)
    begin = plan.clock.time(0)
    for number, (name, component) in enumerate(plan.system.components.items()):
        fmu = component.fmu
        first = component.first_inputs(begin)
        first |= {variable: fmu.start(variable) for variable in free.get(name, ())}
        values = {**component.parameters, **first}
        driven = {target[1] for target in plan.system.drivers if target[0] == name}
        named = [*values, *fmu.names("parameter"), *fmu.names("output", "calculatedParameter")]
        for variable in dict.fromkeys(element for v in named for element in fmu.arrays[v]):
            kind, v, place = fmu.type_of(variable), fmu.variables[variable], fmu.places[variable]
            output = v.causality in ("output", "calculatedParameter") and variable not in values
            if kind is None or kind.code == BINARY or (kind.code == TEXT and output) or variable in fmu.aliases:
                continue
            table = plan.layout.outputs if output else plan.layout.inputs
            slot = table.get((name, variable), -1)
            if output and v.causality == "output" and slot < 0:
                continue
            followed = variable in component.series or variable in driven
            found.append(
                Exposed(
                    f"{name}.{variable}", number, v, kind, _causality(v, followed, variable in values),
                    values.get(variable, fmu.start(variable)), variable in values, slot,
                    place.reference, place.index, place.count, v.description or "", v.unit,
                )
            )  # fmt: skip
    found += [
        Exposed(f"{owner}.{variable}", -1, None, TYPES[2]["Real"], OUTPUT, 0.0, False, extra.slot, 0, 0, 1,
                extra.description, extra.unit)
        for (owner, variable), extra in plan.layout.extras.items()
    ]  # fmt: skip
    return found


def _causality(v: ModelVariable, followed: bool, given: bool) -> str:
    if followed:
        return HIDDEN
    if v.causality == "parameter":
        return TUNABLE if v.variability == "tunable" else PARAMETER
    if v.causality == "input":
        return INPUT
    if given:
        return HIDDEN  # a start value of an output or of a local
    return OUTPUT if v.causality == "output" else CALCULATED
