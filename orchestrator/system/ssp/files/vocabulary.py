"""The elements and attributes of SSP: which are read, which a run would miss, and which must be there."""

from __future__ import annotations

TYPES = {"Real", "Integer", "Boolean", "String", "Enumeration", "Binary", "Float64", "Float32", "Clock"}
TYPES |= {f"{sign}Int{bits}" for sign in ("", "U") for bits in (8, 16, 32, 64)}
MAPPINGS = {"BooleanMappingTransformation", "IntegerMappingTransformation", "EnumerationMappingTransformation"}

# What is read, by the element that it stands in. Whatever else of SSP stands there is noted, but an error that names it
# where a run would miss it: among systems, connections and values.
CHILDREN = {
    "SystemStructureDescription": {"System", "Units", "DefaultExperiment", "Enumerations"},
    "System": {"Connectors", "ParameterBindings", "Elements", "Connections", "SignalDictionaries"},
    "Elements": {"Component", "System", "SignalDictionaryReference"},
    "Component": {"Connectors", "ParameterBindings"},
    "SignalDictionaryReference": {"Connectors", "ParameterBindings"},
    "SignalDictionaries": {"SignalDictionary"},
    "SignalDictionary": {"SignalDictionary", "DictionaryEntry", "Units", "Enumerations"},
    "DictionaryEntry": TYPES,
    "Connectors": {"Connector"},
    "Connector": TYPES,
    "Connections": {"Connection"},
    "Connection": {"LinearTransformation", *MAPPINGS},
    "ParameterBindings": {"ParameterBinding"},
    "ParameterBinding": {"ParameterValues", "ParameterMapping"},
    "ParameterValues": {"ParameterSet"},
    "ParameterSet": {"Parameters", "Units", "Enumerations"},
    "Parameters": {"Parameter"},
    "Parameter": TYPES,
    "ParameterMapping": {"ParameterMapping", "MappingEntry"},
    "MappingEntry": {"LinearTransformation", *MAPPINGS},
    **{name: {"MapEntry"} for name in MAPPINGS},
    "Units": {"Unit"},
    "Unit": {"BaseUnit"},
    "Enumerations": {"Enumeration"},
    **{name: {"Value", "Item"} for name in ("String", "Enumeration", "Binary")},
}
MISSED = {"System", "Elements", "Connections", "Connection", "ParameterBindings", "ParameterBinding", "ParameterValues"}
MISSED |= {"Parameters", "ParameterMapping", "MappingEntry", "SignalDictionaries", *MAPPINGS}
# What has no bearing on a simulation: drawings, signatures, sizes and clocks of variables, which the FMUs state.
PASSED_OVER = {"ElementGeometry", "ConnectorGeometry", "ConnectionGeometry", "SystemGeometry", "GraphicalElements"}
PASSED_OVER |= {"Annotations", "MetaData", "Signature", "SSDVariant", "Dimension", "DisplayUnit"}
DRAFT = {"SimulationInformation"}  # of drafts, which OMSimulator wrote for years: steps of masters and solvers
REFUSED_ATTRIBUTES = ("startIndices", "endIndices")
# What must be there and what must be a number, in versions too for which there is no schema.
REQUIRED_CHILDREN = {"SystemStructureDescription": "System", "Unit": "BaseUnit"}
REQUIRED_ATTRIBUTES = {
    **{name: ("name",) for name in ("System", "Component", "SignalDictionaryReference")},
    "Connection": ("startConnector", "endConnector"),
    "Parameter": ("name",),
}
STATED_ATTRIBUTES = {"MapEntry": ("source", "target")}  # they may be empty
NAMED = ("Connector", "Unit", "DictionaryEntry", "Item")  # what can be left out where it has no name
NUMBERS = {"factor", "offset", "startTime", "stopTime"}
