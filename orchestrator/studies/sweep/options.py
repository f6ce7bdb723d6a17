"""What is asked of a study over parameters, beside what its file says."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from ...system.request import UNCHANGED, Changes


@dataclass(frozen=True)
class Options:
    """What the command line adds to, or says in place of, a sweep file."""

    vary: Sequence[str] = ()
    values: Mapping[str, object] = field(default_factory=dict)
    stop: str = ""
    random: int = 0
    seed: int | None = None
    points: Path | None = None
    workers: int = 0  # 0: one per core
    scheduler: str = ""
    fmus: Path | None = None
    changes: Changes = UNCHANGED
    design: str = ""  # of --random: see `design.SAMPLERS`
    force: bool = False  # go on although another version or processor computed what is there
    start: str = ""
    figures: Mapping[str, str] = field(default_factory=dict)  # of merit, beside those of the file
    blocks: str = ""  # how blocks of points are drawn, `random` of them: see `blocks.BLOCKS`
