"""One point of a sweep, computed in a worker process: the plan is loaded once, the values change."""

from __future__ import annotations

import hashlib
import json
import math
import os
import signal
import threading
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import astuple, dataclass, replace
from functools import lru_cache
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from ....environment import changes, versions
from ....errors import InputError, RunError
from ....plan.algorithms.registry import algorithm_of
from ....plan.plan import Plan, make_plan
from ....processes import peak_memory
from ....results.requested import check_numeric, check_summary
from ....results.summary.figures_of_merit import figure_units
from ....results.summary.summary import figures
from ....results.tables import require_complete
from ....run.simulation import simulate
from ....system.assemble import assemble
from ....system.file.merits import merit, written
from ....system.file.recorded import reported_names
from ....system.model import System
from ....system.replace.view import crossings_of
from ....system.request import UNCHANGED, Changes
from ..design.replanned import needs_plan
from .kept import Kept

# `figures` by name or `error`; `cpu_s` and `wall_s`, means of its batch; `memory_MB` of the worker
Record = dict[str, Any]
_KEPT = Kept()
_ONE_AT_A_TIME = threading.Lock()  # workers of other makes may run several threads


@dataclass(frozen=True)
class Job:
    """What all points of a sweep share, as a worker needs it to make the same plan. Hashable, small to send."""

    system: str  # name of a shipped system, or an absolute path
    fmus: str = ""
    values: tuple[tuple[str, Any], ...] = ()
    figures: tuple[tuple[str, str], ...] = ()  # figures of merit beside those of the system file
    stop: str = ""
    digest: str = ""  # of the system in the process that began the sweep
    versions: tuple[tuple[str, str], ...] = ()  # there
    changes: Changes = UNCHANGED
    start: str = ""


def job_system(job: Job) -> System:
    """The system of a job with its figures of merit, recording only what these need. Raises InputError, FmuError."""
    fmus = Path(job.fmus) if job.fmus else None
    system = assemble(job.system, dict(job.values), job.stop, fmus, job.changes, start=job.start)
    summary = {**system.reporting["summary"], **dict(job.figures)}
    if len(system.components) == 1:
        summary = {key: _in_full(system, text) for key, text in summary.items()}
    if not summary and system.path.suffix != ".toml":  # a file in which nobody can say what to gather
        summary = last_values(system)
    return replace(system, reporting={**system.reporting, "summary": summary}, workers="1")  # every core has a point


def _in_full(system: System, text: object) -> object:
    """A figure of merit of a component alone, whose variables need no prefix."""
    if not isinstance(text, str):
        return text
    operation, names = merit(text)
    return written(operation, [system.full_name(name) for name in names])


def last_values(system: System) -> dict[str, str]:
    """What is gathered where nobody says: the last value of each output; of all locals of an FMU without any.

    Of an FMU alone the figures of merit are called by the variable's own name.
    """
    found, alone = dict[str, str](), len(system.components) == 1
    for component in system.components.values():
        fmu = component.fmu
        for name in fmu.names("output") or fmu.names("local"):
            kind = fmu.type_of(name)
            if kind is not None and kind.name not in ("String", "Binary"):
                full = f"{component.name}.{name}"
                found[f"{name if alone else full}_last"] = written("last", [full])
    return found


@lru_cache(maxsize=4)
def load(job: Job) -> Plan:
    """The plan of a job. Raises InputError, FmuError, RunError."""
    if job.versions and (differing := changes(dict(job.versions), versions())):
        raise RunError(f"the sweep began with other versions ({differing}); install the same everywhere")
    system = job_system(job)
    if job.digest and digest(system) != job.digest:
        raise RunError(
            "the system file, the parameter file or the FMUs are not those with which the sweep began; restore them, "
            "or begin another sweep in another folder"
        )
    return _planned(system)


@lru_cache(maxsize=4)
def planned(job: Job, values: tuple[tuple[str, Any], ...]) -> Plan:
    """The plan of a job with other values that a plan depends on. Raises InputError, FmuError, RunError."""
    return _planned(job_system(replace(job, values=(*job.values, *values))))


def _planned(system: System) -> Plan:
    everything = make_plan(replace(system, record=("*", *needed(system))))
    columns = {".".join(key) for group in everything.groups for key in group.columns}
    check_summary(columns, system.reporting, system.path.name)
    check_numeric(system, system.path.name)
    return make_plan(replace(system, record=needed(system)))


def needed(system: System) -> tuple[str, ...]:
    """The signals that the summary and the balance of a system read: all that a worker has to keep in memory."""
    return tuple(sorted(reported_names(system)))


def digest(system: System) -> str:
    """A hash of everything that decides the results: FMUs by content, values, periods, wiring, figures of merit."""
    components = {
        name: [
            c.fmu.digest,
            str(c.period),
            sorted(c.parameters.items()),
            sorted(c.inputs.items()),
            sorted((name, series.digest) for name, series in c.series.items()),
            c.choices,
            {variable: astuple(crossing) for variable, crossing in crossings_of(c.fmu).items()},
        ]
        for name, c in system.components.items()
    }
    wiring = [[c.label, c.transfer, c.gain, c.offset, *([c.counter] if c.counter else [])] for c in system.connections]
    wiring += [[c.label] for c in system.clock_connections]
    coupling = [system.algorithm, system.order, astuple(algorithm_of(system).settings), system.choices]
    bonds = [astuple(bond) for bond in system.bonds]
    happens = [repr(event) for event in system.events]
    reported = [system.reporting["summary"], system.reporting["balance"]]
    content = [components, wiring, bonds, coupling, [str(system.start), str(system.stop)], *reported]
    content += [happens] if happens else []
    return hashlib.sha256(json.dumps(content, default=str).encode()).hexdigest()


def run_batch(job: Job, batch: Sequence[Mapping[str, Any]]) -> list[Record]:
    """Run points one after the other. A failure of any kind becomes the `error` of its point."""
    with _ONE_AT_A_TIME:
        cpu, wall = time.process_time(), time.perf_counter()
        records = [_record(job, values) for values in batch]
        cpu, wall = (now / max(len(batch), 1) for now in (time.process_time() - cpu, time.perf_counter() - wall))
    cost = {"cpu_s": cpu, "wall_s": wall, "memory_MB": peak_memory()}  # to ask at every point takes a tenth of one
    return [record | cost for record in records]


def run_point(job: Job, values: Mapping[str, Any]) -> Record:
    """Run one point."""
    return run_batch(job, [values])[0]


def _record(job: Job, values: Mapping[str, Any]) -> Record:
    record: Record = {}
    try:
        found = _figures(job, values)
        merits = {name: found.get(name, math.nan) for name in _names(job)}  # with other sizes some may not be there
        record["figures"] = {name: value if math.isfinite(value) else None for name, value in merits.items()}
    except Exception as error:
        expected = isinstance(error, (InputError, RunError)) or hasattr(error, "exit_code")
        record["error"] = str(error) if expected else f"{type(error).__name__}: {error}"
    return record


def _figures(job: Job, values: Mapping[str, Any]) -> dict[str, float]:
    plan = load(job)
    if first := tuple((name, value) for name, value in values.items() if needs_plan(plan.system, name)):
        plan = planned(job, first)
    others = {name: value for name, value in values.items() if (name, value) not in first}
    checked = plan.system.checked(others, "--vary")
    found = None if first else _KEPT.figures(job, plan, checked)
    if found is None:
        found = figures(require_complete(simulate(replace(plan, system=plan.system.with_checked(checked)))))
    return found


@lru_cache(maxsize=4)
def _names(job: Job) -> tuple[str, ...]:
    return tuple(figure_units(load(job).system))


def begin_worker(leash: Connection) -> None:
    """Set up a worker process: the one that started it handles Ctrl-C, and its end is the end of this one."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)

    def end_with_parent() -> None:
        with suppress(EOFError, OSError):
            leash.recv_bytes()  # nothing is ever sent
        os._exit(1)

    threading.Thread(target=end_with_parent, daemon=True).start()
