"""A page of HTML that needs nothing but itself: text is escaped, figures are inside, scripts come from nowhere else."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Html(str):
    """Text that is markup already; everything else is escaped."""

    __slots__ = ()


def markup(content: object) -> str:
    """Markup as it is, anything else escaped."""
    return content if isinstance(content, Html) else escape(str(content))


def element(tag: str, *content: object, **attributes: str) -> Html:
    """One element; `class_` is `class`."""
    pairs = "".join(f' {name.rstrip("_")}="{escape(value)}"' for name, value in attributes.items())
    return Html(f"<{tag}{pairs}>{''.join(map(markup, content))}</{tag}>")


def join(parts: Iterable[object]) -> Html:
    """Several pieces, one after the other."""
    return Html("\n".join(map(markup, parts)))


def table(heading: Sequence[object], rows: Iterable[Sequence[object]], class_: str = "") -> Html:
    """A table with a heading; a row is a sequence of cells."""
    head = element("tr", *(element("th", cell) for cell in heading))
    body = join(element("tr", *(element("td", cell) for cell in row)) for row in rows)
    return element("div", element("table", element("thead", head), element("tbody", body), class_=class_),
                   class_="scroll")  # fmt: skip


def image(figure: Figure, words: str) -> Html:
    """A figure as PNG inside the page; `words` say what it shows."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png")
    data = base64.b64encode(buffer.getvalue()).decode()
    return Html(f'<img alt="{escape(words)}" src="data:image/png;base64,{data}">')


def section(name: str, title: str, *content: object) -> Html:
    """A part of the page with a heading; `name` is its anchor."""
    return element("section", element("h2", title), *content, id=name)


def page(title: str, lead: object, sections: Sequence[tuple[str, str, Html]]) -> str:
    """The whole document: title, lead, contents, and (anchor, heading, content) for every section."""
    contents = element("nav", *(Html(f'<a href="#{escape(name)}">{escape(head)}</a>') for name, head, _ in sections))
    body = join([
        element("header", element("h1", title), lead), contents,
        *(section(name, head, content) for name, head, content in sections),
    ])  # fmt: skip
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>{STYLE}</style>\n</head>\n"
        f"{element('body', element('main', body))}\n</html>\n"
    )


STYLE = """
:root { --ink: #1c2733; --soft: #5b6875; --line: #dde3e9; --paper: #fff; --shade: #f5f7f9; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--shade); color: var(--ink); font: 15px/1.5 system-ui, "Segoe UI", Helvetica, Arial,
  sans-serif; }
main { max-width: 1240px; margin: 0 auto; padding: 24px; }
h1 { font-size: 28px; line-height: 1.2; margin: 0 0 8px; }
h2 { font-size: 21px; margin: 0 0 12px; }
h3 { font-size: 16px; margin: 24px 0 8px; }
p { margin: 0 0 12px; max-width: 90ch; }
header { padding: 8px 0 16px; }
nav { display: flex; flex-wrap: wrap; gap: 6px 18px; padding: 0 0 16px; }
nav a { color: #1f5f8b; text-decoration: none; }
section { background: var(--paper); border: 1px solid var(--line); border-radius: 8px; padding: 20px 22px;
  margin: 0 0 20px; }
.scroll { overflow-x: auto; margin: 0 0 14px; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: 7px 10px; border-bottom: 1px solid var(--line); }
th { font-weight: 600; border-bottom: 2px solid var(--line); white-space: nowrap; }
table table th, table table td { padding: 4px 8px; font-size: 14px; }
table table th { font-weight: 500; color: var(--soft); border-bottom-width: 1px; }
table.checks td:first-child { width: 46%; }
table.checks td:not(:first-child) { white-space: nowrap; }
table.claims > tbody > tr > td:nth-child(2) { width: 31%; }
table.numbers td:not(:first-child), table.numbers th:not(:first-child) { text-align: right; white-space: nowrap; }
.chip { display: inline-block; padding: 1px 9px; border-radius: 10px; white-space: nowrap; font-weight: 600;
  font-size: 13px; }
.yes { background: #d9efdf; color: #14602c; }
.fit { background: #e0e8f8; color: #24468c; }
.no { background: #f9e0da; color: #922b14; }
.soft { color: var(--soft); font-size: 13px; }
code { font: 12.5px/1.45 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
details { margin-top: 4px; }
summary { cursor: pointer; color: #1f5f8b; font-size: 13px; }
details code { display: block; padding: 2px 0; }
img { max-width: 100%; height: auto; display: block; }
.beside { display: grid; grid-template-columns: minmax(220px, 1fr) 2.4fr; gap: 22px; margin: 0 0 22px; }
.counts { display: flex; flex-wrap: wrap; gap: 10px; margin: 0 0 12px; }
@media (max-width: 800px) { .beside { grid-template-columns: 1fr; } main { padding: 12px; } }
"""
