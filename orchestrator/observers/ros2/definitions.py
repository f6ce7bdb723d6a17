"""The messages of ROS 2 that are written, as its packages std_msgs, geometry_msgs and builtin_interfaces define them.

A definition is its own fields, then those of each message that it holds, behind a line of 80 `=`.
"""

from __future__ import annotations

LINE = "=" * 80
TIME = "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec"
HEADER = "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id"
VECTOR = "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z"
POINT = VECTOR.replace("Vector3", "Point")
QUATERNION = "MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w"
POSE = "MSG: geometry_msgs/Pose\ngeometry_msgs/Point position\ngeometry_msgs/Quaternion orientation"
WRENCH = "MSG: geometry_msgs/Wrench\ngeometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque"
TWIST = "MSG: geometry_msgs/Twist\ngeometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular"


def _of(*parts: str) -> str:
    return f"\n{LINE}\n".join(parts) + "\n"


OF_KIND = {  # of a signal: type, definition, code of its number
    "number": ("std_msgs/msg/Float64", _of("float64 data"), "d"),
    "integer": ("std_msgs/msg/Int64", _of("int64 data"), "q"),
    "boolean": ("std_msgs/msg/Bool", _of("bool data"), "?"),
    "string": ("std_msgs/msg/String", _of("string data"), ""),
}
TOGETHER = {  # of several signals
    "PoseStamped": _of("std_msgs/Header header\ngeometry_msgs/Pose pose", HEADER, TIME, POSE, POINT, QUATERNION),
    "WrenchStamped": _of("std_msgs/Header header\ngeometry_msgs/Wrench wrench", HEADER, TIME, WRENCH, VECTOR),
    "TwistStamped": _of("std_msgs/Header header\ngeometry_msgs/Twist twist", HEADER, TIME, TWIST, VECTOR),
}
