"""What was done by hand in a run, with its instants: as lines to read, and as a scenario that does it again."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from ..clock import duration, instant, seconds_text
from ..toml.text import toml_value


class Record:
    """Kept in the order in which it was done. What is done again at the same instant replaces what was."""

    def __init__(self, system: str) -> None:
        self.system = system
        self._entries: list[tuple[int, dict[str, Any]]] = []  # number of the event in the plan, and the entry

    def add(self, number: int, stated: Mapping[str, Any]) -> None:
        """An event that was given, as a scenario states it, with its time."""
        at = instant(stated["at"], "at")
        self.end(number, at)
        self._entries.append((number, dict(stated)))

    def end(self, number: int, time: Fraction) -> bool:
        """What an event does ends at a time [s]; whether it was to begin there, and is taken back."""
        kept, withdrawn = [], False
        for other, entry in self._entries:
            if other == number:
                begin = instant(entry["at"], "at")
                if begin >= time:
                    withdrawn = True
                    continue
                if "fault" in entry and ((ends := _end(entry, begin)) is None or ends > time):
                    entry.pop("for", None)
                    entry["until"] = seconds_text(time)
            kept.append((other, entry))
        self._entries = kept
        return withdrawn

    def faults(self, now: Fraction) -> dict[str, str]:
        """What is broken at a time [s] or will be at the next instant, and how."""
        found = {}
        for _, entry in self._entries:
            if "fault" in entry:
                ends = _end(entry, instant(entry["at"], "at"))
                if ends is None or ends > now:
                    value = f" {entry['value']}" if "value" in entry else ""
                    found[str(entry["on"])] = f"{entry['fault']}{value}"
        return found

    def values(self) -> dict[str, Any]:
        """The last value of each input that was set."""
        return {name: value for _, entry in self._entries for name, value in entry.get("set", {}).items()}

    def lines(self) -> list[str]:
        """A line for each thing that was done."""
        return [f"{entry['at']}: {_words(entry)}" for _, entry in self._entries]

    def toml(self) -> str:
        """The scenario, for `rovbrush run SYSTEM --scenario FILE`."""
        found = [f"description = {toml_value(f'what was done by hand in a run of {self.system}')}\n"]
        for count, (_, entry) in enumerate(self._entries, 1):
            found.append("[[events]]")
            found += [f"{key} = {toml_value(value)}" for key, value in {"name": f"by hand {count}", **entry}.items()]
            found.append("")
        return "\n".join(found)


def _end(entry: Mapping[str, Any], begin: Fraction) -> Fraction | None:
    if "until" in entry:
        return instant(entry["until"], "until")
    return begin + duration(entry["for"], "for") if "for" in entry else None


def _words(entry: Mapping[str, Any]) -> str:
    if "set" in entry:
        return ", ".join(f"{name} = {value}" for name, value in entry["set"].items())
    value = f" {entry['value']}" if "value" in entry else ""
    until = f" until {entry['until']}" if "until" in entry else ""
    return f"{entry['on']}: {entry['fault']}{value}{until}"
