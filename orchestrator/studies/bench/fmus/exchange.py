"""Small FMUs for Model Exchange in C, for benchmarks and tests: a model around sources/exchange.h, FMI 2.0 or 3.0."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from .native import SOURCES, native_fmu

WHOLE = 1_000_000  # FMI 3.0: where the value references of Integers and Booleans begin


@dataclass(frozen=True)
class Var:
    """A variable: its type is Real, Integer or Boolean; `needs`: what an output or a derivative depends on, by name."""

    name: str
    reference: int
    causality: str = "output"
    kind: str = "Real"
    variability: str = ""
    start: str = ""
    needs: Sequence[str] | None = ()
    state: str = ""  # of which it is the derivative

    @property
    def varies(self) -> str:
        """Its variability, stated or usual."""
        usual = "fixed" if self.causality == "parameter" else "continuous" if self.kind == "Real" else "discrete"
        return self.variability or usual


@dataclass(frozen=True)
class Model:
    """A model in C and what its description says."""

    source: Path
    variables: Sequence[Var]
    indicators: int = 0
    directional: bool = True
    completed: bool = False
    flags: str = ""
    experiment: str = '<DefaultExperiment stopTime="1" tolerance="1e-6"/>'


def exchange_fmu(
    target: Path, model: Model, version: int = 2, defines: Mapping[str, object] | None = None, both: bool = False
) -> Path:
    """Compile and pack it. `both`: the description names co-simulation too, though the library has none."""
    xml = (_description2 if version == 2 else _description3)(target.stem, model, both)
    settings = {"FMI": version, **(defines or {})}
    return native_fmu(target, [model.source], xml, version, settings)


def _description2(name: str, model: Model, both: bool) -> str:
    numbers = {v.name: k for k, v in enumerate(model.variables, 1)}

    def element(v: Var) -> str:
        start = f' start="{v.start}"' if v.start else ""
        derivative = f' derivative="{numbers[v.state]}"' if v.state else ""
        inside = f"<{v.kind}{start}{derivative}/>"
        initial = ' initial="calculated"' if v.causality in ("output", "local") and not v.start else ""
        initial = ' initial="exact"' if v.causality in ("output", "local") and v.start else initial
        return (
            f'<ScalarVariable name="{v.name}" valueReference="{v.reference}" causality="{v.causality}" '
            f'variability="{v.varies}"{initial}>{inside}</ScalarVariable>'
        )

    def unknowns(found: Iterable[Var]) -> str:
        return "".join(f'<Unknown index="{numbers[v.name]}"{_needs2(v, numbers)}/>' for v in found)

    structure = ""
    outputs = [v for v in model.variables if v.causality == "output"]
    derivatives = [v for v in model.variables if v.state]
    if outputs:
        structure += f"<Outputs>{unknowns(outputs)}</Outputs>"
    if derivatives:
        structure += f"<Derivatives>{unknowns(derivatives)}</Derivatives>"
    flags = (
        f'canGetAndSetFMUstate="true" canSerializeFMUstate="true" providesDirectionalDerivative='
        f'"{str(model.directional).lower()}"'
    )
    other = f'<CoSimulation modelIdentifier="{name}" {flags}/>\n' if both else ""
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="2.0" modelName="{name}" '
        f'guid="{name}" numberOfEventIndicators="{model.indicators}">\n<ModelExchange modelIdentifier="{name}" '
        f'completedIntegratorStepNotNeeded="{str(not model.completed).lower()}" {model.flags or flags}/>\n{other}'
        f"{model.experiment}\n<ModelVariables>\n{chr(10).join(map(element, model.variables))}\n</ModelVariables>\n"
        f"<ModelStructure>{structure}</ModelStructure>\n</fmiModelDescription>\n"
    )


def _needs2(v: Var, numbers: Mapping[str, int]) -> str:
    if v.needs is None:
        return ""
    return f' dependencies="{" ".join(map(str, sorted(numbers[name] for name in v.needs)))}"'


def _description3(name: str, model: Model, both: bool) -> str:
    numbers = {v.name: v.reference + (WHOLE if v.kind != "Real" else 0) for v in model.variables}
    kinds = {"Real": "Float64", "Integer": "Int32", "Boolean": "Boolean"}

    def element(v: Var) -> str:
        start = f' start="{v.start}"' if v.start else ""
        derivative = f' derivative="{numbers[v.state]}"' if v.state else ""
        initial = ' initial="calculated"' if v.causality in ("output", "local") and not v.start else ""
        initial = ' initial="exact"' if v.causality in ("output", "local") and v.start else initial
        return (
            f'<{kinds[v.kind]} name="{v.name}" valueReference="{numbers[v.name]}" causality="{v.causality}" '
            f'variability="{v.varies}"{initial}{start}{derivative}/>'
        )

    def unknown(tag: str, v: Var) -> str:
        needs = "" if v.needs is None else f' dependencies="{" ".join(str(numbers[n]) for n in v.needs)}"'
        return f'<{tag} valueReference="{numbers[v.name]}"{needs}/>'

    shown = model.variables
    structure = "".join(unknown("Output", v) for v in shown if v.causality == "output")
    structure += "".join(unknown("ContinuousStateDerivative", v) for v in shown if v.state)
    indicators = [
        f'<Float64 name="z{k}" valueReference="{10_000_000 + k}" causality="local" variability="continuous" '
        f'initial="calculated"/>'
        for k in range(model.indicators)
    ]
    structure += "".join(f'<EventIndicator valueReference="{10_000_000 + k}"/>' for k in range(model.indicators))
    flags = (
        f'canGetAndSetFMUState="true" canSerializeFMUState="true" providesDirectionalDerivatives='
        f'"{str(model.directional).lower()}"'
    )
    other = f'<CoSimulation modelIdentifier="{name}" {flags}/>\n' if both else ""
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="3.0" modelName="{name}" '
        f'instantiationToken="{name}">\n<ModelExchange modelIdentifier="{name}" '
        f'needsCompletedIntegratorStep="{str(model.completed).lower()}" {model.flags or flags}/>\n{other}'
        f"{model.experiment}\n<ModelVariables>\n{chr(10).join([*map(element, shown), *indicators])}\n"
        f'<Float64 name="time" valueReference="20000000" causality="independent" variability="continuous"/>\n'
        f"</ModelVariables>\n"
        f"<ModelStructure>{structure}</ModelStructure>\n</fmiModelDescription>\n"
    )


def oscillator() -> Model:
    """The oscillator of van der Pol: two states, an input u, an output y."""
    return Model(
        SOURCES / "oscillator.c",
        [Var("x", 0, start="2", needs=["x"]), Var("v", 1, start="0", needs=["v"]),
         Var("der(x)", 2, "local", state="x", needs=["v"]), Var("der(v)", 3, "local", state="v", needs=["x", "v", "u"]),
         Var("mu", 4, "parameter", start="1", variability="tunable"), Var("u", 5, "input", start="0"),
         Var("y", 6, needs=["x"])],
    )  # fmt: skip


def chain(cells: int) -> Model:
    """A rod of so many cells, each of which knows its neighbours."""
    names = [f"x[{k + 1}]" for k in range(cells)]
    variables = [Var(name, k, "local", start=repr(0.0)) for k, name in enumerate(names)]
    variables += [
        Var(f"der({name})", cells + k, "local", state=name, needs=names[max(k - 1, 0) : k + 2])
        for k, name in enumerate(names)
    ]
    variables += [Var("a", 2 * cells, "parameter", start="100"), Var("y", 2 * cells + 1, needs=[names[cells // 2]])]
    return Model(SOURCES / "chain.c", variables)
