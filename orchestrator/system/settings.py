"""The algorithms that couple the components: what they are, and their settings.

gauss-seidel   one after the other in an order; an input takes the latest values
jacobi         all at once: an input takes values of the beginning of its step
iterated       every macro step is repeated from saved states until the inputs are the mean of what their sources
               gave at both ends of the step: second order, and no energy is made at a power bond
ecco           Jacobi with macro steps that a controller lengthens and shortens by the energy that the power bonds
               make: S. Sadjina, L. T. Kyllingstad, S. Skjong, E. Pedersen, Energy conservation and power bonds in
               co-simulations, Engineering with Computers 33 (2017) 607-620

Only floating-point signals are averaged, extrapolated or iterated upon; any other one is held, over an iterated step
at its value of the beginning.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ..clock import duration
from ..errors import InputError, nearest
from ..toml_file import TomlFile

ALGORITHMS = ("gauss-seidel", "jacobi", "iterated", "ecco")
TRANSFERS = ("hold", "linear", "quadratic", "interpolate", "mean")
METHODS = ("aitken", "newton")


@dataclass(frozen=True)
class Iteration:
    """`[iteration]`: the residual of an input is relative to its size, or to its nominal value where that is larger."""

    method: str = "aitken"
    tolerance: float = 1e-8
    max_iterations: int = 50


@dataclass(frozen=True)
class Ecco:
    """`[ecco]`: energy tolerances, limits of the step [s] and the gains of the step controller."""

    tolerance: float = 1e-3  # J
    relative: float = 1e-2  # of the energy that a bond carries over a step
    minimum: Fraction | None = None  # a hundredth of the period where nothing is stated
    maximum: Fraction | None = None  # a hundred periods where nothing is stated
    safety: float = 0.8
    integral: float = 0.15
    proportional: float = 0.2
    shrink: float = 0.2
    grow: float = 1.5


def iteration_of(file: TomlFile) -> Iteration:
    """The table `[iteration]`. Raises InputError for an unknown key or a value out of range."""
    table = _table(file, "iteration", Iteration)
    method = table.pop("method", "aitken")
    if method not in METHODS:
        raise file.fail(f"iteration: unknown method '{method}'{nearest(str(method), METHODS)}", "method", "iteration")
    count = table.pop("max_iterations", Iteration.max_iterations)
    if isinstance(count, bool) or not isinstance(count, int) or count < 1:
        raise file.fail(
            f"iteration: max_iterations = {count!r} must be a whole number above 0", "max_iterations", "iteration"
        )
    return Iteration(method, max_iterations=count, **_numbers(file, "iteration", table))


def ecco_of(file: TomlFile) -> Ecco:
    """The table `[ecco]`. Raises InputError for an unknown key or a value out of range."""
    table = _table(file, "ecco", Ecco)
    limits: dict[str, Any] = {}
    for key in ("minimum", "maximum"):
        if key in table:
            try:
                limits[key] = duration(table.pop(key), f"ecco: {key}")
            except InputError as error:
                raise file.fail(str(error), key, "ecco") from None
    found = Ecco(**limits, **_numbers(file, "ecco", table))
    if not found.shrink < 1.0 < found.grow:
        raise file.fail(f"ecco: shrink = {found.shrink:g} must be below 1 and grow = {found.grow:g} above", "ecco")
    return found


def _table(file: TomlFile, name: str, kind: type[Any]) -> dict[str, Any]:
    table: dict[str, Any] = dict(file.entry(dict, name))
    for key in table:
        if key not in kind.__dataclass_fields__:
            raise file.fail(f"{name}: unknown key '{key}'{nearest(key, kind.__dataclass_fields__)}", key, name)
    return table


def _numbers(file: TomlFile, name: str, table: dict[str, Any]) -> dict[str, Any]:
    for key, value in table.items():
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0.0 < value < float("inf"):
            raise file.fail(f"{name}: {key} = {value!r} must be a number above 0", key, name)
    return {key: float(value) for key, value in table.items()}


def explain_algorithm(algorithm: str, iteration: Iteration) -> str:
    """One line on what an algorithm does."""
    return {
        "gauss-seidel": "one after the other, inputs from the latest values",
        "jacobi": "all at once, inputs from the beginning of the step",
        "iterated": f"each macro step repeated from saved states ({iteration.method}, at most "
        f"{iteration.max_iterations} times) until every input is the mean of both ends of its step within "
        f"{iteration.tolerance:g}",
        "ecco": "all at once; the macro step follows from the energy that the coupling makes at the power bonds",
    }[algorithm]
