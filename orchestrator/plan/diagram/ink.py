"""Words in a picture: how wide they are, and as many of them as there is room for."""

from __future__ import annotations

import unicodedata

from ...markup import element, safe

MONO = "ui-monospace,SFMono-Regular,Menlo,'DejaVu Sans Mono',Consolas,monospace"
SANS = "system-ui,-apple-system,'Segoe UI',Roboto,'DejaVu Sans',sans-serif"
MONO_WIDTH = 0.605  # of the size; the widest of these fonts
SANS_WIDTH = 0.56  # of the size, of words; somewhat more than their mean


def text(words: str, x: float, y: float, size: float = 12.0, mono: bool = True, **attributes: object) -> str:
    """Words that begin at x, or around it with `text_anchor="middle"`, on the line y."""
    family = MONO if mono else SANS
    return element("text", safe(words), x=x, y=y, font_size=size, font_family=family,
                   **{"fill": "currentColor", **attributes})  # fmt: skip


def width(words: str, size: float = 12.0, mono: bool = True) -> float:
    """How wide words are, or a little less; East Asian characters take two places."""
    places = sum(2 if unicodedata.east_asian_width(letter) in "WF" else 1 for letter in words)
    return places * size * (MONO_WIDTH if mono else SANS_WIDTH)


def shortened(words: str, most: int) -> str:
    """At most so many characters; the end of a long name tells more than its middle."""
    if len(words) <= most:
        return words
    head = (most - 1) * 2 // 3
    return f"{words[:head]}…{words[len(words) - (most - 1 - head) :]}"
