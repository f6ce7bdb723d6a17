"""The commands and the code of the documents, each with what its document says about running it.

A block of commands (```bash) or of Python is run as it stands. A comment in the line before it says otherwise:
`<!-- run with: OPTIONS -->` adds options that make it short, `<!-- fails: TEXT -->` expects an error with this text,
`<!-- run by: tests/... -->` names the test that runs it, and `<!-- not run: REASON -->` says why nobody does. A block
with a caption is a file, and is written.
"""

from __future__ import annotations

import re
import shlex
from dataclasses import dataclass
from pathlib import Path

from helpers import ROOT

GIVEN = ("README.md", "fmus/README.md", "orchestrator/README.md", "components/*/README.md")
PAGES = sorted(path for pattern in ("docs/**/*.md", *GIVEN) for path in ROOT.glob(pattern))
MARK = r"(?:^<!-- (run with|run by|fails|not run): (.*?) -->\n"
FENCE = re.compile(MARK + r")?^```(.*?)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
INDENTED = re.compile(MARK + r"\n)?(?<=\n\n)((?:    .*\n)+)", re.MULTILINE)
COMMAND = re.compile(r"(rovbrush|make|pip|pytest|python\d?|fmpy|gcc|unzip|dask)\s")
CAPTION = re.compile(r"^:caption: (\S+)$", re.MULTILINE)


@dataclass(frozen=True)
class Block:
    """One block of a document."""

    path: Path
    line: int
    kind: str  # bash, python, or the name of a file
    text: str
    mark: str
    said: str

    @property
    def commands(self) -> list[str]:
        """The lines of a block of commands, continued lines joined, without comments."""
        lines = self.text.replace("\\\n", " ").splitlines()
        return [line.strip().removeprefix("$ ") for line in lines if line.strip() and not line.strip().startswith("#")]

    def __str__(self) -> str:
        return f"{self.path.relative_to(ROOT)}:{self.line}"


def blocks(path: Path) -> list[Block]:
    """Commands, code and files of a document, in their order."""
    text = path.read_text(encoding="utf-8")
    found = []
    for fence in FENCE.finditer(text):
        mark, said, info, content = fence.groups()
        caption = CAPTION.search(content)
        kind = caption[1] if caption else {"bash": "bash", "console": "bash", "python": "python"}.get(info.strip(), "")
        if caption:
            content = content.split("\n\n", 1)[1]
        if kind:
            line = text.count("\n", 0, fence.start(4)) + 1
            found.append(Block(path, line, kind, content, mark or "", said or ""))
    for indented in INDENTED.finditer(text):
        mark, said, content = indented.groups()
        if COMMAND.match(content.strip()):
            line = text.count("\n", 0, indented.start(3)) + 1
            found.append(Block(path, line, "bash", re.sub(r"^    ", "", content, flags=re.M), mark or "", said or ""))
    return sorted(found, key=lambda block: block.line)


def words(command: str) -> list[str]:
    """A command as a shell takes it apart, without a comment behind it."""
    return shlex.split(command, comments=True)


INLINE = re.compile(r"`(rovbrush [a-z][^`\n]*)`")


def mentioned(path: Path) -> list[str]:
    """Commands that are named within a line."""
    return INLINE.findall(path.read_text(encoding="utf-8"))
