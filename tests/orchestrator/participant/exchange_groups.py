"""Groups of FMUs for Model Exchange, initialized and begun, for tests of the solver by itself."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import exchange_build
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.fmu.kinds import MODEL_EXCHANGE
from rovbrush.orchestrator.integration.settings import SolverSettings
from rovbrush.orchestrator.participant.model_exchange.group import Group
from rovbrush.orchestrator.participant.model_exchange.instance import Fmi2Member, Fmi3Member
from rovbrush.orchestrator.participant.model_exchange.links import LinkBlock

FIRST, SECOND = 0, 1


def exchanged(path: Path) -> Fmu:
    """An FMU taken for Model Exchange."""
    return Fmu.open(path).of_kind(MODEL_EXCHANGE)


@contextmanager
def group_of(
    folder: Path, *names: str, values: Sequence[Mapping[str, Any]] = (), blocks: Sequence[LinkBlock] = (),
    version: int = 2, initial: Callable[[Sequence[Any]], None] | None = None, paths: Sequence[Path] = (),
    **settings: Any,
) -> Iterator[Group]:  # fmt: skip
    """A group of the models by name, with values that are set before initialization, at time 0."""
    folder = folder / f"fmi{version}"
    folder.mkdir(exist_ok=True)
    found = paths or [exchange_build.exchange(folder, name, version, both=True) for name in names]
    kind = Fmi2Member if version == 2 else Fmi3Member
    members = [kind(exchanged(path), path.stem) for path in found]
    group = Group(members, blocks, SolverSettings(**settings))
    try:
        for k, member in enumerate(members):
            member.join(group)
            member.set_up(100.0)
            member.set_all(values[k] if k < len(values) else {})
            member.enter_initialization()
        if initial:
            initial(members)
        for member in members:
            member.exit_initialization()
        members[0].first_event()
        yield group
    finally:
        for member in members:
            assert member.close() == ""


def run(group: Group, stop: float, step: float = 0.01, watch: Callable[[float], None] | None = None) -> None:
    """To a time, in steps of communication; each must succeed."""
    for k in range(round(stop / step)):
        ended = group.step(k * step, (k + 1) * step - k * step)
        assert not group.failed, group.why()
        assert not ended
        if watch:
            watch((k + 1) * step)


def times(group: Group, member: str | None = None, indicator: int | None = None) -> list[float]:
    """When events were, of a member and an indicator."""
    return [e.time for e in group.events() if member in (None, e.member) and indicator in (None, e.indicator)]
