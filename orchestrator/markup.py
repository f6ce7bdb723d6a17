"""Elements of SVG and HTML as text. What strangers have named is escaped here, and nowhere else."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape

NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")  # of XML 1.0, 2.2


def safe(text: object) -> str:
    """Text that is text in XML and in HTML, whatever is in it."""
    return escape(NO_XML.sub("\ufffd", str(text)))


def element(tag: str, content: Sequence[str] | str = "", /, **attributes: object) -> str:
    """An element; `stroke_width=2` is its attribute `stroke-width`. The content is markup already."""
    inside = content if isinstance(content, str) else "".join(content)
    said = "".join(f' {name.rstrip("_").replace("_", "-")}="{safe(_short(v))}"' for name, v in attributes.items())
    return f"<{tag}{said}>{inside}</{tag}>"  # closed in full: in HTML `<progress/>` is open


def _short(value: object) -> object:
    return f"{value:.2f}".rstrip("0").rstrip(".") if isinstance(value, float) else value


def table(headings: Sequence[str], rows: Sequence[Sequence[str]], words: Sequence[int] = (0,)) -> str:
    """An HTML table; cells are markup already. Columns of `words` begin at the left, numbers end at the right."""
    side = ["left" if k in words else "right" for k in range(len(headings))]
    head = [element("th", text, style=f"text-align:{at}") for text, at in zip(headings, side, strict=True)]
    body = [
        element("tr", [element("td", cell, style=f"text-align:{at}") for cell, at in zip(row, side, strict=True)])
        for row in rows
    ]
    inside = [element("thead", element("tr", head)), element("tbody", body)]
    return element("table", inside, style="border-collapse:collapse")


def boxed(*parts: str) -> str:
    """Parts below one another, in a box that is scrolled where it is too narrow."""
    return element("div", "".join(parts), style="overflow-x:auto;max-width:100%")
