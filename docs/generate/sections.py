"""Parts of Markdown files of the repository, in pages of the documentation."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from markdown_it import MarkdownIt

ROOT = Path(__file__).parents[2]
HEADING = re.compile(r"^(#+) (.*)$", re.MULTILINE)
LINK = re.compile(r"\[([^]]+)\]\(([^)\s#]+)(#[^)\s]*)?\)")


def whole(path: str) -> str:
    """A file without its title."""
    text = (ROOT / path).read_text(encoding="utf-8")
    return linked(re.sub(r"\A# .*\n", "", text), path)


def opening(path: str) -> str:
    """What stands between a file's title and its next heading."""
    return re.split(r"^#+ ", whole(path), maxsplit=1, flags=re.MULTILINE)[0]


def section(path: str, heading: str) -> str:
    """What stands under `heading`, without the heading itself; its own headings one level up."""
    text = (ROOT / path).read_text(encoding="utf-8")
    plain = re.sub(
        r"```.*?```", lambda code: code[0].replace("#", " "), text, flags=re.DOTALL
    )  # comments are no headings
    found = [(m.start(), m.end(), len(m[1]), m[2]) for m in HEADING.finditer(plain)]
    place = next((k for k, one in enumerate(found) if one[3] == heading), None)
    if place is None:
        raise ValueError(f"{path} has no heading '{heading}'")
    level = found[place][2]
    end = next((one[0] for one in found[place + 1 :] if one[2] <= level), len(text))
    return linked(re.sub(r"^#(#+ )", r"\1", text[found[place][1] : end], flags=re.MULTILINE), path)


def linked(text: str, path: str) -> str:
    """Links between READMEs as links between pages; what has no page is named without a link."""

    def link(found: re.Match[str]) -> str:
        text, target, place = found[1], found[2], found[3] or ""
        if "://" in target:
            return found[0]
        name = (Path(path).parent / target).as_posix()
        resolved = re.sub(r"[^/]+/\.\./", "", name)
        known = re.fullmatch(r"components/(\w+)/README\.md", resolved)
        if resolved.startswith("docs/"):
            return f"[{text}](/{resolved.removeprefix('docs/')}{place})"
        return f"[{text}](/fmus/{known[1]}.md{place})" if known else text

    return LINK.sub(link, text)


def wide(table: str) -> str:
    """A long table as HTML, which is quick to build and scrolls by itself on a narrow screen."""
    html = _tables().render(table).replace("<table>", '<table class="table">').replace("\n", "")
    return f'<div class="wide pst-scrollable-table-container">{html}</div>'


@cache
def _tables() -> MarkdownIt:
    return MarkdownIt("commonmark").enable("table")
