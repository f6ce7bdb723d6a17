"""The keys of power bonds, and of what must hold at the start."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta, Struct

Bound = Annotated[float | str, Meta(extra={"must": "a number, or the name of an output or parameter"})]


class BondTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A power bond: two connections in opposite directions whose signals multiply to a power."""

    effort: Annotated[str, Meta(description="the connected input that takes the effort, `component.input`")]
    flow: Annotated[
        str, Meta(description="the connected input that takes the flow, or an output of the effort's taker")
    ]
    name: Annotated[str | None, Meta(description="what results call it; else its effort")] = None
    sign: Annotated[
        Annotated[float, Meta(extra_json_schema={"enum": [1, -1]}, extra={"must": "1 or -1"})],
        Meta(description="-1 where effort times flow is the power that goes the other way"),
    ] = 1.0
    impulse: Annotated[str | None, Meta(description="an output that counts the time integral of the effort")] = None
    displacement: Annotated[str | None, Meta(description="an output that counts the time integral of the flow")] = None
    limit: Annotated[
        Annotated[float, Meta(ge=0, extra={"must": "a number of J, 0 or more"})] | None,
        Meta(description="the energy [J] that the coupling may make or lose over the run"),
    ] = None
    limit_relative: Annotated[
        Annotated[float, Meta(ge=0)] | None,
        Meta(description="the same, of the energy that the bond carries"),
    ] = None


class RequirementTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What an output or parameter must be at the start of a run; so may its bounds be."""

    value: Annotated[str, Meta(description="the output or parameter, `component.name`")]
    minimum: Annotated[Bound | None, Meta(description="its least value: a number, or another one")] = None
    maximum: Annotated[Bound | None, Meta(description="its largest value: a number, or another one")] = None
    message: Annotated[str, Meta(description="what to tell otherwise")] = "out of bounds at time 0"
    otherwise: Annotated[
        Literal["error", "warning"], Meta(description="whether the run is refused otherwise, or goes on with a warning")
    ] = "error"
