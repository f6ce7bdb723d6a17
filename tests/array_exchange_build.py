"""A rod as an FMU of FMI 3.0 for Model Exchange whose states and inputs are arrays: `fixtures/exchange/rod3.c`."""

from __future__ import annotations

from pathlib import Path

from exchange_build import MODELS
from rovbrush.orchestrator.studies.bench.fmus.native import native_fmu

CELLS = 20


def rod3(target: Path) -> Path:
    """x[1] to x[20], walls u[1] and u[2], the middle y."""

    def variable(name: str, reference: int, attributes: str, size: int = 1) -> str:
        dimension = f'<Dimension start="{size}"/>' if size > 1 else ""
        return f'<Float64 name="{name}" valueReference="{reference}" {attributes}>{dimension}</Float64>'

    calculated = 'causality="{}" variability="continuous" initial="calculated"'
    variables = [
        variable("x", 0, 'causality="local" variability="continuous" initial="exact" start="0"', CELLS),
        variable("der(x)", 1, calculated.format("local") + ' derivative="0"', CELLS),
        variable("a", 2, 'causality="parameter" variability="tunable" initial="exact" start="100"'),
        variable("y", 3, calculated.format("output")),
        variable("u", 4, 'causality="input" variability="continuous" start="0"', 2),
        '<Float64 name="time" valueReference="9" causality="independent" variability="continuous"/>',
    ]
    xml = (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="3.0" modelName="rod" '
        f'instantiationToken="rod">\n<ModelExchange modelIdentifier="{target.stem}" canGetAndSetFMUState="true" '
        f'canSerializeFMUState="true" needsCompletedIntegratorStep="false" providesDirectionalDerivatives="true"/>\n'
        f"<ModelVariables>\n{chr(10).join(variables)}\n</ModelVariables>\n"
        f'<ModelStructure><Output valueReference="3" dependencies="0"/>'
        f'<ContinuousStateDerivative valueReference="1" dependencies="0 4"/></ModelStructure>\n</fmiModelDescription>\n'
    )
    return native_fmu(target, [MODELS / "rod3.c"], xml, 3, {"FMI": 3})
