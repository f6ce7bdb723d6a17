"""Units of two connected variables: those that fit are converted, others refused."""

from __future__ import annotations

import re
import zipfile
from pathlib import Path

import pytest
from helpers import edited, last, read_system, run_of
from rovbrush.orchestrator.errors import InputError


def fmu_with_units(fmus: Path, folder: Path, name: str, renamed: dict[str, str]) -> str:
    """A copy with other units, of which it says nothing but their names."""
    with zipfile.ZipFile(fmus / f"{name}.fmu") as archive:
        text = archive.read("modelDescription.xml").decode()
    changes = {f'unit="{old}"': f'unit="{new}"' for old, new in renamed.items()}
    for old, new in renamed.items():
        defined = re.search(f'<Unit name="{re.escape(old)}">.*?</Unit>', text, re.DOTALL)
        assert defined
        changes[defined[0]] = f'<Unit name="{new}"/>'
    return str(edited(fmus / f"{name}.fmu", folder / f"{name}_{len(list(folder.iterdir()))}.fmu", {}, changes))


@pytest.mark.parametrize(
    ("source", "target", "value", "expected"),
    [
        ("m/s", "km/h", 10.0, 36.0), ("rpm", "rad/s", 60.0, 6.283185307179586), ("degC", "K", 20.0, 293.15),
        ("K", "degC", 0.0, -273.15), ("degF", "degC", 212.0, 100.0), ("N.m", "kN.m", 1500.0, 1.5),
        ("deg", "rad", 180.0, 3.141592653589793), ("N.m", "J", 2.0, 2.0), ("Ohm", "V/A", 3.0, 3.0),
        ("kg.m2", "g.cm2", 1.0, 1e7), ("rad", "1", 2.0, 2.0),
    ],
)  # fmt: skip
def test_units_that_fit_are_converted(
    source: str, target: str, value: float, expected: float, tmp_path: Path, fmus: Path
) -> None:
    a = fmu_with_units(fmus, tmp_path, "chassis", {"m/s": source})
    b = fmu_with_units(fmus, tmp_path, "wheel", {"m/s": target})
    system = read_system(tmp_path, fmus, {"c": (a, "1 ms", {"=F": 0.0}), "w": (b, "1 ms")}, ["c.v_c -> w.v_c"])
    connection = system.connections[0]
    assert connection.gain * value + connection.offset == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("source", "target", "hints"),
    [
        ("m/s", "N", ["the units do not fit: m/s cannot become N"]),
        ("m/s", "furlong/blip", ["unit 'furlong/blip' is not understood"]),
        ("Hz", "rad/s", ["Hz", "rad/s", "2 pi"]),
        ("rpm", "Hz", ["rpm", "Hz", "2 pi"]),
    ],
)
def test_units_that_do_not_fit_are_refused_with_the_line(
    source: str, target: str, hints: list[str], tmp_path: Path, fmus: Path
) -> None:
    a = fmu_with_units(fmus, tmp_path, "chassis", {"m/s": source})
    b = fmu_with_units(fmus, tmp_path, "wheel", {"m/s": target})
    with pytest.raises(InputError) as error:
        read_system(tmp_path, fmus, {"c": (a, "1 ms", {"=F": 0.0}), "w": (b, "1 ms")}, ["c.v_c -> w.v_c"])
    for hint in [*hints, "connection c.v_c -> w.v_c", "(case.toml, line 3)"]:
        assert hint in str(error.value)


def test_a_converted_signal_arrives_converted(tmp_path: Path, fmus: Path) -> None:
    fast = fmu_with_units(fmus, tmp_path, "wheel", {"m/s": "km/h"})
    parts = {"c": ("chassis", "1 ms", {"=F": -400.0}), "w": (fast, "1 ms", {"k_c": 0.0, "k_w": 0.0, "m_w": 1e6})}
    run = run_of(tmp_path, fmus, parts, ["c.v_c -> w.v_c"], algorithm="gauss-seidel", order=["c", "w"])
    # 1 m/s after 1 s is 3.6 km/h, which the damper multiplies by 1000; the wheel is too heavy to move away.
    assert last(run, "w.F") == pytest.approx(3600.0, rel=1e-2)
