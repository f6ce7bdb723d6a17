"""The messages that signals make together for observers, checked against the components of a system."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...errors import nearest
from ...toml.file import TomlFile
from ..component import Component
from ..schema.checked import checked
from ..schema.keys.message import FIELDS, MessageTable


def check_message(file: TomlFile, components: Mapping[str, Component], entry: dict[str, Any], label: str) -> None:
    """Raise InputError for a field that its type does not have, and for a signal that no component has."""
    table = checked(MessageTable, entry, label, file, "messages")
    given = {field: getattr(table, field) for fields in FIELDS.values() for field in fields}
    for field, sources in given.items():
        if sources is None:
            continue
        if field not in FIELDS[table.type]:
            has = " and ".join(FIELDS[table.type])
            raise file.fail(f"{label}: a {table.type} has {has}, and no {field}", field, "messages")
        for name in sources:
            owner, _, variable = name.partition(".") if isinstance(name, str) else ("", "", "")
            if isinstance(name, str) and (owner not in components or variable not in components[owner].fmu.variables):
                known = [f"{c.name}.{v}" for c in components.values() for v in c.fmu.variables]
                what = f"{field}: no variable is called '{name}'{nearest(name, known)}"
                raise file.fail(f"{label}: {what}", name, "messages")
    if not any(isinstance(name, str) for sources in given.values() for name in sources or ()):
        raise file.fail(f"{label}: it names no signal", str(table.topic), "messages")
