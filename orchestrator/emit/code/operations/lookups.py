"""Operations that look into tables, as C: inputs that follow tables of times, and types that hold some values only."""

from __future__ import annotations

import numpy as np

from ....loop.operations import (
    FIT,
    SAMPLE,
    SERIES,
)
from ..exchange import Names, indented
from ..names import at, number, whole
from .cost import Row


class Lookups:
    """Their lines, and the tables. `step`: what is added to the length of a step."""

    HOW = {FIT: "fit", SERIES: "series", SAMPLE: "sample"}  # noqa: RUF012

    def __init__(self, names: Names, step: str) -> None:
        self.names, self.plan, self.step = names, names.plan, step
        self.tables: dict[int, str] = {}  # where a table lies in the coefficients, and its name in C
        self.of_wholes: set[int] = set()  # those of whole numbers
        self.items: dict[tuple[int, ...], str] = {}

    def fit(self, row: Row, _tick: int) -> list[str]:
        _, _, _, a, b, p, q, k = row
        c = self.plan.coefficients[k : k + 4 + 2 * q].tolist()
        source = self.names.cells[a]
        value = f"rint({number(c[0])} * z[{source}] + {number(c[1])})" if p else f"(double)w[{source}]"
        cell = "n >= 0x1p63 ? (int64_t)(n - 0x1p64) : (int64_t)n" if p else f"w[{source}]"
        lines = [f"const double n = {value};",
                 f"if (!({number(c[2])} <= n && n < {number(c[3])})) return unfit(s, {self.names.cells[b]});",
                 f"const int64_t found = {cell};"]  # fmt: skip
        if q:
            items = tuple((int(c[4 + 2 * j]) << 32) | int(c[5 + 2 * j]) for j in range(q))
            name = self.items.setdefault(items, f"ITEMS_{len(self.items)}")
            lines.append(f"if (!among(found, {name}, {q})) return unfit(s, {self.names.cells[b]});")
        return ["{", *indented([*lines, f"w[{self.names.cells[b]}] = found;"]), "}"]

    def series(self, row: Row, tick: int) -> list[str]:
        _, _, _, _, b, p, q, k = row
        begin, end = f"seconds({at(p - tick)})", f"seconds({at(p + q - tick)}{self.step})"
        return [f"z[{self.names.cells[b]}] = mean_over({self._table(k)}, {begin}, {end});"]

    def sample(self, row: Row, tick: int) -> list[str]:
        _, _, _, _, b, p, _, k = row
        table, time = self._table(k), f"seconds({at(p - tick)})"
        if not self.names.whole[b]:
            return [f"z[{self.names.cells[b]}] = held_at({table}, {time});"]
        self.of_wholes.add(k)
        return [f"w[{self.names.cells[b]}] = {table}_WHOLE[row_at({table}, {time})];"]

    def _table(self, k: int) -> str:
        return self.tables.setdefault(k, f"TABLE_{len(self.tables)}")

    def constants(self) -> list[str]:
        """The tables that rows look into."""
        lines = []
        for k, name in self.tables.items():
            rows = int(self.plan.coefficients[k])
            numbers, values = np.split(self.plan.coefficients[k : k + 1 + 2 * rows], [1 + rows])
            if k in self.of_wholes:
                # Their bits are whole numbers. As doubles they could be no numbers, of which C writes one for all.
                found = ", ".join(map(whole, values.view(np.int64).tolist()))
                lines.append(f"static const int64_t {name}_WHOLE[] = {{{found}}};")
            else:
                numbers = np.concatenate([numbers, values])
            lines.append(f"static const double {name}[] = {{{', '.join(map(number, numbers.tolist()))}}};")
        lines += [
            f"static const int64_t {name}[] = {{{', '.join(map(whole, items))}}};" for items, name in self.items.items()
        ]
        return lines
