"""Binary values as text, where a file or a command line has nothing else for them.

Plain text is hexadecimal, as FMI itself writes start values: "00ff". "base64:AP8=" is what it says, and "file:PATH" the
content of a file.
"""

from __future__ import annotations

import base64
import binascii
from pathlib import Path

from ..errors import InputError, shown

BASE64, FILE = "base64:", "file:"
LARGEST = 64 << 20  # bytes of a file
SHOWN = 16  # bytes of a value, in messages


def bytes_of(value: object, label: str) -> bytes:
    """A value as bytes, of any of the three ways in which it is written. Raises InputError."""
    if isinstance(value, (bytes, bytearray, memoryview)):
        return bytes(value)
    text = str(value).strip()
    if text.startswith(FILE):
        return _content(Path(text.removeprefix(FILE)), label)
    try:
        if text.startswith(BASE64):
            return base64.b64decode(text.removeprefix(BASE64), validate=True)
        return bytes.fromhex(text)
    except (ValueError, binascii.Error):
        raise InputError(
            f"{label} = {shown(text)!r} is no binary value: write it in hexadecimal (00ff), as base64:AP8=, or as "
            f"file:PATH"
        ) from None


def _content(path: Path, label: str) -> bytes:
    try:
        if path.stat().st_size > LARGEST:
            raise InputError(f"{label}: {path} has more than {LARGEST >> 20} MB")
        return path.read_bytes()
    except (OSError, ValueError) as error:
        raise InputError(f"{label}: {path} cannot be read: {getattr(error, 'strerror', None) or error}") from None


def as_text(value: object) -> str:
    """A value for a person to read: long ones of bytes by their beginning and their number."""
    if not isinstance(value, bytes):
        return str(value)
    return value.hex() if len(value) <= SHOWN else f"{value[:SHOWN].hex()}... ({len(value)} bytes)"


def beside(value: object, folder: Path) -> object:
    """A value as a file in `folder` states it: the path behind `file:` is relative to that."""
    if isinstance(value, list):
        return [beside(one, folder) for one in value]
    if isinstance(value, str) and value.strip().startswith(FILE):
        return f"{FILE}{folder / value.strip().removeprefix(FILE)}"
    return value
