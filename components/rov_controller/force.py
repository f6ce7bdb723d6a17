"""What the measured tool wrench is used for: its filter, feedforward, and the force along the hull normal."""

from math import exp


def filter_wrench(wrench: "float[:]", F_tool: "float[:]", M_tool: "float[:]", h: float, T_filter: float) -> None:
    """First-order low-pass of the measured wrench over a communication step in which it is constant."""
    keep = 0.0
    if T_filter > 0.0:
        keep = exp(-h / T_filter)
    for i in range(3):
        wrench[i] = keep * wrench[i] + (1.0 - keep) * F_tool[i]
        wrench[3 + i] = keep * wrench[3 + i] + (1.0 - keep) * M_tool[i]


def along(vector: "float[:]", normal: "float[:]") -> float:
    """The component of vector[0..2] along the normal."""
    return vector[0] * normal[0] + vector[1] * normal[1] + vector[2] * normal[2]


def feed_forward(tau: "float[:]", wrench: "float[:]", K_feedforward: float) -> None:
    """Take the measured tool wrench off what is asked of the thrusters."""
    for i in range(6):
        tau[i] = tau[i] - K_feedforward * wrench[i]


def press(
    tau: "float[:]", e: "float[:]", integral: "float[:]", nu: "float[:]", wrench: "float[:]", memory: "float[:]",
    normal: "float[:]", F_n_ref: float, T_s: float, contact_force: float, K_force: float, K_force_i: float,
    K_force_d: float,
) -> None:
    """In contact: the force along the normal in tau follows F_n_ref; velocity errors count only across the normal.

    The integral of the velocity loop follows, so that neither the first nor the last sample in contact makes a jump.
    """
    F_n = -along(wrench, normal)
    threshold = contact_force
    if memory[10] > 0.0:
        threshold = 0.5 * contact_force
    if F_n_ref > 0.0 and F_n > threshold:
        pushed = along(tau, normal)
        if memory[10] == 0.0:
            memory[11] = pushed - F_n_ref
        error = F_n_ref - F_n
        F = F_n_ref + K_force * error + memory[11] - K_force_d * along(nu, normal)
        change = F_n_ref + memory[11] - along(integral, normal)
        missed = along(e, normal)
        for i in range(3):
            tau[i] = tau[i] + (F - pushed) * normal[i]
            integral[i] = integral[i] + change * normal[i]
            e[i] = e[i] - missed * normal[i]
        memory[11] = memory[11] + T_s * K_force_i * error
        memory[10] = 1.0
    else:
        memory[10] = 0.0
        memory[11] = 0.0
