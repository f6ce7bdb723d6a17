"""The tool on the vehicle: its wrench (Eq. 21) and its place and motion against the hull."""

from math import atan2, sqrt

from .frames import cross_add


def tool_wrench(
    tau_disturb: "float[:]", r_tool: "float[:]", R_tool_body: "float[:]", F_x: float, F_y: float, F_z: float,
    M_x: float, M_y: float, M_z: float,
) -> None:
    """The tool's force and moment, given in the tool frame, as a wrench about the body origin (Eq. 21)."""
    for r in range(3):
        k = 3 * r
        tau_disturb[r] = R_tool_body[k] * F_x + R_tool_body[k + 1] * F_y + R_tool_body[k + 2] * F_z  # Eq. 21
        tau_disturb[3 + r] = R_tool_body[k] * M_x + R_tool_body[k + 1] * M_y + R_tool_body[k + 2] * M_z
    cross_add(tau_disturb, 3, r_tool[0], r_tool[1], r_tool[2], tau_disturb[0], tau_disturb[1], tau_disturb[2])


def tool_motion(
    x: "float[:]", R: "float[:]", r_tool: "float[:]", R_tool_body: "float[:]", R_brush: float, hull_point: "float[:]",
    hull_normal: "float[:]", work: "float[:]",
) -> tuple[float, float, float, float]:
    """Penetration delta, its rate, hull speed v_rov along x_t, and misalignment of z_t with the normal into the hull.

    work: [0..2] tool point minus body origin, world; [3..5] its velocity, body, and [6..8] world; [9..11] z_t, world.
    """
    for i in range(3):
        work[i] = R[3 * i] * r_tool[0] + R[3 * i + 1] * r_tool[1] + R[3 * i + 2] * r_tool[2]
        work[3 + i] = x[7 + i]
        work[9 + i] = R[3 * i] * R_tool_body[2] + R[3 * i + 1] * R_tool_body[5] + R[3 * i + 2] * R_tool_body[8]
        work[12 + i] = 0.0
    cross_add(work, 3, x[10], x[11], x[12], r_tool[0], r_tool[1], r_tool[2])
    delta = R_brush
    delta_dot = 0.0
    v_rov = 0.0
    facing = 0.0
    for i in range(3):
        work[6 + i] = R[3 * i] * work[3] + R[3 * i + 1] * work[4] + R[3 * i + 2] * work[5]
        delta = delta - hull_normal[i] * (x[i] + work[i] - hull_point[i])
        delta_dot = delta_dot - hull_normal[i] * work[6 + i]
        v_rov = v_rov - R_tool_body[3 * i] * work[3 + i]
        facing = facing - hull_normal[i] * work[9 + i]
    # atan2 of sine and cosine is exact near zero, where acos is not.
    cross_add(work, 12, work[9], work[10], work[11], hull_normal[0], hull_normal[1], hull_normal[2])
    misalignment = atan2(sqrt(work[12] * work[12] + work[13] * work[13] + work[14] * work[14]), facing)
    return delta, delta_dot, v_rov, misalignment
