"""A TOML file that knows its lines, so that an error can say where to mend it."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from contextlib import suppress
from difflib import get_close_matches
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any

from ..errors import InputError
from .lines import Lines

KINDS: dict[type[Any], str] = {dict: "a table", list: "a list", str: "text"}
LARGEST = 16 << 20  # bytes
DEEPEST = 32  # tables and lists within each other
LONGEST = 1024  # bits of a whole number; no double is larger
PART = r"""(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')"""
DOTTED = re.compile(rf"(?<![\w-]){PART}(?:[ \t]*+\.[ \t]*+{PART}){{100}}")  # the parser's time grows with the square
DIGITS = re.compile(r"[\d_]{1000,}")


class TomlFile:
    """Text and data of a TOML file. Raises InputError if it cannot be read, or holds what no file of ours can need:
    names of very many parts, very deep lists, very large numbers, the character NUL."""

    notes: Mapping[str, tuple[str, ...]] = MappingProxyType({})  # what to tell of components, where files of a kind do
    remarks: tuple[str, ...] = ()  # and of the whole
    made: Mapping[str, Any] = MappingProxyType({})  # FMUs of components that are in no file
    breaches: tuple[Any, ...] = ()  # where the file breaks a standard, as `fmu.tolerant` notes it

    def __init__(self, path: Path) -> None:
        self.path = path
        self.text = _text(path)
        self.data: dict[str, Any] = self._parsed()
        self._check()

    def _parsed(self) -> dict[str, Any]:
        dotted = DOTTED.search(self.text)
        if dotted:
            raise self._invalid("a name of so many parts is not allowed", dotted.start())
        try:
            return tomllib.loads(self.text)
        except tomllib.TOMLDecodeError as error:
            raise InputError(f"{self.path.name} is not valid TOML: {error}") from error
        except RecursionError:
            raise self._invalid("lists or tables stand too deep within each other", self._deepest()) from None
        except ValueError:  # Python refuses to read thousands of digits
            digits = DIGITS.search(self.text)
            raise self._invalid("a number has too many digits", digits.start() if digits else 0) from None

    def _invalid(self, message: str, position: int) -> InputError:
        line = self.text.count("\n", 0, position) + 1
        return InputError(f"{self.path.name} cannot be read: {message} ({self.path.name}, line {line})")

    def _deepest(self) -> int:
        """Where most brackets are open."""
        depth, deepest, found = 0, 0, 0
        for bracket in re.finditer(r"[\[\]{}]", self.text):
            depth += 1 if bracket[0] in "[{" else -1
            if depth > deepest:
                deepest, found = depth, bracket.start()
        return found

    def _check(self) -> None:
        """Raise InputError for values that are valid TOML and nothing that could be meant."""
        waiting: list[tuple[Any, tuple[str, ...], int]] = [(self.data, (), 0)]
        while waiting:
            value, keys, depth = waiting.pop()
            wrong = ""
            if isinstance(value, dict | list):
                if depth > DEEPEST:
                    wrong = "lists or tables stand too deep within each other"
                elif isinstance(value, dict):
                    waiting += [(entry, (*keys, key), depth + 1) for key, entry in value.items()]
                    wrong = _NUL if any("\0" in key for key in value) else ""
                else:
                    waiting += [(entry, keys, depth + 1) for entry in value]
            elif isinstance(value, str):
                wrong = _NUL if "\0" in value else ""
            elif isinstance(value, int) and value.bit_length() > LONGEST:
                wrong = "a number has too many digits"
            if wrong:
                needle = keys[-1] if keys else ""
                raise self.fail(f"{'.'.join(keys[:3])}: {wrong}".lstrip(": "), needle, ".".join(keys[:-1][:2]))

    @property
    def name(self) -> str:
        """What the system is called."""
        return self.path.stem

    @cached_property
    def _lines(self) -> Lines:
        return Lines(self.text)

    def at(self, needle: str, table: str = "") -> str:
        """`(nominal.toml, line 31)`: the first line that holds the needle as a word, below the heading of `table`."""
        number = (self._lines.find(needle, table) if table else None) or self._lines.find(needle)
        return f"({self.path.name}, line {number})" if number else f"({self.path.name})"

    def fail(self, message: str, needle: str, table: str = "") -> InputError:
        return InputError(f"{message} {self.at(needle, table)}")

    def entry(self, kind: type[Any], key: str, within: dict[str, Any] | None = None, table: str = "") -> Any:
        """An optional entry of the file, or of one of its tables: empty where it is missing. A wrong type raises."""
        value = (self.data if within is None else within).get(key, kind())
        if not isinstance(value, kind):
            raise self.fail(f"{f'{table}: ' if table else ''}{key} must be {KINDS[kind]}", key, table)
        return value

    def entries(self, kind: type[Any], key: str) -> list[Any]:
        """An optional list, all of one type."""
        values: list[Any] = self.entry(list, key)
        if not all(isinstance(value, kind) for value in values):
            raise self.fail(f"{key} must be a list, each entry {KINDS[kind]}", key)
        return values


_NUL = "the character NUL is not allowed in a text"


def _text(path: Path) -> str:
    try:
        if path.stat().st_size > LARGEST:
            raise InputError(
                f"system file {path} has more than {LARGEST >> 20} MB; split it, or keep tables in CSV files"
            )
        if path.exists() and not path.is_file():
            raise InputError(f"system file {path} is no file")
        return path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise InputError(f"system file {path} cannot be read: there is no such file{_beside(path)}") from None
    except (OSError, ValueError) as error:
        raise InputError(f"system file {path} cannot be read: {error}") from error


def _beside(path: Path) -> str:
    """Which file in the same folder may be meant; empty for none."""
    found: list[str] = []
    with suppress(OSError):
        found = [other.name for other in path.parent.iterdir() if other.suffix.lower() == path.suffix.lower()]
    close = get_close_matches(path.name, found, 1)
    return f"; did you mean '{path.parent / close[0]}'?" if close else ""
