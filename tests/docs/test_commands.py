"""Every command and every piece of Python in README and documentation is run, or says why it is not."""

from __future__ import annotations

import os
from pathlib import Path
from time import perf_counter
from typing import Any

import pytest
import typer
from documents import COMMAND, PAGES, Block, blocks, mentioned, words
from helpers import FIXTURES, ROOT, build_fixture, rovbrush
from rovbrush.orchestrator.cli.main import app

RUN = {path: found for path in PAGES if (found := [b for b in blocks(path) if b.mark not in ("run by", "not run")])}
HERE = ("rovbrush", "cd")  # what is run in this process; all else is marked
ANYWHERE = {"--help", "--debug", "--compile"}  # options that any command takes
PYTHON_ELSEWHERE = ROOT / "orchestrator" / "README.md"  # by tests/orchestrator/test_api_examples.py


@pytest.fixture(scope="module")
def theirs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the pages call `their.fmu`: a motor as a stranger would send it."""
    return build_fixture("foreign_motor", tmp_path_factory.mktemp("theirs"))


@pytest.mark.parametrize("path", RUN, ids=lambda path: str(path.relative_to(ROOT)))
def test_what_a_page_says_can_be_done(
    path: Path,
    fmus: Path,
    shipped: Path,
    theirs: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """All blocks of a page, in their order, in a folder of its own that has FMUs, `their.fmu` and a mapping for it."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ROVBRUSH_FMUS", str(shipped))
    (tmp_path / "fmus").symlink_to(fmus)
    (tmp_path / "their.fmu").symlink_to(theirs)
    (tmp_path / "map.toml").symlink_to(FIXTURES / "foreign_motor.toml")
    names: dict[str, Any] = {"__name__": "page"}
    for block in RUN[path]:
        if block.kind == "python" and path == PYTHON_ELSEWHERE:
            continue
        if block.kind == "python":
            exec(compile("\n" * (block.line - 1) + block.text, str(path), "exec"), names)
        elif block.kind == "bash":
            for command in block.commands:
                carry_out(command, block, monkeypatch, capsys)
        else:
            Path(block.kind).write_text(block.text, encoding="utf-8")


def carry_out(command: str, block: Block, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    program, *arguments = words(command)
    if program == "cd":
        monkeypatch.chdir(arguments[0])
        return
    assert program == "rovbrush", f"{block}: '{command}' is not run; mark the block"
    capsys.readouterr()
    more = words(block.said) if block.mark == "run with" else []
    begin = perf_counter()
    code = rovbrush(monkeypatch, *arguments, *more)
    out, err = capsys.readouterr()
    with capsys.disabled():
        if os.environ.get("SHOW_COMMANDS"):
            print(f"{perf_counter() - begin:5.1f} s  {block}: {command}")
    if block.mark == "fails":
        assert code != 0 and block.said in err, f"{block}: {command}: {err}"
    else:
        assert code == 0, f"{block}: {command}: {out[-2000:]} {err}"


def test_no_block_is_left_out_without_a_reason() -> None:
    every = [block for path in PAGES for block in blocks(path)]
    assert len(every) > 20
    for block in every:
        if block.mark == "run by":
            test, _, said = block.said.partition("::")
            assert (ROOT / test).is_file(), f"{block}: there is no {test}"
            text = (ROOT / test).read_text(encoding="utf-8")
            for part in [said] if said else {words(one)[1] for one in block.commands if one.startswith("rovbrush ")}:
                assert part in text, f"{block}: {test} has no '{part}'"
        elif block.mark == "not run":
            assert len(block.said.split()) > 2, f"{block}: say why"
        elif block.kind == "bash":
            assert {words(command)[0] for command in block.commands} <= set(HERE), f"{block}: mark it"


@pytest.mark.parametrize("path", [p for p in PAGES if mentioned(p)], ids=lambda path: str(path.relative_to(ROOT)))
def test_a_command_that_is_named_exists_with_its_options(path: Path) -> None:
    commands: dict[str, Any] = typer.main.get_command(app).commands  # type: ignore[attr-defined]
    for said in mentioned(path):
        name, *rest = said.split()[1:]
        assert name in commands, f"{path.relative_to(ROOT)}: `{said}`"
        known = {one for p in commands[name].params for one in (*p.opts, *p.secondary_opts)} | ANYWHERE
        options = {word.split("=")[0].rstrip(",.;:)") for word in rest if word.startswith("--")}
        assert options <= known, f"{path.relative_to(ROOT)}: `{said}`: {options - known}"


def test_a_block_of_commands_is_found_wherever_it_stands(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "# Page\n\n    rovbrush run x\n\n<!-- not run: takes some minutes -->\n```bash\nmake run\n```\n\n"
        "```{code-block} toml\n:caption: a.toml\n\nx = 1\n```\n"
    )
    found = blocks(page)
    assert [(b.kind, b.mark, b.text) for b in found] == [
        ("bash", "", "rovbrush run x\n"),
        ("bash", "not run", "make run\n"),
        ("a.toml", "", "x = 1\n"),
    ]
    assert COMMAND.match("rovbrush run") and os.sep
