"""Signal dictionaries: named signals that elements of several systems share, each reference one of the same."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from .archive import Archive
from .document import Document, find, local, typed_child

REALS = ("Real", "Float64", "Float32")
DICTIONARY = "application/x-ssp-signal-dictionary"


@dataclass(frozen=True)
class Entry:
    """What an entry or a connector says of its type; empty where it leaves it open."""

    type: str = ""
    unit: str | None = None
    enumeration: str = ""

    def fits(self, variable: str) -> bool:
        """Whether it is the type of an FMU's variable, whatever the number of bits."""
        return not self.type or self.type == variable or {self.type, variable} <= set(REALS) or (
            "Int" in self.type and "Int" in variable
        )  # fmt: skip


@dataclass(frozen=True)
class Dictionary:
    """The signals of one dictionary."""

    xml: Any
    entries: dict[str, Entry] = field(default_factory=dict)


def typed_entry(element: Any) -> Entry:
    """The type, unit and enumeration that a connector or an entry states."""
    typed = typed_child(element)
    if typed is None:
        return Entry()
    kind = local(typed)
    return Entry(kind, typed.get("unit") or None, typed.get("name") or "" if kind == "Enumeration" else "")


def dictionaries_of(document: Document, archive: Archive, system: Any) -> dict[str, Dictionary]:
    """The dictionaries that a system declares, inside or in a .ssb file. Raises InputError."""
    found = {}
    for xml in find(system, "SignalDictionaries/SignalDictionary"):
        name, source = xml.get("name") or "", xml.get("source")
        if (xml.get("type") or DICTIONARY) != DICTIONARY:
            raise document.fail(f"a signal dictionary of type {xml.get('type')} is not supported", xml)
        roots = find(xml, "SignalDictionary")
        if source:
            label = f"signal dictionary '{name}' {document.at(xml)}"
            file = archive.resolve(source, label, document.notes)
            roots = [Document(file, archive.shown(file), "SignalDictionary", document.notes).root]
        entries = {e.get("name"): typed_entry(e) for root in roots for e in find(root, "DictionaryEntry")}
        found[name] = Dictionary(xml, entries)
    return found
