"""How filaments stand to the hull: a direction that is known is turned on, so that few angles need their sine."""

from math import cos, pi, sin

from .parameters import Parameters
from .records import Inputs, Placement, Scratch, State, Turn


def spread(p: Parameters, x: State) -> None:
    """How the axes of the filaments stand where the brush stands at 0."""
    for i in range(p.n):
        angle = 2.0 * pi * i / p.n - p.alpha
        x.sin_at[i] = sin(angle)
        x.cos_at[i] = cos(angle)


def stand(turn: float, x: State, s: Scratch) -> None:
    """How the brush stands now, and when it has turned on by an angle."""
    s.sin_begin = sin(x.theta_b)
    s.cos_begin = cos(x.theta_b)
    s.sin_end = sin(x.theta_b + turn)
    s.cos_end = cos(x.theta_b + turn)


def at_begin(i: int, delta: float, p: Parameters, x: State, s: Scratch) -> Placement:
    """Filament i where the step begins, pressed in by delta."""
    return Placement(
        s.sin_begin * x.cos_at[i] + s.cos_begin * x.sin_at[i],
        s.cos_begin * x.cos_at[i] - s.sin_begin * x.sin_at[i],
        h_plane=p.R_brush - delta,
    )


def at_end(i: int, delta: float, p: Parameters, x: State, s: Scratch) -> Placement:
    """Filament i where the step ends, pressed in by delta."""
    return Placement(
        s.sin_end * x.cos_at[i] + s.cos_end * x.sin_at[i],
        s.cos_end * x.cos_at[i] - s.sin_end * x.sin_at[i],
        h_plane=p.R_brush - delta,
    )


def turn_by(angle: float) -> Turn:
    """Sine and cosine; of a small angle by their series, whose next term is below rounding."""
    q = angle * angle
    sine = angle * (1.0 - q * (1.0 / 6.0) * (1.0 - q * (1.0 / 20.0) * (1.0 - q * (1.0 / 42.0))))
    cosine = 1.0 - q * 0.5 * (1.0 - q * (1.0 / 12.0) * (1.0 - q * (1.0 / 30.0)))
    if q > 4e-4:
        sine = sin(angle)
        cosine = cos(angle)
    return Turn(sine, cosine)


def turned(at: Placement, turn: Turn, tau: float, u: Inputs) -> Placement:
    """How a filament stands after turning on for a time tau."""
    return Placement(
        at.sin_psi * turn.cosine + at.cos_psi * turn.sine,
        at.cos_psi * turn.cosine - at.sin_psi * turn.sine,
        h_plane=at.h_plane - u.delta_dot * tau,
    )
