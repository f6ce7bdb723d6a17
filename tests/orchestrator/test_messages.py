"""What FMUs log goes to the instance that said it, however many there are and whichever ends first."""

from __future__ import annotations

import gc
from pathlib import Path

from native_build import FAULTS2, feedthrough2, needs_gcc
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.here.loaded import LoadedInstance
from rovbrush.orchestrator.participant.opening import load


def warning(path: Path, name: str) -> LoadedInstance:
    """An instance that warns at every step."""
    instance = load(Fmu.open(path), name)
    instance.set_all({"fault": FAULTS2["warning"], "bad_at": 0.0})
    instance.begin(1.0)
    instance.exit_initialization()
    return instance


@needs_gcc
def test_messages_belong_to_their_instances_whichever_was_made_last(tmp_path: Path) -> None:
    path = feedthrough2(tmp_path / "feedthrough2.fmu")
    first, last = warning(path, "first"), warning(path, "last")
    first.step(0.0, 0.25)
    assert len(first.messages) == 1 and not last.messages
    last.close()
    del last
    gc.collect()
    first.step(0.25, 0.25)
    assert [message.split(" at ")[0] for message in first.messages] == [f"fault {FAULTS2['warning']}"] * 2
    first.close()
