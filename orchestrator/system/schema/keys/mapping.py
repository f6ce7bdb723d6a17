"""The keys of a mapping file: what our variables are called in somebody else's FMU; see `replace/mapping`."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta, Struct

from .values import Values

NAMES = {"says": "name and unit must be text"}


class EntryTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Their variable behind one of ours."""

    name: Annotated[str | None, Meta(description="its name; that of ours where nothing is stated", extra=NAMES)] = None
    sign: Annotated[
        Annotated[float, Meta(extra_json_schema={"enum": [1, -1]}, extra={"must": "1 or -1"})],
        Meta(description="-1 where theirs has the opposite direction"),
    ] = 1.0
    unit: Annotated[str | None, Meta(description="of theirs, where their FMU states none", extra=NAMES)] = None


class MappingTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What the variables of one of our components are called in somebody else's FMU."""

    variables: Annotated[dict[str, str | EntryTable], Meta(description='ours = theirs; `""` where they have none')] = {}
    inputs: Annotated[Values, Meta(description="inputs of their own, in their units, held over the run")] = {}
    parameters: Annotated[Values, Meta(description="parameters of their own")] = {}
