"""Many environments of one system, in processes, by what Gymnasium has for that."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

from gymnasium.vector import AsyncVectorEnv, SyncVectorEnv

from ..api import Model
from ..errors import InputError
from .environment import Environment, Reward
from .signals import Named


def make_vec(
    system: str | Path | Model,
    count: int,
    actions: Named,
    observations: Named,
    reward: Reward,
    *,
    processes: bool = True,
    **keywords: Any,
) -> AsyncVectorEnv | SyncVectorEnv:
    """`count` environments as one of Gymnasium's vector environments: each in a process of its own, or with
    `processes=False` one after the other in this one, which is quicker where a step takes a few microseconds.

    The other arguments are those of `Environment`; each environment gives the bits that it gives alone. Raises
    InputError for what is wrong in them, before a process is started.
    """
    if isinstance(count, bool) or not isinstance(count, int) or count < 1:
        raise InputError(f"make_vec: {count!r} environments; it takes a whole number of at least 1")
    make = [partial(Environment, system, actions, observations, reward, **keywords)] * count
    return AsyncVectorEnv(make) if processes else SyncVectorEnv(make)
