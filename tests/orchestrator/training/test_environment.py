"""Environments of Gymnasium: what an agent sets and sees, resets, ends, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from native_build import needs_gcc
from rovbrush.gym import Environment
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.studies.bench.fmus.native import feedthrough
from rovbrush.orchestrator.training.expression import Expression

pytestmark = needs_gcc
ACTIONS, SEEN = {"a.u": (-1.0, 1.0)}, {"b.y": (-2.0, 2.0)}


@pytest.fixture(scope="module")
def system(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("gym")
    feedthrough(folder / "f.fmu")
    path = folder / "two.toml"
    table = 'fmu = "f.fmu"\nperiod = "1 ms"\n'
    path.write_text(
        f'format = 2\nstop_time = "1 s"\nconnections = ["a.y -> b.u"]\n[components.a]\n{table}[components.b]\n{table}'
    )
    return path


def made(system: Path, **more: object) -> Environment:
    keys = {"actions": ACTIONS, "observations": SEEN, "reward": "-abs(b.y - 0.5)", "episode": "10 ms", **more}
    return Environment(system, **keys)  # type: ignore[arg-type]


def test_the_environment_keeps_the_rules_of_gymnasium(system: Path) -> None:
    env = made(system)
    check_env(env, skip_render_check=True)
    env.close()


def test_the_same_actions_give_the_same_bits_in_every_episode(system: Path) -> None:
    env = made(system)
    rows = []
    for _ in range(3):
        seen, info = env.reset(seed=1)
        rows.append([seen.tobytes()])
        for k in range(10):
            seen, reward, terminated, truncated, _ = env.step(np.array([0.1 * k]))
            rows[-1] += [seen.tobytes(), np.float64(reward).tobytes()]
        assert truncated and not terminated and info["time"] == 0.0
    assert rows[0] == rows[1] == rows[2] and info["reset"] == "saved states"
    env.close()


def test_expressions_end_an_episode_and_what_is_drawn_follows_the_seed(system: Path) -> None:
    env = made(system, terminated="b.y > 0.8", randomise={"a.u": "-1:1"})
    drawn = [env.reset(seed=seed)[1]["drawn"]["a.u"] for seed in (1, 2, 1)]
    assert drawn[0] == drawn[2] != drawn[1]
    assert [env.step(np.array([u]))[2] for u in (0.5, 0.9)] == [False, True]
    env.close()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"actions": {"b.u": (-1.0, 1.0)}}, "action b.u: it is driven by the connection"),
        ({"actions": {"a.v": (0.0, 1.0)}}, "has no variable 'v'"),
        ({"actions": ["a.u"]}, "declares no min of it; give its bounds"),
        ({"actions": {"a.u": (0.0, float("inf"))}}, "its bounds must be finite"),
        ({"observations": {"c.y": (0.0, 1.0)}}, "no component 'c'"),
        ({"reward": "b.z + 1"}, "column 1: .*has no variable 'z'"),
        ({"reward": "open(b.y)"}, "`open` cannot be called"),
        ({"reward": "b.y +"}, "column 6: "),
        ({"reward": "'text'"}, "is not allowed"),
        ({"period": "1.5 ms"}, "no multiple of 0.001 s"),
        ({"episode": "10.5 ms"}, "no multiple of the period"),
        ({"randomise": {"a.u": "1:0"}}, "an empty range"),
    ],
)
def test_what_cannot_be_is_one_clear_error(system: Path, change: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        made(system, **change)


@pytest.mark.parametrize(("action", "words"), [([0.0, 0.0], "shape"), ([np.nan], "nan"), ([1.5], "-1 to 1 are")])
def test_an_action_that_does_not_fit_is_refused(system: Path, action: list[float], words: str) -> None:
    env = made(system)
    with pytest.raises(RunError, match="call reset"):
        env.step(np.zeros(1))
    env.reset(seed=1)
    with pytest.raises(InputError, match=words):
        env.step(np.array(action))
    env.close()


def test_expressions_are_arithmetic() -> None:
    values = {"a.x": 2.0, "y[1]": -3.0}
    for text, value in (("a.x ** 2 - y[1] * max(1, 2, 3)", 13.0), ("not (1 < a.x <= 2) or exp(0) == 1", 1.0)):
        assert Expression(text, "reward", lambda name: lambda: values[name])() == value
    with pytest.raises(RunError, match="has no value"):
        Expression("1 / (a.x - 2)", "reward", lambda name: lambda: values[name])()
