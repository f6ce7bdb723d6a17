"""An FMI 3.0 array model whose sizes are structural parameters: a decay chain, `fixtures/native/chain3.c`."""

from __future__ import annotations

from pathlib import Path

from native_build import NATIVE
from rovbrush.orchestrator.studies.bench import native_fmu

N, M = '<Dimension valueReference="0"/>', '<Dimension valueReference="1"/>'


def chain(target: Path, rates: str = "1", **defines: object) -> Path:
    """n members, at first 3, with rates k, starts x0 (its own for each of three members), feeds u and labels; m sums.

    `rates`: the start values of k; one counts for any size.
    """
    fixed = 'causality="parameter" variability="fixed"'
    variables = [
        '<UInt64 name="n" valueReference="0" causality="structuralParameter" variability="fixed" start="3" min="0" '
        'max="20"><Alias name="members"/></UInt64>',
        '<UInt64 name="m" valueReference="1" causality="structuralParameter" variability="fixed" start="1" max="64"/>',
        f'<Float64 name="k" valueReference="2" {fixed} start="{rates}">{N}</Float64>',
        f'<Float64 name="x0" valueReference="3" {fixed} start="1 0 0">{N}</Float64>',
        f'<Float64 name="u" valueReference="4" causality="input" start="0">{N}</Float64>',
        f'<Float64 name="x" valueReference="5" causality="output">{N}<Alias name="amount"/></Float64>',
        f'<Float64 name="W" valueReference="6" {fixed} start="1">{M}{N}</Float64>',
        f'<Float64 name="y" valueReference="7" causality="output">{M}</Float64>',
        '<Float64 name="total" valueReference="8" causality="output"/>',
        f'<String name="label" valueReference="9" {fixed}>{N}<Start value="member"/></String>',
        '<Float64 name="time" valueReference="999" causality="independent"/>',
    ]
    structure = "".join(
        f'<Output valueReference="{r}" dependencies=""/><InitialUnknown valueReference="{r}" dependencies="3"/>'
        for r in (5, 7, 8)
    )
    structure = "".join(sorted(structure.replace("/>", "/>\n").splitlines(), key=lambda line: line[1] != "O"))
    xml = (
        '<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="3.0" modelName="chain" '
        f'instantiationToken="{{c}}">\n<CoSimulation modelIdentifier="{target.stem}" '
        'canHandleVariableCommunicationStepSize="true" canGetAndSetFMUState="true" canSerializeFMUState="true"/>\n'
        '<DefaultExperiment stopTime="1" stepSize="0.01"/>\n'
        f"<ModelVariables>\n{chr(10).join(variables)}\n</ModelVariables>\n"
        f"<ModelStructure>{structure}</ModelStructure>\n</fmiModelDescription>\n"
    )
    sources = [NATIVE / "chain3.c", NATIVE / "unused3.c"]
    return native_fmu.native_fmu(target, sources, xml, 3, {"CONFIGURES": 1, **defines})
