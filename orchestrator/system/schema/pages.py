"""What is made from the declarations of keys: JSON schemas for editors, and the reference page."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import msgspec
from msgspec import inspect

from ...errors import InputError, nearest
from .checked import fields_of
from .keys.event import ScenarioTable
from .keys.fit import FitTable
from .keys.mapping import MappingTable
from .keys.sweep import SweepTable
from .keys.system import SystemTable
from .keys.values import TIME, ParameterFile, UnitFile
from .words import in_words, stripped

FILES: dict[str, Any] = {
    "system": SystemTable, "scenario": ScenarioTable, "mapping": MappingTable, "sweep": SweepTable, "fit": FitTable,
    "parameter": ParameterFile, "unit": UnitFile,
}  # fmt: skip
HEAD = """\
# Keys of the files

Made by `rovbrush schema --reference` from the declarations that the files are checked against. An editor knows them
from `rovbrush schema system --out system.schema.json` and a first line `#:schema system.schema.json` in the file.
Times are written as `0.005`, `"5 ms"`, `"250 us"` or `"1/60 s"`.
"""


@dataclass(frozen=True)
class Algorithms:
    """What a system file can say of algorithms: their names, and the declared settings by the headings of tables."""

    names: Sequence[str] = ()
    settings: Mapping[str, type[Any]] = field(default_factory=dict)


def json_schema(name: str, algorithms: Algorithms) -> dict[str, Any]:
    """The JSON schema (draft 2020-12) of a kind of file. Raises InputError for a kind that there is not."""
    if name not in FILES:
        raise InputError(f"no file of kind '{name}'{nearest(name, FILES)}")
    found = msgspec.json.schema(FILES[name])
    if name == "system":
        properties = found["$defs"][SystemTable.__name__]["properties"]
        properties["algorithm"]["enum"] = list(algorithms.names)
        said = {"description": "settings of an algorithm"}
        properties.update({heading: {**said, **_settings(kind)} for heading, kind in algorithms.settings.items()})
    cleaned: dict[str, Any] = _without_null(found)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": f"rovbrush {name} file", **cleaned}


def _without_null(value: Any) -> Any:
    """TOML has no null: what may be left out is not written."""
    if isinstance(value, list):
        return [_without_null(entry) for entry in value if entry != {"type": "null"}]
    if not isinstance(value, dict):
        return value
    found = {key: _without_null(entry) for key, entry in value.items() if not (key == "default" and entry is None)}
    if len(found.get("anyOf", ())) == 1:
        found |= found.pop("anyOf")[0]
    return found


def schema_text(name: str, algorithms: Algorithms) -> str:
    """The JSON schema as a file holds it."""
    return json.dumps(json_schema(name, algorithms), indent=1, allow_nan=False) + "\n"


def reference(algorithms: Algorithms) -> str:
    """Every key, type and default, as Markdown."""
    parts = [HEAD]
    for name, kind in FILES.items():
        parts.append(f"## A {name} file\n")
        declared = inspect.type_info(kind)
        if isinstance(stripped(declared), inspect.DictType):  # names of your own, and nothing else
            parts.append(f"{_described(declared)}\n")
            continue
        headings: dict[type[Any], list[str]] = {}
        for heading, table in _tables(kind, ""):
            headings.setdefault(table, []).append(heading)
        for table, several in headings.items():  # what stands in several places is described once
            rows = [_row(key, entry) for key, (entry, _) in fields_of(table).items()]
            shown = ", ".join(f"`{heading}`" for heading in several if heading)
            heading = f"### {shown}\n\n" if shown else ""
            parts.append(f"{heading}{(table.__doc__ or '').strip()}\n\n{_page_table(rows)}")
        if name == "system":
            parts.append(f"`algorithm` is one of {', '.join(algorithms.names)}. Some have settings:\n")
            for heading, kind in algorithms.settings.items():
                rows = [_row(key, entry) for key, (entry, _) in fields_of(kind).items()]
                parts.append(f"### `[{heading}]`\n\n{_page_table(rows)}")
    return "\n".join(parts)


def _page_table(rows: list[str]) -> str:
    return "\n".join(["| key | what | default | |", "|---|---|---|---|", *rows]) + "\n"


def _settings(kind: type[Any]) -> dict[str, Any]:
    """The JSON schema of a table of settings."""
    found = msgspec.json.schema(kind, schema_hook=lambda _time: {"type": ["number", "string"], "pattern": TIME})
    return {**found["$defs"][kind.__name__], "additionalProperties": False}


def _tables(kind: type[Any], heading: str) -> Iterator[tuple[str, type[Any]]]:
    """A table and those within it, each with how it is headed."""
    yield heading, kind
    for key, (declared, _) in fields_of(kind).items():
        plain = stripped(declared.type)
        if isinstance(plain, inspect.StructType | inspect.DataclassType):
            yield from _tables(plain.cls, f"[{key}]")
        elif isinstance(plain, inspect.ListType):
            for part in _parts(plain.item_type):
                yield from _tables(part, f"[[{key}]]")
        elif isinstance(plain, inspect.DictType):
            for part in _parts(plain.value_type):
                if isinstance(stripped(plain.value_type), inspect.UnionType):
                    named = "window" if key == "summary" else "NAME"
                    yield from _tables(part, f"{named} = {{ ... }} in {key}")
                else:
                    yield from _tables(part, f"[{key}.NAME]")


def _parts(type_: Any) -> list[type[Any]]:
    """The tables that a value may be."""
    plain = stripped(type_)
    parts = plain.types if isinstance(plain, inspect.UnionType) else (plain,)
    return [p.cls for p in map(stripped, parts) if isinstance(p, inspect.StructType | inspect.DataclassType)]


def _row(key: str, field: inspect.Field) -> str:
    default = "needed" if field.required else ""
    value = field.default_factory() if callable(field.default_factory) else field.default
    if isinstance(value, str | bool | int | float | list) and value not in ([], ""):
        default = f"`{json.dumps(value)}`"
    return f"| `{key}` | {in_words(field.type)} | {default} | {_described(field.type)} |".replace("  ", " ")


def _described(type_: Any) -> str:
    while isinstance(type_, inspect.Metadata):
        text = (type_.extra_json_schema or {}).get("description")
        if text:
            return str(text)
        type_ = type_.type
    return ""
