"""Changes of a text by the places of its syntax tree, each on the line where it stands."""

from __future__ import annotations

import ast


class Edits:
    """Replacements in one text, collected by place and applied at once; they must not overlap."""

    def __init__(self, text: str) -> None:
        self.bytes = text.encode()
        self.starts = [0]
        for line in self.bytes.splitlines(keepends=True):
            self.starts.append(self.starts[-1] + len(line))
        self.found: list[tuple[int, int, bytes]] = []

    def begin(self, node: ast.AST) -> int:
        """Offset of the first byte of a node."""
        return self.starts[node.lineno - 1] + node.col_offset  # type: ignore[attr-defined,no-any-return]

    def end(self, node: ast.AST) -> int:
        """Offset behind the last byte of a node."""
        return self.starts[node.end_lineno - 1] + node.end_col_offset  # type: ignore[attr-defined,no-any-return]

    def replace(self, node: ast.AST, text: str, until: ast.AST | None = None, inside: bool = True) -> None:
        """Put text in the place of a node, or of all from it to the end of `until`; to its begin if not `inside`."""
        end = self.end(node) if until is None else self.end(until) if inside else self.begin(until)
        self._put(self.begin(node), end, text)

    def between(self, first: ast.AST, second: ast.AST | None, text: str, end: ast.AST | None = None) -> None:
        """Put text in the place of what stands between two nodes, or between one and the end of what holds it."""
        assert second is not None or end is not None
        self._put(self.end(first), self.begin(second) if second is not None else self.end(end), text)  # type: ignore[arg-type]

    def after(self, node: ast.AST, text: str) -> None:
        """Put text behind a node."""
        self._put(self.end(node), self.end(node), text)

    def _put(self, begin: int, end: int, text: str) -> None:
        """Replace, keeping the number of lines: what is cut out leaves its line ends, within brackets."""
        lines = b"\n" * self.bytes[begin:end].count(b"\n")
        closing = text.startswith((")", "]"))
        self.found.append((begin, end, lines + text.encode() if closing else text.encode() + lines))

    def applied(self) -> str:
        """The changed text."""
        pieces, at = [], 0
        for begin, end, text in sorted(self.found, key=lambda one: (one[0], one[1])):
            pieces += [self.bytes[at:begin], text]
            at = end
        return b"".join([*pieces, self.bytes[at:]]).decode()
