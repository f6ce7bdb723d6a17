"""Names and literals of C: identifiers of components, cells and files, and numbers with all of their digits."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable

from ...plan.plan import Plan

WORDS = (
    "auto break case char const continue default do double else enum extern float for goto if inline int long register "
    "restrict return short signed sizeof static struct switch typedef union unsigned void volatile while main s z w at "
    "and or not xor class new delete this template t h v x n tail total found sent again seconds status_ k k_"
)
KEYWORDS = frozenset(re.findall(r"\w+", WORDS))


def identifier(text: str) -> str:
    """A text as a name of C: what is no letter, digit or _ becomes one _."""
    name = re.sub(r"\W+", "_", text, flags=re.ASCII).strip("_") or "x"
    return f"{name}_" if name in KEYWORDS else f"_{name}"[name[0].isalpha() :]


def identifiers(texts: Iterable[str], taken: Iterable[str] = ()) -> list[str]:
    """Names of C, each another one."""
    used, found = set(taken), []
    for text in texts:
        name = base = identifier(text)
        number = 2
        while name in used:
            name, number = f"{base}_{number}", number + 1
        used.add(name)
        found.append(name)
    return found


def number(value: float) -> str:
    """A double with all of its digits."""
    if math.isinf(value):
        return "INFINITY" if value > 0 else "-INFINITY"
    return repr(float(value))


def whole(value: int) -> str:
    """A whole number of 64 bits; those beyond the largest signed one by their bits."""
    value = value - 2**64 if value >= 2**63 else value
    return "INT64_MIN" if value == -(2**63) else f"INT64_C({value})"


def text(value: str) -> str:
    """A text in quotes."""
    escaped = "".join(
        f"\\{c}" if c in '"\\' else c if " " <= c < "\x7f" and c != "?" else "".join(f"\\{b:03o}" for b in c.encode())
        for c in value
    )
    return f'"{escaped}"'


def comment(value: str) -> str:
    """A text inside of a comment."""
    return value.replace("*/", "* /").replace("/*", "/ *").replace("\n", " ")


def cell_words(plan: Plan) -> list[str]:
    """What each cell of the run's vector is, in words: `motor.i`, `previous motor.i`, `loops` by their own names."""
    layout = plan.layout
    words = {slot: ".".join(key) for table in (layout.outputs, layout.inputs) for key, slot in table.items()}
    for before, table in (
        ("previous", layout.previous), ("twice previous", layout.before), ("integral for", layout.integrals),
        ("at the beginning", layout.begins),
    ):  # fmt: skip
        words |= {slot: f"{before} {'.'.join(key)}" for key, slot in table.items()}
    words |= {extra.slot: ".".join(key) for key, extra in layout.extras.items()}
    words |= layout.named
    return [words.get(slot, f"cell {slot}") for slot in range(layout.size)]
