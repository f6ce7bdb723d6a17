"""How `make run` and `make test` install: uv is told what pip is configured with, and pip does it where uv cannot."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from typing import Any

import pytest

SCRIPT = Path(__file__).parents[2] / "release" / "environment.py"


def loaded() -> Any:
    """The script, which is no part of the package."""
    spec = importlib.util.spec_from_file_location("environment_of_make", SCRIPT)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


environment = loaded()
read, settings, NoUvError = environment.read, environment.settings, environment.NoUvError


def test_the_sections_of_pips_configuration_count_in_its_order() -> None:
    text = (
        ":env:.find-links='/c'\nglobal.extra-index-url='file:///a file:///b'\nglobal.find-links='/a'\n"
        "install.find-links='/b'\nfreeze.timeout='9'\nno setting at all\n"
    )
    assert read(text) == {"extra-index-url": ["file:///a", "file:///b"], "find-links": ["/c"]}


def test_where_pip_looks_uv_looks_too() -> None:
    found = {
        "index-url": ["file:///own"], "extra-index-url": ["file:///a", "file:///b"], "find-links": ["/c", "/d"],
        "cert": ["/ca.crt"], "trusted-host": ["here"], "constraint": ["/x.txt"], "timeout": ["180"],
    }  # fmt: skip
    handed = settings(found, {"PATH": "/bin"})
    assert {key: handed[key] for key in handed if key not in ("UV_INDEX_STRATEGY", "UV_PYTHON_DOWNLOADS")} == {
        "UV_DEFAULT_INDEX": "file:///own", "UV_INDEX": "file:///a file:///b", "UV_FIND_LINKS": "/c,/d",
        "SSL_CERT_FILE": "/ca.crt", "UV_INSECURE_HOST": "here", "UV_CONSTRAINT": "/x.txt", "PATH": "/bin",
    }  # fmt: skip
    assert handed["UV_INDEX_STRATEGY"] == "unsafe-best-match", "the best of all indexes, as with pip"


def test_what_uv_was_told_itself_counts_more() -> None:
    assert (
        settings({"index-url": ["file:///pip"]}, {"UV_DEFAULT_INDEX": "file:///uv"})["UV_DEFAULT_INDEX"] == "file:///uv"
    )


def test_a_setting_that_uv_lacks_leaves_it_to_pip() -> None:
    with pytest.raises(NoUvError, match="nothing like pip's setting require-hashes"):
        settings({"require-hashes": ["true"], "timeout": ["3"]}, {})


@pytest.mark.parametrize(
    ("program", "said"),
    [("#!/bin/sh\necho no such index >&2\nexit 3\n", "uv failed: no such index"), ("no program", "uv cannot be run")],
)
def test_pip_installs_where_uv_fails_and_one_line_says_so(
    program: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    uv = tmp_path / "uv"
    uv.write_text(program)
    uv.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    monkeypatch.setattr(environment, "configured", dict)
    asked: list[tuple[Path, str]] = []
    monkeypatch.setattr(environment, "by_pip", lambda folder, extra: asked.append((folder, extra)))
    environment.main(tmp_path / "venv", "compile")
    assert asked == [(tmp_path / "venv", "compile")]
    lines = capfd.readouterr().out.splitlines()
    assert len(lines) == 1 and lines[0].startswith(f"installing by pip, which takes longer: {said}")


def test_an_environment_that_is_there_is_completed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    uv, python = tmp_path / "uv", tmp_path / "venv" / "bin" / "python"
    uv.write_text(f'#!/bin/sh\necho "$@" >> {tmp_path}/calls\n')
    uv.chmod(0o755)
    python.parent.mkdir(parents=True)
    python.touch()
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    monkeypatch.setattr(environment, "configured", dict)
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    environment.main(tmp_path / "venv", "test")
    (call,) = (tmp_path / "calls").read_text().splitlines()
    assert call == f"pip install --quiet --python {python} --editable {environment.ROOT}[test]"


def test_the_lowest_versions_are_of_the_indexes_of_pip_and_chosen_by_uv_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    uv = tmp_path / "uv"
    uv.write_text(f'#!/bin/sh\necho "$UV_DEFAULT_INDEX $@" >> {tmp_path}/calls\n')
    uv.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    monkeypatch.delenv("UV_DEFAULT_INDEX", raising=False)
    monkeypatch.setattr(environment, "configured", lambda: {"index-url": ["file:///own"]})
    environment.main(tmp_path / "venv", "test", "lowest-direct")
    made, installed = (tmp_path / "calls").read_text().splitlines()
    assert made.startswith("file:///own venv") and installed.startswith("file:///own pip install")
    assert "--resolution lowest-direct --editable" in installed
    monkeypatch.setattr(environment, "by_uv", lambda *_: (_ for _ in ()).throw(NoUvError("there is none")))
    with pytest.raises(SystemExit, match="only uv chooses the versions lowest-direct: there is none"):
        environment.main(tmp_path / "venv", "test", "lowest-direct")


def test_what_ends_by_hand_ends_the_process(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(environment.sys, "executable", "/bin/false")
    with pytest.raises(SystemExit) as end:
        environment.by_pip(tmp_path / "venv", "compile")
    assert end.value.code == 1
