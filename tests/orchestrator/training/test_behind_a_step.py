"""Environments in processes, in pictures, with callables, with FMUs that keep no state or fail."""

from __future__ import annotations

import multiprocessing
import zipfile
from pathlib import Path

import gymnasium
import numpy as np
import pytest
import rovbrush.gym
from gymnasium.vector import AsyncVectorEnv
from native_build import moody, needs_gcc
from rovbrush.gym import Environment
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.studies.bench.fmus.native import ring

pytestmark = needs_gcc
KEYS = {"actions": {"c0.u": (-1.0, 1.0)}, "observations": {"c1.y": (-2.0, 2.0)}, "episode": "10 ms"}


@pytest.fixture(scope="module")
def system(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return ring(tmp_path_factory.mktemp("gym"), 2, stop="1 s", closed=False)


def made(system: Path, **more: object) -> Environment:
    return Environment(system, **{**KEYS, "reward": "-abs(c1.y - 0.5)", **more})  # type: ignore[arg-type]


def actions(count: int) -> np.ndarray:
    return np.random.default_rng(3).uniform(-1.0, 1.0, (8, count, 1))


def test_two_processes_give_the_bits_of_two_single_environments(system: Path) -> None:
    """Randomised starts follow the seeds; no process is left."""
    make = [lambda: made(system, randomise={"c0.u": "-1:1"})] * 2
    before = multiprocessing.active_children()
    vector = AsyncVectorEnv(make)
    together = [vector.reset(seed=[5, 6])[0]]
    together += [part for given in actions(2) for part in vector.step(given)[:2]]
    vector.close()
    assert [p for p in multiprocessing.active_children() if p not in before] == []
    for k in range(2):
        env = made(system, randomise={"c0.u": "-1:1"})
        alone = [env.reset(seed=5 + k)[0]]
        alone += [part for given in actions(2) for part in env.step(given[k])[:2]]
        env.close()
        assert [np.asarray(part[k]).tobytes() for part in together] == [np.asarray(part).tobytes() for part in alone]


@pytest.mark.parametrize("processes", [True, False])
def test_many_are_made_of_one_system(system: Path, processes: bool) -> None:
    """In processes and one after the other: the bits of a single one."""
    before = multiprocessing.active_children()
    vector = rovbrush.gym.make_vec(system, 2, KEYS["actions"], KEYS["observations"], "c1.y", episode="10 ms",
                                   processes=processes)  # fmt: skip
    assert len([p for p in multiprocessing.active_children() if p not in before]) == 2 * processes
    seen, _ = vector.reset(seed=1)
    assert seen.shape == (2, 1)
    given = actions(2)
    found = np.array([vector.step(each)[1] for each in given])
    vector.close()
    env = made(system, reward="c1.y")
    env.reset(seed=1)
    assert found[:, 1].tolist() == [env.step(each[1])[1] for each in given]
    env.close()


def test_what_is_wrong_in_many_is_said_before_a_process_starts(system: Path) -> None:
    before = multiprocessing.active_children()
    wanted = (KEYS["actions"], KEYS["observations"])
    with pytest.raises(InputError, match="no component 'c7'"):
        rovbrush.gym.make_vec(system, 2, *wanted, "c7.y", episode="10 ms")
    with pytest.raises(InputError, match="0 environments; it takes a whole number of at least 1"):
        rovbrush.gym.make_vec(system, 0, *wanted, "c1.y", episode="10 ms")
    assert multiprocessing.active_children() == before


def test_recorded_episodes_are_results_and_the_steps_give_the_same_bits(system: Path) -> None:
    """A result has the rows of its episode, and keeps them when the next one begins."""
    env, quick = made(system, record=True), made(system)
    taken = []
    for seed in (1, 2):
        env.reset(seed=seed)
        quick.reset(seed=seed)
        seen = [env.step(given[0])[0].item() for given in actions(1)]
        assert seen == [quick.step(given[0])[0].item() for given in actions(1)]
        taken.append((seen, env.result()))
    for seen, result in taken:
        assert result["c1.y"].values[1:].tolist() == seen and result.run.failure == ""
    env.close()
    quick.close()


def test_an_episode_is_recorded_as_asked_until_its_failure(tmp_path: Path) -> None:
    moody(tmp_path / "moody.fmu", ON_STEP="if (t > 0.0025) return fmi2Error")
    path = tmp_path / "fails.toml"
    path.write_text('format = 2\nstop_time = "1 s"\n[components.m]\nfmu = "moody.fmu"\nperiod = "1 ms"\n')
    env = Environment(path, {"m.u": (-1.0, 1.0)}, {"m.x": (-1.0, 1.0)}, "m.x", episode="10 ms", record=["m.x"])
    with pytest.raises(RunError, match=r"call reset\(\) first"):
        env.result()
    env.reset(seed=1)
    with pytest.raises(RunError, match="component m"):
        for _ in range(5):
            env.step(np.array([1.0]))
    result = env.result()
    assert len(result["m.x"].values) == 4 and "component m" in result.run.failure
    env.close()


def test_where_nothing_is_recorded_a_result_says_how(system: Path) -> None:
    env = made(system)
    env.reset(seed=1)
    with pytest.raises(InputError, match="make the environment with record=True"):
        env.result()
    env.close()
    with pytest.raises(InputError, match="record = 'c1': True, or a list"):
        made(system, record="c1")


def test_the_failure_of_a_worker_is_one_error_and_leaves_no_process(system: Path) -> None:
    before = multiprocessing.active_children()
    vector = AsyncVectorEnv([lambda: made(system)] * 2)
    vector.reset(seed=1)
    with pytest.raises(InputError, match=r"action c0\.u = 7 1: -1 to 1 are allowed"):
        vector.step(np.array([[0.0], [7.0]]))
    vector.close(terminate=True)
    assert [p for p in multiprocessing.active_children() if p not in before] == []


def test_a_registered_environment_is_made_by_its_name(system: Path) -> None:
    rovbrush.gym.register("Chain-v0", system=str(system), **KEYS, reward="c1.y")
    try:
        env = gymnasium.make("Chain-v0")
        env.reset(seed=1)
        env.step(np.array([0.25]))
        assert env.step(np.array([0.25]))[1] == 0.25
        env.close()
        vector = gymnasium.make_vec("Chain-v0", num_envs=2)
        assert vector.reset(seed=1)[0].shape == (2, 1)
        vector.close()
    finally:
        del gymnasium.registry["Chain-v0"]


def test_a_callable_is_given_observations_and_actions_by_name(system: Path) -> None:
    given = []

    def reward(seen: dict[str, float], set_: dict[str, float]) -> float:
        given.append((dict(seen), dict(set_)))
        return seen["c1.y"] - 2.0 * set_["c0.u"]

    env = made(system, reward=reward)
    env.reset(seed=1)
    seen, value, *_ = env.step(np.array([0.5]))
    assert given == [({"c1.y": float(seen[0])}, {"c0.u": 0.5})] and value == seen[0] - 1.0
    env.close()


def test_a_picture_shows_the_episode(system: Path) -> None:
    """An axis for each observation; it changes with the steps, and without a mode there is none."""
    env = made(system, render_mode="rgb_array")
    env.reset(seed=1)
    first = env.render()
    for _ in range(5):
        env.step(np.array([0.5]))
    later = env.render()
    assert later.dtype == np.uint8 and later.shape == first.shape and later.shape[2] == 3
    assert (later != first).any() and made(system).render() is None
    env.close()
    with pytest.raises(InputError, match="there is 'rgb_array', or None"):
        made(system, render_mode="human")


def test_fmus_that_keep_no_state_are_initialized_anew_which_is_said(system: Path, tmp_path: Path) -> None:
    """The same bits as with saved states."""
    with zipfile.ZipFile(system.parent / "feedthrough1.fmu") as old, zipfile.ZipFile(tmp_path / "f.fmu", "w") as new:
        for name in old.namelist():
            new.writestr(name, old.read(name).replace(b'FMUstate="true"', b'FMUstate="false"'))
    path = tmp_path / "slow.toml"
    path.write_text(system.read_text(encoding="utf-8").replace("feedthrough1.fmu", "f.fmu"))
    with pytest.warns(UserWarning, match=r"every reset initializes the system anew: component c0: f\.fmu cannot save"):
        env = made(path)
    quick, rows = made(system), []
    for one in (env, env, quick):
        seen, info = one.reset(seed=1)
        rows.append([seen.tobytes(), *(one.step(given[0])[0].tobytes() for given in actions(1))])
        assert ("cannot save its state" in info["reset"]) is (one is env)
    assert rows[0] == rows[1] == rows[2]
    env.close()
    quick.close()


def test_an_fmu_that_fails_in_a_step_is_an_error_that_names_it_and_a_reset_begins_anew(tmp_path: Path) -> None:
    moody(tmp_path / "moody.fmu", ON_STEP="if (t > 0.0025) return fmi2Error")
    path = tmp_path / "fails.toml"
    path.write_text('format = 2\nstop_time = "1 s"\n[components.m]\nfmu = "moody.fmu"\nperiod = "1 ms"\n')
    env = Environment(path, {"m.u": (-1.0, 1.0)}, {"m.x": (-1.0, 1.0)}, "m.x", episode="10 ms")
    for _ in range(2):
        env.reset(seed=1)
        seen = [env.step(np.array([1.0]))[0].item() for _ in range(3)]
        assert seen == pytest.approx([0.001, 0.002, 0.003], rel=1e-12)
        with pytest.raises(RunError, match="component m"):
            env.step(np.array([1.0]))
        with pytest.raises(RunError, match="ended"):
            env.step(np.array([1.0]))
    env.close()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"actions": {"c1.u": (-1.0, 1.0)}}, "driven by the connection"),
        ({"actions": {"c0.y": (-1.0, 1.0)}}, "of causality output"),
        ({"actions": {"c0.u": (1.0, 1.0)}}, "need a low below high"),
        ({"actions": {"c0.u": (float("nan"), 1.0)}}, "need a low below high"),
        ({"actions": {}}, "actions: there are none"),
        ({"observations": []}, "observations: there are none"),
        ({"observations": {"c1.y": "ab"}}, "two numbers"),
        ({"reward": "__import__('os')"}, "cannot be called"),
        ({"reward": "c1.y if c0.u else 0"}, "is not allowed"),
        ({"reward": "(lambda: 1)()"}, "cannot be called"),
        ({"terminated": "c9.y > 1"}, "terminated = .*no component 'c9'"),
    ],
)
def test_further_input_that_cannot_be(system: Path, change: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        made(system, **change)
