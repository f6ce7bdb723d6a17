"""When a component that works at samples takes them: a sample belongs to the step that starts at it."""

from math import ceil


def first_sample(t: float, T_s: float) -> float:
    """Number of the first sample at or after t, whatever the rounding of t."""
    return ceil((t - 1e-6 * T_s) / T_s) * 1.0


def is_due(sample: float, t: float, h: float, T_s: float) -> bool:
    """Does the sample of this number fall into [t, t + h)?"""
    return sample * T_s < t + h - 1e-6 * T_s
