"""Code of the loop that was compiled from other sources is never taken from Numba's cache."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from rovbrush.orchestrator.loop import run
from rovbrush.orchestrator.loop.compiled import compiled_run, loop_files, loop_hash

HERE = Path(run.__file__)
FILES = loop_files(HERE)


def test_the_loop_is_made_of_these_files() -> None:
    assert {path.stem for path in FILES} == {
        *(
            "run",
            "cells",
            "exchange",
            "calls",
            "texts",
            "types",
            "operations",
            "iteration",
            "step_control",
            "step_doubling",
            "lookup",
        )
    }


@pytest.mark.parametrize("changed", [path.name for path in FILES])
def test_a_change_in_any_of_them_gives_another_name_in_the_cache(changed: str, tmp_path: Path) -> None:
    package = HERE.parent.parent
    copied = [tmp_path / path.relative_to(package) for path in FILES]
    for path, copy in zip(FILES, copied, strict=True):
        copy.parent.mkdir(exist_ok=True)
        shutil.copy(path, copy)
    top = tmp_path / HERE.relative_to(package)
    assert loop_hash(top) == loop_hash(HERE)
    with next(copy for copy in copied if copy.name == changed).open("a", encoding="utf-8") as file:
        file.write("# changed\n")
    assert loop_hash(top) != loop_hash(HERE)


def test_numba_keeps_the_compiled_loop_under_that_name() -> None:
    stats = compiled_run().stats
    kept = [path.name for path in Path(stats.cache_path).glob(f"run.run_{loop_hash(HERE)}-*")]
    assert {name.rsplit(".", 1)[1] for name in kept} == {"nbi", "nbc"}
