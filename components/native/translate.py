"""A kernel as plain C: translated by Pyccel, then freed of its array library so that it stands alone and reads easily.

Pyccel writes arrays as spans of a general container library. A kernel's arrays are whole and in row order, so here
they are `double *` and `Matrix` (`sources/component.h`), and every function is `static`: the C library has functions
called `step` and `advance` of its own.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from collections.abc import Set
from pathlib import Path
from types import ModuleType

from ..errors import BuildError
from ..lowering.cells import NamedCells
from ..lowering.functions import functions_of
from ..lowering.lower import lower
from ..lowering.source import parts_of
from .comments import with_comments
from .places import constants, enumerations, unaliased

PYCCEL = "from pyccel.commands.console import pyccel; import sys; sys.exit(pyccel())"


def kernel_in_c(kernel: ModuleType) -> str:
    """The C text of a kernel's functions. Raises BuildError where Pyccel is missing or refuses the kernel."""
    cells = NamedCells()
    parts, records = parts_of(kernel)
    source = lower(parts, records, cells)
    text, origin = with_comments(source)
    text, origin = f"{constants(cells.records.values())}\n{text}", [1, *origin]
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        (work / "kernel.py").write_text(text, encoding="utf-8")
        command = [sys.executable, "-c", PYCCEL, "--language", "c", "--convert-only", "--output", folder, "kernel.py"]
        run = subprocess.run(command, cwd=work, capture_output=True, text=True, check=False)
        if "No module named 'pyccel'" in run.stderr:
            raise BuildError('native FMUs need Pyccel; install it with `pip install "rovbrush[native]"`')
        made = next(work.glob("__pyccel__*/kernel.c"), None)  # pytest-xdist gives the folder another name
        if run.returncode or made is None:
            said = re.sub(
                r"kernel\.py \[(\d+)(?:,\d+)?\]",
                lambda found: ":".join(map(str, source.place(origin[int(found[1]) - 1]))),
                run.stdout + run.stderr,
            )
            raise BuildError(f"Pyccel cannot translate {kernel.__name__} (exit code {run.returncode}):\n{said}")
        places = enumerations(cells.records.values())
        plain = plain_c(made.read_text(encoding="utf-8"), set(re.findall(r"\w+", places)))
        return f"{places}\n{unaliased(plain, functions_of(parts, records))}"


def plain_c(text: str, enumerated: Set[str] = frozenset()) -> str:
    """Pyccel's C with plain arrays, static functions and no frames around comments.

    `enumerated`: names of constants that stand elsewhere.
    """
    text = re.sub(r'#include "\w+\.h"\n|^/\*[._]+\*/\n', "", text, flags=re.MULTILINE)
    text = _with_constants(text, enumerated)
    text = re.sub(r"/\*[ \t]*(.*?)[ \t]*\*/", r"/* \1 */", text)
    while "cspan_at(&" in text:
        text = _element(text, text.index("cspan_at(&"))
    text = re.sub(r"array_double_1d (\w+)", r"double *\1", text).replace("array_double_2d", "Matrix")
    text = re.sub(r"INT64_C\((\d+)\)", r"\1", text)
    text = re.sub(r"\b(double|int64_t)_(min|max)\(2, ", r"\2_\1(", text)
    left = re.search(r"cspan\w*|array_\w+|_(min|max)\(\d|INT64_C", text)
    if left:
        raise BuildError(f"the translated kernel uses '{left[0]}', which has no plain form in C yet")
    text = re.sub(r"^(?=(double|int64_t|bool|void) \w+\([^;]*\)\n\{)", "static ", text, flags=re.MULTILINE)
    return re.sub(r"\n{3,}", "\n\n", text).strip() + "\n"


def _with_constants(text: str, elsewhere: Set[str]) -> str:
    """Constants of a kernel's files, which Pyccel's initialization of the module sets: here as constants of C."""
    init = re.search(r"^void \w+__init\(void\)\n\{.*?^\}\n", text, flags=re.M | re.S)
    set_there = dict(re.findall(r"^\s+(\w+) = ([^;\n]+);$", init[0], flags=re.M)) if init else {}
    text = text.replace(init[0], "") if init else text

    def constant(found: re.Match[str]) -> str:
        kind, name = found[1], found[2]
        if name in elsewhere or name not in set_there or "initialised" in name:
            return ""
        return f"static const {kind} {name} = {set_there[name]};\n"

    return re.sub(r"^(int64_t|bool|double) (\w+)(?: = 0)?;\n", constant, text, flags=re.M)


def _element(text: str, start: int) -> str:
    """Rewrite the array access at `start`: `(*cspan_at(&K, r, s))` is `AT(K, r, s)`, `cspan_at(&x, k)` is `&x[k]`."""
    begin = start + len("cspan_at(&")
    depth, at, commas = 1, begin, []
    while depth:
        if text[at] == "," and depth == 1:
            commas.append(at)
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        at += 1
    if not 1 <= len(commas) <= 2:
        raise BuildError(f"the translated kernel has an array access of unknown form: {text[start:at]}")
    inside = text[begin : at - 1]
    one = f"{text[begin : commas[0]]}[{text[commas[0] + 1 : at - 1].strip()}]"
    access = f"AT({inside})" if len(commas) == 2 else one
    if text[start - 2 : start] == "(*" and text[at] == ")":
        return text[: start - 2] + access + text[at + 1 :]
    return text[:start] + "&" + access + text[at:]
