"""One variable: what it says of itself is made to agree: words, start value, range, unit."""

from __future__ import annotations

import re
from typing import Any

from ..types import REALS, TYPES
from .literals import TRUTH, mend_boolean, mend_number, number, place, whole
from .rules import (
    BOOLEAN,
    COMBINATION,
    CONTINUOUS,
    DISPLAY_UNIT,
    NUMBER,
    RANGE,
    START_MISSING,
    START_OUTSIDE,
    START_SURPLUS,
    TYPE,
    UNIT,
    WORD,
    Notes,
    Rule,
)

CALCULATED = ("calculated", "exact", "approx")
# what `initial` may be for a causality and variability, the default first (FMI 2.0.4: 2.2.7; FMI 3.0: 2.4.7.5)
INITIAL: dict[tuple[str, str], tuple[str, ...]] = {
    **{(c, v): ("exact",) for c in ("parameter", "structuralParameter") for v in ("fixed", "tunable")},
    **{(c, v): ("calculated", "approx") for c in ("calculatedParameter", "local") for v in ("fixed", "tunable")},
    **{(c, "constant"): ("exact",) for c in ("output", "local")},
    **{(c, v): CALCULATED for c in ("output", "local") for v in ("discrete", "continuous")},
    **{("input", v): ("exact",) for v in ("discrete", "continuous")},
    ("independent", "continuous"): (),
}
CAUSALITIES, VARIABILITIES = ({key[k] for key in INITIAL} for k in (0, 1))
WITHOUT_RANGE = ("Boolean", "String", "Binary", "Clock")


class Known:
    """What variables refer to: declared types and units, by name; and where notes go."""

    def __init__(self, root: Any, version: int, notes: Notes) -> None:
        self.version, self.notes = version, notes
        types = root.findall("TypeDefinitions/SimpleType" if version == 2 else "TypeDefinitions/*")
        self.types = {t.get("name"): t[0] if version == 2 else t for t in types}
        self.units = {
            unit.get("name"): [display.get("name") for display in unit.findall("DisplayUnit")]
            for unit in root.findall("UnitDefinitions/Unit")
        }
        bases = {unit.get("name"): unit.find("BaseUnit") for unit in root.findall("UnitDefinitions/Unit")}
        self.bases = {name: dict(base.attrib) for name, base in bases.items() if base is not None}

    def same_unit(self, one: str, other: str) -> bool:
        """Whether two names are defined as one unit."""
        return one in self.bases and self.bases[one] == self.bases.get(other)


def value_of(element: Any, version: int) -> Any:
    """The element that tells of a variable's values; None where there is none of a known type."""
    if version == 3:
        return element if element.tag in (*TYPES[3], "Binary", "Clock") else None
    return next((child for child in element if child.tag in TYPES[2]), None)


def mend_variable(element: Any, known: Known) -> None:
    """Mend one variable that has a name, a value reference and a type."""
    _Variable(element, known).mend()


class _Variable:
    def __init__(self, element: Any, known: Known) -> None:
        self.element, self.known, self.notes = element, known, known.notes
        self.name, self.value = element.get("name"), value_of(element, known.version)
        self.type = str(self.value.tag)
        self.real = self.type in REALS
        declared = self.value.get("declaredType")
        self.declared = known.types.get(declared)
        if declared is not None and self.declared is None:
            self.note(TYPE, f"{declared!r} of ")
            del self.value.attrib["declaredType"]

    def note(self, rule: Rule, what: str = "") -> None:
        self.notes.add(rule, f"{what}{place(self.element)}")

    def mend(self) -> None:
        for attribute in ("relativeQuantity", "unbounded", "reinit"):
            mend_boolean(self.value, attribute, self.notes, self.name)
        if self.real:
            mend_number(self.value, "nominal", self.notes, name=self.name)
        if self.type not in WITHOUT_RANGE:
            for attribute in ("min", "max"):
                mend_number(self.value, attribute, self.notes, integer=not self.real, name=self.name)
        self._variability()
        start = self._start()
        if self.type not in WITHOUT_RANGE:
            self._range(start)
        self._unit()

    def attribute(self, name: str) -> str | None:
        """Its own, or that of its declared type."""
        own: str | None = self.value.get(name)
        return own if own is not None or self.declared is None else self.declared.get(name)

    def _variability(self) -> None:
        element = self.element
        for attribute, words in (("causality", CAUSALITIES), ("variability", VARIABILITIES)):
            if element.get(attribute) is not None and element.get(attribute) not in words:
                self.note(WORD, f"{attribute}={element.get(attribute)[:40]!r} of ")
                del element.attrib[attribute]
        causality = element.get("causality", "local")
        natural = self._natural(causality)
        variability = element.get("variability") or ("continuous" if self.known.version == 2 else natural)
        if (causality, variability) not in INITIAL:
            self.note(COMBINATION, f"{causality} and {variability} of ")
            variability = natural
            element.set("variability", natural)
        elif variability == "continuous" and not self.real and causality != "independent":
            self.note(CONTINUOUS)
            variability = natural
            element.set("variability", natural)
        self.initials = INITIAL[causality, variability]
        initial = element.get("initial")
        if initial is not None and initial not in self.initials:
            self.note(COMBINATION if initial in CALCULATED else WORD, f"initial={initial[:40]!r} of ")
            del element.attrib["initial"]

    def _natural(self, causality: str) -> str:
        """The variability that a causality has if nothing else is said."""
        if "arameter" in causality:
            return "fixed"
        return "continuous" if self.real or causality == "independent" else "discrete"

    def _start(self) -> str | None:
        start: str | None = self.value.get("start")
        if self.known.version == 3 and self.type in ("String", "Binary"):
            self._bytes()
            start = next((child.get("value") for child in self.value.findall("Start")), None)
        elif start is not None and self.type != "String":
            start = self._numbers(start)
        initial = self.element.get("initial") or next(iter(self.initials), "")
        if start is None and initial in ("exact", "approx") and self.type != "Clock":
            self.note(START_MISSING)
        if start and (initial == "calculated" or self.element.get("causality") == "independent"):
            self.note(START_SURPLUS)
        return start

    def _bytes(self) -> None:
        """The start values of bytes are hexadecimal; left out where one is not."""
        starts = self.value.findall("Start") if self.type == "Binary" else ()
        for start in starts:
            try:
                bytes.fromhex(start.get("value") or "")
            except ValueError:
                self.note(NUMBER, f"start={start.get('value')[:40]!r} of ")
                for each in starts:
                    self.value.remove(each)
                return

    def _numbers(self, start: str) -> str | None:
        """The start value, or those of an array, as numbers; left out where one of them is none."""
        words, rule = start.split(), BOOLEAN if self.type == "Boolean" else NUMBER
        found: list[Any]
        if self.type == "Boolean":
            found, good = [TRUTH.get(word.lower()) for word in words], ("true|false|1|0")
        elif self.real or self.type == "Clock":
            found, good = [number(word) for word in words], ".*"
        else:
            found, good = [whole(word) for word in words], r"[+-]?\d+"
        if not words or None in found or any(x != x for x in found):
            del self.value.attrib["start"]
        elif all(re.fullmatch(good, word) for word in words):
            return start
        else:
            self.value.set("start", " ".join(map(str, found)))
        self.note(rule, f"start={start[:40]!r} of ")
        return self.value.get("start")  # type: ignore[no-any-return]

    def _range(self, start: str | None) -> None:
        low, high = number(self.attribute("min")), number(self.attribute("max"))
        if low is not None and high is not None and low > high:
            self.note(RANGE)
            for attribute in ("min", "max"):
                self.value.attrib.pop(attribute, None)
            return
        for word in (start or "").split():
            x = number(word)
            if x is not None and ((low is not None and x < low) or (high is not None and x > high)):
                self.note(START_OUTSIDE)

    def _unit(self) -> None:
        unit, shown = self.attribute("unit"), self.attribute("displayUnit")
        if unit and unit not in self.known.units:
            self.notes.add(UNIT, unit)
        if shown and shown not in (unit, *self.known.units.get(unit or "", ())):
            self.notes.add(DISPLAY_UNIT, shown)
        for alias in self.element.findall("Alias"):
            other = alias.get("displayUnit")
            if other and other not in (unit, *self.known.units.get(unit or "", ())):
                self.notes.add(DISPLAY_UNIT, other)
