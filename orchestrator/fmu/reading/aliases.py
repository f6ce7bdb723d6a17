"""Which variables are other names of one: an Alias of FMI 3.0, and what can be set under one value reference.

Whoever sets two names of one value sets it twice, and the second would undo the first: they are one variable.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable

from fmpy.model_description import ModelVariable

BASE = {"Enumeration": "Integer"}  # types that share their references in FMI 1.0 and 2.0


def other_names(variables: Iterable[ModelVariable], negated: Collection[str] = ()) -> dict[str, str]:
    """The variables that are other names, and of which variable each is one.

    `negated`: those of FMI 1.0 that are another one with the other sign, which keep a name of their own.
    """
    found: dict[str, str] = {}
    first: dict[tuple[str, str, int], str] = {}
    for v in variables:
        if v.alias is not None:
            found[v.name] = v.alias.name
        elif v.causality in ("input", "parameter") and v.name not in negated:
            key = v.causality, BASE.get(v.type, v.type), v.valueReference
            if (name := first.setdefault(key, v.name)) != v.name:
                found[v.name] = name
    return found
