"""An equation is one line of one file: who changes it there has changed it in every FMU, and nothing else."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from helpers import Part, column, run_of
from rovbrush.components.build import HERE, build

INPUTS = {"omega_b": 15.7, "delta": 5e-3, "v_rov": 0.05}
ROW = re.compile(r"\| Eq\. 13 \| `\S+` \| `(?P<text>[^`]+)` \| `filament_brush/(?P<file>\w+\.py):(?P<line>\d+)` \|")


@pytest.fixture(scope="module")
def changed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """FMUs of the brush in which Eq. 13 counts the normal forces twice, written where the README says that it is."""
    folder = tmp_path_factory.mktemp("equation")
    component = Path(shutil.copytree(HERE / "filament_brush", folder / "filament_brush"))
    (row,) = ROW.finditer((component / "README.md").read_text(encoding="utf-8"))
    path = component / row["file"]
    lines = path.read_text(encoding="utf-8").splitlines()
    assert row["text"] in lines[int(row["line"]) - 1]
    lines[int(row["line"]) - 1] = lines[int(row["line"]) - 1].replace("f.F_n", "2.0 * f.F_n")
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    build(component, folder / "fmus")
    if shutil.which("gcc"):
        build(component, folder / "fmus", 0, ("linux64",))
    return folder / "fmus"


def outputs(folder: Path, fmus: Path, isolation: str = "none") -> dict[str, np.ndarray]:
    """All outputs of the brush alone on a hull that it touches, over 20 steps."""
    parts: dict[str, Part] = {"b": ("filament_brush", "0.5 ms")}
    run = run_of(folder, fmus, parts, [], stop="10 ms", of={"b": {"isolation": isolation, "inputs": INPUTS}})
    assert not run.failure
    names = [name for group in run.plan.groups for part, name in group.columns if part == "b"]
    return {name: column(run, f"b.{name}")[1] for name in names}


def only_eq13_differs(seen: dict[str, np.ndarray], before: dict[str, np.ndarray]) -> None:
    differ = {name for name in before if not np.array_equal(seen[name], before[name])}
    assert differ == {"F_z_eq13"}
    friction = before["F_x"]  # the rest of Eq. 13
    normal = before["F_z_eq13"] - friction
    assert np.abs(normal).max() > 1.0
    np.testing.assert_allclose(seen["F_z_eq13"], 2.0 * normal + friction, rtol=1e-10)


@pytest.mark.evidence
@pytest.mark.skipif(not shutil.which("gcc"), reason="no C compiler: native FMUs cannot be built")
@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_an_equation_changed_in_one_line_is_changed_in_the_native_fmus(
    tmp_path: Path, changed: Path, native: Path, version: str
) -> None:
    before = outputs(tmp_path, native / version)
    only_eq13_differs(outputs(tmp_path, changed / "native" / version), before)


def test_an_equation_changed_in_one_line_is_changed_in_the_python_fmu(
    tmp_path: Path, changed: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = outputs(tmp_path, fmus)
    monkeypatch.setenv("NUMBA_DISABLE_JIT", "1")  # heard by the process of the FMU: 20 steps are not worth compiling
    only_eq13_differs(outputs(tmp_path, changed, "process"), before)
