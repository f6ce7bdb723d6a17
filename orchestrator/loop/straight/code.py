"""The machine code of a text: from this process, from the cache, or compiled now."""

from __future__ import annotations

from ..machine.objects import Loaded, keep, kept, name_of, object_of
from .functions import NAME, ONE, SEGMENT

_loaded: dict[str, Code] = {}


class Code(Loaded):
    """What a text has become."""

    @property
    def function(self) -> int:
        """The address of what does cycles."""
        return self.address(NAME)

    @property
    def one(self) -> int:
        """The address of what does one, with its numbers in memory."""
        return self.address(ONE)

    def segment(self, number: int) -> int:
        """The address of what does a segment."""
        return self.address(SEGMENT.format(number))


def straight_code(text: str, compiles: bool = True) -> Code | None:
    """None where it would have to be compiled, and is not to be; nor where LLVM does not take it."""
    name = name_of("straight", text)
    if name not in _loaded:
        try:
            content = kept(name)
            if content is None:
                if not compiles:
                    return None
                content = object_of(text)
                keep(name, content)
            _loaded[name] = Code(content)
        except RuntimeError:
            return None
    return _loaded[name]
