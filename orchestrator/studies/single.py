"""One run of one system, from its file to the results folder."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from ..boundary import write_boundary
from ..changes import UNCHANGED, Changes
from ..clock import duration
from ..console import console, print_comparison, print_notes, print_summary, progress
from ..energy import require_energy
from ..errors import InputError, RunError, nearest
from ..plan import Plan, make_plan
from ..reader import load_system
from ..reporting import check_reporting
from ..results import prepare_folder, write_results
from ..series_file import with_files
from ..simulation import simulate
from ..summary import comparison, summarize


def planned(
    name: str,
    values: Mapping[str, object],
    stop: str = "",
    fmus: Path | None = None,
    changes: Changes = UNCHANGED,
    boundaries: Sequence[str] = (),
    step: str = "",
    inputs: Sequence[Path] = (),
) -> Plan:
    """Load a system, apply changes, values and a stop time, plan it and check what it wants reported.

    `boundaries`: components of which every input and output is recorded. `step`: see `load_system`.
    `inputs`: CSV files whose columns inputs follow. Raises InputError.
    """
    system = changes.apply(load_system(name, fmus, step, stop)).with_values(values, "--set")
    system = with_files(system, inputs)
    for component in boundaries:
        if component not in system.components:
            raise InputError(f"--record-boundary: no component '{component}'{nearest(component, system.components)}")
    system = replace(system, record=(*system.record, *(f"{component}.*" for component in boundaries)))
    if stop:
        system = replace(system, stop=duration(stop, "--stop"))
    plan = make_plan(system)
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
    inputs: Sequence[Path] = (),
) -> None:
    """Run, print and write. Raises RunError after an early end (what was computed is written) or a failed check."""
    plan = planned(name, values, stop, fmus, changes, boundaries, step, inputs)
    prepare_folder(out)
    print_notes(plan.system)
    console.print("loading the FMUs; the first run compiles their kernels, which takes about half a minute")
    with progress(float(plan.system.stop), f"running {plan.system.name}") as report:
        run = simulate(plan, progress=report)
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
    if run.failure:
        raise RunError(f"{run.failure}\nwhat was computed until then is in {out}, marked incomplete")
    require_energy(run)
    outside = [row["label"] for row in rows if row["within"] is False]
    if check and outside:
        raise RunError(f"outside their bounds: {', '.join(outside)}")
