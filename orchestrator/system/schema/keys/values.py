"""The kinds of values that several files share."""

from __future__ import annotations

import sys
from fractions import Fraction
from typing import Annotated

from msgspec import Meta

LARGEST = sys.float_info.max  # the bound that keeps infinity out

TIME = r"^\s*[+]?[0-9.]+([eE][+-]?[0-9]+)?(/[0-9]+)?\s*(s|ms|us|ns)?\s*$"
Time = Annotated[
    str | int | float,
    Meta(
        examples=["5 ms", "1/60 s", 0.005],
        extra_json_schema={"pattern": TIME},
        extra={"must": 'a time: a number of seconds, "5 ms", "250 us" or "1/60 s"'},
    ),
]
INSTANT = TIME.replace("[+]?", "[+-]?", 1)
Instant = Annotated[
    str | int | float,
    Meta(
        examples=["2 s", 0, "-0.5 s"],
        extra_json_schema={"pattern": INSTANT},
        extra={"must": 'a time, also 0 or a negative one: a number of seconds, "2 s", "-5 ms" or "1/60 s"'},
    ),
]
Span = Fraction  # a time that is read at once, and exact
Number = Annotated[float, Meta(ge=-LARGEST, le=LARGEST)]
Positive = Annotated[float, Meta(gt=0, le=LARGEST)]
Count = Annotated[int, Meta(ge=1)]
Seed = Annotated[int, Meta(ge=0, le=2**63 - 1, extra={"must": "a whole number from 0 to 2^63 - 1"})]
Value = bool | int | float | str
Values = dict[str, Value | list[Value]]
ParameterFile = Annotated[
    dict[str, Values],
    Meta(
        description="A table `[COMPONENT]` of values for each component, and `description`, a text: what `parameters` "
        "in a system file names. Tables for components that the system does not have are left out. Values of the "
        "system's own file come over those of a set; a set with `base`, a text, comes over them: what a study found, "
        'such as `fitted.toml`. `base` names the set below both, as `parameters` does; `""` is that of the system.',
        extra_json_schema={
            "properties": {
                "description": {"type": "string", "description": "of the set, in a line"},
                "base": {
                    "type": "string",
                    "description": "the set below one whose values come over those of the system's own file",
                },
            }
        },
    ),
]
UnitFile = Annotated[
    dict[str, str],
    Meta(description='A line `variable = "unit"` each: what `units` under `[components.NAME]` names.'),
]
# An operation and its signals: see `results/summary`.
FigureOfMerit = Annotated[
    str, Meta(pattern=r"\S", extra={"must": 'text: an operation and its signals, such as "mean motor.i"'})
]
