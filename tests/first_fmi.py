"""FMI 1.0 FMUs for tests: `fixtures/native/first.c`, described and packed as other tools do it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from native_build import NATIVE
from rovbrush.orchestrator.studies.bench import native_fmu

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
    return native_fmu.native_fmu(target, [NATIVE / "first.c"], xml, 1, {"MODEL": target.stem, **defines})
