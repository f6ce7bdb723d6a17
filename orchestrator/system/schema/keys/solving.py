"""The keys of solvers: of loops at an instant, and of Model Exchange."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta, Struct

from ....integration.settings import Method
from .values import Count, Positive, Time


class Loops(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Loops of direct dependence, which are solved at every instant by Newton's method."""

    tolerance: Annotated[
        Positive, Meta(description="what an input may be off, relative to its size or its nominal value [1]")
    ] = 1e-13
    max_iterations: Annotated[Count, Meta(description="steps of Newton's method before the run fails [1]")] = 50


class Solver(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How the FMUs for Model Exchange are integrated, all of them together."""

    method: Annotated[
        Method | None,
        Meta(
            description="`dormand-prince` (steps by their error), `rk4` (fixed steps, for real time) or `cvode` (stiff "
            "models); where nothing is stated the plan chooses, and says why"
        ),
    ] = None
    tolerance: Annotated[
        Positive | None,
        Meta(description="relative tolerance; else the smallest that a component or its FMU states [1]"),
    ] = None
    step: Annotated[Time | None, Meta(description="of `rk4`; else the period")] = None
    max_step: Annotated[Time | None, Meta(description="the largest step of the others; else there is no limit")] = None
    max_order: Annotated[Count, Meta(description="of `cvode`, up to 5 [1]")] = 5
    restart: Annotated[
        bool,
        Meta(
            description="`cvode` begins anew at every communication point, not only where something was set or "
            "happened: runs that were interrupted give the same bits"
        ),
    ] = False
