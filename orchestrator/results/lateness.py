"""How late the deadlines of a run were kept, as data and in words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

ELSEWHERE = "between the steps"  # observers, a program that steps by hand, others on the machine


@dataclass(frozen=True)
class Lateness:
    """Of a run, or of a part of it. A deadline is missed where the steps before it were not done in time."""

    factor: float  # simulated seconds in a second
    deadlines: int
    missed: int
    mean: float  # s, of all deadlines: how much later than its deadline an instant was reached
    worst: float  # s
    worst_at: float  # s of the simulation
    worst_by: str  # who needed the most time before it; empty where the machine woke up late
    histogram: Mapping[float, int] = field(default_factory=dict)  # deadlines by the lateness [s] that they are below
    missed_by: Mapping[str, int] = field(default_factory=dict)  # deadlines by who needed the most time before them

    def within(self, limit: float) -> float:
        """The share of deadlines that were kept within a bound of the histogram [s]."""
        kept = sum(count for bound, count in self.histogram.items() if bound <= limit * (1.0 + 1e-9))
        return kept / self.deadlines if self.deadlines else 1.0

    def content(self) -> dict[str, Any]:
        """Ready for JSON; bounds of the histogram in seconds as texts."""
        found = asdict(self)
        found["histogram"] = {f"{bound:g}": count for bound, count in self.histogram.items() if count}
        return found

    def words(self) -> list[str]:
        """What a run tells of it in the end."""
        if not self.deadlines:
            return [f"real time x {self.factor:g}: no deadline was reached"]
        share = f"{100.0 * self.within(0.002):.4g} %"
        lines = [
            f"real time x {self.factor:g}: {self.deadlines} deadlines, {share} kept within 2 ms; mean lateness "
            f"{_short(self.mean)}, worst {_short(self.worst)} at t = {self.worst_at:.9g} s"
            + (f" ({self.worst_by})" if self.worst_by else "")
        ]
        shown = [f"< {_short(bound)}: {count}" for bound, count in self.histogram.items() if count]
        lines.append(f"lateness: {', '.join(shown)}")
        if self.missed:
            causes = sorted(self.missed_by.items(), key=lambda item: -item[1])
            who = ", ".join(f"{name} {count}" for name, count in causes if count)
            lines.append(f"warning: {self.missed} of them were missed; the most time before them was needed by: {who}")
        return lines


def _short(seconds: float) -> str:
    """A duration as people read it."""
    if seconds == float("inf"):
        return "any"
    for scale, unit in ((1.0, "s"), (1e3, "ms")):
        if seconds * scale >= 1.0:
            return f"{seconds * scale:.3g} {unit}"
    return f"{seconds * 1e6:.3g} us"
