"""Ways to break SSP (and OSP's format) that a run can do without: what is wrong, how it is taken, how it is mended."""

from __future__ import annotations

from ....fmu.tolerant.rules import Rule

# files and text
SCHEMA = Rule("not as the XML schema wants it", "read all the same", "correct the file as it says")
VERSION = Rule("a version that is missing or none of the standard's", "read as the nearest one", "write 1.0 or 2.0")
NAMESPACE = Rule("elements outside of the standard's namespaces", "taken by their names", "declare the namespaces")
FOREIGN = Rule("elements that the standard does not know", "passed over", "keep what is one's own in Annotations")
STRUCTURE = Rule("a package without SystemStructure.ssd", "its only .ssd is taken", "name it SystemStructure.ssd")
BACKSLASH = Rule("sources with a backslash", "taken for a slash", "write slashes, as URIs have them")
CASE = Rule("sources in other upper and lower case than their files", "the file is taken", "write them alike")
KIND_OF_SOURCE = Rule(
    "sources of another kind than their type says",
    "taken by the file's name",
    "state the type that it has",
)
NAMELESS = Rule("units, connectors or items without a name", "passed over", "name them, or leave them out")
EMPTY = Rule("mappings without a source or target", "passed over", "state both, or leave the entry out")
# connectors and connections
NO_VARIABLE = Rule(
    "connectors for which the FMU has no variable", "passed over", "leave them out, or name them as the FMU does"
)
OTHER_KIND = Rule("connectors of another kind than the FMU's variable", "the FMU's causality is taken", "correct kind")
OTHER_TYPE = Rule("connectors of another type than the FMU's variable", "the FMU's type is taken", "correct the type")
OTHER_UNIT = Rule(
    "connectors in another unit than the FMU's variable", "the FMU's unit is taken", "state the FMU's unit, or none"
)
UNDEFINED_UNIT = Rule(
    "units that nothing defines", "values are passed on as they are", "define them in Units, by their base units"
)
TWICE = Rule("connections that are there twice", "taken once", "state each once")
NO_SIGNAL = Rule(
    "connectors that are not in the signal dictionary", "added to it", "add them to the dictionary, or leave them out"
)
# values
NOT_SETTABLE = Rule(
    "values for what the FMU computes itself", "not set", "leave them out, or give values to parameters and inputs"
)
NO_START = Rule(
    "inputs that nothing drives and for which neither file nor FMU has a value",
    "0, false or empty are taken", "connect them, or give them start values",
)  # fmt: skip
