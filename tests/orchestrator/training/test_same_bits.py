"""What an agent sees is what a session that is stepped by hand gives, bit by bit; and what that leaves as it was."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from native_build import needs_gcc
from rovbrush.gym import Environment
from rovbrush.orchestrator import load
from rovbrush.orchestrator.errors import InputError, RunError
from rovbrush.orchestrator.studies.bench.fmus.native import feedthrough, ring

pytestmark = needs_gcc
INPUTS, SEEN = ("c0.u[1]", "c0.u[2]"), ("c3.y[1]", "c1.y[2]", "c0.u[2]", "c2.u[1]")
PERIODS = ("1 ms", "2 ms", "4 ms", "1 ms")


@pytest.fixture(scope="module", params=["jacobi", "gauss-seidel"])
def system(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Four components of three rates, with means and held values between them."""
    path = ring(tmp_path_factory.mktemp("gym"), 4, 2, stop="1 s", closed=False)
    head, *tables = path.read_text(encoding="utf-8").split("[components.")
    tables = [table.replace("1 ms", period) for table, period in zip(tables, PERIODS, strict=True)]
    path.write_text("[components.".join([f'format = 2\nalgorithm = "{request.param}"\n{head}', *tables]))
    return path


def action(k: int) -> list[float]:
    return [math.sin(0.7 * k), math.cos(1.3 * k) / 3]


@pytest.mark.parametrize("period", ["4 ms", "12 ms"])
def test_an_episode_is_a_session_stepped_by_hand(system: Path, period: str) -> None:
    bounds = dict.fromkeys(SEEN, (-9.0, 9.0))
    env = Environment(system, dict.fromkeys(INPUTS, (-1.0, 1.0)), bounds, "c3.y[2]", period=period, episode="240 ms")
    rows = []
    for _ in range(2):
        rows.append([env.reset(seed=0)[0].tobytes()])
        over, k = False, 0
        while not over:
            seen, reward, _, over, info = env.step(np.array(action(k)))
            rows[-1].append(seen.tobytes() + np.float64(reward).tobytes() + np.float64(info["time"]).tobytes())
            k += 1
    env.close()
    with load(system, stop="240 ms", record=["c3.*"]).start() as session:
        by_hand = [np.array([session.get(name) for name in SEEN]).tobytes()]
        for k in range(len(rows[0]) - 1):
            for name, value in zip(INPUTS, action(k), strict=True):
                session.set(name, value)
            session.step(period)
            values = [session.get(name) for name in (*SEEN, "c3.y[2]")]
            by_hand.append(np.array([*values, session.time]).tobytes())
    assert rows[0] == rows[1] == by_hand and len(set(by_hand)) > 10


def test_what_is_seen_has_a_cell_though_it_is_not_recorded(system: Path) -> None:
    env = Environment(system, {INPUTS[0]: (-1.0, 1.0)}, {"c3.y[1]": (-9.0, 9.0)}, "c2.y[2]", episode="40 ms")
    assert {("c3", "y[1]"), ("c2", "y[2]")} <= set(env.plan.layout.outputs) and env.plan.groups == ()
    plain = Environment(system, {INPUTS[0]: (-1.0, 1.0)}, {"c3.u[1]": (-9.0, 9.0)}, "0", episode="40 ms")
    assert ("c3", "y[1]") not in plain.plan.layout.outputs


def test_a_writer_sets_as_the_session_does_with_its_errors(tmp_path: Path) -> None:
    feedthrough(tmp_path / "f.fmu")
    path = tmp_path / "one.toml"
    path.write_text('format = 2\nstop_time = "9 ms"\n[components.a]\nfmu = "f.fmu"\nperiod = "1 ms"\n')
    with load(path).start() as session:
        write, read, wrong = session.writer("a.u"), session.reader("a.y"), session.writer("a.v")
        for value in (0.5, -2.0, 3.25):
            write(value)
            session.step()
            assert read() == value == session.get("a.y")
        with pytest.raises(InputError, match=r"a\.v is unknown"):
            wrong(1.0)
        with pytest.raises(InputError, match="not a finite number"):
            write(math.nan)
    with pytest.raises(RunError, match="closed"):
        write(1.0)
