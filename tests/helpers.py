"""What the tests of FMUs and master share: building fixtures, writing system files, running them, reading results."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import zipfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rovbrush.components.build import build
from rovbrush.components.python.building.archive import repack
from rovbrush.orchestrator.cli.main import main
from rovbrush.orchestrator.plan.plan import Plan, make_plan
from rovbrush.orchestrator.results.tables import Run
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

FIXTURES = Path(__file__).parent / "fixtures"
ROOT = Path(__file__).parent.parent

Measured = Callable[[str, float | str, str], None]  # the fixture `measured`: claim, number, bound
Part = tuple[str, str] | tuple[str, str, Mapping[str, Any]]  # FMU, period, parameters


def build_fixture(name: str, folder: Path) -> Path:
    """A fixture as an FMU: a component folder by the project's own build, a script by plain pythonfmu."""
    if (FIXTURES / name).is_dir():
        return build(FIXTURES / name, folder)[0]
    code = "import sys; from pythonfmu.builder import FmuBuilder; print(FmuBuilder.build_FMU(sys.argv[1], sys.argv[2]))"
    raw = folder / f"raw_{name}"
    raw.mkdir(parents=True)
    subprocess.run(
        [sys.executable, "-c", code, str(FIXTURES / f"{name}.py"), str(raw)], check=True, capture_output=True
    )
    return repack(next(raw.glob("*.fmu")), folder / f"{name}.fmu")


def edited(
    fmu: Path, target: Path, changes: Mapping[str, bytes | None], replacements: Mapping[str, str] | None = None
) -> Path:
    """A copy of an FMU with entries added, exchanged or (None) dropped, and text replaced in its model description."""
    with zipfile.ZipFile(fmu) as archive:
        entries: dict[str, bytes | None] = {name: archive.read(name) for name in archive.namelist()}
    entries |= changes
    description = entries["modelDescription.xml"]
    for old, new in (replacements or {}).items():
        assert description is not None and old.encode() in description, f"nothing to replace: {old}"
        description = description.replace(old.encode(), new.encode())
    entries["modelDescription.xml"] = description
    with zipfile.ZipFile(target, "w") as archive:
        for name, content in entries.items():
            if content is not None:
                archive.writestr(name, content)
    return target


def system_text(
    parts: Mapping[str, Part], connections: Iterable[str] = (), stop: str = "1 s",
    of: Mapping[str, Mapping[str, Any]] | None = None, **keys: Any,
) -> str:  # fmt: skip
    """A system file: `parts` by name, further keys of components in `of`, further top-level keys as they are."""
    format_ = keys.pop("format", 2)
    lines = [f'stop_time = "{stop}"'] + [f"{key} = {_toml(value)}" for key, value in keys.items()]
    lines += ["connections = [", *(f"  {_toml(c)}," for c in connections), "]", f"format = {format_}"]
    for name, (fmu, period, *values) in parts.items():
        lines += ["", f"[components.{name}]", f'fmu = "{fmu}"', f'period = "{period}"']
        lines += [f"{key} = {_toml(value)}" for key, value in (of or {}).get(name, {}).items()]
        for table in ("parameters", "inputs"):
            chosen = {
                k.removeprefix("="): v
                for k, v in (values[0] if values else {}).items()
                if k.startswith("=") == (table == "inputs")
            }
            if chosen:
                lines += [f"[components.{name}.{table}]", *(f"{key} = {_toml(value)}" for key, value in chosen.items())]
    return "\n".join(lines) + "\n"


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, Mapping):
        return f"{{ {', '.join(f'{key} = {_toml(v)}' for key, v in value.items())} }}"
    return (
        json.dumps(value, ensure_ascii=False)
        if isinstance(value, str)
        else f"[{', '.join(map(_toml, value))}]"
        if isinstance(value, (list, tuple))
        else repr(value)
    )


def read_system(folder: Path, fmus: Path, *args: Any, **keys: Any) -> System:
    """Write a system file and read it: arguments as for `system_text`."""
    path = folder / "case.toml"
    path.write_text(system_text(*args, **keys), encoding="utf-8")
    return load_system(str(path), fmus)


def plan_of(folder: Path, fmus: Path, *args: Any, **keys: Any) -> Plan:
    """The plan of a system given as for `system_text`."""
    return make_plan(read_system(folder, fmus, *args, **keys))


def run_of(folder: Path, fmus: Path, *args: Any, interpreted: bool = False, **keys: Any) -> Run:
    """The run of a system given as for `system_text`, which must reach its end."""
    run = simulate(plan_of(folder, fmus, *args, **keys), interpreted)
    assert not run.failure, run.failure
    return run


def column(run: Run, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Times and values of `component.variable`."""
    key = tuple(name.split(".", 1))
    for group, table, ticks in zip(run.plan.groups, run.tables, run.ticks, strict=True):
        if key in group.columns:
            times = np.array([run.plan.clock.time(tick) for tick in ticks.tolist()])
            return times, table[:, group.columns.index(key)]
    raise KeyError(name)


def last(run: Run, name: str) -> float:
    """The value of `component.variable` at the end of a run."""
    return float(column(run, name)[1][-1])


def interrupted(command: Sequence[str], first_words: str) -> tuple[int, str]:
    """Exit code and stderr of a command that gets Ctrl-C when a line of its output begins with these words."""
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None and process.stderr is not None
        try:
            while not process.stdout.readline().startswith(first_words):
                assert process.poll() is None, process.stderr.read()
            process.send_signal(signal.SIGINT)
            _, err = process.communicate(timeout=60)
        finally:
            process.kill()
    return process.returncode, err


def rovbrush(monkeypatch: pytest.MonkeyPatch, *arguments: object) -> int:
    """The command in this process; returns its exit code."""
    monkeypatch.setattr(sys, "argv", ["rovbrush", *map(str, arguments)])
    with pytest.raises(SystemExit) as ending:
        main()
    return int(ending.value.code or 0)


def python(code: str, *arguments: str, timeout: float = 60.0, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run Python code in a process of its own."""
    command = [sys.executable, "-c", code, *arguments]
    return subprocess.run(
        command, capture_output=True, text=True, timeout=timeout, env={**os.environ, **environment}, check=False
    )
