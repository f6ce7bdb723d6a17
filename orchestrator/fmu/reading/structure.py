"""Structural parameters (FMI 3.0): they give the sizes of arrays, and are set before all others, in Configuration Mode.

A start value that an array states for every element counts for any size; several, one for each element, count for the
size that they were stated for only: elements of an array of another size have none then.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from attrs import evolve
from fmpy.model_description import ModelDescription, ModelVariable

from ..types import Value

STRUCTURAL = "structuralParameter"


def resize(
    description: ModelDescription, texts: Mapping[str, list[str]], values: Mapping[str, Value]
) -> tuple[ModelDescription, dict[str, list[str]]]:
    """A description, and the start values of its texts, in which structural parameters have other values."""
    known: dict[str, Value] = {}
    for v in description.modelVariables:
        name = v.name if v.alias is None else v.alias.name
        if v.name in values:
            known[name] = values[v.name]
    texts = dict(texts)
    variables = [_resized(v, known, texts) for v in description.modelVariables]
    return evolve(description, modelVariables=variables), texts


def _resized(v: ModelVariable, values: Mapping[str, Value], texts: dict[str, list[str]]) -> ModelVariable:
    own = v.name if v.alias is None else v.alias.name
    if own in values:
        value: Any = values[own]
        return evolve(v, start=str(value).lower() if isinstance(value, bool) else str(value))
    shape = tuple(
        size if d.variable is None or d.variable.name not in values else int(values[d.variable.name])
        for d, size in zip(v.dimensions, v.shape or (), strict=True)
    )
    if shape == v.shape:
        return v
    starts = texts.get(own, (v.start or "").split())
    if len(starts) == 1:
        return evolve(v, shape=shape)
    if own in texts:
        texts[own] = []
    return evolve(v, shape=shape, start=None)


def resized_variables(before: ModelDescription, after: ModelDescription) -> list[str]:
    """The arrays that have another shape now, by their own names."""
    pairs = zip(before.modelVariables, after.modelVariables, strict=True)
    return [b.name for a, b in pairs if a.shape != b.shape and b.alias is None]
