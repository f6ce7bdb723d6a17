"""The names of a record's cells in C: `y[Outputs_F_z]`, and what is known of the arrays that records lie in."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from ..declare.layout import cells_name, cells_of
from ..declare.record import Field, fields_of
from ..lowering.functions import Function


def constants(records: Iterable[type[Any]]) -> str:
    """The numbers of all cells as one line of Python, for Pyccel to know the names."""
    return "; ".join(f"{one.__name__}_{key} = {at}" for one in records for key, at in cells_of(one).items())


def enumerations(records: Iterable[type[Any]]) -> str:
    """The same in C, each cell with its description and unit."""
    return "\n".join(
        f"/* {_first_line(record)} */\nenum {{\n"
        + "".join(
            f"    {record.__name__}_{key} = {at}, /* {_described(fields_of(record)[key])} */\n"
            for key, at in cells_of(record).items()
        )
        + "};\n"
        for record in records
    )


def unaliased(text: str, functions: Mapping[str, Function]) -> str:
    """Say `restrict` of the arrays of records: lowering refuses to give one twice where it is written.

    Without it a compiler must fear that each assignment changes all other arrays. Of packed records that are passed
    about within a step it holds too, but there it makes the code slower.
    """

    def signature(found: re.Match[str]) -> str:
        function = functions[found[1]]
        names = {f"{name}_{key}" for name in function.records for key in function.passed(name)}
        names |= {name for name, kind in function.records.items() if _lasts(kind)}
        return re.sub(
            r"double \*(\w+)", lambda one: f"double *{'restrict ' * (one[1] in names)}{one[1]}", found[0]
        )

    return re.sub(r"^static \w+ (\w+)\(.*\)$", signature, text, flags=re.MULTILINE)


def _lasts(record: type[Any]) -> bool:
    """Is it a record of state or outputs, rather than one that is passed about within a step?"""
    return not getattr(record, "packed", False) or cells_name(record) == "y"


def _first_line(record: type[Any]) -> str:
    return (record.__doc__ or record.__name__).strip().splitlines()[0]


def _described(field: Field) -> str:
    """`F_z: force along z_t [N]`, with the number of cells of an array."""
    shape = field.shape if isinstance(field.shape, tuple) else (field.shape,)
    cells = f"{' x '.join(map(str, shape))}: " if field.is_array else ""
    return f"{cells}{field.description} [{field.unit}]"
