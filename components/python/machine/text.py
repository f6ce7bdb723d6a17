"""LLVM's text as it grows, instruction by instruction."""

from __future__ import annotations


class Text:
    """The text of one function so far."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.block = "entry"
        self.count = 0

    def new(self, what: str) -> str:
        """A value that an instruction makes."""
        self.count += 1
        self.lines.append(f"  %t{self.count} = {what}")
        return f"%t{self.count}"

    def do(self, what: str) -> None:
        self.lines.append(f"  {what}")

    def label(self) -> str:
        self.count += 1
        return f"b{self.count}"

    def begin(self, block: str) -> None:
        self.lines.append(f"{block}:")
        self.block = block


def result_type(kinds: tuple[str, ...]) -> str:
    """What LLVM calls what a function returns."""
    if not kinds:
        return "void"
    return kinds[0] if len(kinds) == 1 else f"{{ {', '.join(kinds)} }}"
