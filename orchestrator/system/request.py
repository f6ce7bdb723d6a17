"""What `rovbrush run` was asked for, as it was written: kept with a checkpoint, so that the run can go on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class Request:
    """The options of the command; texts, tuples where they are repeatable."""

    system: str
    set_: tuple[str, ...] = ()
    stop: str = ""
    replace: tuple[str, ...] = ()
    map_: tuple[str, ...] = ()
    period: tuple[str, ...] = ()
    record_boundary: tuple[str, ...] = ()
    record: tuple[str, ...] = ()
    step: str = ""
    fmus: str = ""
    checkpoint: str = ""
    input_: tuple[str, ...] = ()

    def content(self) -> dict[str, Any]:
        """As JSON, with paths that hold in any folder."""
        return asdict(
            replace(
                self,
                system=str(Path(self.system).absolute()) if Path(self.system).suffix else self.system,
                fmus=str(Path(self.fmus).absolute()) if self.fmus else "",
                replace=tuple(map(_absolute, self.replace)),
                map_=tuple(map(_absolute, self.map_)),
                input_=tuple(str(Path(path).absolute()) for path in self.input_),
            )
        )

    @classmethod
    def of(cls, content: Mapping[str, Any]) -> Request:
        """From JSON. Raises ValueError if it is no request."""
        values = {key: tuple(map(str, v)) if isinstance(v, list) else str(v) for key, v in content.items()}
        kinds = {f.name: str if f.type == "str" else tuple for f in fields(cls)}
        if values.keys() != kinds.keys() or not all(isinstance(v, kinds[key]) for key, v in values.items()):
            raise ValueError("no request")
        return cls(**values)  # type: ignore[arg-type]


def _absolute(text: str) -> str:
    """`motor=their.fmu` with its path absolute."""
    name, equals, path = text.partition("=")
    return f"{name}{equals}{Path(path.strip()).absolute()}" if equals else text
