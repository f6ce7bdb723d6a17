"""What a person should know of the transfers of a plan: what it chose by itself, what was another, what aliases."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from fractions import Fraction

from ..clock import seconds_text
from ..errors import counted
from ..system.file.connections.link import ROUND
from ..system.formats import is_ssp
from ..system.one_fmu import stated_step
from .order import discrete
from .plan import Plan

ROUNDING = Fraction(1, 10**6)  # relative: by so much a period may be longer than a step that is stated in decimals
WORDS = {"mean": "mean", "hold": "held value"}


def chosen(plan: Plan) -> str:
    """How many transfers between rates the plan chose by itself; empty for none."""
    periods = plan.clock.periods
    found = Counter(
        WORDS[choice.transfer]
        for c, choice in plan.choices.items()
        if not c.transfer and periods[c.source[0]] != periods[c.target[0]] and choice.transfer in WORDS
    )
    counts = ", ".join(counted(found[words], words) for words in WORDS.values() if found[words])
    return f"between rates the plan chose {counts}" if counts else ""


def held_now(plan: Plan) -> list[str]:
    """Of a file without `format = 2`: the connections that are held and were not before, with the former word."""
    if plan.system.format > 1:
        return []
    lines: dict[str, None] = {}
    for c, choice in plan.choices.items():
        if choice.former:
            ends = " -> ".join(re.sub(r"\[[\d,]+\]$", "", end) for end in c.label.split(" -> "))  # arrays as a whole
            words = f"{choice.former}, {ROUND}" if c.rounded else choice.former
            mend = f'"{ends} ({words})" gives the former result'
            if is_ssp(plan.system.path):
                mend = f'its annotation {{"transfer": "{choice.former}"}} gives the former result'
            lines[f'"{ends}": held since transfers other than means must be stated; {mend}'] = None
    return list(lines)


def aliased(plan: Plan) -> list[str]:
    """Warnings of signals that change faster than they are taken, by what is stated: no signal is looked at.

    A held value of a faster source, into an input that does not sample by nature, is one of many. And a component that
    steps more rarely than its own FMU states passes its outputs on as rarely to one that steps more often.
    """
    return list(dict.fromkeys([*_one_of_many(plan), *_too_rare(plan)]))


def _one_of_many(plan: Plan) -> Iterator[str]:
    periods, seconds = plan.clock.periods, plan.clock.seconds
    for c, choice in plan.choices.items():
        h, long = periods[c.source[0]], periods[c.target[0]]
        sampled = {c.source[0], c.target[0]} & set(plan.samplers) or discrete(plan.system, c.target)
        if h < long and choice.transfer == "hold" and plan.system.is_real(c) and not sampled:
            mend = "" if c.target[0] in plan.leaders else "; (mean) averages it"
            yield (
                f"warning: {c.label} takes one of {long / h:g} values, every {seconds_text(seconds(long))}: what "
                f"changes within {seconds_text(seconds(2 * long))} is aliased{mend}"
            )


def _too_rare(plan: Plan) -> Iterator[str]:
    system = plan.system
    for name, component in system.components.items():
        own = stated_step(component.fmu)
        if own is None or component.period <= own * (1 + ROUNDING):
            continue
        takers = {
            c.target[0]: None
            for c in system.connections
            if c.source[0] == name and system.components[c.target[0]].period < component.period
            if system.is_real(c) and not discrete(system, c.source)
        }
        if takers:
            verb = "steps" if len(takers) == 1 else "step"
            yield (
                f"warning: {name} steps every {seconds_text(component.period)}, its FMU states {seconds_text(own)}: "
                f"what its outputs do within {seconds_text(2 * component.period)} is aliased in {', '.join(takers)}, "
                f"which {verb} more often; shorten the period of {name}"
            )
