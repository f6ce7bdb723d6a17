"""A Python function or class as a component: what it is given, what it returns, and what is wrong with that."""

from __future__ import annotations

import copy
import inspect
import operator
from collections.abc import Callable, Mapping
from math import isfinite
from typing import Any

from ....errors import InputError
from ....fmu.outside.declared import DeclaredFmu
from ....fmu.outside.model import Model, StepFailedError
from ....fmu.outside.python_file import PythonCode, arguments_of, is_compiled, line_of, named, where
from .plain_data import as_bytes, from_bytes

INT32 = 2**31


def python_model(fmu: DeclaredFmu) -> Model:
    """What runs a Python function or class. Raises InputError."""
    found = fmu.settings.found()
    if is_compiled(found):
        from .machine import CompiledFunction

        return CompiledFunction(fmu, found)
    return PythonClass(fmu, found) if inspect.isclass(found) else PythonFunction(fmu, found)


class PythonFunction(Model):
    """A function that is given time, step, inputs, parameters and states, and returns outputs and states."""

    def __init__(self, fmu: DeclaredFmu, found: Any) -> None:
        code: PythonCode = fmu.settings
        super().__init__({**fmu.starts(), **dict(code.states)})
        self.code, self.line = code, line_of(found)
        self.types = {name: v.type for name, v in fmu.variables.items()}
        self.outputs = [*fmu.names("output"), *dict(code.states)]
        self.reals = {name for name in self.outputs if self.types.get(name, "Real") == "Real"}
        self.arguments = [a.name for a in arguments_of(found, code.name)]
        self.function: Callable[..., Any] = self._function(found)

    def _function(self, found: Any) -> Callable[..., Any]:
        return found  # type: ignore[no-any-return]

    def step(self, time: float, length: float) -> int | None:
        values = self.values
        values["t"], values["h"] = time, length
        try:
            answer = self.function(*[values[name] for name in self.arguments])
        except (Exception, SystemExit) as error:
            raise StepFailedError(f"{where(error, self.code.path)}: {named(error)}") from error
        self.values |= self._outputs(answer)
        return None

    def _outputs(self, answer: Any) -> dict[str, Any]:
        """What was returned, by name and checked. Raises StepFailedError with file and line."""
        names = self.outputs
        if isinstance(answer, Mapping):
            if set(answer) != set(names):
                raise self._wrong(f"a dict of {', '.join(map(str, answer)) or 'nothing'}")
            answer = [answer[name] for name in names]
        elif not isinstance(answer, (tuple, list)):
            answer = answer.tolist() if getattr(answer, "ndim", 0) == 1 else [answer]
        if len(answer) != len(names):
            raise self._wrong(f"{len(answer)} value{'s' * (len(answer) != 1)}")
        return {
            name: value if type(value) is float and name in self.reals and isfinite(value) else self._value(name, value)
            for name, value in zip(names, answer, strict=True)
        }

    def _value(self, name: str, value: Any) -> Any:
        kind = self.types.get(name, "Real")
        try:
            if kind == "Boolean":
                if operator.index(value) in (0, 1):
                    return bool(value)
            elif kind == "Integer":
                if -INT32 <= operator.index(value) < INT32:
                    return int(value)
            elif not isinstance(value, (str, bytes)) and isfinite(found := float(value)):
                return found
        except (TypeError, ValueError, OverflowError):
            pass
        wanted = {"Boolean": "true or false", "Integer": "a whole number of 32 bits"}.get(kind, "a finite number")
        raise StepFailedError(
            f"{self.code.path.name}, line {self.line}: {self.code.name} returned {name} = {value!r:.60}, which is not "
            f"{wanted}"
        )

    def _wrong(self, what: str) -> StepFailedError:
        return StepFailedError(
            f"{self.code.path.name}, line {self.line}: {self.code.name} returned {what}, and it is to return "
            f"{', '.join(self.outputs)}"
        )


class PythonClass(PythonFunction):
    """An object with `step`, whose state is what stands in it."""

    def _function(self, found: Any) -> Callable[..., Any]:
        try:
            self.object = found()
        except Exception as error:
            raise InputError(f"{where(error, self.code.path)}: {self.code.name}(): {named(error)}") from error
        return self.object.step  # type: ignore[no-any-return]

    def save(self) -> Any:
        try:
            return dict(self.values), copy.deepcopy(vars(self.object))
        except Exception as error:
            raise RuntimeError(f"what {self.code.name} keeps in self cannot be copied: {named(error)}") from error

    def restore(self, state: Any) -> None:
        values, kept = state
        self.values = dict(values)
        vars(self.object).clear()
        vars(self.object).update(copy.deepcopy(kept))

    def written(self, state: Any) -> bytes:
        values, kept = state
        return as_bytes({"values": values, "self": kept})

    def read(self, content: bytes) -> Any:
        found = from_bytes(content)
        return found["values"], found["self"]
