"""Who looks on and who drives: one at most. The others look until nobody drives and they take over."""

from __future__ import annotations

from dataclasses import dataclass

GRACE = 6.0  # s that whoever drives may be away, to load the page again


@dataclass
class _Viewer:
    name: str
    here: int = 1  # connections
    left: float = 0.0  # when the last of them went [s]


class Viewers:
    """By a key for each, that of a browser's tab. Times are seconds of any clock that goes on."""

    def __init__(self, grace: float = GRACE) -> None:
        self.grace = grace
        self._viewers: dict[str, _Viewer] = {}
        self._driver = ""
        self._count = 0

    def arrive(self, key: str, now: float) -> None:
        """Somebody opens the page, or again; whoever comes where nobody drives does."""
        self.look(now)
        known = self._viewers.get(key)
        if known is None:
            self._count += 1
            self._viewers[key] = _Viewer(f"viewer {self._count}")
        else:
            known.here += 1
        if not self._driver and not any(other.here for k, other in self._viewers.items() if k != key):
            self._driver = key

    def leave(self, key: str, now: float) -> None:
        """A connection of somebody has ended."""
        known = self._viewers.get(key)
        if known is not None and known.here:
            known.here -= 1
            known.left = now

    def look(self, now: float) -> None:
        """Forget whoever has been away for too long."""
        for key, viewer in list(self._viewers.items()):
            if not viewer.here and now - viewer.left > self.grace:
                del self._viewers[key]
                if self._driver == key:
                    self._driver = ""

    def take(self, key: str, now: float) -> str:
        """Drive; why not, if somebody else does."""
        self.look(now)
        if key not in self._viewers:
            return "this page is not connected; load it again"
        if self._driver not in ("", key):
            return f"{self.driver} drives; you can take over when they have let go or gone"
        self._driver = key
        return ""

    def release(self, key: str) -> None:
        if self._driver == key:
            self._driver = ""

    def drives(self, key: str) -> bool:
        return bool(key) and self._driver == key

    @property
    def driver(self) -> str:
        """The name of whoever drives; empty if nobody does."""
        return self._viewers[self._driver].name if self._driver else ""

    @property
    def here(self) -> int:
        """How many look on now."""
        return sum(bool(viewer.here) for viewer in self._viewers.values())

    def name(self, key: str) -> str:
        return self._viewers[key].name if key in self._viewers else ""
