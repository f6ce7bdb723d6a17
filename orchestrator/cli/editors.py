"""What lies beside a system file so that an editor knows its keys: the schema, and who is told of it."""

from __future__ import annotations

import json

from ..system.file.shipped import SCHEMAS

SCHEMA = "system.schema.json"  # named by the first line of a system file, `#:schema system.schema.json`
TAPLO = """\
# For editors with Taplo, and for `taplo check`: the keys of the system file.
[[rule]]
include = ["{name}.toml"]
[rule.schema]
path = "{schema}"
"""
# Even Better TOML takes the schema from the first line; in its settings a schema beside the file cannot be named.
CODE = {
    ".vscode/extensions.json": {"recommendations": ["tamasfe.even-better-toml", "ms-python.python"]},
    ".vscode/settings.json": {"python.testing.pytestEnabled": True, "evenBetterToml.schema.enabled": True},
}


def editor_files(name: str) -> dict[str, str]:
    """Texts by their path beside the system file NAME.toml."""
    settings = {path: json.dumps(content, indent=2) + "\n" for path, content in CODE.items()}
    schema = (SCHEMAS / SCHEMA).read_text(encoding="utf-8")
    return {SCHEMA: schema, ".taplo.toml": TAPLO.format(name=name, schema=SCHEMA), **settings}
