"""The keys of the page of a live run: what it offers first, its charts, and what is drawn in three dimensions."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta, Struct, field

from .values import Number, Positive

Place = Number | str


class LiveControl(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A free input or a tunable parameter that the page shows first."""

    input: Annotated[str, Meta(description="its name, `component.variable`")]
    label: Annotated[str, Meta(description="what the page calls it; else its name")] = ""
    low: Annotated[Number | None, Meta(description="where its slider begins")] = None
    high: Annotated[Number | None, Meta(description="where its slider ends")] = None
    choices: Annotated[dict[str, Number], Meta(description="in place of a slider: values by what they are called")] = {}


class LivePart(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A part of the scene. Numbers may be names: of outputs, which it follows, or parameters; an array stands for all
    of its elements. Lengths in metres, in the frame of the part that it is `on`; the world is north, east, down."""

    shape: Annotated[
        Literal["box", "cylinder", "plane", "arrow", "jet", "patches"],
        Meta(
            description="a box of `size`; a cylinder, `size` is radius and length, about the y axis; a plane, across "
            "`along`; an arrow or the jet of a thruster along `along`, `value` times `scale` long; patches in a row "
            "from `at` to `to` that vanish where the part `under` comes by while `when` is positive"
        ),
    ]
    name: Annotated[str, Meta(description="for parts that are on it")] = ""
    on: Annotated[str, Meta(description="the part that it moves with; else it stands in the world")] = ""
    at: Annotated[list[Place], Meta(description="where it is")] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    to: Annotated[list[Place], Meta(description="where a row of patches ends")] = []
    attitude: Annotated[
        list[Place], Meta(description="a quaternion, scalar first, or the nine elements of a rotation matrix, by rows")
    ] = []
    turn: Annotated[str, Meta(description="the angle [rad] by which it has turned about its y axis")] = ""
    size: Annotated[list[Place], Meta(description="its sizes; of patches along and across")] = []
    along: Annotated[list[Place], Meta(description="a direction, or a vector with its length")] = []
    value: Annotated[Place, Meta(description="what `along` is multiplied by")] = 1.0
    scale: Annotated[Positive, Meta(description="metres per unit of an arrow or a jet")] = 1.0
    count: Annotated[int, Meta(ge=1, le=2000, description="how many patches")] = 40
    under: Annotated[str, Meta(description="the part that wipes patches off")] = ""
    when: Annotated[str, Meta(description="an output that is positive while it does")] = ""
    color: Annotated[str, Meta(pattern="^#[0-9a-f]{6}$", description="as `#2f7ebc`")] = "#7d8590"
    opacity: Annotated[float, Meta(ge=0, le=1, description="1: nothing is seen through it")] = 1.0
    follow: Annotated[bool, Meta(description="the eye goes with it")] = False


class LiveTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What `rovbrush live` shows of a system beside what it shows of any."""

    charts: Annotated[list[list[str]], Meta(description="outputs, chart by chart; else those of the figures")] = []
    controls: Annotated[list[LiveControl], Meta(description="what the page offers first")] = []
    scene: Annotated[list[LivePart], Meta(description="what is drawn in three dimensions")] = []
