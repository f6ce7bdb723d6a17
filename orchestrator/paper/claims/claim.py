"""What a claim is: text, checks against what the paper says, and the verdict that follows from the checks alone."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

from ..lab import Lab
from ..specification import read_specification

REPRODUCED = "reproduced"
BY_CALIBRATION = "reproduced by calibration"
NOT_REPRODUCIBLE = "not reproducible"
PRINTED = "as the paper says"
BOUNDS = ("at most", "at least")  # rules whose number is a bound
VERDICTS = (REPRODUCED, BY_CALIBRATION, NOT_REPRODUCIBLE)


@dataclass(frozen=True)
class Check:
    """One number of the paper beside the computed one, the rule that compares them, its reason, and whether it holds.

    `target` names the calibration target that the number is, if it is one.
    """

    quantity: str
    paper: float
    computed: float
    unit: str
    rule: str
    holds: bool
    reason: str  # why this bound
    target: str = ""


@dataclass(frozen=True)
class Finding:
    """What a claim's function returns: its checks, why it fails if it does (one line), and what else was seen."""

    checks: tuple[Check, ...]
    arithmetic: str = ""
    note: str = ""

    @property
    def verdict(self) -> str:
        """All checks must hold; a claim that rests on a fitted number is reproduced by calibration only."""
        if not all(check.holds for check in self.checks):
            return NOT_REPRODUCIBLE
        return BY_CALIBRATION if any(c.target in calibration_targets() for c in self.checks) else REPRODUCED


@dataclass(frozen=True)
class Claim:
    """One of the paper's claims and the function that answers it."""

    number: int
    text: str
    place: str  # in the paper
    answer: Callable[[Lab], Finding]


CLAIMS: dict[int, Claim] = {}


def claim(number: int, text: str, place: str) -> Callable[[Callable[[Lab], Finding]], Callable[[Lab], Finding]]:
    """Register a function as the answer to a claim."""

    def register(answer: Callable[[Lab], Finding]) -> Callable[[Lab], Finding]:
        CLAIMS[number] = Claim(number, text, place, answer)
        return answer

    return register


@cache
def calibration_targets() -> frozenset[str]:
    """The figures of merit that `rovbrush calibrate` fits."""
    return frozenset(read_specification().targets)


def near(
    quantity: str, paper: float, computed: float, unit: str, relative: float, reason: str, target: str = ""
) -> Check:
    """Equal to the paper's number within a share of it."""
    holds = math.isfinite(computed) and abs(computed - paper) <= relative * abs(paper)
    return Check(quantity, paper, computed, unit, f"within {100 * relative:g} %", holds, reason, target)


def within(quantity: str, paper: float, computed: float, unit: str, distance: float, reason: str) -> Check:
    """Equal to the paper's number within a distance."""
    rule = f"within {distance:g}" + ("" if unit == "1" else f" {unit}") if distance else "equal"
    return Check(quantity, paper, computed, unit, rule, abs(computed - paper) <= distance, reason)


def at_most(quantity: str, limit: float, computed: float, unit: str, reason: str = PRINTED) -> Check:
    """Not above a bound, the paper's unless another reason is given."""
    return Check(quantity, limit, computed, unit, "at most", computed <= limit, reason)


def at_least(quantity: str, limit: float, computed: float, unit: str, reason: str = PRINTED) -> Check:
    """Not below a bound, the paper's unless another reason is given."""
    return Check(quantity, limit, computed, unit, "at least", computed >= limit, reason)
