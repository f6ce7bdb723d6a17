"""Operations of macro steps that are repeated or vary in length, as C."""

from __future__ import annotations

from ....loop.operations import (
    ADVANCE,
    CONTROL,
    ESTIMATE,
    GAUGE,
    HALVE,
    ITERATE,
    REPEAT,
    RESTORE,
    REWIND,
    SAVE,
)
from ..exchange import Names, indented
from ..names import number
from .cost import Row


class Repeated:
    """Their lines, and the tables of their settings."""

    HOW = {  # noqa: RUF012
        **dict.fromkeys((SAVE, RESTORE), "state"), REWIND: "rewind", ITERATE: "iterate", REPEAT: "repeat",
        GAUGE: "gauge", CONTROL: "control", HALVE: "halve", ADVANCE: "advance", ESTIMATE: "estimate",
    }  # fmt: skip

    def __init__(self, names: Names) -> None:
        self.names, self.plan = names, names.plan
        self.settings: list[str] = []

    def state(self, row: Row, _tick: int) -> list[str]:
        code, _, component, a, *_ = row
        if component < 0:
            to, what = ("s->saved", "z") if code == SAVE else ("z", "s->saved")
            return [f"memcpy({to}, {what}, {a} * sizeof *z);"]
        part = self.names.parts[self.names.components[component]]
        return [f"if ({'keep' if code == SAVE else 'go_back'}(s, {part})) return 1;"]

    def rewind(self, row: Row, _tick: int) -> list[str]:
        return [f"if (s->rewind) s->rewind(s->user, {row[3]}, {row[4]});"]

    def repeat(self, row: Row, _tick: int) -> list[str]:
        return [f"goto row_{row[3]};"]

    def iterate(self, row: Row, _tick: int) -> list[str]:
        _, _, _, a, b, p, q, k = row
        lines = [
            f"const int verdict = iterate(z, {b}, {p}, {q}, {self._setting(k, 3 + q)}, s->now.work);",
            f"if (verdict < 0) return not_converged(s, {b} + (int)s->now.work[3]);", f"if (!verdict) goto row_{a};",
        ]  # fmt: skip
        return ["{", *indented(lines), "}"]

    def gauge(self, row: Row, _tick: int) -> list[str]:
        _, _, _, a, b, p, q, k = row
        cells = ", ".join(self.names.cells[slot] for slot in (a, b, p, q))
        return [f"gauge(s, {cells}, {self._setting(k, 2)});"]

    def control(self, row: Row, _tick: int) -> list[str]:
        a, k = row[3], row[7]
        now, step, found = (f"z[{self.names.cells[a + j]}]" for j in range(3))
        return [
            f"{step} = seconds(s->now.clock[STEP_TICKS]);", f"{found} = choose_step(s, {self._setting(k, 5)});",
            f"{now} = (double)s->now.clock[NOW];",
        ]  # fmt: skip

    def halve(self, _row: Row, _tick: int) -> list[str]:
        return ["s->now.clock[STEP_TICKS] /= 2;"]

    def advance(self, _row: Row, _tick: int) -> list[str]:
        return [
            "s->now.clock[OFFSET] = s->now.clock[STEP_TICKS];",
            "at = s->now.first + s->now.clock[NOW] + s->now.clock[OFFSET];",
        ]

    def estimate(self, row: Row, _tick: int) -> list[str]:
        _, _, _, a, b, p, q, k = row
        now, step, found, rejected = (f"z[{self.names.cells[b + j]}]" for j in range(4))
        lines = [
            f"{step} = seconds(2 * s->now.clock[STEP_TICKS]);",
            f"const int verdict = estimate(s, {p}, {q}, {self._setting(k, 5 + q)});", "if (verdict < 0) return 1;",
            "if (verdict == 0) {",
            f"    {now} = (double)s->now.clock[NOW], {found} = s->now.work[0], {rejected} = s->now.work[2];",
            "    s->now.work[2] = 0.0;", f"    goto row_{a};", "}", "at = s->now.first + s->now.clock[NOW];",
        ]  # fmt: skip
        return ["{", *indented(lines), "}"]

    def _setting(self, k: int, count: int) -> str:
        """The name of a table of settings."""
        values = ", ".join(number(value) for value in self.plan.coefficients[k : k + count].tolist())
        self.settings.append(f"static const double STEPS_{len(self.settings)}[] = {{{values}}};")
        return f"STEPS_{len(self.settings) - 1}"
