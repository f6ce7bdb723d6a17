"""What `rovbrush calibrate` fits, as `calibration.toml` says."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, TypeVar

from msgspec import Meta, Struct

from ..system.schema.checked import checked
from ..system.schema.keys.values import Number, Positive
from ..toml.file import TomlFile

SPECIFICATION = Path(__file__).with_name("calibration.toml")


class Target(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A figure of merit that the fit is to meet."""

    reference: Annotated[Number, Meta(description="the paper's value")]
    scale: Annotated[Positive, Meta(description="of its relative deviation in the residual")]
    bound: Annotated[Positive, Meta(description="the relative deviation that is granted")]


class Limit(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A figure of merit with an upper bound."""

    at_most: Annotated[Number, Meta(description="the bound")]
    scale: Annotated[Positive, Meta(description="of what exceeds it in the residual")]


class Free(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A parameter that is fitted."""

    start: Annotated[Number, Meta(description="the first guess")]
    low: Annotated[Number, Meta(description="its least value")]
    high: Annotated[Number, Meta(description="its largest value")]
    log: Annotated[bool, Meta(description="whether its logarithm is what is varied")] = False


class Specification(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What is fitted to what."""

    system: Annotated[str, Meta(description="the system that is run")]
    write: Annotated[str, Meta(description="the parameter file that is written")]
    targets: Annotated[dict[str, Target], Meta(description="figures of merit to be met")]
    limits: Annotated[dict[str, Limit], Meta(description="figures of merit with a bound")] = {}
    free: Annotated[dict[str, Free], Meta(description="what is fitted, `component.parameter`")]
    ladder: Annotated[
        dict[str, list[Number]], Meta(description="a parameter and its values, each tried from the fit before")
    ]
    held: Annotated[dict[str, Number], Meta(description="what is set and not fitted")] = {}


T = TypeVar("T")


def read_specification(path: Path = SPECIFICATION) -> Specification:
    """Raises InputError for a key or a value that cannot be meant."""
    file = TomlFile(path)
    table = checked(Specification, file.data, "", file)
    if len(table.ladder) != 1:
        raise file.fail("ladder must name one parameter", "[ladder]")

    def tables(kind: type[T], heading: str) -> dict[str, T]:
        entries = file.entry(dict, heading).items()
        return {
            name: checked(kind, entry, f"{heading} {name}", file, where=file.at(name, heading))
            for name, entry in entries
        }

    return Specification(
        system=table.system, write=table.write, targets=tables(Target, "targets"), limits=tables(Limit, "limits"),
        free=tables(Free, "free"), ladder=table.ladder, held=table.held,
    )  # fmt: skip
