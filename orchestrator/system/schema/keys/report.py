"""The keys of what a system file wants reported: see `results`."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta, Struct, field

from .values import LARGEST

Number = Annotated[float, Meta(ge=-LARGEST, le=LARGEST, extra={"says": "{key} = {value} is not a number"})]


class Window(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The steady window of the figures of merit."""

    angle: Annotated[str | None, Meta(description="a signal [rad] of which the window holds whole turns")] = None
    start: Annotated[Number | None, Meta(description="where it begins [s]; else with the run")] = None
    end: Annotated[Number | None, Meta(description="where it ends [s]; else with the run")] = None


class Balance(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The energies of the whole system, by the outputs that count them [J]."""

    supplied: Annotated[list[str], Meta(description="what comes in")] = []
    lost: Annotated[list[str], Meta(description="what goes out")] = []
    stored: Annotated[list[str], Meta(description="what is kept")] = []


class Comparison(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A figure of merit beside its reference."""

    label: Annotated[str, Meta(description="what the table calls it")]
    value: Annotated[str, Meta(description="the figure of merit")]
    unit: Annotated[str, Meta(description="of both")]
    reference: Annotated[Number, Meta(description="another number than 0")]
    tolerance: Annotated[Number | None, Meta(description="relative; without one there is no verdict")] = None
    note: Annotated[str, Meta(description="a remark for the reader")] = ""


class Figure(Struct, frozen=True, kw_only=True):
    """A figure of signals over time, of arrays along another, or of a kind that a package adds with keys of its own."""

    file: Annotated[str, Meta(description="a plain name that ends in .png, .pdf or .svg")]
    title: Annotated[str, Meta(description="what stands above it")]
    signals: Annotated[list[str], Meta(description="what is drawn, `component.variable`")] = []
    from_: Annotated[Number | None, Meta(description="where the time axis begins [s]")] = field(
        name="from", default=None
    )
    to: Annotated[Number | None, Meta(description="where the time axis ends [s]")] = None
    reference: Annotated[Number | None, Meta(description="a line at this value")] = None
    along: Annotated[
        str | None,
        Meta(
            description="an array, outputs or calculated parameters: the signals, arrays of as many elements, are "
            "drawn along it, as they are at the end of the run"
        ),
    ] = None
    at: Annotated[
        list[Number],
        Meta(
            description="with `along`: instants [s] in place of the end, of which those are shown that the run reaches"
        ),
    ] = []
    table: Annotated[
        str | None, Meta(description="with `along`: a plain name that ends in .csv, of a table of what is drawn")
    ] = None
    kind: Annotated[str | None, Meta(description="of another figure, by the name of its entry point")] = None
