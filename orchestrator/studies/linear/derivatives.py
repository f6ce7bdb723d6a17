"""A, B, C, D of one FMU that says which its states are: by directional derivatives where offered, else by differences.

FMI 2.0 sections 2.1.9 and 2.2.7, FMI 3.0 section 2.2.11. In co-simulation states cannot be set, so there they must be
offered.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...errors import FmuError
from ...fmu.fmu import Fmu
from ...fmu.kinds import CO_SIMULATION
from ...fmu.reading.states import derivative_names, state_names
from ...integration.stiff.offered import offers_directional
from ...loop.versions import signatures
from ...participant.here.loaded import LoadedInstance
from ...participant.lifecycle import good

STEP = 6e-6  # of a state's or an input's size: the cube root of the rounding of doubles, best for central differences
GET_DERIVATIVES = {1: "GetDerivatives", 2: "GetDerivatives", 3: "GetContinuousStateDerivatives"}


@dataclass(frozen=True)
class Local:
    """Of one FMU: A (n, n), B (n, m), C (p, n), D (p, m); its states [x] and their rates now."""

    A: np.ndarray
    B: np.ndarray
    C: np.ndarray
    D: np.ndarray
    x: np.ndarray
    rates: np.ndarray
    how: str  # "directional derivatives" or "differences"


def why_no_states(fmu: Fmu) -> str:
    """Why an FMU gives no A, B, C, D of its own; empty where it does."""
    if fmu.kind == CO_SIMULATION:
        if not fmu.own.description.derivatives:
            return "does not list its states (ModelStructure)"
        if not offers_directional(fmu) or not plain(fmu, derivative_names(fmu)):
            return "lists its states but offers no directional derivatives"
    return ""


def plain(fmu: Fmu, names: Sequence[str]) -> bool:
    """Whether directional derivatives can be asked for by the names of scalars."""
    return fmu is fmu.own and all(fmu.places[v].count == 1 and not fmu.places[v].negated for v in names)


def local(instance: LoadedInstance, inputs: Sequence[str], outputs: Sequence[str]) -> Local:
    """Of an instance at an instant. Inputs, outputs: its scalars. Raises FmuError where it refuses."""
    fmu = instance.fmu
    stated = {name for unknown in fmu.own.description.outputs for name in fmu.own.expand(unknown.variable.name)}
    known = [*state_names(fmu), *inputs]
    asked = [name for name in outputs if name not in known]
    by_call = offers_directional(fmu) and plain(fmu, [*inputs, *outputs, *derivative_names(fmu)])
    if fmu.kind == CO_SIMULATION or (by_call and stated.issuperset(asked)):
        return _directional(instance, inputs, outputs)
    return _differences(instance, inputs, outputs)


def _directional(instance: LoadedInstance, inputs: Sequence[str], outputs: Sequence[str]) -> Local:
    fmu = instance.fmu
    states, slopes = state_names(fmu), derivative_names(fmu)
    known = [*states, *inputs]
    asked = [*slopes, *(name for name in outputs if name not in known)]
    columns = np.zeros((len(slopes) + len(outputs), len(known)))
    rows = [*range(len(slopes)), *(len(slopes) + k for k, name in enumerate(outputs) if name not in known)]
    for j, name in enumerate(known):
        columns[rows, j] = _derivative(instance, asked, name)
        columns[[len(slopes) + k for k, output in enumerate(outputs) if output == name], j] = 1.0
    n = len(states)
    x, rates = (np.array([float(instance.get_own(v)) for v in names]) for names in (states, slopes))
    return Local(*_parts(columns, n), x, rates, "directional derivatives")


def _derivative(instance: LoadedInstance, unknowns: Sequence[str], known: str) -> np.ndarray:
    """The change of unknowns with one that is known."""
    places = instance.fmu.own.places
    refs = np.array([places[name].reference for name in unknowns], dtype=np.uint32)
    ref, seed, out = np.array([places[known].reference], dtype=np.uint32), np.ones(1), np.zeros(len(unknowns))
    function = instance.address(f"{instance.prefix}GetDirectionalDerivative")
    arguments: list[Any] = [instance.pointer, refs.ctypes.data, len(refs), ref.ctypes.data, 1, seed.ctypes.data]
    arguments += [out.ctypes.data] if signatures(instance.fmu.version) == 2 else [1, out.ctypes.data, len(out)]
    _ask(instance, "give directional derivatives", function, *arguments)
    return out


def _differences(instance: LoadedInstance, inputs: Sequence[str], outputs: Sequence[str]) -> Local:
    fmu, n = instance.fmu, len(state_names(instance.fmu))
    x = _vector(instance, "GetContinuousStates", n)
    nominal = _vector(
        instance, "GetNominalContinuousStates" if fmu.version == 1 else "GetNominalsOfContinuousStates", n
    )

    def all_of() -> np.ndarray:
        rates = _vector(instance, GET_DERIVATIVES[fmu.version], n)
        return np.concatenate([rates, [float(instance.get(name)) for name in outputs]])

    def set_states(values: np.ndarray) -> None:
        _vector(instance, "SetContinuousStates", n, values)

    def push(k: int, value: float) -> Callable[[float], None]:
        return lambda d: set_states(x + d * np.eye(n)[k]) if k < n else instance.set(inputs[k - n], value + d)

    rates = all_of()[:n]
    values = [*x.tolist(), *(float(instance.get(name)) for name in inputs)]
    stated = [abs(float(fmu.variables[name].nominal or 0.0)) or 1.0 for name in inputs]
    sizes = np.maximum(np.abs(values), [*(abs(v) or 1.0 for v in nominal.tolist()), *stated])
    columns = []
    for k, (value, size) in enumerate(zip(values, sizes.tolist(), strict=True)):
        columns.append(_central(push(k, value), all_of, STEP * size))
        push(k, value)(0.0)
    table = np.array(columns).T if columns else np.zeros((n + len(outputs), 0))
    return Local(*_parts(table, n), x, rates, f"central differences, steps of {STEP:g} of each value")


def _central(move: Callable[[float], None], read: Callable[[], np.ndarray], step: float) -> np.ndarray:
    move(step)
    plus = read()
    move(-step)
    column: np.ndarray = (plus - read()) / (2.0 * step)
    return column


def _parts(table: np.ndarray, n: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    return table[:n, :n], table[:n, n:], table[n:, :n], table[n:, n:]


def _vector(instance: LoadedInstance, what: str, size: int, values: np.ndarray | None = None) -> np.ndarray:
    """The continuous states of an FMU, or what belongs to each of them; set to `values` where these are given."""
    array = np.zeros(size) if values is None else np.ascontiguousarray(values, dtype=float)
    if size:
        function = instance.address(f"{instance.prefix}{what}")
        _ask(instance, what, function, instance.pointer, array.ctypes.data, size)
    return array


def _ask(instance: LoadedInstance, what: str, function: int, *arguments: Any) -> None:
    """Call a function of FMI by its address; whole numbers are addresses or counts. Raises FmuError."""
    kinds = [ctypes.c_void_p if k == 0 or value > 2**31 else ctypes.c_size_t for k, value in enumerate(arguments)]
    status = ctypes.CFUNCTYPE(ctypes.c_int, *kinds)(function)(*arguments)
    if not good(status):
        raise FmuError(f"component {instance.name}: cannot {what}{instance.reasons()}")
