"""FMI 1.0 FMUs for tests: `fixtures/native/first.c`, described and packed as other tools do it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from native_build import NATIVE
from rovbrush.orchestrator.studies.bench.fmus import native

ALONE = (
    '<Implementation><CoSimulation_StandAlone><Capabilities canHandleVariableCommunicationStepSize="true" '
    'canHandleEvents="true" canRejectSteps="false" canInterpolateInputs="false" maxOutputDerivativeOrder="0" '
    'canRunAsynchronuously="false" FLAGS/></CoSimulation_StandAlone></Implementation>'
)
TOOL = (
    "<Implementation><CoSimulation_Tool><Capabilities/><Model entryPoint='file:///C:/model.mdl' "
    "type='application/x-another-tool'/></CoSimulation_Tool></Implementation>"
)


def first_fmu(
    target: Path, implementation: str = ALONE, flags: str = "", changes: Mapping[str, str] | None = None,
    **defines: object,
) -> Path:  # fmt: skip
    """FMI 1.0: y = gain u, x integrates u, z = -minus_v one step ago, the rest passes through; see first.c."""
    xml = (NATIVE / "first.xml").read_text().replace("NAME", target.stem)
    xml = xml.replace("IMPLEMENTATION", implementation.replace("FLAGS", flags))
    for old, new in (changes or {}).items():
        assert old in xml, f"nothing to replace: {old}"
        xml = xml.replace(old, new)
    return native.native_fmu(target, [NATIVE / "first.c"], xml, 1, {"MODEL": target.stem, **defines})


MOTOR = {"Ra": 0.08, "La": 5e-5, "kt": 0.016, "ke": 0.016, "b": 9.6777e-4, "Jrotor": 5e-5, "Jload": 0.6,
         "ratio": 27.2484}  # fmt: skip


def motor1(target: Path) -> Path:
    """A DC motor: inputs supply and load, outputs amps and speed [rpm]; see motor1.c. `foreign_motor.toml` maps it."""

    def variable(name: str, reference: int, attributes: str, inside: str, more: str = "") -> str:
        head = f'<ScalarVariable name="{name}" valueReference="{reference}" {attributes}>'
        return f"{head}<Real {inside}/>{more}</ScalarVariable>\n"

    late = "<DirectDependency/>"
    variables = [
        variable("supply", 0, 'causality="input"', 'start="0" unit="V"'),
        variable("tau", 1, "", 'unit="N.m"'),
        variable("load", 1, 'causality="input" alias="negatedAlias"', 'start="0" unit="N.m"'),
        variable("amps", 2, 'causality="output"', 'unit="A"', late),
        variable("speed", 3, 'causality="output"', 'unit="rpm"', late),
        *(variable(n, 4 + k, 'variability="parameter"', f'start="{x}"') for k, (n, x) in enumerate(MOTOR.items())),
    ]
    name = target.stem
    xml = (
        f'<?xml version="1.0" encoding="ISO-8859-1"?>\n<fmiModelDescription fmiVersion="1.0" modelName="Motor" '
        f'modelIdentifier="{name}" guid="{{1}}" numberOfContinuousStates="2" numberOfEventIndicators="0">\n'
        f"<ModelVariables>\n{''.join(variables)}</ModelVariables>\n{ALONE.replace('FLAGS', '')}\n"
        f"</fmiModelDescription>\n"
    )
    return native.native_fmu(target, [NATIVE / "motor1.c"], xml, 1, {"MODEL": name})
