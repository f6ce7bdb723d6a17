"""A linear model as others take it: python-control, and arrays in a file."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from rovbrush.orchestrator.studies.linear.statespace import Linear, write

A, B, C, D = np.array([[0.9, 0.1], [0.0, 0.5]]), np.array([[0.0], [1.0]]), np.array([[1.0, 0.0]]), np.array([[0.2]])
MODEL = Linear(A, B, C, D, 0.01, ("g.y -> p.u",), ("p.y",), ("N",), ("m",), (), 8.0, {"method": "pulses"})


def test_python_control_has_the_matrices_the_sample_and_the_response() -> None:
    control = pytest.importorskip("control")
    found = MODEL.statespace()
    assert isinstance(found, control.StateSpace) and found.dt == 0.01
    assert all(np.array_equal(getattr(found, name), getattr(MODEL, name)) for name in "ABCD")
    omega = np.array([0.1, 5.0, 100.0])
    assert np.allclose(np.squeeze(found(np.exp(1j * omega * 0.01))), MODEL.response(omega)[:, 0, 0], rtol=1e-12)


def test_arrays_come_back_bit_for_bit_without_pickle(tmp_path: Path) -> None:
    write([MODEL, MODEL], tmp_path)
    for name in ("linear.npz", "linear_2.npz"):
        with np.load(tmp_path / name, allow_pickle=False) as kept:
            assert all(np.array_equal(kept[key], getattr(MODEL, key)) for key in ("A", "B", "C", "D"))
            assert (float(kept["dt"]), float(kept["at"]), list(kept["inputs"])) == (0.01, 8.0, ["g.y -> p.u"])
