"""A connection as a file states it."""

from __future__ import annotations

from dataclasses import dataclass

ROUND = "round"  # what a connection says where its values may lose what the input's type does not hold


@dataclass(frozen=True)
class Link:
    """A connection as a file states it. `factor` and `offset`, where given, are all that happens to the value."""

    source: str
    output: str
    target: str
    input_: str
    transfer: str = ""
    factor: float | None = None
    offset: float = 0.0
    where: str = ""
    rounded: bool = False
    sign: float = 1.0  # -1: of flows that both ends count inwards, or both outwards
    counter: str = ""  # of `mean of a.counter`, with its component

    def __str__(self) -> str:
        return f"{self.source}.{self.output} -> {self.target}.{self.input_}"
