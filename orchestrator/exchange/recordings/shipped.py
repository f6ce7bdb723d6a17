"""The recordings that are handed over with the FMUs, one per component, as systems/recordings.toml says.

`python -m rovbrush.orchestrator.exchange.recordings.shipped [FMUS [FOLDER]]` makes them anew, by native FMUs of
FMI 2.0.
"""

from __future__ import annotations

import sys
import tomllib
from pathlib import Path

from ...errors import RovbrushError
from ...results.tables import require_complete
from ...run.planned import planned
from ...run.simulation import simulate
from ...system.assemble import assemble
from ...system.reader import SYSTEMS
from .write import write_boundary

RUNS = SYSTEMS / "recordings.toml"
FMUS = Path("fmus")


def record_all(fmus: Path, folder: Path) -> list[Path]:
    """Run the systems on the FMUs in a folder and write a recording per component. Raises InputError, RunError."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for case in tomllib.loads(RUNS.read_text(encoding="utf-8"))["run"]:
        record: dict[str, str] = case["record"]
        plan = planned(
            assemble(case["system"], case.get("set", {}), case["stop"], fmus, boundaries=tuple(record.values()))
        )
        run = require_complete(simulate(plan))
        for fmu, component in record.items():
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
