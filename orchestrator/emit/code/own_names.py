"""The names that the C of every system declares in its files: functions, types, macros, items, variables."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

SOURCES = Path(__file__).parent.parent / "sources"
AROUND = re.compile(r'/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)  # comments and texts
MACRO = re.compile(r"^#\s*define\s+(\w+)", re.MULTILINE)
ITEMS = re.compile(r"\benum\s*\w*\s*\{(.*?)\}", re.DOTALL)
DECLARED = re.compile(r"\b([A-Za-z_]\w*)\s*(?:\[[^\]]*\]\s*)*(?=[(=;,])")


@cache
def own_names() -> frozenset[str]:
    """Those that stand there as they are; others begin with the name of the system."""
    found: set[str] = set()
    for path in sorted(SOURCES.iterdir()):
        text = AROUND.sub("", path.read_text(encoding="utf-8"))
        found.update(MACRO.findall(text))
        for items in ITEMS.findall(text):
            found.update(re.findall(r"[A-Za-z_]\w*", items))
        found.update(DECLARED.findall(_outermost(text)))
    return frozenset(name for name in found if not re.match(r"SYSTEM\b|SYSTEM_|fmi\d", name))


def _outermost(text: str) -> str:
    """A text of C without what stands in brackets, and without what is for the preprocessor."""
    text = re.sub(r"^#(?:.*\\\n)*.*$", "", text, flags=re.MULTILINE)
    kept, depth = [], 0
    for c in text:
        depth -= c in ")}"
        if depth == 0 or (depth == 1 and c == "("):
            kept.append(c)
        depth += c in "({"
    return "".join(kept)
