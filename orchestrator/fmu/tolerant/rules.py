"""Ways to break the standard that a run can do without: what is wrong, how it is taken, how its maker mends it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from ...errors import listed


class Rule(NamedTuple):
    """`found` is said before the places where it is; `taken`: what is done instead; `mend`: for the FMU's maker."""

    found: str
    taken: str
    mend: str


# archive and library
BACKSLASH = Rule("paths with a backslash", "taken for a slash", "pack with slashes, as zip wants them")
TWICE = Rule("entries that are there twice with the same content", "one is taken", "pack each file once")
LIBRARY = Rule("a library not called after modelIdentifier", "it is taken", "name the library after modelIdentifier")
IDENTIFIER = Rule(
    "a modelIdentifier that is no name in C", "taken for the library's name", "use letters, digits and _ only"
)
PLATFORM = Rule("a platform folder of another version of FMI", "it is taken", "name the folder as this version does")
FUNCTIONS = Rule(
    "functions that the library lacks", "only a call of them fails", "export all functions of the standard"
)
BUILD = Rule("sources/buildDescription.xml cannot be understood", "it is not used", "correct it, or leave it out")
TERMINALS_FILE = Rule("terminalsAndIcons.xml cannot be understood", "it has none", "correct it, or leave it out")
TERMINAL = Rule(
    "terminals and members that name no variable, or not one of their own", "passed over", "complete or leave them out"
)
# text
ENCODING = Rule("bytes that are not of the declared encoding", "taken for Windows-1252", "write UTF-8, and declare it")
BEFORE = Rule("blank space before the XML declaration", "passed over", "begin the file with <?xml")
PREFIX = Rule("namespace prefixes that nothing declares", "taken for a part of the name", "declare each with xmlns:")
# the whole
VERSION = Rule("an fmiVersion that is not one of the standard's", "taken for the nearest", "write 1.0, 2.0 or 3.0")
MISSING = Rule("elements and attributes that must be there", "taken for empty", "write them")
BOOLEAN = Rule("attributes that are neither true nor false", "taken as they are meant", "write true or false")
NUMBER = Rule("attributes that are no numbers", "passed over", "write numbers, with a point and without units")
UNKNOWN = Rule("attributes that the standard does not know", "passed over", "keep what is one's own in Annotations")
NAMELESS = Rule("units, types or items without a name or content", "passed over", "complete them, or leave them out")
SCHEMA = Rule("not as the XML schema wants it", "not used", "correct modelDescription.xml as it says")
# variables
UNUSABLE = Rule("variables without name, type, value reference or size", "left out", "complete them, or leave them out")
NAME_TWICE = Rule("variables of the same name", "the first is taken", "give each variable a name of its own")
REFERENCE_TWICE = Rule("variables of the same value reference", "both are kept", "write one, the other as its Alias")
SET_TWICE = Rule(
    "inputs or parameters of the same value reference", "they are one variable", "let one of them alone be set"
)
UNITS_DIFFER = Rule(
    "variables of the same value reference in different units",
    "the number is the same in each",
    "state one unit, and others as its displayUnit",
)
INDEPENDENT = Rule("not one independent variable but", "no matter", "declare time, and nothing else, as independent")
TYPE = Rule("declared types that nothing defines", "the variable is taken without", "define them in TypeDefinitions")
WORD = Rule("unknown words for causality, variability or initial", "the default is taken", "use those of the standard")
CONTINUOUS = Rule(
    "continuous variables that are no real numbers", "taken for discrete", 'write variability="discrete"'
)  # also where the attribute is left out: its default is continuous in FMI 2.0
COMBINATION = Rule(
    "causality, variability and initial that do not go together", "the nearest that do are taken", "correct them"
)
START_MISSING = Rule("start values that are missing", "0, false or empty where one is needed", "give start values")
START_SURPLUS = Rule("start values of what is calculated", "not set", "leave start out, or correct initial")
START_OUTSIDE = Rule("start values outside of min and max", "taken as they are", "correct min, max or start")
ALIAS = Rule("negated aliases that are no numbers", "taken as aliases", "negate in the model, or leave the alias out")
STARTS = Rule("arrays with neither one start value nor one per element", "passed over", "give one per element")
RANGE = Rule("min above max", "taken for no range", "correct min and max")
UNIT = Rule("units that nothing defines", "taken by their names", "define them in UnitDefinitions")
DISPLAY_UNIT = Rule("display units that nothing defines", "not used", "define them as DisplayUnit of the unit")
# structure
NOWHERE = Rule("references to what is not there", "passed over", "let indices and references name what is there")
KINDS = Rule("dependenciesKind not one for each dependency", "passed over", "write one word for each dependency")
OUTPUTS = Rule("outputs missing in or surplus to ModelStructure", "taken to depend on all inputs", "list each once")

RULES = tuple(value for value in list(vars().values()) if isinstance(value, Rule))


@dataclass(frozen=True)
class Note:
    """One rule and the places where it is broken."""

    rule: Rule
    places: tuple[str, ...]

    @property
    def found(self) -> str:
        """What is wrong where, and how it is taken."""
        return f"{self.rule.found}: {listed(self.places)}; {self.rule.taken}"


class Notes:
    """What is noted while an FMU is read."""

    def __init__(self) -> None:
        self._places: dict[Rule, dict[str, None]] = {}

    def add(self, rule: Rule, place: str) -> None:
        """Note that a rule is broken at a place."""
        self._places.setdefault(rule, {})[place if len(place) < 200 else f"{place[:200]}..."] = None

    def leave_out(self, *rules: Rule) -> None:
        """Forget rules that are none here."""
        for rule in rules:
            self._places.pop(rule, None)

    def all(self) -> tuple[Note, ...]:
        """Each rule once."""
        return tuple(Note(rule, tuple(places)) for rule, places in self._places.items())
