"""Native FMUs for tests: C sources under `native/`, compiled here; every type, and every way to misbehave."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from rovbrush.orchestrator.studies.bench.fmus import native

# Values of every type for the feedthrough FMUs, and the connections of two of them.
FREE2 = {"=u": 1.5, "=n_in": -7, "=mode_in": 2, "=on_in": True, "=s_in": 'hüll, "on"'}
FREE3: dict[str, Any] = {
    "=Float64_in": 0.1, "=Float32_in": 0.1, "=Int8_in": -128, "=UInt8_in": 255, "=Int16_in": -32768,
    "=UInt16_in": 65535, "=Int32_in": -(2**31), "=UInt32_in": 2**32 - 1, "=Int64_in": -(2**53) - 1,
    "=UInt64_in": 2**63 - 1, "=Boolean_in": True, "=Enumeration_in": 2**53 + 1, "=String_in": "text",
    "=a_in": [0.5, 1, 2, 3, 4, 5, 6, 7], "=t_in": ["a", "b"],
}  # fmt: skip
WIRES2 = [f"a.{v}_out -> b.{v}_in" for v in ("n", "mode", "on", "s")] + ["a.y -> b.u"]
WIRES3 = [f"a.{v[1:-3]}_out -> b.{v[1:]}" for v in FREE3]
NATIVE = Path(__file__).parent / "fixtures" / "native"
needs_gcc = pytest.mark.skipif(native.compiler() is None, reason="no C compiler: native FMUs cannot be built")
FAULTS2 = {
    name: k
    for k, name in enumerate(
        ["none", "discard", "error", "fatal", "nan", "crash", "exit", "hang", "pending", "warning"]
    )
}
FAULTS3 = {
    name: k for k, name in enumerate(["none", "discard", "error", "fatal", "nan", "terminate", "early", "event"])
}
# Name, type, reference, causality and start of the variables of `answers`, by what they belong to.
ANSWERS = {
    "mass": [("F", "Real", 0, "input", "0"), ("m", "Real", 1, "parameter", "1"), ("x0", "Real", 2, "parameter", "0"),
             ("x", "Real", 3, "output", ""), ("v", "Real", 4, "output", "")],
    "force": [(f"{v}{k}", "Real", 3 + 2 * k + (v == "v"), "input", "0") for k in (1, 2) for v in "xv"]
    + [("k", "Real", 9, "parameter", "0"), ("d", "Real", 10, "parameter", "0"), ("F", "Real", 11, "output", ""),
       ("back", "Real", 12, "output", "")],
    "reals": [("u", "Real", 13, "input", "0"), ("y", "Real", 14, "output", "")],
    "integers": [("n_in", "Integer", 0, "input", "0"), ("n_out", "Integer", 2, "output", "")],
    "counter": [("n", "Integer", 1, "output", "")],
    "booleans": [("on_in", "Boolean", 0, "input", "false"), ("on_out", "Boolean", 1, "output", "")],
}  # fmt: skip
NUMBERS3 = ("Float32", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64")


def feedthrough2(target: Path, flags: str = "", experiment: str = "", **defines: object) -> Path:
    """FMI 2.0: u -> y, n_in -> n_out, mode_in -> mode_out, on_in -> on_out, s_in -> s_out; x integrates u."""

    def variable(name: str, reference: int, causality: str, kind: str, inner: str = "") -> str:
        variability = {"parameter": "fixed"}.get(causality, "continuous" if kind == "Real" else "discrete")
        start = (
            "" if causality == "output" else {"Boolean": 'start="false"', "String": 'start=""'}.get(kind, 'start="0"')
        )
        return (
            f'<ScalarVariable name="{name}" valueReference="{reference}" causality="{causality}" '
            f'variability="{variability}"><{kind} {inner or start}/></ScalarVariable>'
        )

    enumeration = 'declaredType="Mode"'
    variables = [
        variable("u", 0, "input", "Real"),
        variable("y", 1, "output", "Real"),
        variable("x", 2, "output", "Real"),
        variable("bad_at", 3, "parameter", "Real", 'start="1e9"'),
        variable("n_in", 0, "input", "Integer"),
        variable("n_out", 1, "output", "Integer"),
        variable("fault", 2, "parameter", "Integer", 'start="0" min="0" max="9"'),
        variable("mode_in", 3, "input", "Enumeration", f'{enumeration} start="1"'),
        variable("mode_out", 4, "output", "Enumeration", enumeration),
        variable("on_in", 0, "input", "Boolean"),
        variable("on_out", 1, "output", "Boolean"),
        variable("s_in", 0, "input", "String"),
        variable("s_out", 1, "output", "String"),
    ]
    unknowns = {2: "1", 3: "", 6: "5", 9: "8", 11: "10", 13: "12"}  # the outputs and the inputs they depend on
    outputs = "".join(f'<Unknown index="{k}" dependencies="{d}"/>' for k, d in unknowns.items())
    types = "".join(
        f'<SimpleType name="{name}"><Enumeration>{items}</Enumeration></SimpleType>'
        for name, items in (("Mode", '<Item name="off" value="1"/><Item name="on" value="2"/>'),)
    )
    xml = native.description2(target.stem, variables, unknowns, flags)
    xml = xml.replace("<ModelVariables>", f"<TypeDefinitions>{types}</TypeDefinitions>\n{experiment}<ModelVariables>")
    xml = re.sub("<Outputs>.*?</Outputs>", f"<Outputs>{outputs}</Outputs>", xml)
    for flag in re.findall(r"(\w+)=", flags):  # a flag given here replaces the one of description2
        xml = re.sub(rf' {flag}="true"(.*){flag}=', rf"\1{flag}=", xml)
    return native.native_fmu(target, [NATIVE / "feedthrough2.c"], xml, 2, defines)


def feedthrough3(target: Path, **defines: object) -> Path:
    """FMI 3.0: <Type>_in -> <Type>_out for every type, a_in[8] -> a_out[8], t_in[2] -> t_out[2], M[2,2] -> trace."""
    variables, outputs = [], []

    def add(kind: str, name: str, reference: int, causality: str, inside: str = "", **attributes: str) -> None:
        text = "".join(f' {key}="{value}"' for key, value in attributes.items())
        variables.append(
            f'<{kind} name="{name}" valueReference="{reference}" causality="{causality}"{text}>{inside}</{kind}>'
        )
        if causality == "output":
            outputs.append(reference)

    for k, kind in enumerate(("Float64", *NUMBERS3)):
        add(kind, f"{kind}_in", 2 * k, "input", start="0")
        add(kind, f"{kind}_out", 2 * k + 1, "output")
    add("Boolean", "Boolean_in", 20, "input", start="false")
    add("Boolean", "Boolean_out", 21, "output")
    add("Enumeration", "Enumeration_in", 22, "input", start="1", declaredType="Mode")
    add("Enumeration", "Enumeration_out", 23, "output", declaredType="Mode")
    add("String", "String_in", 24, "input", '<Start value=""/>')
    add("String", "String_out", 25, "output")
    add("Float64", "a_in", 100, "input", '<Dimension start="8"/>', start="1 2 3 4 5 6 7 8")
    add("Float64", "a_out", 101, "output", '<Dimension start="8"/>')
    add("String", "t_in", 102, "input", '<Dimension start="2"/><Start value="left"/><Start value="right"/>')
    add("String", "t_out", 103, "output", '<Dimension start="2"/>')
    add("Float64", "bad_at", 104, "parameter", start="1e9", variability="fixed")
    add("Int32", "fault", 105, "parameter", start="0", variability="fixed")
    add(
        "Float64",
        "M",
        106,
        "parameter",
        '<Dimension start="2"/><Dimension start="2"/>',
        start="1 2 3 4",
        variability="fixed",
    )
    add("Float64", "trace", 107, "output")
    add("Binary", "blob", 200, "input", '<Start value="00ff"/>')
    add("Binary", "blob_out", 201, "output")
    add("Float64", "time", 999, "independent")
    structure = "".join(
        f'<Output valueReference="{r}" dependencies="{"" if r == 107 else r - 1}"/>' for r in outputs
    ) + "".join(f'<InitialUnknown valueReference="{r}"/>' for r in outputs)
    xml = (
        '<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="3.0" modelName="feedthrough3" '
        f'instantiationToken="{{t}}">\n<CoSimulation modelIdentifier="{target.stem}" '
        'canHandleVariableCommunicationStepSize="true" canGetAndSetFMUState="true" canSerializeFMUState="true"/>\n'
        '<TypeDefinitions><EnumerationType name="Mode"><Item name="off" value="1"/><Item name="big" '
        'value="9007199254740993"/></EnumerationType></TypeDefinitions>\n'
        f"<ModelVariables>{chr(10).join(variables)}</ModelVariables>\n"
        f"<ModelStructure>{structure}</ModelStructure>\n</fmiModelDescription>\n"
    )
    return native.native_fmu(target, [NATIVE / "feedthrough3.c", NATIVE / "unused3.c"], xml, 3, defines)


def moody(target: Path, flags: str = "", categories: tuple[str, ...] = (), **actions: str) -> Path:
    """FMI 2.0: x integrates u, y = k x behind each step; `ON_STEP="return 99"` and so on: what a call does first.

    `categories`: of messages, that it declares.
    """
    variables = [
        f'<ScalarVariable name="{name}" valueReference="{reference}" causality="{causality}" '
        f'variability="{variability}"><Real {start}/></ScalarVariable>'
        for name, reference, causality, variability, start in (
            ("x", 0, "output", "continuous", ""), ("u", 1, "input", "continuous", 'start="0"'),
            ("k", 2, "parameter", "fixed", 'start="1"'), ("y", 3, "output", "continuous", ""),
        )
    ]  # fmt: skip
    xml = native.description2(target.stem, variables, [1, 4], flags)
    said = "".join(f'<Category name="{name}"/>' for name in categories)
    said = f"<LogCategories>{said}</LogCategories>\n" if said else ""
    xml = xml.replace("<ModelVariables>", f'{said}<DefaultExperiment tolerance="1e-6"/>\n<ModelVariables>')
    return native.native_fmu(target, [NATIVE / "moody.c"], xml, 2, actions)


def answers(target: Path, *parts: str) -> Path:
    """FMI 2.0: outputs that answer at once. `parts`: what of ANSWERS its description shows."""
    shown = [entry for part in parts for entry in ANSWERS[part]]
    variables, outputs = [], []
    for name, kind, reference, causality, start in shown:
        variability = "fixed" if causality == "parameter" else "continuous" if kind == "Real" else "discrete"
        given = f' start="{start}"' if start else ""
        variables.append(
            f'<ScalarVariable name="{name}" valueReference="{reference}" causality="{causality}" '
            f'variability="{variability}"><{kind}{given}/></ScalarVariable>'
        )
        known = (
            ""
            if name in ("x", "v", "n")
            else " ".join(str(k) for k, (*_, other, _) in enumerate(shown, 1) if other == "input")
        )
        if causality == "output":
            outputs.append(f'<Unknown index="{len(variables)}" dependencies="{known}"/>')
    xml = native.description2(target.stem, variables, [])
    structure = f"<ModelStructure><Outputs>{''.join(outputs)}</Outputs></ModelStructure>"
    return native.native_fmu(
        target, [NATIVE / "answers.c"], xml.replace("<ModelStructure></ModelStructure>", structure), 2
    )


FUNCTIONS = ("x1", "x2", "x3", "x4", "fail_above", "ishigami", "g", "rosenbrock", "disc", "flat", "length")


def functions(target: Path) -> Path:
    """FMI 2.0: outputs that are functions of parameters, known in closed form; x2 and `length` are in m."""

    def variable(reference: int, name: str) -> str:
        is_parameter = reference < FUNCTIONS.index("ishigami")
        unit = ' unit="m"' if name in ("x2", "length") else ""
        start = f' start="{"1e9" if name == "fail_above" else 0.0}"' if is_parameter else ""
        kind = 'causality="parameter" variability="fixed"' if is_parameter else 'causality="output"'
        return (
            f'<ScalarVariable name="{name}" valueReference="{reference}" {kind}><Real{unit}{start}/></ScalarVariable>'
        )

    first = FUNCTIONS.index("ishigami")
    xml = native.description2(
        target.stem, [variable(k, name) for k, name in enumerate(FUNCTIONS)], range(first + 1, len(FUNCTIONS) + 1)
    )
    return native.native_fmu(target, [NATIVE / "functions.c"], xml, 2)


def built(folder: Path) -> Path:
    """A folder with feedthrough2.fmu and feedthrough3.fmu."""
    for make in (feedthrough2, feedthrough3):
        make(folder / f"{make.__name__}.fmu")
    return folder
