"""The keys of messages that signals make together, for observers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Literal

from msgspec import Meta, Struct

Source = str | float
Three = Annotated[list[Source], Meta(min_length=3, max_length=3, extra={"must": "a list of three signals or numbers"})]


class MessageTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A message of ROS 2 (geometry_msgs) that signals make together, in what `--observe ros2=FILE` writes.

    Signals have their names, `component.variable`, and must be recorded at the same instants; a number stands for
    itself, and what is left out is 0. Nothing is turned: the axes are those of the signals.
    """

    topic: Annotated[str, Meta(description="where it is, such as `/vehicle/pose`", pattern=r"^(/[A-Za-z_]\w*)+$")]
    type: Annotated[Literal["PoseStamped", "WrenchStamped", "TwistStamped"], Meta(description="what it is")]
    frame: Annotated[str, Meta(description="the frame_id of its header")] = "world"
    position: Annotated[Three | None, Meta(description="of a pose: x, y, z [m]")] = None
    orientation: Annotated[
        Annotated[list[Source], Meta(min_length=3, max_length=4)] | None,
        Meta(description="of a pose: roll, pitch, yaw [rad], about x, the new y and z; or a quaternion x, y, z, w"),
    ] = None
    force: Annotated[Three | None, Meta(description="of a wrench: x, y, z [N]")] = None
    torque: Annotated[Three | None, Meta(description="of a wrench: x, y, z [N m]")] = None
    linear: Annotated[Three | None, Meta(description="of a twist: x, y, z [m/s]")] = None
    angular: Annotated[Three | None, Meta(description="of a twist: x, y, z [rad/s]")] = None


FIELDS = {
    "PoseStamped": ("position", "orientation"), "WrenchStamped": ("force", "torque"),
    "TwistStamped": ("linear", "angular"),
}  # fmt: skip


def signals_of(message: Mapping[str, Any]) -> list[str]:
    """The signals that a message, as a file states it, is made of."""
    parts = [message.get(field) or () for fields in FIELDS.values() for field in fields]
    return [name for part in parts for name in part if isinstance(name, str)]
