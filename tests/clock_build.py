"""FMUs of FMI 3.0 with event mode, clocks and model partitions for tests: C sources under `native/events/`."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from native_build import NATIVE
from rovbrush.orchestrator.studies.bench.fmus import native

EVENTS = NATIVE / "events"
CLOCK, WHOLE = 200, 100  # the first references of clocks and of Int64 variables
# Name, reference, causality and further attributes of the variables of each FMU.
Variables = list[tuple[str, int, str, str]]
TICK = 'intervalVariability="constant" intervalDecimal="{decimal}" supportsFraction="true" {fraction}'
MODELS: dict[str, Variables] = {
    "controller": [
        ("tick", CLOCK, "input", ""), ("y", 0, "input", 'clocks="200"'), ("u", 1, "output", 'clocks="200"'),
        ("k", 2, "parameter", ""), ("r", 3, "parameter", ""), ("at", 4, "output", 'clocks="200"'),
        ("ticks", WHOLE, "output", 'clocks="200"'),
    ],
    "countdown": [
        ("arm", CLOCK, "input", 'intervalVariability="triggered"'),
        ("fire", CLOCK + 1, "input", 'intervalVariability="countdown" supportsFraction="true"'),
        ("at", 0, "output", 'clocks="201"'), ("fired", WHOLE, "output", 'clocks="201"'),
        ("first", WHOLE + 1, "parameter", 'start="100"'), ("limit", WHOLE + 2, "parameter", 'start="1000000000"'),
    ],
    "producer": [
        ("crossing", CLOCK, "output", 'intervalVariability="triggered"'), ("phase", 0, "output", ""),
        ("f", 1, "parameter", 'start="3"'), ("count", WHOLE, "output", 'clocks="200"'),
    ],
    "consumer": [
        ("sample", CLOCK, "input", 'intervalVariability="triggered"'), ("v", WHOLE, "input", 'clocks="200"'),
        ("ticks", WHOLE + 1, "output", 'clocks="200"'), ("sum", WHOLE + 2, "output", 'clocks="200"'),
        ("at", 0, "output", 'clocks="200"'),
    ],
    "ball": [
        ("h", 0, "output", ""), ("v", 1, "output", ""), ("g", 2, "parameter", 'start="9.81"'),
        ("e", 3, "parameter", 'start="0.7"'), ("h0", 4, "parameter", 'start="1"'), ("hit", 5, "output", ""),
        ("bounces", WHOLE, "output", ""),
    ],
    "square": [("y", 0, "output", 'variability="discrete"'), ("half", 1, "parameter", 'start="0.25"'),
               ("stuck", 2, "parameter", 'start="1e9"'),
               ("changes", WHOLE, "output", "")],
    "trouble": [("updates", WHOLE, "output", ""), ("fault", WHOLE + 1, "parameter", 'start="0"')],
    "partitions": [
        ("fast", CLOCK, "input", 'intervalVariability="constant" intervalDecimal="0.01" priority="0"'),
        ("slow", CLOCK + 1, "input", 'intervalVariability="constant" intervalDecimal="0.033333333" priority="1" '
                                     'supportsFraction="true" intervalCounter="1" resolution="30"'),
        ("burst", CLOCK + 2, "input", 'intervalVariability="countdown" supportsFraction="true" priority="2"'),
        ("alarm", CLOCK + 3, "output", 'intervalVariability="triggered" clocks="202"'),
        ("u", 0, "input", 'clocks="200"'), ("y", 1, "output", 'clocks="200"'),
        ("at_fast", 2, "output", 'clocks="200"'), ("at_slow", 3, "output", 'clocks="201"'),
        ("at_burst", 4, "output", 'clocks="202"'), ("n_fast", WHOLE, "output", 'clocks="200"'),
        ("n_slow", WHOLE + 1, "output", 'clocks="201"'), ("n_burst", WHOLE + 2, "output", 'clocks="202"'),
    ],
    "witness": [
        ("at", 0, "output", 'variability="discrete"'), ("u", 1, "input", ""),
        ("u_then", 2, "output", 'variability="discrete"'), ("w", 3, "output", ""), ("n", WHOLE, "input", ""),
        ("changes", WHOLE + 1, "output", ""),
    ],
    "liar": [("y", 0, "output", ""), ("lie", WHOLE, "parameter", "")],
    "plant": [("x", 0, "output", ""), ("u", 1, "input", ""), ("x0", 2, "parameter", 'start="0"')],
}  # fmt: skip
UNEVENTFUL = ("plant",)


def clocked(
    target: Path, model: str, period: str = "1/60", tick: str | None = None, changes: Mapping[str, str] | None = None,
    flags: str = "", calculated: bool = False, causalities: Mapping[str, str] | None = None,
) -> Path:  # fmt: skip
    """One of MODELS as an FMU. `period`: of the controller's clock [s], `tick`: its attributes where not as usual;
    `changes`, `causalities`: of other variables, by name."""
    counter, _, resolution = period.partition("/")
    decimal = float(counter) / float(resolution or 1)
    fraction = f'intervalCounter="{counter}" resolution="{resolution or 1}"'
    usual = TICK.format(decimal=repr(decimal), fraction=fraction)
    lines, outputs = [], []
    for name, reference, causality, stated in MODELS[model]:
        causality = (causalities or {}).get(name, causality)
        kind = "Clock" if reference >= CLOCK else "Int64" if reference >= WHOLE else "Float64"
        given = (tick or usual) if name == "tick" else (changes or {}).get(name, stated)
        if causality == "parameter":
            given += ' variability="fixed"' + ("" if "start=" in given else ' start="1"')
        if causality == "input" and kind != "Clock":
            given += ' start="0"'
        if "clocks=" in given and "variability=" not in given and kind == "Float64":
            given += ' variability="discrete"'
        lines.append(f'<{kind} name="{name}" valueReference="{reference}" causality="{causality}" {given}/>')
        if causality == "output":
            outputs.append((reference, kind))
    lines.append('<Float64 name="time" valueReference="999" causality="independent" variability="continuous"/>')
    structure = "".join(f'<Output valueReference="{r}" dependencies=""/>' for r, _ in outputs)
    structure += "".join(f'<InitialUnknown valueReference="{r}"/>' for r, kind in outputs if kind != "Clock")
    states = 'canGetAndSetFMUState="true" canSerializeFMUState="true"'
    kind = f'<CoSimulation modelIdentifier="{target.stem}" canHandleVariableCommunicationStepSize="true" {states} '
    kind += "" if model in UNEVENTFUL else 'hasEventMode="true" '
    if model == "partitions":
        kind = f'<ScheduledExecution modelIdentifier="{target.stem}" {states} '
    xml = (
        '<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="3.0" '
        f'modelName="{model}" instantiationToken="{{{model}}}">\n{kind}{flags}/>\n'
        f"<ModelVariables>\n{chr(10).join(lines)}\n</ModelVariables>\n"
        f"<ModelStructure>{structure}</ModelStructure>\n</fmiModelDescription>\n"
    )
    defines = {"COUNTER": counter, "RESOLUTION": resolution or 1, "CALCULATED": int(calculated)}
    return native.native_fmu(target, [EVENTS / f"{model}.c", EVENTS / "unused.c"], xml, 3, defines)


def built(folder: Path) -> Path:
    """A folder with an FMU of each of MODELS."""
    for model in MODELS:
        clocked(folder / f"{model}.fmu", model)
    return folder
