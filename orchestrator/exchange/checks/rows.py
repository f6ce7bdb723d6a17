"""One row per check of an FMU: the verdict, what was found and how to mend it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from ...errors import counted, listed

Verdict = Literal["pass", "finding", "error", "not applicable", "skipped"]


@dataclass(frozen=True)
class Row:
    """One check. `error`: no run can do with it; `finding`: it breaks the standard, or a partner will stumble over it.

    `not applicable`: the FMU says that it cannot, or has nothing to check; `skipped`: a tool is missing. Only errors
    and findings count.
    """

    stage: str
    rule: str
    verdict: Verdict
    found: str
    mend: str = ""


@dataclass(frozen=True)
class Report:
    """All rows of one FMU."""

    path: Path
    kind: str  # for instance "FMI 2.0, dc_motor"; empty where the FMU cannot be read
    rows: list[Row] = field(default_factory=list)

    def count(self, *verdicts: Verdict) -> int:
        """How many rows have one of the verdicts."""
        return sum(row.verdict in verdicts for row in self.rows)

    @property
    def clean(self) -> bool:
        """Neither an error nor a finding."""
        return self.count("error", "finding") == 0

    @property
    def text(self) -> str:
        """How many checks passed, and what did not."""
        parts = [f"{self.count('pass')} passed", counted(self.count("error"), "error")]
        parts.append(counted(self.count("finding"), "finding"))
        others: tuple[Verdict, ...] = ("not applicable", "skipped")
        return ", ".join([*parts, *(f"{self.count(kind)} {kind}" for kind in others if self.count(kind))])


def judged(stage: str, rule: str, bad: Sequence[str], good: str, found: str, mend: str, verdict: Verdict) -> Row:
    """A row that passes with `good` if nothing is `bad`; otherwise `found` is put before the bad ones."""
    if not bad:
        return Row(stage, rule, "pass", good)
    return Row(stage, rule, verdict, f"{found}: {listed(bad)}" if found else listed(bad), mend)
