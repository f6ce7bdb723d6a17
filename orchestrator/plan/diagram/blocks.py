"""What a block diagram shows of a plan: a block for each component, a flow for each pair that is connected."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from ...clock import seconds_text
from ...fmu.kinds import MODEL_EXCHANGE
from ..plan import Plan

ELEMENT = re.compile(r"(.*)\[(\d+(?:,\d+)*)\]")


@dataclass(frozen=True)
class Block:
    """A component: how often it exchanges values, and what its FMU is."""

    name: str
    rate: str  # "every 5 ms"
    period: Fraction  # s
    about: str


@dataclass(frozen=True)
class Flow:
    """All that goes from one component to another: the names of its outputs by the transfer that they take."""

    source: int  # positions among the blocks
    target: int
    signals: tuple[tuple[str, tuple[str, ...]], ...]
    about: str
    bond: bool  # does a power bond cross here?


def blocks_of(plan: Plan) -> list[Block]:
    """The components in the order in which they step."""
    found = []
    for name in plan.order:
        component = plan.system.components[name]
        fmu, every = component.fmu, f"every {seconds_text(component.period)}"
        kind = fmu.kind
        if component.scheduled:
            every = "at its clocks"
        elif kind == MODEL_EXCHANGE:
            every = f"solved, {every}"
        elif plan.adaptive:
            every = f"from {seconds_text(component.period)} on"
        where = f"at {component.isolation}" if component.elsewhere else "in a process of its own"
        apart = f"; {where}" if component.isolation else ""
        about = f"{name}: {fmu.path.name}, {fmu.standard}, {every}{apart}"
        found.append(Block(name, every, component.period, about))
    return found


def flows_of(plan: Plan) -> list[Flow]:
    """The connections, by pairs of components; between clocks too, whose transfer is `tick`."""
    place = {name: k for k, name in enumerate(plan.order)}
    pairs: dict[tuple[int, int], dict[str, list[str]]] = {}
    labels: dict[tuple[int, int], list[str]] = {}
    every = [(c, choice.transfer, choice.reason) for c, choice in plan.choices.items()]
    every += [(c, "tick", "clocks") for c in plan.system.clock_connections]
    for c, transfer, reason in every:
        pair = place[c.source[0]], place[c.target[0]]
        pairs.setdefault(pair, {}).setdefault(transfer, []).append(c.source[1])
        labels.setdefault(pair, []).append(f"{c.label}: {transfer} ({reason})")
    bonds = {
        (place[end.partition(".")[0]], place[to.partition(".")[0]])
        for bond in plan.system.bonds
        for end, to in (bond.effort, bond.flow)
        if to
    }
    return [
        Flow(
            *pair,
            tuple((transfer, tuple(merged(names))) for transfer, names in by_transfer.items()),
            "\n".join(labels[pair]),
            pair in bonds,
        )
        for pair, by_transfer in sorted(pairs.items())
    ]


def merged(names: Sequence[str]) -> list[str]:
    """Each name once, the elements of an array as one: `u[1..8]`."""
    elements: dict[str, list[str]] = {}
    for name in names:
        found = ELEMENT.fullmatch(name)
        elements.setdefault(found[1] if found else name, []).append(found[2] if found else "")
    return [f"{name}{_range(indices)}" for name, indices in elements.items()]


def _range(indices: Iterable[str]) -> str:
    known = list(dict.fromkeys(index for index in indices if index))
    if not known:
        return ""
    return f"[{known[0]}]" if len(known) == 1 else f"[{known[0]}..{known[-1]}]"
