"""What every FMU file is made of, whatever is inside: documentation, fixed dates and order, the content's hash."""

from __future__ import annotations

import hashlib
import os
import zipfile
from pathlib import Path
from xml.sax.saxutils import escape

from ...declare.model_description import GUID_PLACEHOLDER

FIXED_DATE = (1980, 1, 1, 0, 0, 0)


def digest(files: dict[str, bytes]) -> str:
    """SHA-256 over names and contents, independent of order."""
    total = hashlib.sha256()
    for key in sorted(files):
        total.update(f"{key}\0{len(files[key])}\0".encode() + files[key])
    return total.hexdigest()


def documentation(component: Path) -> bytes:
    """The component's README as the FMU's documentation/index.html (FMI 2.0.4, section 2.3)."""
    from markdown_it import MarkdownIt

    text = (component / "README.md").read_text(encoding="utf-8")
    body = MarkdownIt("commonmark").enable("table").render(text)
    head = f"<head><meta charset='utf-8'><title>{escape(component.name)}</title></head>"
    return f"<!DOCTYPE html>\n<html lang='en'>{head}<body>\n{body}</body></html>\n".encode()


def repack(raw: Path, target: Path) -> Path:
    """Write `raw` again with sorted entries, fixed dates and a GUID that is the hash of the content."""
    with zipfile.ZipFile(raw) as archive:
        entries = {name: archive.read(name) for name in archive.namelist()}
    guid = f"{{{digest(entries)}}}"
    entries["modelDescription.xml"] = entries["modelDescription.xml"].replace(GUID_PLACEHOLDER.encode(), guid.encode())
    return write_archive(entries, target)


def write_archive(entries: dict[str, bytes], target: Path) -> Path:
    """A zip file with sorted entries and fixed dates; it appears under its name only when it is complete."""
    temporary = target.with_name(f"{target.name}.{os.getpid()}.tmp")
    with zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name in sorted(entries):
            info = zipfile.ZipInfo(name, FIXED_DATE)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            archive.writestr(info, entries[name], compresslevel=9)
    temporary.replace(target)
    return target
