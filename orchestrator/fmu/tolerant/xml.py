"""Reading XML from strangers: nothing else is opened, nothing is expanded, and nothing huge is read."""

from __future__ import annotations

import codecs
import io
import re
from pathlib import Path
from typing import Any

from ...errors import FmuError
from .rules import BEFORE, ENCODING, PREFIX, Notes

LARGEST = 64 << 20  # bytes
DECLARATION = re.compile(rb"\A(?:\xef\xbb\xbf)?<\?xml[^>]{0,200}?encoding\s*=\s*[\"']([^\"']{1,40})[\"'][^>]{0,200}\?>")
BYTE_ORDER_MARKS = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)


def safe_xml(path: Path, xml: Path, notes: Notes | None = None) -> Any:
    """The root of an XML file in the archive `path`, without comments: see `read_xml`. Raises FmuError."""
    return read_xml(xml, f"FMU {path}: its {xml.name}", notes)


def read_xml(xml: Path, shown: str, notes: Notes | None = None) -> Any:
    """The root of an XML file, without comments; `shown` is what messages call it. Raises FmuError.

    One that is huge, or declares a document type (entities, other files), is refused. With `notes`, what can be read
    beyond doubt is read and noted: prefixes that nothing declares, bytes that are not of the declared encoding.
    """
    from lxml import etree

    name = xml.name
    if xml.stat().st_size > LARGEST:
        raise FmuError(f"{shown} has more than {LARGEST >> 20} MB; export the model with fewer variables")
    content = xml.read_bytes()
    if notes is not None:
        content = _readable(content, name, notes)
    parser = _parser()
    try:
        tree = etree.parse(io.BytesIO(content), parser)
    except (etree.XMLSyntaxError, OSError) as error:  # OSError: bytes that are none of its encoding
        faults = [e for e in parser.error_log if e.type_name != "NS_ERR_UNDEFINED_NAMESPACE"]
        if notes is None or faults or not len(parser.error_log):
            raise FmuError(f"{shown} is not well-formed: {error}; export it again, or correct that line") from error
        for prefix in {e.message.split()[2] for e in parser.error_log}:
            notes.add(PREFIX, f"{prefix}: in {name}")
        tree = etree.parse(io.BytesIO(content), _parser(recover=True))
        _without_prefixes(tree.getroot())
    if tree.docinfo.doctype:
        raise FmuError(f"{shown} has a document type declaration, which can open and expand anything; remove it")
    return tree.getroot()


def _without_prefixes(root: Any) -> None:
    """Make names of those that begin with a prefix that nothing declares."""
    for element in root.iter():
        if element.prefix is None and ":" in element.tag and not element.tag.startswith("{"):
            element.tag = element.tag.replace(":", "_")
        for name in [name for name in element.attrib if ":" in name and not name.startswith("{")]:
            element.set(name.replace(":", "_"), element.attrib.pop(name))


def _parser(recover: bool = False) -> Any:
    from lxml import etree

    return etree.XMLParser(
        resolve_entities=False, no_network=True, load_dtd=False, remove_comments=True, remove_pis=True, recover=recover
    )


def _readable(content: bytes, name: str, notes: Notes) -> bytes:
    """The content from its declaration on, in an encoding in which its bytes have a meaning."""
    if content.startswith(BYTE_ORDER_MARKS):
        return content
    bare = content.removeprefix(codecs.BOM_UTF8).lstrip(b" \t\r\n")
    if bare.startswith(b"<?xml") and bare != content.removeprefix(codecs.BOM_UTF8):
        notes.add(BEFORE, name)
        content = bare
    declared = DECLARATION.match(content)
    encoding = declared[1].decode("latin-1") if declared else "utf-8"
    marked = content.startswith(codecs.BOM_UTF8)
    try:
        content.decode("utf-8" if marked else encoding)
        return content
    except (UnicodeDecodeError, LookupError):
        pass
    notes.add(ENCODING, f"{encoding} in {name}")
    body = content[declared.end() :] if declared else content
    try:
        return body.decode("utf-8").encode()
    except UnicodeDecodeError:
        return body.decode("cp1252", "replace").encode()
