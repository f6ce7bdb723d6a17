"""The loop as text for LLVM, as it lies beside its sources: a checkout that was never run needs no Numba for it.

`loop.ll` is what Numba makes of the loop for any processor of x86-64, optimised; its first line holds the hash of the
sources. Of other sources it is not taken: then Numba compiles. `python -m release.loop --text` writes it anew.
"""

from __future__ import annotations

import re
from pathlib import Path

from . import shipped

FILE = Path(__file__).with_name("loop.ll")
HEAD = "; made by `python -m release.loop --text` of sources "
# Hints of the optimiser that later optimisation would use, and that other versions of LLVM cannot read.
HINTS = (
    r" (?:captures|range|initializes)\((?:[^()]|\([^()]*\))*\)",
    r" nusw\b", r"(?<=getelementptr) nuw", r"(?<=inbounds) nuw", r"(?<=trunc) nuw", r"(?<=trunc) nsw",
    r" (?:samesign|disjoint|nneg)(?= )", r" (?:local_)?unnamed_addr", r"(?m)(?<=\)) #\d+(?=$| \{)", r", ![\w.]+ !\d+",
    r"(?m)^(?:attributes #\d+ =|!\d+ =|!llvm\.|; |source_filename|target ).*\n",
)  # fmt: skip


def text(digest: str) -> str | None:
    """The text of the loop of sources with this hash; None where there is none, or it is not for this system."""
    if shipped.target() != "linux64":
        return None
    try:
        head, _, rest = FILE.read_text(encoding="utf-8").partition("\n")
    except (OSError, UnicodeDecodeError):
        return None
    return rest if head == f"{HEAD}{digest}" else None


def plain(made: str) -> str:
    """What Numba has made without hints, and with short names for long ones, numbered in the order of their places."""
    for hint in HINTS:
        made = re.sub(hint, "", made)
    names: dict[str, str] = {}
    made = re.sub(r'@_ZN[\w.]+|@"_ZN[^"]+"', lambda found: names.setdefault(found[0], f"@f{len(names)}"), made)
    for name in names.values():  # what Numba's errors would refer to, which are never raised
        if len(re.findall(rf"{name}\b", made)) == 1:
            made = re.sub(rf"(?m)^{name} = .*\n", "", made)
    return re.sub(r"\n{2,}", "\n", made)


def write(digest: str, made: str) -> Path:
    """Write the file; its path."""
    FILE.write_text(f"{HEAD}{digest}\n{plain(made)}", encoding="utf-8")
    return FILE
