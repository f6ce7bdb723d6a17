"""An isolated FMU for Model Exchange, on its own side: inputs that the loop sets, at which its solver begins anew."""

from __future__ import annotations

import ctypes

from ..here.loaded import LoadedInstance
from .functions import Function
from .memory import Shared


class Inputs:
    """What was set last, by function and references."""

    def __init__(self, shared: Shared) -> None:
        self.shared = shared
        self.last: dict[tuple[str, bytes], bytes] = {}

    def look(self, instance: LoadedInstance, function: Function, references: int, values: int) -> None:
        """Before a set: tell the group of an FMU for Model Exchange if anything is new."""
        from ..model_exchange.instance import Member

        if not isinstance(instance, Member) or instance.group is None:
            return
        key = function.name, ctypes.string_at(self.shared.references, 4 * references)
        content = ctypes.string_at(self.shared.values, function.size * values)
        if self.last.get(key) != content:
            self.last[key] = content
            instance.group.changed()
