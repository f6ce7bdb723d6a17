"""The text for Pyccel, which keeps only comments on lines of their own: those behind a statement go before it."""

from __future__ import annotations

import ast
import io
import tokenize

from ..lowering.lowered import Lowered, Part


def with_comments(source: Lowered) -> tuple[str, list[int]]:
    """The lowered text with each comment before its statement, and for each of its lines the line of `source.text`."""
    lines: list[str] = []
    origin: list[int] = []
    first = 1
    for part in source.parts:
        for line, number in _commented(part.path.read_text(encoding="utf-8"), part):
            lines.append(line)
            origin.append(first + number)
        lines.append("")
        origin.append(first)
        first += part.text.count("\n") + 1
    return "\n".join(lines) + "\n", origin


def _commented(written: str, part: Part) -> list[tuple[str, int]]:
    """The lines of a lowered part with its comments, each with the number, from 0, of the line that it comes from."""
    statements = [node for node in ast.walk(ast.parse(part.text)) if isinstance(node, ast.stmt)]
    before: dict[int, dict[int, list[str]]] = {}
    for line, comment in _behind_code(written):
        holding = [s for s in statements if s.lineno <= line <= _end_of_head(s)]
        if holding:
            one = max(holding, key=lambda s: (s.lineno, -_end_of_head(s)))
            before.setdefault(one.lineno, {}).setdefault(one.col_offset, []).append(comment)
    found: list[tuple[str, int]] = []
    for number, text in enumerate(part.text.splitlines()):
        indent = text[: len(text) - len(text.lstrip())]
        if text.lstrip().startswith(("elif ", "else:")):  # no place for a comment before
            before.pop(number + 1, None)
        at = 0
        for column, comments in sorted(before.get(number + 1, {}).items()):
            head = text[at:column].rstrip().removesuffix(";")
            found += [(head, number)] * bool(head.strip())
            found += [(indent + comment, number) for comment in comments]
            at = column
        found.append((indent * bool(at and at > len(indent)) + text[at if at > len(indent) else 0 :], number))
    return found


def _behind_code(text: str) -> list[tuple[int, str]]:
    """Line and text of each comment that stands behind code."""
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    return [
        (token.start[0], token.string)
        for token in tokens
        if token.type == tokenize.COMMENT and token.line[: token.start[1]].strip()
    ]


def _end_of_head(statement: ast.stmt) -> int:
    """The last line of a statement, or of what stands before its block."""
    body = getattr(statement, "body", None)
    return body[0].lineno - 1 if body else statement.end_lineno or statement.lineno
