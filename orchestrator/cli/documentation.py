"""Where the documentation is: in the package, in the checkout, or on the web; and how it is opened."""

from __future__ import annotations

import os
import sys
from importlib.metadata import PackageNotFoundError, metadata
from pathlib import Path

from ..errors import InputError

PACKAGE = Path(__file__).parents[2]  # rovbrush/ where it is installed, the checkout where it is developed
BUILT = ("docs/index.html", "build/docs/index.html")  # in the package; where `make docs` puts it
URLS = ("documentation", "homepage", "repository", "source")  # of the package's metadata, the best first


def documentation() -> str:
    """The site that is built, as a file, else an address. Raises InputError where there is neither."""
    for place in BUILT:
        if os.path.isfile(PACKAGE / place):
            return str(PACKAGE / place)
    known = _urls()
    for label in URLS:
        if label in known:
            return known[label]
    raise InputError(
        "no documentation is installed, and the package names no address; `make docs` in the checkout builds it. "
        "`rovbrush --help`, and `rovbrush schema --reference` for all keys, need none"
    )


def _urls() -> dict[str, str]:
    """The addresses in the package's metadata, by label."""
    try:
        entries = metadata("rovbrush").get_all("Project-URL") or []
    except PackageNotFoundError:
        entries = []
    pairs = (entry.partition(",")[::2] for entry in entries)
    return {label.strip().lower(): url.strip() for label, url in pairs}


def open_page(place: str) -> bool:
    """Open it in a browser with windows; False where there is none, never an error."""
    import webbrowser

    if sys.platform.startswith("linux") and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        return False  # a browser in the terminal would take it over
    try:
        return webbrowser.open(place if "://" in place else Path(place).as_uri())
    except (webbrowser.Error, OSError, ValueError):
        return False
