"""A linear model: x' = A x + B u, y = C x + D u, in continuous time or from sample to sample."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import InputError
from ...files import write_file, write_json


@dataclass(frozen=True)
class Pole:
    """An eigenvalue of A, as what it is in continuous time: `s` [1/s]. `z`: of a sampled model, else None."""

    s: complex
    z: complex | None

    @property
    def frequency(self) -> float:
        """|s| / 2 pi [Hz]."""
        return abs(self.s) / (2.0 * np.pi)

    @property
    def damping(self) -> float:
        """-Re s / |s|: 1 decays without swinging, 0 swings for ever, below 0 grows; 1 of a pole at s = 0."""
        return float(-self.s.real / abs(self.s)) if self.s else 1.0

    @property
    def magnitude(self) -> float:
        """|z|: by how much it shrinks in a sample; of a continuous model |s|."""
        return abs(self.s if self.z is None else self.z)


@dataclass(frozen=True)
class Linear:
    """Deviations from an operating point: A (n, n), B (n, m), C (p, n), D (p, m).

    `dt`: the sample [s], over which inputs are held; 0 in continuous time. `inputs`, `outputs`: names, with units.
    `states`: names where the states are an FMU's own. `at`: the time of the operating point [s].
    """

    A: np.ndarray
    B: np.ndarray
    C: np.ndarray
    D: np.ndarray
    dt: float
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    input_units: tuple[str, ...] = ()
    output_units: tuple[str, ...] = ()
    states: tuple[str, ...] = ()
    at: float = 0.0
    notes: dict[str, Any] = field(default_factory=dict)  # how it was found, ready for JSON

    @property
    def order(self) -> int:
        """How many states it has."""
        return len(self.A)

    @property
    def poles(self) -> list[Pole]:
        """All of them, the slowest first."""
        values = np.linalg.eigvals(self.A) if self.order else np.zeros(0)
        if self.dt == 0.0:
            found = [Pole(complex(s), None) for s in values]
        else:
            smallest = np.finfo(float).tiny  # a pole at z = 0 has no logarithm: it is gone after a sample
            found = [Pole(complex(np.log(complex(z) or smallest) / self.dt), complex(z)) for z in values]
        return sorted(found, key=lambda pole: (round(abs(pole.s), 9), pole.s.imag))

    @property
    def stable(self) -> bool:
        """Whether all that was disturbed dies out."""
        return all(pole.s.real < 0.0 for pole in self.poles)

    def response(self, omega: np.ndarray) -> np.ndarray:
        """The frequency response (frequencies, p, m) at angular frequencies [rad/s], of a sampled model at
        z = exp(i omega dt)."""
        at = 1j * omega if self.dt == 0.0 else np.exp(1j * omega * self.dt)
        identity = np.eye(self.order)
        found = np.empty((len(omega), *self.D.shape), dtype=complex)
        for k, value in enumerate(at):
            found[k] = self.C @ np.linalg.solve(value * identity - self.A, self.B) + self.D if self.order else self.D
        return found

    def pulses(self, count: int) -> np.ndarray:
        """Markov parameters (count, p, m) of a sampled model: D, C B, C A B, ..."""
        found = np.zeros((count, *self.D.shape))
        state = self.B
        for k in range(count):
            found[k] = self.D if k == 0 else self.C @ state
            state = state if k == 0 else self.A @ state
        return found

    def sampled(self, dt: float) -> Linear:
        """A continuous model with inputs held over `dt` [s]: by the matrix exponential, exactly (Van Loan 1978)."""
        from dataclasses import replace

        from scipy.linalg import expm

        n, m = self.B.shape
        both = expm(np.block([[self.A, self.B], [np.zeros((m, n + m))]]) * dt)
        return replace(self, A=both[:n, :n], B=both[:n, n:], dt=dt)

    def statespace(self) -> Any:
        """As `control.StateSpace` (python-control). Raises InputError if that is not installed."""
        try:
            import control
        except ImportError:
            raise InputError("python-control is not installed: pip install 'rovbrush[linearise]'") from None
        return control.StateSpace(
            self.A, self.B, self.C, self.D, self.dt,
            inputs=[_plain(name) for name in self.inputs], outputs=[_plain(name) for name in self.outputs],
            **({"states": [_plain(name) for name in self.states]} if self.states else {}),
        )  # fmt: skip

    def content(self) -> dict[str, Any]:
        """Ready for JSON."""
        return {
            "at": self.at, "dt": self.dt, "inputs": list(self.inputs), "input_units": list(self.input_units),
            "outputs": list(self.outputs), "output_units": list(self.output_units), "states": list(self.states),
            "A": self.A.tolist(), "B": self.B.tolist(), "C": self.C.tolist(), "D": self.D.tolist(),
            "poles": [
                {"s": [p.s.real, p.s.imag], "z": None if p.z is None else [p.z.real, p.z.imag],
                 "frequency_Hz": p.frequency, "damping": p.damping, "magnitude": p.magnitude}
                for p in self.poles
            ],
            **self.notes,
        }  # fmt: skip


def _plain(name: str) -> str:
    """A name that python-control takes: dots mean systems to it."""
    return name.replace(".", "_").replace(" -> ", "_to_")


def write(models: Sequence[Linear], folder: Path) -> list[Path]:
    """Models at rising times as `linear.json`, and each as `linear.npz`, `linear_2.npz`, ...; the paths."""
    paths = [write_file(folder / "linear.json", lambda p: write_json(p, [model.content() for model in models]))]
    for k, model in enumerate(models):
        arrays = {"A": model.A, "B": model.B, "C": model.C, "D": model.D, "dt": model.dt, "at": model.at}
        names = {key: np.array(getattr(model, key), dtype=str) for key in ("inputs", "outputs", "states")}
        file = folder / ("linear.npz" if k == 0 else f"linear_{k + 1}.npz")
        paths.append(write_file(file, lambda p, a=arrays, n=names: np.savez(p, **a, **n)))  # type: ignore[misc]
    return paths
