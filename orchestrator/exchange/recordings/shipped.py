"""The recordings that are handed over with the FMUs, one per component, as systems/recordings.toml says.

`python -m rovbrush.orchestrator.exchange.recordings.shipped [FMUS [FOLDER]]` makes them anew, by native FMUs of
FMI 2.0.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

from msgspec import Meta, Struct

from ...errors import RovbrushError
from ...results.tables import require_complete
from ...run.planned import planned
from ...run.simulation import simulate
from ...system.assemble import assemble
from ...system.file.shipped import SYSTEMS
from ...system.schema.checked import checked
from ...system.schema.keys.values import Time, Values
from ...toml.file import TomlFile
from .write import write_boundary

RUNS = SYSTEMS / "recordings.toml"
FMUS = Path("fmus")


class RecordedRun(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A run of a shipped system, and the components that are recorded of it."""

    system: Annotated[str, Meta(description="the system")]
    stop: Annotated[Time, Meta(description="where the run ends")]
    record: Annotated[dict[str, str], Meta(description="components, by the FMU that they are")]
    set: Annotated[Values, Meta(description="values that differ from the system's, `component.variable`")] = {}


class RecordedRuns(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """All of them."""

    run: Annotated[list[RecordedRun], Meta(description="a run each")]


def read_runs(path: Path = RUNS) -> list[RecordedRun]:
    """What is recorded of which runs. Raises InputError for a key or a value that cannot be meant."""
    file = TomlFile(path)
    checked(RecordedRuns, file.data, "", file)
    return [checked(RecordedRun, entry, f"run {k}", file, "run") for k, entry in enumerate(file.data["run"], 1)]


def record_all(fmus: Path, folder: Path) -> list[Path]:
    """Run the systems on the FMUs in a folder and write a recording per component. Raises InputError, RunError."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for case in read_runs():
        boundaries = tuple(case.record.values())
        plan = planned(assemble(case.system, case.set, str(case.stop), fmus, boundaries=boundaries))
        run = require_complete(simulate(plan))
        for fmu, component in case.record.items():
            paths += write_boundary(run, component, folder, fmu)
    return paths


def main(fmus: Path = FMUS / "native" / "fmi2", folder: Path = FMUS / "recordings") -> None:
    """Write them and say so."""
    try:
        for path in record_all(fmus, folder):
            print(f"{path} ({path.stat().st_size // 1000} kB)")
    except RovbrushError as error:
        print(f"error: {error}", file=sys.stderr)
        sys.exit(error.exit_code)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
