"""pytest plugin: `pytest --rovbrush-fmu their.fmu --rovbrush-as dc_motor` tests an FMU as that component.

`--rovbrush-map map.toml` gives its names. `--fmu`, `--as`, `--map` and `--fmu-tolerance` mean the same in a command
that has both of the first two.

The tests come with the component's package, not from the repository that pytest runs in. Loaded by every pytest run of
an environment that has rovbrush, so nothing heavy is imported before the options ask for it.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from .component_tests.verdicts import Bench


SHORT = {
    "--fmu": "--rovbrush-fmu", "--as": "--rovbrush-as", "--map": "--rovbrush-map",
    "--fmu-tolerance": "--rovbrush-tolerance",
}  # fmt: skip


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("rovbrush", "tests of an FMU as one of the components of rovbrush")
    group.addoption("--rovbrush-fmu", dest="rovbrush_fmu", type=Path, metavar="FILE", help="the FMU to test")
    group.addoption("--rovbrush-as", dest="rovbrush_as", metavar="NAME", help="the component that it claims to be")
    group.addoption("--rovbrush-map", dest="rovbrush_map", type=Path, metavar="FILE", help="mapping file of its names")
    group.addoption(
        "--rovbrush-tolerance", dest="rovbrush_tolerance", type=float, metavar="X",
        help="relative error granted to its solver",
    )  # fmt: skip


@pytest.hookimpl(tryfirst=True)  # before conftest files, which `rootdir` may hold many of
def pytest_load_initial_conftests(args: list[str]) -> None:
    """The short names become the long ones here, and are no options: other plugins can have such of their own."""
    used = {word.partition("=")[0] for word in args}
    if {"--fmu", "--as"} <= used:
        split = [word.partition("=") for word in args]
        args[:] = ["".join((SHORT.get(name, name), equals, value)) for name, equals, value in split]


@pytest.hookimpl(tryfirst=True)  # so that -k and --deselect see these tests too
def pytest_collection_modifyitems(session: pytest.Session, config: pytest.Config, items: list[pytest.Item]) -> None:
    """Add the suite to whatever else was collected."""
    path, component = config.getoption("rovbrush_fmu"), config.getoption("rovbrush_as")
    if path is None and component is None:
        return
    if path is None or component is None:
        raise pytest.UsageError("--rovbrush-fmu FILE and --rovbrush-as NAME go together")
    from ..errors import RovbrushError
    from .component_tests.verdicts import TOLERANCE, make_bench

    granted = config.getoption("rovbrush_tolerance")
    try:
        bench = make_bench(path, component, config.getoption("rovbrush_map"), TOLERANCE if granted is None else granted)
    except RovbrushError as error:
        raise pytest.UsageError(str(error)) from error
    suite = Suite.from_parent(session, name=f"{path.name} as {component}", nodeid=f"{path.name}::{component}")
    items.append(InterfaceItem.from_parent(suite, name="interface_fits", bench=bench))
    items += [
        BehaviourItem.from_parent(suite, name=test.__name__, bench=bench, test=test) for test in bench.suite.tests
    ]


class Suite(pytest.Collector):
    """The parent of the items, for their names in reports."""

    def collect(self) -> list[pytest.Item]:
        return []


class InterfaceItem(pytest.Item):
    """Every variable that a system needs is there, with a unit, a type and a causality that fit."""

    def __init__(self, *, bench: Bench, **rest: Any) -> None:
        super().__init__(**rest)
        self.bench = bench

    def runtest(self) -> None:
        failures = [f"{row.ours}: {row.text}" for row in self.bench.comparison.failures]
        assert not failures, "\n".join(failures)

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """The reason alone: the code of the suite tells a reader nothing about the FMU."""
        from ..errors import FmuError

        if isinstance(excinfo.value, (AssertionError, FmuError)):
            return f"{(type(self).__doc__ if not hasattr(self, 'claim') else self.claim)}\n{excinfo.value}"
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        return self.bench.unit.fmu.path, None, self.name


class BehaviourItem(InterfaceItem):
    """One test of the suite."""

    def __init__(self, *, test: Callable[[Any], None], **rest: Any) -> None:
        from .component_tests.suites import claim_of

        super().__init__(**rest)
        self.test, self.claim = test, claim_of(test)

    def runtest(self) -> None:
        from .component_tests.suites import NotApplicableError
        from .component_tests.verdicts import attempt

        try:
            attempt(self.test, self.bench.unit)
        except NotApplicableError as error:
            pytest.skip(f"not applicable: {error}")
