"""One run of one system, from its file to the results folder."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from ..boundary import write_boundary
from ..changes import UNCHANGED, Changes
from ..clock import duration
from ..console import console, print_comparison, print_notes, print_summary, progress
from ..energy import require_energy
from ..errors import InputError, RunError, nearest
from ..interrupt import stop_on_interrupt
from ..plan import Plan, make_plan
from ..reader import load_system
from ..recorder import IN_MEMORY
from ..reporting import check_reporting
from ..results import prepare_folder, write_results
from ..run import Run
from ..selection import select_recorded
from ..series_file import with_files
from ..session import Session
from ..summary import comparison, summarize


def planned(
    name: str,
    values: Mapping[str, object],
    stop: str = "",
    fmus: Path | None = None,
    changes: Changes = UNCHANGED,
    boundaries: Sequence[str] = (),
    step: str = "",
    record: Sequence[str] = (),
    inputs: Sequence[Path] = (),
) -> Plan:
    """Load a system, apply changes, values and a stop time, plan it and check what it wants reported.

    `boundaries`: components of which every input and output is recorded. `step`: see `load_system`. `record`: patterns
    of what is recorded instead of what the system says. `inputs`: CSV files whose columns inputs follow. Raises
    InputError.
    """
    system = changes.apply(load_system(name, fmus, step, stop)).with_values(values, "--set")
    system = with_files(system, inputs)
    if record:
        system = select_recorded(system, record)
    for component in boundaries:
        if component not in system.components:
            raise InputError(f"--record-boundary: no component '{component}'{nearest(component, system.components)}")
    system = replace(system, record=(*system.record, *(f"{component}.*" for component in boundaries)))
    if stop:
        system = replace(system, stop=duration(stop, "--stop"))
    plan = make_plan(system)
    if boundaries and plan.adaptive:
        raise InputError(f"--record-boundary needs steps of one length; with algorithm 'ecco' they vary ({name})")
    check_reporting({".".join(key) for group in plan.groups for key in group.columns}, system)
    return plan


def run_system(
    name: str,
    out: Path,
    values: Mapping[str, object],
    stop: str,
    fmus: Path | None,
    check: bool,
    changes: Changes = UNCHANGED,
    boundaries: Sequence[str] = (),
    step: str = "",
    record: Sequence[str] = (),
    inputs: Sequence[Path] = (),
) -> None:
    """Run, print and write. Raises RunError after an early end (what was computed is written) or a failed check."""
    plan = planned(name, values, stop, fmus, changes, boundaries, step, record, inputs)
    prepare_folder(out)
    print_notes(plan.system)
    console.print("loading the FMUs; the first run compiles their kernels, which takes about half a minute")
    file = out / f".result.{os.getpid()}.tmp.nc"
    try:
        with Session(plan, file=file) as session, stop_on_interrupt(session.control):
            with progress(float(plan.system.stop), f"running {plan.system.name}") as report:
                session.advance(progress=report)
            write_run(session.run(), out, boundaries, check)
    finally:
        file.unlink(missing_ok=True)


def write_run(run: Run, out: Path, boundaries: Sequence[str], check: bool) -> None:
    """Print and write what a run left; see `run_system`."""
    summary = summarize(run)
    rows = comparison(run, summary)
    summary["comparison"] = [
        {k: row[k] for k in ("label", "unit", "reference", "value", "ratio", "within")} for row in rows
    ]
    paths = write_results(run, out, summary)
    for component in boundaries:
        paths += write_boundary(run, component, out)
    print_comparison(rows)
    print_summary(summary)
    console.print(f"wrote {', '.join(path.name for path in paths)} to {out}")
    if not isinstance(run.recorded, list):
        console.print(f"no result.csv: the tables take more than {IN_MEMORY / 1e6:g} MB; result.nc holds all rows")
    if run.failure:
        raise RunError(f"{run.failure}\nwhat was computed until then is in {out}, marked incomplete")
    require_energy(run)
    outside = [row["label"] for row in rows if row["within"] is False]
    if check and outside:
        raise RunError(f"outside their bounds: {', '.join(outside)}")
