"""A ring of feedthrough FMUs of FMI 1.0, 2.0 and 3.0: what the loop costs where versions meet."""

from __future__ import annotations

from pathlib import Path

from .native import SOURCES, feedthrough, native_fmu

HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="{}.0" modelName="{}" '


def feedthrough1(target: Path) -> Path:
    """An FMI 1.0 FMU with input u and output y: y = u after every step."""
    name = target.stem
    xml = (
        HEAD.format(1, name) + f'modelIdentifier="{name}" guid="{name}" numberOfContinuousStates="0" '
        'numberOfEventIndicators="0">\n<ModelVariables>\n'
        '<ScalarVariable name="u" valueReference="0" causality="input"><Real start="0"/></ScalarVariable>\n'
        '<ScalarVariable name="y" valueReference="1" causality="output"><Real/></ScalarVariable>\n'
        "</ModelVariables>\n<Implementation><CoSimulation_StandAlone>"
        '<Capabilities canHandleVariableCommunicationStepSize="true"/>'
        "</CoSimulation_StandAlone></Implementation>\n</fmiModelDescription>\n"
    )
    return native_fmu(target, [SOURCES / "feedthrough1.c"], xml, 1, {"MODEL": name})


def feedthrough3(target: Path) -> Path:
    """The same of FMI 3.0."""
    name = target.stem
    xml = (
        HEAD.format(3, name) + f'instantiationToken="{name}">\n'
        f'<CoSimulation modelIdentifier="{name}" canHandleVariableCommunicationStepSize="true"/>\n<ModelVariables>\n'
        '<Float64 name="u" valueReference="0" causality="input" start="0"/>\n'
        '<Float64 name="y" valueReference="1" causality="output"/>\n'
        '<Float64 name="time" valueReference="2" causality="independent"/>\n</ModelVariables>\n'
        '<ModelStructure><Output valueReference="1"/><InitialUnknown valueReference="1"/></ModelStructure>\n'
        "</fmiModelDescription>\n"
    )
    return native_fmu(target, [SOURCES / "feedthrough3.c"], xml, 3)


def mixed_ring(folder: Path, stop: str = "10 s", period: str = "1 ms") -> Path:
    """A system file: four feedthrough FMUs of FMI 1.0, 2.0, 3.0 and 1.0 in a ring."""
    fmus = [make(folder / f"passes{k}.fmu") for k, make in enumerate((feedthrough1, feedthrough, feedthrough3), 1)]
    parts = [(f"c{k}", fmus[k % len(fmus)].name) for k in range(4)]
    wires = "".join(f'  "{name}.y -> c{(k + 1) % 4}.u",\n' for k, (name, _) in enumerate(parts))
    tables = "".join(f'[components.{name}]\nfmu = "{fmu}"\nperiod = "{period}"\n' for name, fmu in parts)
    path = folder / "mixed_ring.toml"
    path.write_text(
        f'description = "native feedthrough FMUs of FMI 1.0, 2.0 and 3.0 in a ring"\nstop_time = "{stop}"\n'
        f"connections = [\n{wires}]\n{tables}",
        encoding="utf-8",
    )
    return path
