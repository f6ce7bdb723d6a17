"""The page of a live run as a system file states it."""

from __future__ import annotations

from pathlib import Path

import pytest
from helpers import system_text
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.live.scene import scene_of, scene_signals
from rovbrush.orchestrator.system.file.reader import load_system
from rovbrush.orchestrator.system.model import System

PART = '[[live.scene]]\nshape = "box"\nname = "hub"\nsize = [1.0, 2.0, 3.0]\n'


def system(folder: Path, live: str) -> System:
    text = system_text({"w": ("wave", "10 ms", {"c0": 2.5})}, (), "1 s")
    (folder / "case.toml").write_text(f"{text}\n{live}", "utf-8")
    return load_system(str(folder / "case.toml"), FMUS[0])


FMUS: list[Path] = []


@pytest.fixture(autouse=True, scope="module")
def _fmus(tmp_path_factory: pytest.TempPathFactory) -> None:
    from helpers import build_fixture

    folder = tmp_path_factory.mktemp("fmus")
    build_fixture("wave", folder)
    FMUS[:] = [folder]


def test_numbers_of_a_part_are_signals_and_parameters_by_name(tmp_path: Path) -> None:
    found = system(tmp_path, PART + 'at = ["w.c0", "w.y", 1]\n')
    assert scene_signals(found) == ["w.c0", "w.y"]
    scene = scene_of(found, ["w.other", "w.y"])
    assert scene is not None and scene["parts"][0]["at"] == [2.5, {"signal": 1}, 1.0]


def test_an_output_that_is_not_recorded_cannot_be_followed(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"w\.y is not recorded"):
        scene_of(system(tmp_path, PART + 'at = ["w.y"]\n'), [])


WRONG = [
    ('[live]\ncharts = [["w.z"]]\n', "no variable is called 'w.z'"),
    ('[[live.controls]]\ninput = "v.u"\n', "no variable is called 'v.u'"),
    ('[[live.controls]]\nlabel = "x"\n', "'input' is missing"),
    (PART + 'turn = "w.angle"\n', "no variable is called 'w.angle'"),
    (PART + 'on = "rotor"\n', "no part is called 'rotor'"),
    (PART + "colour = 1\n", "unknown key 'colour'"),
    (PART.replace("box", "sphere"), "unknown shape 'sphere'"),
    (PART.replace("box", "patches"), "patches need 'to' and 'under'"),
]


@pytest.mark.parametrize(("live", "message"), WRONG, ids=[message for _, message in WRONG])
def test_what_the_table_gets_wrong_is_said_with_its_place(live: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=message) as told:
        system(tmp_path, live)
    assert "case.toml" in str(told.value)
