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
    return f"<{tag}{said}>{inside}</{tag}>" if inside else f"<{tag}{said}/>"


def _short(value: object) -> object:
    return f"{value:.2f}".rstrip("0").rstrip(".") if isinstance(value, float) else value
