"""A TOML file that knows its lines, so that an error can say where to mend it."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

from .errors import InputError

KINDS: dict[type[Any], str] = {dict: "a table", list: "a list", str: "text"}


class TomlFile:
    """Text and data of a TOML file. Raises InputError if it cannot be read."""

    def __init__(self, path: Path) -> None:
        self.path = path
        try:
            self.text = path.read_text(encoding="utf-8")
            self.data: dict[str, Any] = tomllib.loads(self.text)
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(f"system file {path} cannot be read: {error}") from error
        except tomllib.TOMLDecodeError as error:
            raise InputError(f"{path.name} is not valid TOML: {error}") from error

    @property
    def name(self) -> str:
        """What the system is called."""
        return self.path.stem

    def at(self, needle: str, table: str = "") -> str:
        """`(nominal.toml, line 31)`: the first line that holds the needle as a word, below the heading of `table`."""
        word = re.compile(rf"(?<![\w.]){re.escape(needle)}(?!\w)")
        inside = not table
        for number, line in enumerate(self.text.splitlines(), 1):
            heading = re.match(r"\s*\[+([^\[\]]+)\]", line)
            if heading and table:
                inside = f"{heading[1]}.".startswith(f"{table}.")
            if inside and word.search(line.partition("#")[0]):
                return f"({self.path.name}, line {number})"
        return self.at(needle) if table else f"({self.path.name})"

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
