"""The keys of a fit file; see `studies/fit/file.py`."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta, Struct

from .values import Instant, Values


class ExperimentTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One measurement."""

    data: Annotated[str, Meta(description="a CSV file beside this one: `time`, and columns `name [unit]`")]
    set: Annotated[Values, Meta(description="values of this experiment, `component.variable`")] = {}
    start_time: Annotated[Instant | None, Meta(description="another start time than the system's")] = None
    stop_time: Annotated[Instant | None, Meta(description="where it ends; at the end of the data if not given")] = None


class FitTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Parameters of a system, fitted to measured data."""

    system: Annotated[str, Meta(description="a shipped system, or the path of a file beside this one")]
    vary: Annotated[dict[str, str], Meta(description='what is fitted: `"low:high"` or `"low:high:log"`')]
    match: Annotated[list[str], Meta(description="the signals that were measured, `name` or `name=column`")]
    experiments: Annotated[list[ExperimentTable], Meta(description="what was measured", min_length=1)]
    description: Annotated[str, Meta(description="what it is for")] = ""
    parameters: Annotated[str, Meta(description="a parameter set in place of the system's own")] = ""
    set: Annotated[Values, Meta(description="values of all experiments, `component.variable`")] = {}
    sigma: Annotated[
        dict[str, float], Meta(description="standard deviations of signals, in their units; estimated if not given")
    ] = {}
    loss: Annotated[str, Meta(description="linear, soft_l1, huber, cauchy or arctan")] = "linear"
