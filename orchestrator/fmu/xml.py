"""Reading XML from strangers: nothing else is opened, nothing is expanded, and nothing huge is read."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

from ..errors import FmuError

LARGEST = 64 << 20  # bytes


def safe_xml(path: Path, xml: Path) -> Any:
    """The root of an XML file in the archive `path`. Raises FmuError.

    One that is huge, or declares a document type (entities, other files), is refused.
    """
    from lxml import etree

    name = xml.name
    if xml.stat().st_size > LARGEST:
        raise FmuError(f"FMU {path}: its {name} has more than {LARGEST >> 20} MB; refused")
    parser = etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False)
    try:
        tree = etree.parse(io.BytesIO(xml.read_bytes()), parser)
    except (etree.XMLSyntaxError, OSError) as error:  # OSError: bytes that are none of its encoding
        raise FmuError(f"FMU {path}: its {name} is not well-formed: {error}") from error
    if tree.docinfo.doctype:
        raise FmuError(f"FMU {path}: its {name} has a document type declaration; refused")
    return tree.getroot()
