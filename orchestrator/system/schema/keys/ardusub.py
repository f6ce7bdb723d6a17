"""The keys of an autopilot in a component's place."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta, Struct, field

from .values import Number, Time


class ServoTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Channels of the autopilot, and what their pulses are worth as an output."""

    output: Annotated[str, Meta(description="name of the output", pattern=r"^[A-Za-z_]\w*$")]
    channels: Annotated[
        list[Annotated[int, Meta(ge=1, le=32)]],
        Meta(description="from 1 to 32; several make an array, in their order", min_length=1),
    ]
    pulses: Annotated[
        list[Annotated[float, Meta(gt=0)]], Meta(description="lengths of pulses [us], rising", min_length=2)
    ] = field(default_factory=lambda: [1100.0, 1500.0, 1900.0])
    values: Annotated[
        list[Number], Meta(description="the output at these, straight between and held beyond", min_length=2)
    ] = field(default_factory=lambda: [-1.0, 0.0, 1.0])
    idle: Annotated[Number, Meta(description="the output without a pulse")] = 0.0
    unit: Annotated[str, Meta(description="of the output")] = "1"
    description: Annotated[str, Meta(description="what it is, in a line")] = ""


class ArduSubTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """ArduPilot's autopilot for submarines by its SITL JSON interface, in lock-step with the run."""

    port: Annotated[int, Meta(description="the UDP port at which the autopilot is waited for", ge=0, le=65535)] = 9002
    host: Annotated[str, Meta(description="the address of this machine at which it is waited for")] = "127.0.0.1"
    peer: Annotated[
        str, Meta(description="the one address that is listened to; needed where `host` is not this machine alone")
    ] = ""
    timeout: Annotated[Time, Meta(description="of the wait for each packet, in wall time")] = "30 s"
    origin: Annotated[
        list[Number],
        Meta(
            description="the world's origin from the autopilot's home: north, east, down [m]; home is at the surface",
            min_length=3,
            max_length=3,
        ),
    ] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    rangefinders: Annotated[int, Meta(description="number of distances that it is told", ge=0, le=6)] = 0
    battery: Annotated[bool, Meta(description="true: it is told voltage and current of a battery")] = False
    servos: Annotated[
        list[ServoTable],
        Meta(description="its outputs; else `u_thruster`, motors 1 to 8 of the heavy frame (vectored_6dof)"),
    ] = []
