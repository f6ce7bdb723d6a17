"""Connections between the members of a group."""

from __future__ import annotations

from typing import NamedTuple


class Link(NamedTuple):
    """What goes from an output to an input, each by member and the FMU's own name: gain times it, and an offset."""

    source: tuple[int, str]
    target: tuple[int, str]
    gain: float = 1.0
    offset: float = 0.0


class Crossed(NamedTuple):
    """A signal of a member (by number, and the FMU's own name) whose passing of a value is an event: the address of the
    value, whether the signal rises there, and all of it in words."""

    member: int
    name: str
    limit: int
    rises: bool
    text: str


class LinkBlock(NamedTuple):
    """One link, or all links of a loop of direct dependences."""

    links: tuple[Link, ...]
    loop: bool = False
