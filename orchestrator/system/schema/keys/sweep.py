"""The keys of a sweep file; see `studies/sweep`."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta, Struct

from .values import FigureOfMerit, Instant, Value, Values

Whole = Annotated[int, Meta(ge=0, extra={"says": "{key} must be a whole number, 0 or more"})]


class SweepTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Many runs of one system with varied values."""

    system: Annotated[str, Meta(description="a shipped system, or the path of a file beside this one")]
    vary: Annotated[
        dict[str, Value | list[Value]],
        Meta(description='what is varied: `"low:high:count"`, `"low:high:count:log"` or a list of values'),
    ]
    description: Annotated[str, Meta(description="what it is for")] = ""
    parameters: Annotated[
        str, Meta(description="a parameter set in place of the system's own: its name, or a file beside this one")
    ] = ""
    start_time: Annotated[Instant | None, Meta(description="another start time than the system's")] = None
    stop_time: Annotated[Instant | None, Meta(description="another stop time than the system's")] = None
    random: Annotated[Whole, Meta(description="so many random points in place of a grid")] = 0
    seed: Annotated[Whole, Meta(description="that they are drawn with")] = 1
    design: Annotated[
        Annotated[str, Meta(extra_json_schema={"enum": ["", "random", "latin", "sobol"]})],
        Meta(description="how they are drawn; evenly at random if nothing is stated"),
    ] = ""
    set: Annotated[Values, Meta(description="values of all points, `component.variable`")] = {}
    summary: Annotated[dict[str, FigureOfMerit], Meta(description="figures of merit beside those of the system")] = {}
