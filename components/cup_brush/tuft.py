"""One tuft: where it stands, how its tip slides, how its bristles bend, and what its tip does to the brush."""

from math import atan2, cos, pi, sin, sqrt

from ..library.friction import stribeck, stribeck_with_peak
from .elastica import compliance, sideways
from .parameters import Parameters
from .records import Bend, Hull, Inputs, Place, Sliding, State, Tip


def hull_at(delta: float, u: Inputs, p: Parameters) -> Hull:
    """The hull when the penetration on the axis is delta; it moves at v_rov along x_t and so that delta_dot holds."""
    n_x = sin(u.misalignment)
    n_z = cos(u.misalignment)
    return Hull(
        delta=delta,
        n_x=n_x,
        n_z=n_z,
        v_z=(u.delta_dot + n_x * u.v_rov) / n_z,
        mu_s=u.friction_scale * p.mu_s,
        mu_c=u.friction_scale * p.mu_c,
    )


def place(r: float, phi: float, p: Parameters) -> Place:
    """A tuft whose root stands at the radius r and at the angle phi from x_t."""
    c = cos(phi)
    s = sin(phi)
    lean = sin(p.alpha)
    return Place(r, c, s, a_x=lean * s, a_y=-lean * c, a_z=cos(p.alpha))


def sliding_at(x: float, y: float, hull: Hull, u: Inputs) -> Sliding:
    """How a point of the brush slides on the hull (Eq. 10 for an axis normal to the hull)."""
    v_1 = (-u.omega_b * y - u.v_rov) * hull.n_z - hull.v_z * hull.n_x  # Eq. 10
    v_2 = u.omega_b * x  # Eq. 10
    V = sqrt(v_1 * v_1 + v_2 * v_2)
    scale = 1.0 / max(V, 1e-30)
    return Sliding(u_1=v_1 * scale, u_2=v_2 * scale, V=V)


def friction_coefficient(V: float, hull: Hull, p: Parameters) -> float:
    """F_f/F_n at a sliding speed, by the law of `friction_law`."""
    if p.friction_law == 0:
        mu, _ = stribeck(V, hull.mu_s, hull.mu_c, p.v_0, p.k_v, p.v_eps)
    else:
        mu, _ = stribeck_with_peak(V, hull.mu_s, hull.mu_c, p.v_0, p.k_v, p.v_eps)
    return mu


def bend_of(slide: Sliding, q: float, D: float, at: Place, hull: Hull, p: Parameters, x: State) -> Bend:
    """The bristle under the friction of a sliding tip that is pressed in by D L; q as known before."""
    mu = friction_coefficient(slide.V, hull, p)
    # The hull presses along t: its normal and the friction.
    scale = 1.0 / sqrt(1.0 + mu * mu)
    t_x = (hull.n_x + mu * slide.u_1 * hull.n_z) * scale  # Eq. 6
    t_y = mu * slide.u_2 * scale  # Eq. 6
    t_z = (hull.n_z - mu * slide.u_1 * hull.n_x) * scale  # Eq. 6
    cosine = t_x * at.a_x + t_y * at.a_y + t_z * at.a_z
    d_x = cosine * at.a_x - t_x
    d_y = cosine * at.a_y - t_y
    d_z = cosine * at.a_z - t_z
    sine = sqrt(d_x * d_x + d_y * d_y + d_z * d_z)
    unit = 0.0
    if sine > 1e-9:  # else it buckles to no side
        unit = 1.0 / sine
    beta = atan2(sine, cosine)
    H = sideways(q, beta, x.H)
    # D = q^2 n.a - H q n.d: what shortening and, of a bristle that leans, the deflection give.
    c = hull.n_x * at.a_x + hull.n_z * at.a_z
    gain = -(hull.n_x * d_x + hull.n_z * d_z) * unit
    if gain < 0.0:  # leans against its sliding: at first touch it does not dig in
        gain = gain * D / (D + 0.02 * gain * gain)
    half = 0.5 * H * gain
    q_new = D / (half + sqrt(half * half + c * D))  # Eq. 8
    return Bend(mu, beta, q_new, b=H * q_new, d_x=d_x * unit, d_y=d_y * unit, d_z=d_z * unit)


def slides_on(bend: Bend, slide: Sliding, at: Place, hull: Hull, u: Inputs, p: Parameters) -> Sliding:
    """How the tip of a bristle that bends so slides: it trails behind its root.

    The part B of the deflection that trails turns with the sliding; V^2 = w^2 - (omega_b B)^2 solves for it.
    """
    k = 1.0 - bend.q * bend.q
    B = -p.L * bend.b * (
        slide.u_1 * (bend.d_x * hull.n_z - bend.d_z * hull.n_x) + slide.u_2 * bend.d_y)
    x = at.r * at.cos_phi + p.L * (k * at.a_x + bend.b * bend.d_x) + B * slide.u_1 * hull.n_z
    y = at.r * at.sin_phi + p.L * (k * at.a_y + bend.b * bend.d_y) + B * slide.u_2
    w = sliding_at(x, y, hull, u)
    turning = u.omega_b * B
    V = sqrt(max(w.V * w.V - turning * turning, 0.0))
    unit = 1.0 / max(sqrt(V * V + turning * turning), 1e-30)
    return Sliding(
        u_1=(w.u_1 * V + w.u_2 * turning) * unit,
        u_2=(w.u_2 * V - w.u_1 * turning) * unit,
        V=V,
    )


def press(tip: Tip, at: Place, hull: Hull, u: Inputs, p: Parameters, x: State) -> None:
    """What the hull does to a tuft."""
    x_0 = at.r * at.cos_phi + p.L * at.a_x
    y_0 = at.r * at.sin_phi + p.L * at.a_y
    Delta = hull.delta + hull.n_x * x_0  # Eq. 8, of the undeformed tuft
    if Delta > 0.0:
        D = Delta / p.L
        slide = sliding_at(x_0, y_0, hull, u)
        bend = bend_of(slide, sqrt(D), D, at, hull, p, x)
        for _ in range(20):
            V = slide.V
            u_2 = slide.u_2
            slide = slides_on(bend, slide, at, hull, u, p)
            bend = bend_of(slide, bend.q, D, at, hull, p, x)
            if abs(slide.V - V) <= 1e-8 * V and abs(slide.u_2 - u_2) <= 1e-8:
                break
        elastic(tip, D, bend, at, p, x)
        load(tip, Delta, bend.mu, slide, hull, u, p)
    else:
        off(tip, at, p)


def off(tip: Tip, at: Place, p: Parameters) -> None:
    """A straight tuft off the hull."""
    tip.x = at.r * at.cos_phi + p.L * at.a_x
    tip.y = at.r * at.sin_phi + p.L * at.a_y
    tip.z = p.L * at.a_z
    tip.P = 0.0
    tip.F_n = 0.0
    tip.F_f = 0.0
    tip.f_x = 0.0
    tip.f_y = 0.0
    tip.f_z = 0.0
    tip.F_x = 0.0
    tip.F_y = 0.0
    tip.F_z = 0.0
    tip.shear = 0.0
    tip.M_b = 0.0
    tip.slope = 0.0
    tip.b = 0.0
    tip.E = 0.0
    tip.P_friction = 0.0
    tip.P_contact = 0.0


def elastic(tip: Tip, D: float, bend: Bend, at: Place, p: Parameters, x: State) -> None:
    """Place and elastic load of the tip, base reactions and energy, from the tables of the elastica."""
    EI = p.bristles_per_tuft * p.E * pi * p.d * p.d * p.d * p.d / 64.0
    a = 1.0 - bend.q * bend.q
    f = bend.q / compliance(bend.q, bend.beta, x.G)
    c = cos(bend.beta)
    s = sin(bend.beta)
    m = f * (a * s + bend.b * c)  # elastica: moment of the tip force about the root
    # With Delta^0.5 the force would start with infinite stiffness.
    depth = D * p.L / p.Delta_eps
    onset = depth * depth * depth * depth
    onset = sqrt(sqrt(sqrt(onset / (1.0 + onset))))
    F = onset * EI * f / (p.L * p.L)
    tip.P = F / sqrt(1.0 + bend.mu * bend.mu)
    tip.shear = F * s  # Eq. 11
    tip.M_b = onset * EI * m / p.L  # Eq. 12
    # elastica: theta'^2/2 = f (cos(beta + theta) - cos(beta + theta_L)), at the root and over the length
    c_L = max(c - 0.5 * m * m / f, -1.0)
    tip.slope = atan2(sqrt(max(1.0 - c_L * c_L, 0.0)), c_L) - bend.beta
    tip.E = EI / p.L * (f * (a * c - bend.b * s - c) + 0.5 * m * m)
    tip.b = bend.b
    tip.x = at.r * at.cos_phi + p.L * (a * at.a_x + bend.b * bend.d_x)
    tip.y = at.r * at.sin_phi + p.L * (a * at.a_y + bend.b * bend.d_y)
    tip.z = p.L * (a * at.a_z + bend.b * bend.d_z)


def load(tip: Tip, Delta: float, mu: float, slide: Sliding, hull: Hull, u: Inputs, p: Parameters) -> None:
    """Normal force and friction of a bent tuft, along the axes of the tool, and what they lose."""
    Delta_dot = u.delta_dot - hull.n_x * u.omega_b * tip.y
    ramp = 1.0
    if Delta < p.Delta_s:
        share = Delta / p.Delta_s
        ramp = share * share * (3.0 - 2.0 * share)
    tip.F_n = max(0.0, tip.P + p.c_c * ramp * Delta_dot)  # Eq. 7, with the elastica for k_c Delta^1.5
    tip.F_f = mu * tip.F_n  # Eq. 9
    tip.f_x = mu * tip.P * slide.u_1 * hull.n_z
    tip.f_y = mu * tip.P * slide.u_2
    tip.f_z = -mu * tip.P * slide.u_1 * hull.n_x
    tip.F_x = -tip.F_n * hull.n_x - tip.F_f * slide.u_1 * hull.n_z  # Eq. 6
    tip.F_y = -tip.F_f * slide.u_2  # Eq. 6
    tip.F_z = -tip.F_n * hull.n_z + tip.F_f * slide.u_1 * hull.n_x  # Eq. 6
    at_tip = sliding_at(tip.x, tip.y, hull, u)
    tip.P_friction = tip.F_f * at_tip.V * (at_tip.u_1 * slide.u_1 + at_tip.u_2 * slide.u_2)
    tip.P_contact = (tip.F_n - tip.P) * Delta_dot
