"""A Python function, or a class with `step`, in a file: found, looked at, and made afresh for each run."""

from __future__ import annotations
import __future__

import hashlib
import inspect
import sys
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any, get_args, get_origin

from ...errors import InputError, nearest
from .declared import Causality, Declared, Type

EXAMPLE = 'python = "controller.py:step"'
TYPES: dict[Any, Type] = {float: "Real", int: "Integer", bool: "Boolean"}


@dataclass(frozen=True)
class PythonCode:
    """What is run: the name of a function or class in a file. `states`: start values of what a function returns behind
    its outputs, by name; `content`: of the file as it was read."""

    path: Path
    name: str
    content: bytes
    states: tuple[tuple[str, float], ...] = ()

    def __repr__(self) -> str:
        """Without folders: the digest of a system does not change where its folder is moved."""
        return f"PythonCode({self.path.name}:{self.name}, {self.states})"

    def found(self) -> Any:
        """The function or class, of a module that is loaded afresh. Raises InputError with file and line."""
        return self.loaded()[0]

    def loaded(self) -> tuple[Any, bytes]:
        """The same, and what stands in the files of its folder that it imports."""
        module, helpers = _module(self)
        return self._checked(module), b"".join(path.read_bytes() for path in helpers)

    def _checked(self, module: Any) -> Any:
        if not hasattr(module, self.name):
            known = [name for name, value in vars(module).items() if callable(value) and not name.startswith("_")]
            raise InputError(f"{self.path.name} has no '{self.name}'{nearest(self.name, known)}")
        found = getattr(module, self.name)
        if not callable(found) and not is_compiled(found):
            raise InputError(f"{self.path.name}: '{self.name}' is no function and no class, but {found!r:.60}")
        if inspect.isclass(found) and not callable(getattr(found, "step", None)):
            raise InputError(f"{self.path.name}: class {self.name} has no method step(self, ...)")
        return found


def _module(code: PythonCode) -> tuple[Any, list[Path]]:
    """The module, and the files of its folder that it has imported, which the next one imports afresh too."""
    name = f"rovbrush_{code.path.stem}_{hashlib.sha256(str(code.path).encode()).hexdigest()[:8]}"
    spec = spec_from_file_location(name, code.path)
    assert spec is not None
    module = sys.modules[name] = module_from_spec(spec)  # where dataclasses look for it
    helpers: list[Path] = []
    with _beside(code.path.parent, helpers):
        try:
            exec(compile(code.content, str(code.path), "exec", dont_inherit=True), vars(module))
        except SyntaxError as error:
            raise InputError(f"{code.path.name}, line {error.lineno}: {error.msg}") from None
        except (Exception, SystemExit) as error:
            raise InputError(f"{where(error, code.path)}: {named(error)}") from error
    return module, sorted(helpers)


@contextmanager
def _beside(folder: Path, helpers: list[Path]) -> Iterator[None]:
    """Files in the same folder may be imported; those that are come to `helpers`, and are forgotten again."""
    before, writes = set(sys.modules), sys.dont_write_bytecode
    sys.dont_write_bytecode = True  # which is as old as its source only to the second
    sys.path.insert(0, str(folder))
    try:
        yield
    finally:
        sys.dont_write_bytecode = writes
        if str(folder) in sys.path:
            sys.path.remove(str(folder))
        for name in set(sys.modules) - before:
            file = getattr(sys.modules[name], "__file__", None)
            if file and Path(file).is_relative_to(folder):
                helpers.append(Path(file))
                del sys.modules[name]


def where(error: BaseException, path: Path) -> str:
    """`controller.py, line 12, in step`: the deepest place in a file that an exception came through."""
    frames = [f for f in traceback.extract_tb(error.__traceback__) if f.filename == str(path)]
    if not frames:
        return path.name
    within = "" if frames[-1].name == "<module>" else f", in {frames[-1].name}"
    return f"{path.name}, line {frames[-1].lineno}{within}"


def named(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}".rstrip(": ")


def is_compiled(function: Any) -> bool:
    """Whether it is a function that Numba has compiled, or will: of `njit` or `cfunc`."""
    return plain(function) is not function


def plain(function: Any) -> Any:
    """The Python function behind one of Numba."""
    found = getattr(function, "py_func", None) or getattr(function, "_pyfunc", None)
    return found if inspect.isfunction(found) else function


def stepped(found: Any) -> Callable[..., Any]:
    """What is called at every step: a function, or the method of a class."""
    step: Any = getattr(found, "step", None) if inspect.isclass(found) else found
    return plain(step)  # type: ignore[no-any-return]


def line_of(found: Any) -> int:
    code = getattr(stepped(found), "__code__", None)
    return int(code.co_firstlineno) if code is not None else 0


def arguments_of(found: Any, label: str) -> list[inspect.Parameter]:
    """Those of a step, without `self`. Raises InputError for kinds that have no names."""
    try:
        every = list(inspect.signature(stepped(found)).parameters.values())
    except (TypeError, ValueError):
        raise InputError(f"{label} does not say what arguments it takes") from None
    every = every[1:] if inspect.isclass(found) else every
    for argument in every:
        if argument.kind in (argument.VAR_POSITIONAL, argument.VAR_KEYWORD, argument.POSITIONAL_ONLY):
            star = "*" * (argument.kind != argument.POSITIONAL_ONLY) + "*" * (argument.kind == argument.VAR_KEYWORD)
            raise InputError(f"{label}: argument {star}{argument.name} has no name that an input could have; name each")
    return every


def annotated(found: Any, label: str) -> list[Declared]:
    """What the annotations of a step say: `force: "N"`, `k: "V/N" = 0.05` (a parameter), `on: bool`, and
    `-> {"V_in": "V"}` for the outputs. Raises InputError for others."""
    function = stepped(found)
    said = dict(getattr(function, "__annotations__", {}))
    if function.__code__.co_flags & __future__.annotations.compiler_flag:
        try:
            said = inspect.get_annotations(function, eval_str=True)
        except Exception as error:
            raise InputError(f"{label}: its annotations cannot be read: {named(error)}") from None
    declared = []
    for argument in arguments_of(found, label):
        if argument.name in ("t", "h"):
            continue
        has_default = argument.default is not argument.empty
        kind: Causality = "parameter" if has_default else "input"
        start = argument.default if has_default else None
        if has_default and type(start) not in TYPES:
            raise InputError(f"{label}: the default of {argument.name} is {start!r:.40}, no number, true or false")
        declared.append(_declared(argument.name, kind, said.get(argument.name), start, label))
    outputs = said.get("return")
    if isinstance(outputs, dict):
        declared += [_declared(str(name), "output", how, None, label) for name, how in outputs.items()]
    return declared


def _declared(name: str, causality: Causality, said: Any, start: Any, label: str) -> Declared:
    unit = ""
    if hasattr(said, "__metadata__"):  # Annotated[float, "N"]
        unit = next((m for m in said.__metadata__ if isinstance(m, str)), "")
        said = get_args(said)[0]
    if isinstance(said, str):
        said, unit = None, said
    type_: Type = "Boolean" if isinstance(start, bool) else "Real"
    if said is not None:
        if said not in TYPES or get_origin(said) is not None:
            raise InputError(
                f'{label}: {name} is annotated as {said!r:.40}; write its unit ("N"), float, int, bool, or '
                f'Annotated[float, "N"]'
            )
        type_ = TYPES[said]
    start = float(start) if start is not None and type_ == "Real" else start
    return Declared(name, causality, type_, unit, start)
