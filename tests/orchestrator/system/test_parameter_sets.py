"""Sets of parameters: by name or by file, named by the system or by who runs it, under the system's own values."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from helpers import rovbrush, system_text
from rovbrush.orchestrator import load
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.plan.explain import explain
from rovbrush.orchestrator.plan.plan import make_plan
from rovbrush.orchestrator.studies.sweep.workers.point import Job, job_system
from rovbrush.orchestrator.system.assemble import assemble, assemble_request
from rovbrush.orchestrator.system.file.parameter_sets import shipped_sets
from rovbrush.orchestrator.system.request import Changes, Request, changes_of

SOFT = 'description = "half of everything"\n\n[g]\nk = 0.5\n[another]\nk = 9.0\n'


@pytest.fixture
def system(tmp_path: Path) -> Path:
    """A gain that names no set, with two sets beside it."""
    path = tmp_path / "case.toml"
    path.write_text(system_text({"g": ("gain", "1 ms"), "w": ("wave", "1 ms")}, ["w.y -> g.u"], stop="5 ms"))
    (tmp_path / "soft.toml").write_text(SOFT)
    (tmp_path / "hard.toml").write_text("[g]\nk = 7.0\n")
    return path


def gain_of(path: Path, fmus: Path, parameters: str = "") -> object:
    system = assemble(str(path), {}, fmus=fmus, changes=changes_of((), (), (), parameters=parameters))
    return system.components["g"].parameters.get("k")


def test_a_set_is_a_file_beside_the_system_known_by_its_name(system: Path, fmus: Path) -> None:
    assert gain_of(system, fmus) is None
    assert gain_of(system, fmus, "soft") == 0.5
    assert gain_of(system, fmus, "hard") == 7.0


def test_a_set_is_also_known_by_its_path_from_anywhere(
    system: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path.parent)
    assert gain_of(system, fmus, f"{tmp_path.name}/hard.toml") == 7.0


@pytest.mark.parametrize("name", ["values.txt", "values"])
def test_a_file_of_any_name_is_a_set(
    system: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, name: str
) -> None:
    (tmp_path / name).write_text("[g]\nk = 6.0\n")
    monkeypatch.chdir(tmp_path)
    assert gain_of(system, fmus, name) == 6.0
    monkeypatch.chdir(tmp_path.parent)
    system.write_text(f'parameters = "{name}"\n{system.read_text()}')
    assert gain_of(system, fmus) == 6.0


def test_the_chosen_set_takes_the_place_of_the_one_that_the_system_names(system: Path, fmus: Path) -> None:
    system.write_text(f'parameters = "soft"\n{system.read_text()}')
    assert gain_of(system, fmus) == 0.5
    assert gain_of(system, fmus, "hard") == 7.0


def test_values_of_the_system_come_over_the_set_and_those_of_the_user_over_both(system: Path, fmus: Path) -> None:
    system.write_text(system.read_text().replace("[components.g]", "[components.g]\nparameters = { k = 3.0 }"))
    assert gain_of(system, fmus, "soft") == 3.0
    changes = Changes(parameters="soft")
    assert assemble(str(system), {"g.k": 4.0}, fmus=fmus, changes=changes).components["g"].parameters["k"] == 4.0


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("sof", None, "no parameter set 'sof'; did you mean 'soft'?"),
        ("case.toml", None, "'stop_time' must be a table of values"),
        ("bad", "description = 3\n[g]\nk = 1.0\n", "'description' must be a text"),
        ("bad", "k = 1.0\n", "'k' must be a table of values"),
        ("bad", "[g]\nkk = 1.0\n", "kk"),
        ("gone.toml", None, "gone.toml"),
    ],
)
def test_what_is_no_set_is_one_error_that_names_it(
    system: Path, fmus: Path, name: str, text: str | None, said: str
) -> None:
    if text is not None:
        (system.parent / f"{name}.toml").write_text(text)
    chosen = str(system.parent / name) if name.endswith(".toml") else name
    with pytest.raises(InputError, match=said.replace("?", "[?]")):
        gain_of(system, fmus, chosen)


def test_the_error_about_a_set_that_the_system_names_has_its_line(system: Path, fmus: Path) -> None:
    system.write_text(f'parameters = "sof"\n{system.read_text()}')
    with pytest.raises(InputError, match=r"no parameter set 'sof'; did you mean 'soft'.*case.toml, line 1"):
        gain_of(system, fmus)


def test_plan_run_and_manifest_say_which_set_was_taken(
    system: Path, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    plan = make_plan(assemble(str(system), {}, fmus=fmus, changes=Changes(parameters="soft")))
    assert "parameters: soft (half of everything)" in explain(plan)
    out = tmp_path / "out"
    assert rovbrush(monkeypatch, "run", system, "--fmus", fmus, "--parameters", "soft", "--out", out) == 0
    assert "parameters: soft (half of everything)" in capsys.readouterr().out
    (manifest,) = out.rglob("manifest.json")
    assert json.loads(manifest.read_text())["parameters"] == "soft (half of everything)"


def test_sweeps_checkpoints_and_the_api_take_the_same_set(
    system: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    changes = changes_of((), (), (), parameters="hard.toml")
    request = Request(str(system), parameters="hard.toml", fmus=str(fmus))
    again = Request.of(json.loads(json.dumps(request.content())))
    monkeypatch.chdir(tmp_path.parent)
    assert job_system(Job(str(system), str(fmus), changes=changes)).components["g"].parameters["k"] == 7.0
    assert assemble_request(again).components["g"].parameters["k"] == 7.0
    assert load(system, fmus=fmus, parameters="hard").system.components["g"].parameters["k"] == 7.0


def test_a_set_with_a_base_comes_over_the_system_and_a_base_may_have_one_too(
    system: Path, fmus: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """What a study found from what a study found: both come over the system's own value, the later one on top."""
    text = system.read_text().replace('period = "1 ms"', 'period = "1 ms"\nparameters = { k = 2.0 }', 1)
    system.write_text(f'parameters = "soft"\n{text}')
    (tmp_path / "first").mkdir()
    (tmp_path / "second").mkdir()
    (tmp_path / "first" / "found.toml").write_text('base = ""\n[g]\nk = 3.0\noffset = 1.0\n')
    second = tmp_path / "second" / "found.toml"
    second.write_text('base = "../first/found.toml"\n[g]\noffset = 5.0\n')
    for folder in (tmp_path, tmp_path.parent):  # a base is looked for from where its set stands
        monkeypatch.chdir(folder)
        taken = assemble(str(system), {}, fmus=fmus, changes=changes_of((), (), (), parameters=str(second)))
        parameters = taken.components["g"].parameters
        assert (parameters["k"], parameters["offset"]) == (3.0, 5.0)
    assert gain_of(system, fmus) == 2.0
    system.write_text(f'parameters = "first/found.toml"\n{text}')  # which has nothing below it but the system
    assert gain_of(system, fmus) == 3.0


def test_a_base_that_is_missing_or_leads_back_is_one_error_that_names_the_set(
    system: Path, fmus: Path, tmp_path: Path
) -> None:
    (tmp_path / "one.toml").write_text('base = "two"\n[g]\nk = 1.0\n')
    (tmp_path / "two.toml").write_text('base = "one"\n[g]\nk = 2.0\n')
    (tmp_path / "lost.toml").write_text('base = "nowhere"\n[g]\nk = 2.0\n')
    with pytest.raises(InputError, match=r"'base' leads back to one.toml.*two.toml"):
        gain_of(system, fmus, "one")
    with pytest.raises(InputError, match=r"no parameter set 'nowhere'.*lost.toml"):
        gain_of(system, fmus, "lost")


def test_shipped_sets_say_what_they_are() -> None:
    assert all(shipped_sets().values()) and "paper" in shipped_sets()
