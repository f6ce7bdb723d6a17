"""What the tests of FMUs made with pythonfmu share: a started instance, its description, the component behind it."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from lxml import etree
from rovbrush.components.build import COMPONENTS
from rovbrush.orchestrator.fmu.fmu import Fmu
from rovbrush.orchestrator.participant.here.fmi2 import Fmi2Instance as Instance

H = 1e-3
every_component = pytest.mark.parametrize("name", COMPONENTS)


@contextmanager
def started(path: Path, **values: Any) -> Iterator[Instance]:
    """An instance at time 0."""
    instance = Instance(Fmu.open(path), "test")
    try:
        instance.set_up(10.0)
        instance.set_all(values)
        instance.enter_initialization()
        instance.exit_initialization()
        yield instance
    finally:
        instance.close()


def stir(instance: Instance, first: int, steps: int) -> list[list[float]]:
    """Steps with inputs that change all the time; the Real outputs after each."""
    described = instance.fmu.variables
    inputs = [v for v in instance.fmu.names("input") if described[v].type == "Real"]
    outputs = [v for v in instance.fmu.names("output") if described[v].type == "Real"]
    references = [described[v].valueReference for v in outputs]
    history = []
    for k in range(first, first + steps):
        for number, name in enumerate(inputs):
            instance.set(name, bounded(described[name], 0.01 * np.sin(0.3 * k + number)))
        instance.step(k * H, H)
        history.append(instance.slave.getReal(references))
    return history


def bounded(variable: Any, value: float) -> float:
    low = float(variable.min) if variable.min is not None else value
    high = float(variable.max) if variable.max is not None else value
    return min(max(value, low), high)


def declared(path: Path) -> etree._Element:
    with zipfile.ZipFile(path) as archive:
        return etree.fromstring(archive.read("modelDescription.xml"))
