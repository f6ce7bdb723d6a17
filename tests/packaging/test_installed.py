"""What pip makes of the project runs from any folder and has all that it needs: wheel, folder and editable install.

Nothing is downloaded: the packages that rovbrush needs are borrowed from the environment of the tests.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tarfile
import tomllib
import venv
import zipfile
from pathlib import Path

import pytest
from helpers import ROOT, system_text
from rovbrush.components.declare.model_description import VERSION

SHIPPED = ("orchestrator", "components", "setup.py", "pyproject.toml", "README.md", "LICENSE", "MANIFEST.in")
WITH_FMUS = ("README.md", "verify.c", "recordings")  # of fmus/, what a wheel has whether FMUs were built or not
BUILT = {"fmus/native/fmi2/ours.fmu": VERSION, "fmus/native/fmi3/older.fmu": "0.0.1"}  # as `rovbrush build --native`
PAGES = {  # as `make docs`, with what only Sphinx needs
    "build/docs/index.html": "<html></html>",
    "build/docs/_static/documentation_options.js": f"VERSION: '{VERSION}',",
    "build/docs/_static/theme.css.map": "{}",
    "build/docs/.doctrees/index.doctree": "",
}
LEFT_OUT = {"orchestrator/README.md"}  # for readers of the repository
OFFLINE = ("--no-index", "--no-deps", "--no-build-isolation", "--quiet", "--disable-pip-version-check")


def ended_well(*command: str | Path, cwd: Path) -> str:
    """Output of a command that must succeed, run where nothing of the checkout is in reach."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "PYTEST", "PIP_"))}
    done = subprocess.run(command, cwd=cwd, env=kept, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def source(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of what the packages are made of, so that nothing is built in the checkout."""
    folder = tmp_path_factory.mktemp("source")
    for name in SHIPPED:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
        else:
            shutil.copy(ROOT / name, folder / name)
    (folder / "fmus").mkdir()
    for name in WITH_FMUS:
        copy = shutil.copytree if (ROOT / "fmus" / name).is_dir() else shutil.copy
        copy(ROOT / "fmus" / name, folder / "fmus" / name)
    for path, made_by in BUILT.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        with zipfile.ZipFile(folder / path, "w") as archive:
            archive.writestr("modelDescription.xml", f'<fmiModelDescription generationTool="rovbrush {made_by}"/>')
    for path, text in PAGES.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def wheel(source: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, made of the source distribution as a package index would."""
    folder = tmp_path_factory.mktemp("dist")
    build = "import sys; from setuptools import build_meta as b; getattr(b, sys.argv[1])(sys.argv[2])"
    ended_well(sys.executable, "-c", build, "build_sdist", folder, cwd=source)
    (sdist,) = folder.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        archive.extractall(folder, filter="data")
    ended_well(sys.executable, "-c", build, "build_wheel", folder, cwd=folder / sdist.name.removesuffix(".tar.gz"))
    return next(folder.glob("*.whl"))


def test_the_wheel_holds_every_file_of_the_packages(wheel: Path, source: Path) -> None:
    expected = set()
    for path in (file for top in ("orchestrator", "components") for file in (source / top).rglob("*")):
        name = path.relative_to(source).as_posix()
        if path.is_file() and name not in LEFT_OUT:
            public = name.removeprefix("orchestrator/public/")
            expected.add(f"rovbrush/{public}")
    files = {path.relative_to(source).as_posix() for path in (source / "fmus").rglob("*") if path.is_file()}
    expected |= {f"rovbrush/{name}" for name in files - BUILT.keys()}  # a source distribution has none of these
    with zipfile.ZipFile(wheel) as archive:
        held = {name for name in archive.namelist() if ".dist-info/" not in name}
    assert held == expected


@pytest.fixture(scope="module", params=["wheel", "folder", "editable"])
def installed(
    request: pytest.FixtureRequest, source: Path, wheel: Path, tmp_path_factory: pytest.TempPathFactory
) -> Path:
    """The folder of the programs of a fresh environment in which rovbrush is installed."""
    folder = tmp_path_factory.mktemp(request.param)
    venv.create(folder, with_pip=False, symlinks=os.name != "nt")
    programs = folder / ("Scripts" if os.name == "nt" else "bin")
    (packages,) = (folder / "Lib").glob("site-packages") if os.name == "nt" else folder.glob("lib/*/site-packages")
    borrowed = [path for path in sys.path if path.endswith(("site-packages", "dist-packages"))]
    (packages / "borrowed.pth").write_text("\n".join(borrowed), encoding="utf-8")
    here = tmp_path_factory.mktemp("here")
    if request.param == "editable":
        what: tuple[str | Path, ...] = ("--editable", source)
    else:
        what = (wheel if request.param == "wheel" else source,)
    python = programs / "python"
    ended_well(sys.executable, "-m", "pip", "--python", python, "install", *OFFLINE, *what, cwd=here)
    return programs


def test_it_says_its_version_which_stands_in_one_place(installed: Path, tmp_path: Path) -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["dynamic"] == ["version"] and "version" not in project
    assert ended_well(installed / "rovbrush", "--version", cwd=tmp_path) == f"rovbrush {VERSION}\n"
    code = "import rovbrush; print(rovbrush.__version__, rovbrush.load.__module__)"
    said = ended_well(installed / "python", "-c", code, cwd=tmp_path)
    assert said == f"{VERSION} rovbrush.orchestrator.api\n"


def test_a_folder_gives_the_fmus_that_this_version_built_there(installed: Path, source: Path, tmp_path: Path) -> None:
    code = "import rovbrush; print(rovbrush.__path__[0])"
    package = Path(ended_well(installed / "python", "-c", code, cwd=tmp_path).strip())
    assert not (source / "orchestrator" / "public" / "fmus").exists()
    if package.is_relative_to(source):
        return  # of an editable install they stay where they are
    found = {path.name for path in package.rglob("*.fmu")}
    assert found == ({"ours.fmu"} if "folder" in str(installed) else set())


def test_the_documentation_that_was_built_comes_along(installed: Path, source: Path, tmp_path: Path) -> None:
    """The pages alone, from a folder; of an editable install they stay where they are; else it is said that there are
    none."""
    command = [installed / "rovbrush", "docs", "--path"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    if "wheel" in str(installed):  # of a source distribution, which has none
        assert done.returncode == 2 and "`make docs`" in done.stderr
        return
    page = Path(done.stdout.strip())
    assert page.name == "index.html" and page.is_file() and done.returncode == 0
    if page.is_relative_to(source):
        return
    files = {path.relative_to(page.parent).as_posix() for path in page.parent.rglob("*") if path.is_file()}
    assert files == {"index.html", "_static/documentation_options.js"}


def test_without_fmus_it_says_how_to_build_them(installed: Path, tmp_path: Path) -> None:
    done = subprocess.run(
        [installed / "rovbrush", "plan", "nominal"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 1 and "`rovbrush build`" in done.stderr, done.stderr


def test_it_has_its_systems_and_sweeps(installed: Path, tmp_path: Path) -> None:
    said = ended_well(installed / "rovbrush", "systems", cwd=tmp_path)
    for path in (ROOT / "orchestrator" / "systems").rglob("*.toml"):
        if path.stem not in ("paper", "recordings"):
            assert path.stem in said


def test_it_plans_a_system(installed: Path, fmus: Path, tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_text(
        system_text({"a": ("gain", "1 ms", {"=u": 1.0}), "b": ("integrator", "2 ms")}, ["a.y -> b.u"]), encoding="utf-8"
    )
    said = ended_well(installed / "rovbrush", "plan", path, "--fmus", fmus, cwd=tmp_path)
    assert "a.y" in said and "b.u" in said


def test_it_builds_fmus_of_its_own(installed: Path, tmp_path: Path) -> None:
    code = (
        "import sys; from pathlib import Path; from rovbrush.components.build import HERE, build; "
        "[print(path.name) for path in build(HERE / 'dc_motor', Path(sys.argv[1]))]"
    )
    assert ended_well(installed / "python", "-c", code, tmp_path / "made", cwd=tmp_path) == "dc_motor.fmu\n"


ONE = pytest.mark.parametrize(
    "installed",
    ["wheel", pytest.param("folder", marks=pytest.mark.evidence), pytest.param("editable", marks=pytest.mark.evidence)],
    indirect=True,
)


@ONE
def test_it_writes_a_component_that_it_builds_and_tests(installed: Path, tmp_path: Path) -> None:
    ended_well(installed / "rovbrush", "new-component", "body", cwd=tmp_path)
    ended_well(installed / "rovbrush", "build", "./body", "--fmus", "fmus", cwd=tmp_path)
    said = ended_well(installed / "rovbrush", "test-component", "fmus/body.fmu", "--as", "./body", cwd=tmp_path)
    assert "9 passed, 0 failed" in said


@ONE
def test_components_outside_are_typed(installed: Path, tmp_path: Path) -> None:
    if not list(installed.parent.rglob("site-packages/rovbrush/py.typed")):
        pytest.skip("mypy does not look into editable installs")
    ended_well(installed / "rovbrush", "new-component", "body", cwd=tmp_path)
    said = ended_well(installed / "python", "-m", "mypy", "--strict", "body", cwd=tmp_path)
    assert "Success" in said
