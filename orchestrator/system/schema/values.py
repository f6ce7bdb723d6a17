"""The kinds of values that several files share."""

from __future__ import annotations

import sys
from typing import Annotated

from msgspec import Meta

LARGEST = sys.float_info.max  # the bound that keeps infinity out

Time = Annotated[
    str | int | float,
    Meta(
        examples=["5 ms", "1/60 s", 0.005],
        extra_json_schema={"pattern": r"^\s*[+]?[0-9.]+([eE][+-]?[0-9]+)?(/[0-9]+)?\s*(s|ms|us|ns)?\s*$"},
        extra={"must": 'a time: a number of seconds, "5 ms", "250 us" or "1/60 s"'},
    ),
]
Number = Annotated[float, Meta(ge=-LARGEST, le=LARGEST)]
Positive = Annotated[float, Meta(gt=0, le=LARGEST)]
Count = Annotated[int, Meta(ge=1)]
Value = bool | int | float | str
Values = dict[str, Value | list[Value]]
# An operation and its signals: see `results/summary`.
FigureOfMerit = Annotated[
    str, Meta(pattern=r"\S", extra={"must": 'text: an operation and its signals, such as "mean motor.i"'})
]
