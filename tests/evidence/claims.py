"""The claims of a folder: its modules that define NAME, CLAIM, COUNT and `one`."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

HERE = Path(__file__).parent
OWN = {"__init__", "__main__", "claims", "journal", "runner", "worker"}
LIMIT = 60.0  # s of wall time for a case, where a module does not say LIMIT
SAMPLE = 3  # cases in `make test`, where a module does not say SAMPLE


@dataclass(frozen=True)
class Claim:
    name: str
    claim: str
    count: int  # cases that it takes to be believed
    unit: str
    limit: float  # s
    sample: int
    path: Path
    one: Callable[[int, Path], str]
    prepare: Callable[[Path], None] | None
    finite: bool  # there are no more cases than `count`
    says: bool  # what a case prints is told


def load(path: Path) -> Claim:
    """The claim that a file makes. Its relative imports see this package, wherever it lies."""
    spec = importlib.util.spec_from_file_location(f"{__package__}.{path.stem}", path)
    assert spec is not None and spec.loader is not None
    module: ModuleType = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return Claim(
        module.NAME,
        module.CLAIM,
        module.COUNT,
        getattr(module, "UNIT", "cases"),
        getattr(module, "LIMIT", LIMIT),
        getattr(module, "SAMPLE", SAMPLE),
        path,
        module.one,
        getattr(module, "prepare", None),
        getattr(module, "FINITE", False),
        getattr(module, "SAYS", False),
    )


def found(folder: Path = HERE) -> list[Claim]:
    """All claims of a folder, by file name."""
    files = (path for path in sorted(folder.glob("*.py")) if path.stem not in OWN and not path.stem.startswith("test_"))
    claims = [load(path) for path in files if "\nNAME = " in path.read_text(encoding="utf-8")]
    names = [claim.name for claim in claims]
    assert len(names) == len(set(names)), f"two claims of one name: {names}"
    return claims
