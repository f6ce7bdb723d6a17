"""OspSystemStructure.xml files written by hand, as other tools write them, for the tests of their reader."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

XMLNS = "http://opensimulationplatform.com/MSMI/OSPSystemStructure"
GROUPS = "https://open-simulation-platform.com/OspModelDescription/1.0.0"


def simulator(name: str, source: str = "gain.fmu", values: Mapping[str, object] | None = None, step: str = "") -> str:
    """`values`: numbers, truth values and texts."""
    kinds = {float: "Real", int: "Integer", bool: "Boolean", str: "String"}
    rows = "".join(
        f'<InitialValue variable="{key}"><{kinds[type(v)]} value="{str(v).lower() if isinstance(v, bool) else v}"/>'
        "</InitialValue>"
        for key, v in (values or {}).items()
    )
    inside = f"<InitialValues>{rows}</InitialValues>" if rows else ""
    more = f' stepSize="{step}"' if step else ""
    return f'<Simulator name="{name}" source="{source}"{more}>{inside}</Simulator>'


def wire(a: str, b: str, kind: str = "Variable", bond: str = "") -> str:
    """`a.y` of a simulator; `f:out` is a signal of a function."""
    ends = []
    for text in (a, b):
        owner, colon, name = text.partition(":")
        if colon:
            ends.append(f'<Signal{kind.removeprefix("Variable")} function="{owner}" name="{name}"/>')
        else:
            owner, _, name = text.partition(".")
            ends.append(f'<{kind} simulator="{owner}" name="{name}"/>')
    element = ("Signal" if any(":" in text for text in (a, b)) else "Variable") + kind.removeprefix("Variable")
    more = f' powerBond="{bond}"' if bond else ""
    return f"<{element}Connection{more}>{''.join(ends)}</{element}Connection>"


def structure(
    simulators: Iterable[str], connections: Iterable[str] = (), functions: str = "",
    head: str = "<EndTime>0.1</EndTime>", tail: str = "", step: str = "0.001",
) -> str:  # fmt: skip
    base = f"<BaseStepSize>{step}</BaseStepSize>" if step else ""
    functions = f"<Functions>{functions}</Functions>" if functions else ""
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<OspSystemStructure xmlns="{XMLNS}" version="0.1">{head}{base}'
        f"<Simulators>{''.join(simulators)}</Simulators>{functions}"
        f"<Connections>{''.join(connections)}</Connections>{tail}</OspSystemStructure>"
    )


def groups(inside: str) -> str:
    """An OspModelDescription.xml."""
    within = f"<VariableGroups>{inside}</VariableGroups>"
    return f'<OspModelDescription xmlns="{GROUPS}" version="1.0">{within}</OspModelDescription>'


def group(kind: str, name: str, *variables: str, inside: str = "") -> str:
    rows = "".join(f'<Variable ref="{v}"/>' for v in variables)
    return f'<{kind} name="{name}">{rows}{inside}</{kind}>'


def write_osp(folder: Path, fmus: Path, text: str, used: Iterable[str] = ("gain", "integrator"), **files: str) -> Path:
    """The file in a folder with its FMUs and further files, `Gain` for Gain_OspModelDescription.xml."""
    folder.mkdir(exist_ok=True, parents=True)
    for name in used:
        (folder / f"{name}.fmu").write_bytes((fmus / f"{name}.fmu").read_bytes())
    for name, content in files.items():
        (folder / f"{name}_OspModelDescription.xml").write_text(content)
    path = folder / "OspSystemStructure.xml"
    path.write_text(text)
    return path
