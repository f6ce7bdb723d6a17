"""Descriptions that break the standard, for every rule: what is edited in those of two sound FMUs, and what is said."""

from __future__ import annotations

from collections.abc import Mapping

import fmpy
from rovbrush.orchestrator.fmu.tolerant import rules

SUFFIX = fmpy.sharedLibraryExtension
FOLDER2, FOLDER3 = f"binaries/{fmpy.platform}", f"binaries/{fmpy.platform_tuple}"
LIBRARY2, LIBRARY3 = f"{FOLDER2}/feedthrough2{SUFFIX}", f"{FOLDER3}/feedthrough3{SUFFIX}"
GUID, VARIABLES, OUT = 'guid="feedthrough2"', "<ModelVariables>", '<Unknown index="2" dependencies="1"/>'
COMPLEX = '<ScalarVariable name="c" valueReference="7"><Complex/></ScalarVariable>'
U = 'name="u" valueReference="0" causality="input" variability="continuous"><Real start="0"/>'
Y = 'name="y" valueReference="1" causality="output" variability="continuous"><Real /></ScalarVariable>'
N = 'name="n_in" valueReference="0" causality="input" variability="discrete"><Integer start="0"/>'
FAULT = 'causality="parameter" variability="fixed"><Integer start="0" min="0" max="9"/>'
AT = 'causality="parameter" variability="fixed"><Real start="1e9"/>'
MODE = 'causality="input" variability="discrete"><Enumeration declaredType="Mode" start="1"/>'
ON = 'causality="input" variability="discrete"><Boolean start="false"/>'
HEAD = '<?xml version="1.0" encoding="UTF-8"?>'
NEXT = "</ScalarVariable>\n</ModelVariables>"
LAST = '<ScalarVariable name="more" valueReference="2" causality="local"><Real {}/></ScalarVariable>\n</ModelVariables>'
UNITS = "<UnitDefinitions>{}</UnitDefinitions>\n<TypeDefinitions>"
TYPES = "<TypeDefinitions>"
RAD_DEG = (
    '<Unit name="rad"><BaseUnit rad="1"/></Unit>'
    '<Unit name="deg"><BaseUnit rad="1" factor="0.017453292519943295"/></Unit>'
)


def more(inner: str) -> dict[str, str]:
    """One more variable, a Real with these attributes."""
    return {"</ModelVariables>": LAST.format(inner)}


# rule, what is replaced in the description of feedthrough2.fmu, words of the note
DESCRIPTIONS: list[tuple[rules.Rule, Mapping[str, str], str]] = [
    (rules.BEFORE, {HEAD: f"\n {HEAD}"}, "modelDescription.xml"),
    (rules.PREFIX, {NEXT: "<Annotations><Tool name='t'><osp:x/></Tool></Annotations>" + NEXT}, "osp:"),
    (rules.PREFIX, {VARIABLES: '<VendorAnnotations><Tool name="t"><osp:x osp:y="1"/></Tool></VendorAnnotations>'
                    + VARIABLES}, "osp:"),
    (rules.VERSION, {'fmiVersion="2.0"': 'fmiVersion="2.0.4"'}, "'2.0.4', taken for 2.0"),
    (rules.MISSING, {'guid="feedthrough2"': ""}, "guid"),
    (rules.MISSING, {'modelName="feedthrough2"': ""}, "modelName"),
    (rules.IDENTIFIER, {'modelIdentifier="feedthrough2"': 'modelIdentifier="feed through-2"'}, "'feed through-2'"),
    (rules.BOOLEAN, {'canGetAndSetFMUstate="true"': 'canGetAndSetFMUstate="True"'}, "canGetAndSetFMUstate='True'"),
    (rules.BOOLEAN, {ON: ON.replace("false", "False")}, "start='False' of on_in"),
    (rules.NUMBER, {GUID: GUID + ' numberOfEventIndicators=""'}, "numberOfEventIndicators=''"),
    (rules.NUMBER, {VARIABLES: '<DefaultExperiment startTime="" stopTime="1 s" stepSize="0,01"/>' + VARIABLES},
     "stopTime='1 s' of DefaultExperiment"),
    (rules.NUMBER, {"<CoSimulation": '<CoSimulation maxOutputDerivativeOrder="no"'}, "maxOutputDerivativeOrder='no'"),
    (rules.NUMBER, {U: U.replace("start", 'min="low" nominal="" start')}, "nominal='' of u (line 6), min='low'"),
    (rules.NUMBER, {N: N.replace('"0"/>', '"0.0" min="-50.0"/>')}, "min='-50.0' of n_in"),
    (rules.NUMBER, {U: U.replace('start="0"', 'start="zero"')}, "start='zero' of u"),
    (rules.NUMBER, {TYPES: UNITS.format('<Unit name="m"><BaseUnit m="one"/></Unit>')}, "m='one' of m"),
    (rules.NUMBER, {TYPES: UNITS.format('<Unit name="m"><BaseUnit m="1" factor="0"/></Unit>')}, "factor='0' of m"),
    (rules.UNKNOWN, {TYPES: TYPES + '<SimpleType name="T"><Real color="red"/></SimpleType>'}, "color of T"),
    (rules.UNKNOWN, {'<Item name="off" ': '<Item name="off" color="red" '}, "color of Mode"),
    (rules.NAMELESS, {TYPES: TYPES + '<SimpleType name="T"/><SimpleType><Real/></SimpleType>'}, "T (line 4), Simp"),
    (rules.NAMELESS, {TYPES: UNITS.format("<Unit/>")}, "Unit"),
    (rules.SCHEMA, {'guid="feedthrough2"': 'guid="feedthrough2" newerAttribute="1"'}, "newerAttribute"),
    (rules.SCHEMA, {"<ModelVariables>": "<Clocks/><ModelVariables>"}, "Clocks"),
    (rules.UNUSABLE, {"<ScalarVariable " + U: COMPLEX + "<ScalarVariable " + U,
                      'index="2" dependencies="1"': 'index="3" dependencies="2"'}, "c (line 6)"),
    (rules.UNUSABLE, {Y: Y + '<ScalarVariable name="z" valueReference="-1"><Real/></ScalarVariable>'}, "z (line 7)"),
    (rules.NAME_TWICE, {"</ModelVariables>": LAST.format("").replace("more", "y")}, "y (line 19)"),
    (rules.SET_TWICE, {"</ModelVariables>": LAST.format('start="3"').replace("local", "input").replace('"2"', '"0"')},
     "more (line 19)"),
    (rules.UNITS_DIFFER, {U: U.replace("start", 'unit="rad" start'), TYPES: UNITS.format(RAD_DEG),
                          "</ModelVariables>": LAST.format('unit="deg"').replace('"2"', '"0"')}, "deg of more (line"),
    (rules.TYPE, {U: U.replace("start", 'declaredType="Nowhere" start')}, "'Nowhere' of u"),
    (rules.WORD, {U: U.replace("continuous", "steady")}, "variability='steady' of u"),
    (rules.WORD, {"</ModelVariables>": LAST.format("").replace("local", "none")}, "causality='none' of more"),
    (rules.CONTINUOUS, {MODE: MODE.replace("discrete", "continuous")}, "mode_in"),
    (rules.CONTINUOUS, {MODE: MODE.replace('variability="discrete"', "")}, "mode_in"),
    (rules.CONTINUOUS, {ON: ON.replace('variability="discrete"', "")}, "on_in"),
    (rules.COMBINATION, {FAULT: FAULT.replace('variability="fixed"', "")}, "parameter and continuous of fault"),
    (rules.COMBINATION, {U: U.replace("continuous", "constant")}, "input and constant of u"),
    (rules.COMBINATION, {U: U.replace('"continuous"', '"continuous" initial="approx"')}, "initial='approx' of u"),
    (rules.START_MISSING, {N: N.replace(' start="0"', "")}, "n_in"),
    (rules.START_MISSING, {AT: AT.replace(' start="1e9"', "")}, "bad_at"),
    (rules.START_SURPLUS, {Y: Y.replace("<Real ", '<Real start="3" ')}, "y (line 7)"),
    (rules.START_OUTSIDE, {U: U.replace("start", 'min="1" start')}, "u (line 6)"),
    (rules.RANGE, {U: U.replace("start", 'min="3" max="1" start')}, "u (line 6)"),
    (rules.UNIT, {U: U.replace("start", 'unit="blorp" start')}, "blorp"),
    (rules.DISPLAY_UNIT, {U: U.replace("start", 'unit="m" displayUnit="yd" start'),
                          TYPES: UNITS.format('<Unit name="m"/>')}, "yd"),
    (rules.NOWHERE, {"<InitialUnknowns>": '<InitialUnknowns><Unknown index="99"/><Unknown index="-1"/>'}, "index='99'"),
    (rules.NOWHERE, {'index="2" dependencies="1"': 'index="2" dependencies="1 77"'}, "dependencies='1 77'"),
    (rules.NOWHERE, more('derivative="50"'), "derivative of more"),
    (rules.KINDS, {'index="2" dependencies="1"': 'index="2" dependencies="1" dependenciesKind="dependent dependent"'},
     "ModelStructure"),
    (rules.OUTPUTS, {OUT: ""}, "y (line 7)"),
    (rules.OUTPUTS, {OUT: OUT + '<Unknown index="1"/>'}, "u (line 6)"),
]  # fmt: skip

TIME = '<Float64 name="time" valueReference="999" causality="independent"></Float64>'
IN, INT, A = 'name="Float64_in" valueReference="0"', '<Int8 name="Int8_in"', '<Float64 name="a_in" valueReference="100"'
STARTS = 'start="1 2 3 4 5 6 7 8"'
# the same of feedthrough3.fmu
DESCRIPTIONS3: list[tuple[rules.Rule, Mapping[str, str], str]] = [
    (rules.VERSION, {'fmiVersion="3.0"': 'fmiVersion="3.0-beta.2"'}, "'3.0-beta.2', taken for 3.0"),
    (rules.MISSING, {'instantiationToken="{t}"': ""}, "instantiationToken"),
    (rules.BOOLEAN, {'canGetAndSetFMUState="true"': 'canGetAndSetFMUState="TRUE"'}, "canGetAndSetFMUState='TRUE'"),
    (rules.NUMBER, {"<CoSimulation": '<CoSimulation fixedInternalStepSize=""'}, "fixedInternalStepSize=''"),
    (rules.NUMBER, {STARTS: 'start="1 2 3 4 5 6 7 eight"'}, "start='1 2 3 4 5 6 7 eight' of a_in"),
    (rules.STARTS, {STARTS: 'start="1 2 3"'}, "3 for 8 of a_in"),
    (rules.UNUSABLE, {"</ModelVariables>": '<Quaternion name="q" valueReference="300"/></ModelVariables>'}, "q (line"),
    (rules.UNUSABLE, {"</ModelVariables>": '<Float64 name="b" valueReference="301"><Dimension valueReference="9999"/>'
                      "</Float64></ModelVariables>"}, "b (line"),
    (rules.NAME_TWICE, {"</ModelVariables>": '<Float64 name="b" valueReference="301"><Alias name="a_in"/></Float64>'
                        "</ModelVariables>"}, "a_in (line"),
    (rules.REFERENCE_TWICE, {"</ModelVariables>": '<Float64 name="b" valueReference="107"/></ModelVariables>'}, "b ("),
    (rules.INDEPENDENT, {TIME: ""}, "0"),
    (rules.CONTINUOUS, {INT: INT + ' variability="continuous"'}, "Int8_in"),
    (rules.NOWHERE, {IN: IN + ' clocks="77 78"'}, "clocks of Float64_in"),
    (rules.NOWHERE, {IN: IN + ' derivative="77"'}, "derivative of Float64_in"),
    (rules.NOWHERE, {'<Output valueReference="1" dependencies="0"': '<Output valueReference="1" dependencies="0 77"'},
     "dependencies='0 77'"),
    (rules.OUTPUTS, {'<Output valueReference="1" dependencies="0"/>': ""}, "Float64_out"),
    (rules.TYPE, {IN: IN + ' declaredType="Nowhere"'}, "'Nowhere' of Float64_in"),
]  # fmt: skip
