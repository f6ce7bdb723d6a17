"""A bouncing ball as an FMU of FMI 1.0 for Model Exchange, for tests: `fixtures/exchange/ball1.c`."""

from __future__ import annotations

from pathlib import Path

from exchange_build import MODELS
from rovbrush.orchestrator.studies.bench.fmus.native import native_fmu

PARAMETERS = {"g": (2, 9.81), "e": (3, 0.7), "period": (5, 1e9), "end": (6, 1e9)}


def ball1(target: Path) -> Path:
    """Outputs h, v, minus_v (a negated alias), a, hits, n; inputs u and on."""
    name, none = target.stem, "<DirectDependency/>"

    def variable(name: str, reference: int, attributes: str, inside: str, more: str = "") -> str:
        head = f'<ScalarVariable name="{name}" valueReference="{reference}" {attributes}>'
        return f"{head}<{inside}/>{more}</ScalarVariable>\n"

    output = 'causality="output"'
    variables = [
        variable("h", 0, output, "Real", none), variable("v", 1, output, "Real", none),
        variable("minus_v", 1, f'{output} alias="negatedAlias"', "Real", none),
        variable("a", 7, output, "Real", "<DirectDependency><Name>u</Name></DirectDependency>"),
        variable("u", 4, 'causality="input"', 'Real start="0"'),
        variable("on", 0, 'causality="input" variability="discrete"', 'Boolean start="false"'),
        variable("hits", 0, f'{output} variability="discrete"', "Integer", none),
        variable("n", 1, f'{output} variability="discrete"', "Integer", none),
        *(variable(n, r, 'variability="parameter"', f'Real start="{x}"') for n, (r, x) in PARAMETERS.items()),
    ]  # fmt: skip
    xml = (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="1.0" modelName="Ball" '
        f'modelIdentifier="{name}" guid="{{1}}" numberOfContinuousStates="2" numberOfEventIndicators="1">\n'
        f"<ModelVariables>\n{''.join(variables)}</ModelVariables>\n</fmiModelDescription>\n"
    )
    return native_fmu(target, [MODELS / "ball1.c"], xml, 1, {"MODEL": name})
