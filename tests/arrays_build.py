"""FMI 3.0 FMUs for tests: a decay chain whose sizes are structural parameters, and one of bytes in and bytes out."""

from __future__ import annotations

from pathlib import Path

from native_build import NATIVE
from rovbrush.orchestrator.studies.bench.fmus import native

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
    return native.native_fmu(target, sources, xml, 3, defines)


def bytes_fmu(target: Path, mime: str = "application/x-own") -> Path:
    """data -> out (changed by key), pair_in[2] -> pair_out[2] (exchanged), size of data; see `bytes3.c`."""
    two = '<Dimension start="2"/>'
    variables = [
        f'<Binary name="data" valueReference="0" causality="input" mimeType="{mime}"><Start value="00ff10"/></Binary>',
        '<Binary name="key" valueReference="1" causality="parameter" variability="fixed"><Start value="01"/></Binary>',
        f'<Binary name="out" valueReference="2" causality="output" mimeType="{mime}"><Alias name="out too"/></Binary>',
        f'<Binary name="pair_in" valueReference="3" causality="input">{two}<Start value="aa"/>'
        '<Start value=""/></Binary>',
        f'<Binary name="pair_out" valueReference="4" causality="output">{two}</Binary>',
        '<UInt64 name="size" valueReference="5" causality="output"/>',
        '<Int32 name="fault" valueReference="6" causality="parameter" variability="fixed" start="0"/>',
        '<Binary name="limited" valueReference="7" causality="input" maxSize="4"><Start value=""/></Binary>',
        '<Float64 name="time" valueReference="999" causality="independent"/>',
    ]
    outputs = {2: "0", 4: "3", 5: "0"}
    structure = "".join(f'<Output valueReference="{r}" dependencies="{d}"/>' for r, d in outputs.items())
    structure += "".join(f'<InitialUnknown valueReference="{r}" dependencies="{d}"/>' for r, d in outputs.items())
    xml = (
        '<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="3.0" modelName="bytes" '
        f'instantiationToken="{{b}}">\n<CoSimulation modelIdentifier="{target.stem}" '
        'canHandleVariableCommunicationStepSize="true"/>\n'
        f"<ModelVariables>\n{chr(10).join(variables)}\n</ModelVariables>\n"
        f"<ModelStructure>{structure}</ModelStructure>\n</fmiModelDescription>\n"
    )
    sources = [NATIVE / "bytes3.c", NATIVE / "unused3.c"]
    return native.native_fmu(target, sources, xml, 3)
