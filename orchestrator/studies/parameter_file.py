"""What a study has found, as a parameter set: `--parameters` takes it, whatever the system's own file states."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from ..toml.text import toml_key, toml_value


def set_text(about: str, base: str, values: Mapping[str, tuple[object, str]], folder: Path) -> str:
    """The set as TOML: values by `component.variable`, each with a comment or none.

    `base`: the set that the study was given, by its name or its path, which is written from `folder`, where the text
    goes; "" is that of the system.
    """
    below = Path(os.path.relpath(base, folder)).as_posix() if base and Path(base).is_file() else base
    tables: dict[str, list[str]] = {}
    for name, (value, comment) in values.items():
        component, _, variable = name.partition(".")
        line = f"{toml_key(variable)} = {toml_value(value)}"
        tables.setdefault(component, []).append(f"{line}  # {comment}" if comment else line)
    lines = [f"description = {toml_value(about)}", f"base = {toml_value(below)}"]
    for component, entries in tables.items():
        lines += ["", f"[{component}]", *entries]
    return "\n".join(lines) + "\n"
