"""How long answers took, as counts of doublings of a microsecond."""

from __future__ import annotations

BINS = 40  # 2^39 us are six days


class Waits:
    """Wall times [s] between a question and its answer."""

    def __init__(self) -> None:
        self.counts = [0] * BINS  # k: from 2^(k-1) up to 2^k us
        self.worst = 0.0

    def add(self, seconds: float) -> None:
        """Count a wait."""
        self.counts[min(int(seconds * 1e6).bit_length(), BINS - 1)] += 1
        self.worst = max(self.worst, seconds)

    def below(self, share: float) -> float:
        """The shortest doubling of 1 us [s] that a share of the waits stayed below, at most the worst of them."""
        wanted, reached = share * sum(self.counts), 0
        for k, count in enumerate(self.counts):
            reached += count
            if reached >= wanted:
                return min(2.0**k * 1e-6, self.worst)
        return self.worst

    def text(self) -> str:
        """`half below 64 us, 99 % below 256 us, worst 1.3 ms`."""
        return f"half below {_time(self.below(0.5))}, 99 % below {_time(self.below(0.99))}, worst {_time(self.worst)}"


def _time(seconds: float) -> str:
    for limit, scale, unit in ((1e-3, 1e6, "us"), (1.0, 1e3, "ms")):
        if seconds < limit:
            return f"{seconds * scale:.3g} {unit}"
    return f"{seconds:.3g} s"
