"""The keys of what happens in a run."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta, Struct, field

from .values import Instant, Seed, Time, Value, Values


class EventTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What happens in a run: at a time, when a signal crosses a value or by hand, inputs are set or a signal breaks.

    It acts at the first instant of the component that it touches which is not before it; `rovbrush plan` shows when.
    What is there at the start or before holds in the initialization too.
    """

    name: Annotated[
        str | None, Meta(description="what the plan and the results call it; else `event 1`, by its place")
    ] = None
    at: Annotated[Instant | None, Meta(description="when it happens; this, `when` or `by_hand`")] = None
    when: Annotated[
        str | None,
        Meta(
            description="the crossing at which it happens: `component.output > value` for a rising signal, `<` for a "
            "falling one, `component.output` or `not component.output` for a Boolean; beyond the value from the start "
            "is no crossing",
            examples=["motor.i > 20 A", "vehicle.z_n < -3 m", "controller.alarm"],
        ),
    ] = None
    by_hand: Annotated[
        bool,
        Meta(description="it happens, any number of times, when `happen` of a session says so between two steps"),
    ] = False
    initial: Annotated[
        bool,
        Meta(
            description="false: at the start it happens behind the initialization, not in it, as what is done by hand "
            "there does"
        ),
    ] = True
    after: Annotated[Time | None, Meta(description="how long behind the crossing it happens")] = None
    repeat: Annotated[bool, Meta(description="at every crossing, not at the first alone")] = False
    set: Annotated[
        Values,
        Meta(
            description="new values of inputs that nothing drives and of tunable parameters, `component.variable`; a "
            "list for an array"
        ),
    ] = {}
    fault: Annotated[
        Literal["hold", "bias", "scale", "noise", "loss"] | None,
        Meta(
            description="what becomes of a signal, in place of `set`: it stays as it is, `value` is added to it, it is "
            "multiplied by `value`, Gaussian noise with the standard deviation `value` is added, or it is `value` (0)"
        ),
    ] = None
    on: Annotated[
        str | None,
        Meta(description="the broken signal: an input that a connection drives, or an output for all that it drives"),
    ] = None
    value: Annotated[Value | None, Meta(description="of the fault, in the unit of the signal or with its own")] = None
    seed: Annotated[Seed | None, Meta(description="of the noise; the same seed gives the same noise")] = None
    until: Annotated[Instant | None, Meta(description="when the fault ends; else it stays")] = None
    for_: Annotated[Time | None, Meta(description="how long the fault lasts, in place of `until`")] = field(
        default=None, name="for"
    )


class ScenarioTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A file of events for `rovbrush run SYSTEM --scenario FILE.toml`, added to those that the system states."""

    description: Annotated[str, Meta(description="what happens, in a line")] = ""
    events: Annotated[list[EventTable], Meta(description="as in a system file")] = []
