"""Where CVODE comes from, and what a run is without it."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import exchange_build
import pytest
from exchange_groups import group_of, run
from native_build import needs_gcc
from rovbrush.orchestrator import InputError, load
from rovbrush.orchestrator.integration.stiff import libraries
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.system.file.reader import load_system

pytestmark = needs_gcc
there = pytest.mark.skipif(not libraries.is_there(), reason="no CVODE on this machine")


@pytest.fixture
def anew() -> Iterator[None]:
    """Libraries are looked for again."""
    libraries.libraries.cache_clear()
    yield
    libraries.libraries.cache_clear()


@pytest.fixture
def none(anew: None, monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine that has no CVODE."""
    for place in ("_of_fmpy", "_of_folders", "_of_system"):
        monkeypatch.setattr(libraries, place, lambda: iter(()))


def system(folder: Path, fmu: str, solver: str = "", mu: float = 1.0) -> Path:
    path = folder / "system.toml"
    parameters = f"parameters = {{ mu = {mu} }}" if fmu == "oscillator" else ""
    path.write_text(
        f'format = 2\nstop_time = "5 s"\n[solver]\n{solver}\n[components.o]\nfmu = "{fmu}.fmu"\nperiod = "1 s"\n'
        f"{parameters}\n",
        encoding="utf-8",
    )
    return path


@pytest.mark.usefixtures("none")
def test_cvode_that_is_asked_for_and_is_not_there_is_an_error_that_says_what_to_do(tmp_path: Path) -> None:
    exchange_build.exchange(tmp_path, "oscillator")
    with pytest.raises(InputError, match="there is no CVODE on this machine") as raised:
        make_plan(load_system(str(system(tmp_path, "oscillator", 'method = "cvode"')), tmp_path))
    assert "install the shared libraries of SUNDIALS 7" in str(raised.value)
    assert 'take "dormand-prince"' in str(raised.value)


@pytest.mark.usefixtures("none")
def test_a_large_model_without_cvode_is_integrated_otherwise_and_the_plan_and_the_run_say_so(tmp_path: Path) -> None:
    exchange_build.chain(tmp_path, 60)
    path = system(tmp_path, "chain60", "tolerance = 1e-3")
    words = "dormand-prince (not by cvode, though it has 60 states"
    assert words in explain(make_plan(load_system(str(path), tmp_path)))
    note = load(path, stop="1 s").run().summary["notes"][0]
    assert "o: integrated by dormand-prince, not by cvode, though it has 60 states" in note
    assert "install the shared libraries" in note


@pytest.mark.usefixtures("none")
def test_a_model_that_proves_stiff_without_cvode_says_so(tmp_path: Path) -> None:
    exchange_build.exchange(tmp_path, "oscillator")
    result = load(system(tmp_path, "oscillator", mu=1000.0)).run()
    (note,) = result.summary["notes"]
    assert "o: steps are limited by stability since t = " in note and "there is no CVODE on this machine" in note


@pytest.mark.usefixtures("none")
def test_one_that_is_not_stiff_has_nothing_to_say(tmp_path: Path) -> None:
    exchange_build.exchange(tmp_path, "oscillator")
    assert not load(system(tmp_path, "oscillator")).run().summary.get("notes")


@there
@pytest.mark.skipif(sys.platform == "win32", reason="links to files")
@pytest.mark.usefixtures("anew")
def test_libraries_of_the_environment_are_taken_where_fmpy_brings_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Their names may have hashes and versions."""
    import fmpy.sundials.libraries as shipped

    place = tmp_path / "lib"
    place.mkdir()
    for part in libraries.PARTS:
        if hasattr(shipped, f"sundials_{part}"):
            source = Path(getattr(shipped, f"sundials_{part}")._name)
            (place / f"libsundials_{part}-0123abcd{source.suffix}.7").symlink_to(source)
    monkeypatch.setattr(libraries, "_of_fmpy", lambda: iter(()))
    monkeypatch.setattr(libraries, "folders", lambda: iter((tmp_path / "none", place)))
    assert {Path(library._name).parent for library in libraries.libraries()} == {place}
    with group_of(tmp_path, "oscillator", values=[{"mu": 100.0}], method="cvode") as group:
        run(group, 1.0)


@there
@pytest.mark.usefixtures("anew")
def test_libraries_that_are_too_old_or_lack_a_part_are_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(libraries, "_of_system", lambda: iter(()))
    monkeypatch.setattr(libraries, "folders", lambda: iter(()))
    monkeypatch.setattr(libraries, "OLDEST", 1000)
    assert not libraries.is_there()
    libraries.libraries.cache_clear()
    monkeypatch.setattr(libraries, "OLDEST", 7)
    monkeypatch.setattr(libraries, "NEEDED", ("CVode", "SUNLinSol_None"))
    assert not libraries.is_there()
