"""Builds of Python FMUs are reproducible, and what they carry is all they need."""

from __future__ import annotations

import json
import shutil
import sys
import textwrap
import zipfile
from pathlib import Path

import pytest
from helpers import FIXTURES, python
from pythonfmu_instance import H, declared, every_component, started
from rovbrush.components.build import HERE, build
from rovbrush.orchestrator.fmu.fmu import Fmu


@pytest.mark.sampled(3)
@every_component
def test_two_builds_are_byte_identical(name: str, tmp_path: Path, fmus: Path) -> None:
    """The second one from another folder, with another hash seed, in another time zone and language."""
    code = "import os; from pathlib import Path; from rovbrush.components.build import build_all"
    code = f"{code}; os.chdir({str(tmp_path)!r}); build_all(Path('out'), ({name!r},))"
    run = python(code, PYTHONHASHSEED="77", TZ="Asia/Tokyo", LC_ALL="C")
    assert run.returncode == 0, run.stderr
    assert (tmp_path / "out" / f"{name}.fmu").read_bytes() == (fmus / f"{name}.fmu").read_bytes()


def test_any_change_of_a_source_changes_the_guid(tmp_path: Path, fmus: Path) -> None:
    changed = tmp_path / "new" / "gain"
    shutil.copytree(FIXTURES / "gain", changed)
    (changed / "kernel.py").write_text((changed / "kernel.py").read_text() + "# changed\n")
    assert declared(build(changed, tmp_path)[0]).get("guid") != declared(fmus / "gain.fmu").get("guid")


@every_component
def test_an_fmu_carries_no_path_and_no_user_of_the_machine_it_was_built_on(name: str, fmus: Path) -> None:
    with zipfile.ZipFile(fmus / f"{name}.fmu") as archive:
        for entry in archive.infolist():
            content = archive.read(entry)
            assert not entry.filename.endswith((".pyc", ".nbi", ".nbc"))
            if entry.filename.startswith("binaries/"):
                continue  # as pythonfmu ships them
            for path in (str(HERE.parent), str(Path.home()) + "/", "/tmp/", sys.prefix, str(fmus)):
                assert path.encode() not in content, f"{entry.filename} holds {path}"


@pytest.mark.sampled(3)
@every_component
def test_an_fmu_runs_from_its_own_content(name: str, fmus: Path) -> None:
    """In a process that cannot import the package: neither from the source tree nor from an installation."""
    code = textwrap.dedent("""
        import importlib.abc, sys
        class Refuse(importlib.abc.MetaPathFinder):
            def find_spec(self, name, path=None, target=None):
                if name.split(".")[0] == "rovbrush":
                    raise ImportError(f"{name} is out of reach")
        sys.path[:] = [p for p in sys.path if p]
        sys.meta_path[:] = [Refuse()] + [f for f in sys.meta_path if "editable" not in repr(f).lower()]
        import fmpy
        from fmpy import fmi2
        folder = sys.argv[1]
        described = fmpy.read_model_description(folder)
        fmu = fmi2.FMU2Slave(guid=described.guid, modelIdentifier=described.coSimulation.modelIdentifier,
                             unzipDirectory=folder, instanceName="alone")
        fmu.instantiate()
        fmu.setupExperiment(startTime=0.0)
        fmu.enterInitializationMode()
        fmu.exitInitializationMode()
        for k in range(5):
            fmu.doStep(k * 1e-3, 1e-3)
        outputs = [v for v in described.modelVariables if v.causality == "output" and v.type == "Real"]
        values = fmu.getReal([v.valueReference for v in outputs])
        fmu.terminate()
        own = {n: getattr(m, "__file__", None) for n, m in sys.modules.items() if n.startswith("rovbrush")}
        import json, os
        print(json.dumps({"values": values, "own": own, "pythonfmu": sys.modules["pythonfmu"].__file__}), flush=True)
        os._exit(0)
    """)  # fmt: skip
    folder = Fmu.open(fmus / f"{name}.fmu").folder
    run = python(code, str(folder), timeout=120.0)
    assert run.returncode == 0, run.stdout + run.stderr
    seen = json.loads(run.stdout.splitlines()[-1])
    assert seen["own"] and not any(module.split(".")[0] == "rovbrush" for module in seen["own"])
    assert all(path is None or path.startswith(str(folder)) for path in seen["own"].values())
    assert seen["pythonfmu"].startswith(str(folder)), "pythonfmu itself comes with the FMU"
    with started(fmus / f"{name}.fmu") as here:
        for k in range(5):
            here.slave.doStep(k * H, H)
        outputs = [v for v in here.fmu.names("output") if here.fmu.variables[v].type == "Real"]
        assert [here.get(v) for v in outputs] == seen["values"]
