"""Without the extras a run and its figures are made; what needs one says which."""

from __future__ import annotations

import shutil
from importlib.metadata import packages_distributions
from pathlib import Path

import pytest
from exchange_build import exchange
from helpers import python
from native_build import feedthrough2, needs_gcc
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.extras import extra_of, needed
from test_declared import EXTRAS, PROJECT, named, normal

CODE = (
    "import sys; n = int(sys.argv[1]); sys.modules |= dict.fromkeys(sys.argv[2 + n:]); "
    "sys.argv[1:] = sys.argv[2:2 + n]; from rovbrush.orchestrator.cli.main import main; main()"
)
SYSTEM = (
    'format = 2\nstop_time = "4 ms"\n[[figures]]\nfile = "y.png"\ntitle = "y"\nsignals = ["a.y"]\n'
    '[components.a]\nfmu = "a.fmu"\nperiod = "1 ms"\n'
    'inputs = { u = 1.0, n_in = 0, mode_in = 1, on_in = false, s_in = "" }\n'
)
ALWAYS = [text for text in PROJECT["dependencies"] if ";" not in text]  # on every platform


def without_extras(*words: object, loop: Path | str = "") -> tuple[int, str]:
    """Exit code and words of a command, as if no library of an extra were installed."""
    missing = set().union(*map(named, EXTRAS.values())) - named(ALWAYS) - {"rovbrush"}
    modules = [module for module, names in packages_distributions().items() if missing & set(map(normal, names))]
    done = python(CODE, str(len(words)), *map(str, words), *modules, timeout=600.0, ROVBRUSH_LOOP=str(loop))
    return done.returncode, done.stdout + done.stderr


@needs_gcc
def test_a_run_and_its_figures_need_no_extra(tmp_path: Path, loop_library: Path) -> None:
    feedthrough2(tmp_path / "a.fmu")
    (tmp_path / "case.toml").write_text(SYSTEM)
    status, said = without_extras("run", tmp_path / "case.toml", "--out", tmp_path / "out", loop=loop_library)
    assert status == 0 and (tmp_path / "out" / "y.png").is_file(), said


@needs_gcc
def test_where_no_loop_is_shipped_and_nothing_compiles_it_that_is_said(tmp_path: Path) -> None:
    feedthrough2(tmp_path / "a.fmu")
    (tmp_path / "case.toml").write_text(SYSTEM)
    status, said = without_extras("run", tmp_path / "case.toml", "--out", tmp_path / "out")
    assert status == 2 and "python -m pip install 'rovbrush[compile]'" in said and not (tmp_path / "out").exists(), said


@needs_gcc
@pytest.mark.parametrize("isolated", ["", 'isolation = "process"\n'])
@pytest.mark.parametrize(
    ("kind", "said"), [("lag", "an FMU for Model Exchange,"), ("dc_motor", "a Python FMU of `rovbrush build`,")]
)
def test_fmus_that_are_compiled_for_here_say_what_that_needs(
    kind: str, said: str, isolated: str, tmp_path: Path, fmus: Path, loop_library: Path
) -> None:
    path = exchange(tmp_path, kind) if kind == "lag" else shutil.copy(fmus / f"{kind}.fmu", tmp_path)
    text = f'format = 2\nstop_time = "4 ms"\n[components.a]\nfmu = "{Path(path).name}"\nperiod = "1 ms"\n{isolated}'
    (tmp_path / "case.toml").write_text(text)
    status, words = without_extras("run", tmp_path / "case.toml", "--out", tmp_path / "out", loop=loop_library)
    assert status == 2 and f"component a, {said} needs numba: python -m pip install 'rovbrush[compile]'" in words, words


def test_what_needs_an_extra_says_which(tmp_path: Path) -> None:
    status, said = without_extras("sweep", "friction", "--out", tmp_path / "swept")
    assert status == 2 and "a sweep needs xarray: python -m pip install 'rovbrush[study]'" in said, said
    status, said = without_extras("reproduce", "--out", tmp_path / "report")
    assert status == 2 and "this needs scipy: python -m pip install 'rovbrush[study]'" in said, said


def test_a_library_has_the_smallest_extra_that_brings_it() -> None:
    assert extra_of("xarray") == "study" and extra_of("jinja2") == "report" and extra_of("numpy") == ""
    with pytest.raises(InputError, match="it needs No module named 'of_nobody'"):
        needed("of_nobody", "it")
