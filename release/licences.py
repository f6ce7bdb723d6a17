"""The licences of what is in the FMUs: ours, that of pythonfmu, those of the headers of the standard."""

from __future__ import annotations

import re
from importlib.metadata import files
from pathlib import Path

from rovbrush.components.native.build import HEADERS, STANDARD

from .sources import ROOT


def licences() -> dict[str, bytes]:
    """Texts by file name."""
    found = {"LICENSE": (ROOT / "LICENSE").read_bytes()}
    of_pythonfmu = next(path for path in files("pythonfmu") or () if path.name.upper().startswith("LICEN"))
    found["licences/pythonfmu.txt"] = Path(str(of_pythonfmu.locate())).read_bytes()
    for version, names in STANDARD.items():
        found[f"licences/{version}_headers.txt"] = _first_comment(HEADERS / names[0])
    return found


def _first_comment(header: Path) -> bytes:
    """What a header of the standard says of its licence."""
    texts = re.findall(r"/\*.*?\*/", header.read_text(encoding="utf-8"), re.DOTALL)
    return next(text for text in texts if "Copyright" in text).encode() + b"\n"
