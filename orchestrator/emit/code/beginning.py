"""The start as C: values along the connections until they are consistent, loops of them solved by Newton."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...fmu.conversions import Conversion, How
from ...loop.cells import OFFSET_OR_VALUE
from ...plan.happening.scenario import from_start
from ...plan.start import Block
from ...system.connection import Connection
from ...system.event import stream_of
from .exchange import Key, Names, indented
from .exposed import Exposed
from .names import comment, number, whole

CELLS = ("    double *const z = s->now.z;", "    int64_t *const w = s->now.whole;", "    (void)z, (void)w;")


class Beginning:
    """Functions that lead to consistent values, as `run/start/initialize.py` does."""

    def __init__(self, names: Names, shown: list[Exposed], solutions: Mapping[Key, float]) -> None:
        """`solutions`: the inputs of loops as `run` finds them, from which they are sought."""
        self.names, self.plan, self.solutions = names, names.plan, solutions
        self.shown = {(names.components[e.component], e.name.partition(".")[2]): k for k, e in enumerate(shown)}
        self.loops: list[str] = []
        self.items: list[str] = []

    def functions(self) -> list[str]:
        """All of them, each as one text."""
        first, propagate, instant = self._first(), self._propagate(), self._instant()
        found = [
            self._function("first_cells", "The inputs that have cells, before anything is known.", first),
            self._function("propagate", "Values along all connections once, in order.", propagate),
            self._function("read_outputs", "All outputs, as they are now.", self._outputs()),
            self._function("settle_instant", "What answers at once to inputs, as at every instant.", instant),
            self._function("first_history", "Before the first step every earlier value is that of the start.",
                           self._history()),
        ]  # fmt: skip
        return [*self.items, *self.loops, *found]

    def _function(self, name: str, words: str, lines: Iterable[str]) -> str:
        head = f"int {self.names.system}_{name}({self.names.system} *s) {{"
        return "\n".join([f"/* {words} */", head, *CELLS, *indented(list(lines)), "    return 0;", "}"])

    def _first(self) -> list[str]:
        lines = []
        for key, slot in self.plan.layout.inputs.items():
            fmu = self.plan.system.components[key[0]].fmu
            real = self.names.memory.kind(key).real
            if key in self.shown:
                value = f"s->now.values[{self.shown[key]}].{'real' if real else 'whole'}"
            else:
                start = self.solutions.get(key, fmu.start(key[1]))
                assert not isinstance(start, (str, bytes))
                value = number(float(start)) if real else whole(int(start))
            lines.append(f"{self.names.cell(slot)} = {value};")
        return lines

    def _propagate(self) -> list[str]:
        lines: list[str] = []
        for block in self.plan.start:
            for c in block.connections:
                if not block.loop or not self.plan.system.is_real(c):
                    lines += self._passed(c)
            lines += self._loop(block)
        return [*lines, "if (read_outputs(s)) return 1;"]

    def _instant(self) -> list[str]:
        plan = self.plan
        lines: list[str] = []
        blocks = plan.instants.blocks(frozenset(plan.system.components) - set(plan.early))
        for block in blocks:
            lines += self._loop(block) if block.loop else self._passed(block.connections[0])
        for name in dict.fromkeys(c.target[0] for block in blocks for c in block.connections):
            lines += [line for found in self.names.taken(name) for line in self.names.get_block(name, found)]
        return lines

    def _outputs(self) -> list[str]:
        return [
            line
            for name in self.names.components
            for block in self.names.taken(name)
            for line in self.names.get_block(name, block)
        ]

    def _history(self) -> list[str]:
        layout = self.plan.layout
        return [
            f"{self.names.cell(slot)} = {self.names.cell(layout.outputs[key])};"
            for table in (layout.previous, layout.before, layout.begins, layout.samples, layout.parts)
            for key, slot in table.items()
        ]

    # --- connections ---

    def _passed(self, c: Connection) -> list[str]:
        """What the source of a connection sends, to its target."""
        slot = self.plan.layout.inputs[c.target]
        lines = [*self._received(c), f"{self.names.cell(slot)} = sent;", *self.names.set_one(c.target)]
        return [f"{{ /* {comment(c.label)} */", *indented(lines), "}"]

    def _received(self, c: Connection) -> list[str]:
        """Lines behind which `sent` is what the target is to get."""
        real = self.names.memory.kind(c.source).real
        target = self.names.memory.kind(c.target).real
        cell = self.names.cells[self.plan.layout.inputs[c.target]]
        lines = [
            f"{'double' if real else 'int64_t'} x;", *self.names.get_one(c.source, "x"),
            *self._converted(c, self.plan.conversions[c], cell, target),
        ]  # fmt: skip
        broken = self._broken(c, target)
        return (
            lines
            if not broken
            else [
                line.replace("const double sent", "double sent").replace("const int64_t sent", "int64_t sent")
                for line in lines
            ]
            + broken
        )

    def _broken(self, c: Connection, real: bool) -> list[str]:
        """What faults from the start make of it."""
        lines = []
        for n, event in enumerate(self.plan.system.events):
            first = self.plan.layout.faults.get((n, c.target))
            if first is None or event not in from_start(self.plan.system):
                continue
            stream, start = whole(stream_of(event.fault)), whole(self.plan.clock.start)
            cell = f"{'z' if real else 's->now.whole'}[{first + OFFSET_OR_VALUE}]"
            lines.append(f"if (z[{first}] == 2.0) sent = {cell};")
            if real:
                name = self.names.system
                lines.append(f"else if (z[{first}] == 1.0) sent = {name}_faulted(s, {first}, {stream}, {start}, sent);")
        return lines

    def _converted(self, c: Connection, found: Conversion, cell: str, real: bool) -> list[str]:
        gain, offset = number(c.gain), number(c.offset)
        if found.how is How.SAME:
            return [f"const {'double' if real else 'int64_t'} sent = x;"]
        if found.how in (How.REAL, How.NUMBER):
            source = "x" if found.real else f"(double){'(uint64_t)' if found.unsigned else ''}x"
            lines = [f"const double sent = {gain} * {source} + {offset};"]
            if found.largest != float("inf"):
                lines.append(f"if (fabs(sent) > {number(found.largest)}) return unfit(s, {cell});")
            return lines
        low, high = found.bounds
        value = f"rint({gain} * x + {offset})" if found.real else "(double)x"
        cast = "n >= 0x1p63 ? (int64_t)(n - 0x1p64) : (int64_t)n" if found.real else "x"
        lines = [f"const double n = {value};",
                 f"if (!({number(low)} <= n && n < {number(high)})) return unfit(s, {cell});",
                 f"const int64_t sent = {cast};"]  # fmt: skip
        if found.items:
            name = f"START_ITEMS_{len(self.items)}"
            items = ", ".join(map(whole, found.items))
            self.items.append(f"static const int64_t {name}[] = {{{items}}};")
            lines.append(f"if (!among(sent, {name}, {len(found.items)})) return unfit(s, {cell});")
        return lines

    def _loop(self, block: Block) -> list[str]:
        """Find the inputs of a loop that their sources give back: those that are torn, which give the others."""
        unknowns, behind = ([c for c in part if self.plan.system.is_real(c)] for part in (block.torn, block.behind))
        if not unknowns:
            return [line for c in behind for line in self._passed(c)]
        number_of = sum(text.startswith("/* The loop") for text in self.loops)
        name = f"loop_{number_of}"
        layout = self.plan.layout
        lines = []
        for k, c in enumerate(unknowns):
            lines += [f"z[{self.names.cells[layout.inputs[c.target]]}] = given[{k}];", *self.names.set_one(c.target)]
        for c in behind:
            lines += self._passed(c)
        for k, c in enumerate(unknowns):
            lines += ["{", *indented([*self._received(c), f"sent_back[{k}] = sent;"]), "}"]
        words = ", ".join(".".join(c.target) for c in unknowns)
        self.loops.append("\n".join([
            f"/* The loop of {comment(words)}: what its sources send, where its inputs are `given`. */",
            f"static int {name}({self.names.system} *s, const double *given, double *sent_back) {{",
            *CELLS, *indented(lines), "    return 0;", "}",
            f"static const int {name.upper()}[] = {{"
            f"{', '.join(self.names.cells[layout.inputs[c.target]] for c in unknowns)}}};",
        ]))  # fmt: skip
        tolerance = number(self.plan.system.loops.tolerance)
        return [f"if (solve_start(s, {name}, {name.upper()}, {len(unknowns)}, {tolerance})) return 1;"]
