"""The declaration of a component in C: its tables, and its entry points with their arguments bound by name."""

from __future__ import annotations

import json
import re
import textwrap
from dataclasses import fields
from typing import Any

from ..declare.interface import Array, Variable, parameter_variables
from ..declare.model_description import GUID_PLACEHOLDER
from ..declare.usual import usual_sizes, usual_values
from ..errors import BuildError
from ..python.kernels import argument_names

KINDS = {"Real": "REAL", "Integer": "INTEGER", "Boolean": "BOOLEAN"}
CAUSALITIES = {"parameter": "PARAMETER", "input": "INPUT", "output": "OUTPUT", "calculatedParameter": "OUTPUT"}
SIGNATURE = re.compile(r"^static \w+ (\w+)\((.*)\)$", re.MULTILINE)
HEADER = "/* {doc}.\n   Made from the equations in {name}/kernel.py by `rovbrush build --native`. */\n"


class Term:
    """A parameter, or sums and products of parameters, as C text: what the shape of an array may consist of."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __str__(self) -> str:
        return self.text

    def __add__(self, other: object) -> Term:
        return Term(f"({self} + {other})")

    def __sub__(self, other: object) -> Term:
        return Term(f"({self} - {other})")

    def __mul__(self, other: object) -> Term:
        return Term(f"{self} * {other}")

    def __radd__(self, other: object) -> Term:
        return Term(f"({other} + {self})")

    def __rmul__(self, other: object) -> Term:
        return Term(f"{other} * {self}")


class Tables:
    """C text for one component class; see `sources/component.h` for what the tables mean."""

    def __init__(self, component: Any) -> None:
        self.component = component
        self.name: str = component.component_name()
        self.variables: tuple[Variable, ...] = component.variables()
        self.arrays: tuple[Array, ...] = component.arrays
        self.first: dict[str, int] = {}
        self.count = 0
        for v in self.variables:
            self.first[v.name] = self.count
            self.count += len(v.start)
        self.usual = usual_values(self.variables)
        self.given: dict[str, str] = {}  # arguments that are known where a call stands
        self.sizes: dict[str, tuple[int | None, int | None]] = {}  # and sizes of arrays

    def source(self, kernel: str) -> str:
        """The whole C file of a component, around its kernel."""
        self.signatures = {found[1]: found[2].split(", ") for found in SIGNATURE.finditer(kernel)}
        doc = (self.component.__doc__ or self.name).strip().splitlines()[0].rstrip(".")
        head = HEADER.format(doc=doc, name=self.name)
        return "\n".join(
            [head + '#include <stdlib.h>\n\n#include "component.h"\n', kernel, self._places(), self._variables(),
             self._shapes(),
             self._entry("start", ("setup", "initialize", "outputs")), self._entry("outputs", ("outputs",)),
             self._usual(), self._entry("step", ("step",)), self._component()]
        )  # fmt: skip

    def _places(self) -> str:
        """Names for places in `v` and for the arrays."""
        places = [f"at_{v.name} = {self.first[v.name]}" for v in self.variables]
        arrays = [f"array_{a.name}" for a in self.arrays]
        return (
            _wrapped("enum {", [*places, f"at_time = {self.count}", "at_step_size"], "};\n")
            + _wrapped("enum {", arrays, "};\n") * bool(arrays)
        )

    def _variables(self) -> str:
        rows = [
            f"    {{{json.dumps(v.name)}, {json.dumps(v.unit)}, {KINDS[v.kind]}, {_causality(v)}, "
            f"{self.first[v.name]}, {len(v.start)}, {_number(v.minimum)}, {_number(v.maximum)}}},"
            for v in self.variables
        ]
        owners = [str(k) for k, v in enumerate(self.variables) for _ in v.start]
        starts = [_number(x) for v in self.variables for x in v.start]
        scratch = [str(a.scratch).lower() for a in self.arrays] or ["false"]  # C has no empty arrays
        return (
            "static const Variable variables[] = {\n"
            + "\n".join(rows)
            + "\n};\n"
            + _wrapped("static const short owners[] = {", owners, "};\n")
            + _wrapped("static const double starts[] = {", starts, "};\n")
            + _wrapped("static const bool scratch[] = {", scratch, "};\n")
        )

    def _shapes(self) -> str:
        """Sizes of the arrays; those that follow from parameters are found by asking the declaration with symbols."""
        names = [f.name for f in fields(self.component.parameters)]
        symbols = type("Symbols", (), {name: Term(f"(int64_t)v[at_{name}]") for name in names})
        lines = []
        for array in self.arrays:
            shape = array.shape_for(symbols())
            rows, columns = shape if isinstance(shape, tuple) else (shape, 1)
            lines.append(f"    shape[array_{array.name}] = (Shape){{{rows}, {columns}}};")
        return "static void shapes(const double *v, Shape *shape) {\n    (void)v;\n" + "\n".join(lines) + "\n}\n"

    def _entry(self, entry: str, stages: tuple[str, ...]) -> str:
        """A function of the component: the kernel's own in turn, then the rows of arrays that are shown."""
        calls = [self._call(stage) for stage in stages if hasattr(self.component.kernel, stage)]
        unusual = [self._branch()] * (entry == "step" and bool(self.usual))
        body = "\n".join([*unusual, *calls, *self._table_and_rows()])
        return (
            f"static void {self.name}_{entry}(double *v, double *const *a, const Shape *shape) {{\n"
            f"    (void)a, (void)shape;\n{body}\n}}\n"
        )

    def _table_and_rows(self) -> list[str]:
        """What fills in the rows of arrays that are shown."""
        shown = self._show_rows()
        table = [self._call("table")] if shown and hasattr(self.component.kernel, "table") else []
        return [*table, *shown]

    def _usual(self) -> str:
        """The step where all parameters that are declared `usual` have their start values."""
        if not self.usual:
            return ""
        values = ", ".join(f"{name} = {value:g}" for name, value in self.usual.items())
        comment = textwrap.fill(f"The step for {values}: much is decided there.", 112, subsequent_indent="   ")
        self.given = {v.name: _literal(v, self.usual[v.name]) for v in self.variables if v.name in self.usual}
        self.sizes = usual_sizes(self.variables, self.arrays)
        body = "\n".join([self._call("step"), *self._table_and_rows()])
        self.given, self.sizes = {}, {}
        return (
            f"/* {comment} */\n"
            f"FLAT static void {self.name}_usual_step(double *v, double *const *a, const Shape *shape) {{\n"
            f"    (void)a, (void)shape;\n{body}\n}}\n"
        )

    def _branch(self) -> str:
        """Take the step for usual values where they are."""
        tests = [f"v[at_{name}] == {_number(value)}" for name, value in self.usual.items()]
        condition = textwrap.fill(" && ".join(tests), 100, initial_indent="    if (", subsequent_indent="        ")
        return f"{condition}) {{\n        {self.name}_usual_step(v, a, shape);\n        return;\n    }}"

    def _call(self, stage: str) -> str:
        names = argument_names(self.component.kernel, stage)
        given = [self._argument(stage, *both) for both in zip(names, self.signatures[stage], strict=True)]
        return _wrapped(f"    {stage}(", given, ");").rstrip("\n")

    def _argument(self, stage: str, name: str, taken: str) -> str:
        """What a function of the kernel gets for an argument, which it takes as `double *x` or `Matrix x_M`."""
        if name in ("t", "h"):
            return "v[at_step_size]" if name == "h" else "v[at_time]"
        if name == "y":
            return f"v + at_{self.component.outputs[0].name}"
        for array in self.arrays:
            if array.name == name:
                at = f"array_{name}"
                known = self.sizes.get(name, (None, None))[1]
                columns = f"shape[{at}].columns" if known is None else str(known)
                return f"(Matrix){{a[{at}], {columns}}}" if taken.startswith("Matrix ") else f"a[{at}]"
        declared = next((v for v in self.variables if v.name == name), None)
        if declared is None:
            raise BuildError(f"{self.name}: {stage}: argument '{name}' is no variable of the interface")
        place = f"v[at_{name}]"
        if name in self.given:
            return self.given[name]
        if declared.size:
            return f"v + at_{name}"
        return {"Real": place, "Integer": f"(int64_t){place}", "Boolean": f"{place} != 0.0"}[declared.kind]

    def _show_rows(self) -> list[str]:
        """Copies of vectors' elements to their outputs, where the FMU is built with such outputs."""
        lines = []
        sizes = {v.name: len(v.start) for v in self.variables}
        for array in self.arrays:
            if array.shown and array.shown.name in self.first:
                name, at = array.shown.name, f"array_{array.name}"
                lines.append(
                    f"    for (int64_t r = 0; r < {sizes[name]} && r < shape[{at}].rows; r++)\n"
                    f"        v[at_{name} + r] = a[{at}][r];"
                )
        return lines

    def _component(self) -> str:
        parameters = sum(len(v.start) for v in parameter_variables(self.component.parameters))
        inputs = sum(len(v.start) for v in self.component.inputs)
        return (
            f'const Component component = {{\n    "{self.name}", "{GUID_PLACEHOLDER}",\n'
            f"    {self.count}, {parameters}, {parameters + inputs}, {len(self.arrays)},\n"
            f"    variables, owners, starts, scratch,\n"
            f"    shapes, {self.name}_start, {self.name}_outputs, {self.name}_step,\n}};\n"
        )


def _causality(v: Variable) -> str:
    return "TUNABLE" if v.tunable else CAUSALITIES[v.causality]


def _literal(v: Variable, value: float) -> str:
    return _number(value) if v.kind == "Real" else str(int(value))


def _number(value: float) -> str:
    return ("-" if value < 0 else "") + "INFINITY" if abs(value) == float("inf") else repr(float(value))


def _wrapped(begin: str, items: list[str], end: str) -> str:
    """A comma-separated list in lines of bounded length."""
    lead = " " * (len(begin) - len(begin.lstrip()) + 4)
    lines = textwrap.wrap(", ".join(items), 110, break_long_words=False, break_on_hyphens=False)
    if len(lines) < 2:
        return f"{begin}{' '.join(lines)}{end}\n" if end == ");" else f"{begin}{' '.join(lines)}{end}"
    return "\n".join([begin, *(lead + line for line in lines)]) + ("" if end == ");" else "\n") + end
