"""Run the tests of a suite on one FMU and judge each."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from ...errors import FmuError, RunError
from ...fmu.fmu import Fmu
from ...system.replace.mapping import VariableMapping, load_mapping
from .compare import Comparison, compare
from .fmu_unit import FmuUnit, first_line
from .suites import NotApplicableError, Suite, claim_of, suite_of

TOLERANCE = 1e-3  # what the solver of a foreign FMU may err by, relative to the size of a result


@dataclass(frozen=True)
class Verdict:
    """One test: its claim, whether it holds, and why not, or how closely it does."""

    claim: str
    verdict: Literal["passed", "failed", "not applicable"]
    text: str


@dataclass(frozen=True)
class Bench:
    """A suite, an FMU that claims to be its component, and what came of comparing their interfaces."""

    suite: Suite
    unit: FmuUnit
    comparison: Comparison

    def judge(self) -> Iterator[Verdict]:
        """The verdicts, as they come."""
        for test in self.suite.tests:
            yield judge(test, self.unit)


def make_bench(path: Path, component: str, map_path: Path | None, tolerance: float = TOLERANCE) -> Bench:
    """Open the FMU and compare interfaces. Raises InputError or FmuError if that is not possible."""
    suite = suite_of(component)
    mapping = load_mapping(map_path) if map_path else VariableMapping()
    fmu = Fmu.open(path)
    comparison = compare(fmu, suite, mapping)
    return Bench(suite, FmuUnit(fmu, comparison.bindings, mapping, tolerance), comparison)


def attempt(test: Callable[[Any], None], unit: FmuUnit) -> None:
    """Run one test and free its instances; whatever it raises goes through."""
    unit.observed.clear()
    try:
        test(unit)
    finally:
        unit.release()


def judge(test: Callable[[Any], None], unit: FmuUnit) -> Verdict:
    """Run one test; what it raises becomes the verdict."""
    claim = claim_of(test)
    try:
        attempt(test, unit)
    except NotApplicableError as error:
        return Verdict(claim, "not applicable", str(error))
    except AssertionError as error:
        return Verdict(claim, "failed", str(error))
    except FmuError as error:
        return Verdict(claim, "failed", first_line(error))
    return Verdict(claim, "passed", closest(unit.observed))


def require_outputs(bench: Bench) -> None:
    """Raise RunError, with the beginning of a mapping file, if none of their variables stands for an output of ours."""
    if any(binding.ours.causality == "output" for binding in bench.comparison.bindings.values()):
        return
    lines = ["[variables]"]
    for v in bench.suite.interface:
        if v.name in bench.suite.essential:
            theirs = ", ".join(bench.unit.fmu.base_names(v.causality)) or f"no {v.causality} at all"
            lines.append(f'{v.name} = ""  # {v.causality} in {v.unit}; there: {theirs}')
    raise RunError(
        f"{bench.unit.fmu.path.name} has no output of {bench.suite.name} under its name: nothing can be tested; "
        "begin a mapping file (--map) with this, and put their names between the quotes:\n\n" + "\n".join(lines)
    )


def require_applicable(path: Path, component: str, verdicts: Sequence[Verdict]) -> None:
    """Raise RunError if not one test could be run."""
    if all(v.verdict == "not applicable" for v in verdicts):
        raise RunError(f"{path.name}: no test of {component} could be run on it; a mapping file can name its variables")


def closest(observed: list[tuple[str, float, float]]) -> str:
    """The measured deviation that comes closest to its bound."""
    if not observed:
        return ""
    what, deviation, bound = max(observed, key=lambda row: row[1] / row[2] if row[2] else row[1])
    return f"{what}: off by {deviation:.1e}, {bound:.1e} allowed"
