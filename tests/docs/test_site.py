"""The documentation builds without a warning, and its pages ask no other server for anything."""

from __future__ import annotations

import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest
from helpers import ROOT

sys.path.insert(0, str(ROOT / "docs"))
components, messages = (import_module(f"generate.{name}") for name in ("components", "messages"))

# What a browser fetches by itself; a link that somebody may follow is none.
FETCHED = re.compile(
    r"""<(?:script|img|iframe|source|audio|video|embed)\b[^>]*\bsrc(?:set)?=["']?(?:https?:)?//[^>]*>"""
    r"""|<link\b(?=[^>]*\brel=["']?(?:stylesheet|preload|preconnect|icon|modulepreload))[^>]*\bhref=["']?(?:https?:)?//[^>]*>"""
)
FETCHED_BY_STYLE = re.compile(r"""(?:@import\s+["']|url\(["']?)(?:https?:)?//[^)]*""")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The built pages; notebooks are not executed."""
    out = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "sphinx", "-b", "html", "-W", "--keep-going", "-q", "-d", str(out / "trees")]
    said = subprocess.run(
        [*command, str(ROOT / "docs"), str(out / "html")], capture_output=True, text=True, check=False
    )
    assert said.returncode == 0, said.stdout + said.stderr
    return out / "html"


def test_the_documentation_builds_with_warnings_as_errors(site: Path) -> None:
    assert (site / "index.html").is_file() and (site / "searchindex.js").is_file()
    for page in ("tutorial/index", "reference/commands", "reference/system-file", "fmus/dc_motor", "theory/index"):
        assert (site / f"{page}.html").is_file()


def test_a_reader_needs_no_network(site: Path) -> None:
    pages = {path: path.read_text(encoding="utf-8") for path in site.rglob("*.html")}
    assert len(pages) > 20
    assert {path.name: found for path, text in pages.items() if (found := FETCHED.findall(text))} == {}
    styles = [*site.rglob("*.css")]
    assert styles and not [path for path in styles if FETCHED_BY_STYLE.search(path.read_text(encoding="utf-8"))]


def test_what_a_browser_would_fetch_is_found() -> None:
    assert FETCHED.search('<script defer src="https://cdn.example/x.js"></script>')
    assert FETCHED.search('<link href="//fonts.example/css" rel="stylesheet">')
    assert FETCHED_BY_STYLE.search("src: url(https://fonts.example/a.woff2)")
    assert not FETCHED.search('<a href="https://fmi-standard.org">FMI</a>')


def test_every_command_and_component_has_its_place(site: Path) -> None:
    import typer
    from rovbrush.components.build import COMPONENTS
    from rovbrush.orchestrator.cli.main import app

    reference = (site / "reference" / "commands.html").read_text(encoding="utf-8")
    group = typer.main.get_command(app)
    for name in group.commands:  # type: ignore[attr-defined]
        assert f'id="rovbrush-{name}"' in reference
    assert {path.stem for path in (site / "fmus").glob("*.html")} == {*COMPONENTS, "index"}


def test_equations_are_typeset(site: Path) -> None:
    text = "".join(path.read_text(encoding="utf-8") for path in (site / "theory").glob("*.html"))
    assert text.count("<math ") > 50 and "\\frac" not in text and "merror" not in text


def test_every_message_that_is_explained_is_one_of_the_code() -> None:
    said = [one.text for one in messages.messages()]
    assert len(said) > 300
    for one in messages.known():
        assert any(one["says"] in text for text in said), f"no message has '{one['says']}'"


def test_every_numbered_equation_is_typeset() -> None:
    text = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "docs" / "theory").glob("*.md"))
    shown = {tag for tag in re.findall(r"\\tag\{(\w+)\}", text)}
    computed = {n for name in components.names() for n in re.findall(r"^\| Eq\. (\w+) \|", readme(name), re.MULTILINE)}
    assert computed <= shown and shown - computed == {"1"}  # Eq. 1 is solved by its modes
    assert {n for n in re.findall(r"made: equation (\w+)", text)} == computed


def readme(name: str) -> str:
    return (ROOT / "components" / name / "README.md").read_text(encoding="utf-8")
