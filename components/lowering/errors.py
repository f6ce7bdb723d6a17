"""What a kernel may not do, said with file and line."""

from __future__ import annotations

import ast
import difflib
from collections.abc import Iterable
from pathlib import Path
from typing import NoReturn

from ..errors import BuildError


class KernelError(BuildError):
    """A kernel uses what cannot be compiled; the text says what, where, and what to write instead."""


def refuse(path: Path, node: ast.AST, text: str) -> NoReturn:
    """Raise KernelError for a place in a file."""
    raise KernelError(f"{path}:{getattr(node, 'lineno', 1)}: {text}")


def meant(name: str, known: Iterable[str]) -> str:
    """`; did you mean 'k_c'?`, or what there is."""
    known = list(known)
    close = difflib.get_close_matches(name, known, n=1)
    return f"; did you mean '{close[0]}'?" if close else f"; there are {', '.join(known) or 'none'}"
