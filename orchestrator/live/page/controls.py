"""A slider, a switch, a choice or a field for one input."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from nicegui import ui

from ..messages import Input

EVERY = 0.1  # s between two values of a slider that is dragged
STEPS = 200  # of a slider

Give = Callable[[Any], object]


@dataclass
class Control:
    """`show` has it stand at a value without giving that to the run."""

    elements: list[Any]
    start: Any
    show: Callable[[Any], object]


def control_of(entry: Input, give: Give) -> Control:
    """The elements for an input; `give` is called with what a viewer chooses."""
    with ui.element("div").classes("input").props(f'data-input="{entry.name}"'):
        unit = f" [{entry.unit}]" if entry.unit not in ("", "1") else ""
        name = ui.label(f"{entry.label}{unit}").classes("name")
        if entry.description or entry.label != entry.name:
            name.tooltip(f"{entry.name}: {entry.description}".rstrip(": "))
        if entry.choices:
            return _choice(entry, give)
        if entry.kind == "switch":
            return _switch(entry, give)
        return _text(entry, give) if entry.kind == "text" else _number(entry, give)


def _number(entry: Input, give: Give) -> Control:
    whole = entry.kind == "whole"
    low, high = (math.floor(entry.low), math.ceil(entry.high)) if whole else (entry.low, entry.high)
    step = max((high - low) // STEPS, 1) if whole else (high - low) / STEPS
    value: Any = entry.value
    slider = ui.slider(min=low, max=high, step=step, value=value).props("dense")
    field = ui.number(value=value).props("dense outlined")

    def give_it(given: Any) -> None:
        if given is not None:
            give(int(given) if whole else float(given))

    def slid(event: Any) -> None:
        field.set_value(event.args)
        give_it(event.args)

    def typed() -> None:
        if field.value is not None:
            slider.set_value(min(max(field.value, low), high))
            give_it(field.value)

    slider.on("update:model-value", slid, throttle=EVERY)
    field.on("change", typed)

    def show(known: Any) -> None:
        slider.set_value(min(max(known, low), high))
        field.set_value(known)

    return Control([slider, field], value, show)


def _switch(entry: Input, give: Give) -> Control:
    switch = ui.switch(value=bool(entry.value))
    switch.on("update:model-value", lambda: give(bool(switch.value)))
    return Control([switch], bool(entry.value), switch.set_value)


def _choice(entry: Input, give: Give) -> Control:
    options = {number: label for label, number in entry.choices.items()}
    toggle = ui.toggle(options, value=entry.value if entry.value in options else None).props("dense no-caps")
    toggle.on("update:model-value", lambda: toggle.value is not None and give(toggle.value))
    return Control([toggle], entry.value, lambda value: toggle.set_value(value if value in options else None))


def _text(entry: Input, give: Give) -> Control:
    field = ui.input(value=str(entry.value)).props("dense outlined")
    field.on("change", lambda: give(field.value))
    return Control([field], str(entry.value), field.set_value)
