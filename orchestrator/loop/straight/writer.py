"""Lines of LLVM's text in functions of bounded length: pieces, which are called one behind the other.

Time to compile grows faster than the length of a function. All pieces have the same parameters, so that a line means
the same in each; what one has computed the next one does not know.
"""

from __future__ import annotations

# Parameters of a piece: cells, addresses, coefficients, `control`, raw values, texts, the recorder's tables, its buffer
# and its rows; the first instant of the cycle [ticks from time 0], what is added to the length of steps that vary
# [ticks], nanoseconds of a tick as a quotient, the stop [s].
POINTERS = ("z", "t", "c", "control", "raw", "index", "groups", "buffer", "rows")
NUMBERS = ("i64 %base", "i64 %varying", "i64 %numerator", "double %denominator", "double %stop")
PARAMETERS = ", ".join([*(f"ptr %{name}" for name in POINTERS), *NUMBERS])


BYTES = ("i8", "i16", "i32", "float")  # of raw values, which need not be aligned


class Writer:
    """Collects pieces; `known` is what the piece that is written has computed."""

    def __init__(self) -> None:
        self.pieces: list[list[str]] = []
        self.known: dict[object, str] = {}
        self._lines: list[str] = []
        self._count = 0

    def begin_piece(self) -> None:
        """What comes now is in a function of its own."""
        self._lines, self.known = ["entry:"], {}
        self.pieces.append(self._lines)

    def name(self) -> str:
        """A new one."""
        self._count += 1
        return f"v{self._count}"

    def line(self, text: str) -> None:
        """An instruction without a value."""
        self._lines.append(f"  {text}")

    def value(self, text: str) -> str:
        """An instruction with one."""
        name = f"%{self.name()}"
        self.line(f"{name} = {text}")
        return name

    def place(self, of: str, number: int) -> str:
        """The address of one of the words behind a pointer."""
        return self.value(f"getelementptr i64, ptr %{of}, i64 {number}")

    def cell(self, slot: int) -> str:
        """The address of a signal."""
        return self.place("z", slot)

    def load(self, kind: str, place: str, how: str = "") -> str:
        """What lies there."""
        return self.value(f"load {how}{kind}, ptr {place}, align {1 if kind in BYTES else 8}")

    def store(self, kind: str, value: str, place: str) -> None:
        """Put it there."""
        self.line(f"store {kind} {value}, ptr {place}, align {1 if kind in BYTES else 8}")

    def require(self, condition: str, otherwise: list[str], code: int) -> None:
        """Go on where a condition is true; else do some lines and end with a code."""
        name = self.name()
        self.line(f"br i1 {condition}, label %{name}.on, label %{name}.off, !prof !0")
        self._lines.append(f"{name}.off:")
        for text in otherwise:
            self.line(text)
        self.line(f"ret i64 {code}")
        self._lines.append(f"{name}.on:")

    def text(self, stay: bool) -> str:
        """The functions `piece_0`..., which become part of who calls them, or stay what they are."""
        how = f"({PARAMETERS}) {'noinline ' if stay else ''}nounwind"
        functions = (
            [f"define internal i64 @piece_{k}{how} {{", *lines, "  ret i64 0", "}\n"]
            for k, lines in enumerate(self.pieces)
        )
        return "\n".join(line for function in functions for line in function)
