"""What holds when a server or a connection breaks, or a server has no place: one error that says which component
and when, and rows that are kept."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
from helpers import column, plan_of
from native_build import FAULTS2, FREE2, WIRES2
from rovbrush.orchestrator.errors import FmuError, RunError
from rovbrush.orchestrator.run.simulation import simulate
from rovbrush.orchestrator.run.stepping.stepping import Stepping
from serving import PARTS as PARTS
from serving import SERVERS, serving, started
from serving import native as native  # a fixture, as the next one is
from serving import quick as quick

pytestmark = SERVERS


@pytest.mark.parametrize(
    ("fault", "words", "told"),
    [
        ("crash", "its process crashed with SIGSEGV", "its process crashed with SIGSEGV"),
        ("exit", "its process ended by itself with exit code 3 at tcp://127.0.0.1:", "with exit code 3"),
        ("hang", "did not answer within 1 s, and the connection was closed", "its process was ended by SIGKILL"),
        ("error", "returned fmi2Error", "ended after"),
    ],
)
def test_what_ends_an_instance_at_a_server_is_an_error_of_the_run(
    fault: str, words: str, told: str, native: Path, tmp_path: Path
) -> None:
    """A server that is silent among them; the server says it too, goes on, and leaves no process behind."""
    parts = {
        "w": ("feedthrough2", "1 ms", FREE2),
        "bad": ("feedthrough2", "1 ms", {"fault": FAULTS2[fault], "bad_at": 0.0045}),
    }
    wires = [w.replace("a.", "w.").replace("b.", "bad.") for w in WIRES2]
    with serving(native / "feedthrough2.fmu") as server:
        of = {"bad": {"isolation": str(server.address), "timeout": "1 s"}}
        run = simulate(plan_of(tmp_path, native, parts, wires, stop="10 ms", of=of))
        assert run.failure.startswith("component bad") and words in run.failure
        assert "in the step to t = 0.005 s" in run.failure and run.end == 0.004
        t, y = column(run, "bad.y")
        assert t[-1] == 0.004 and np.all(y == 1.5)
        assert told in server.says("component bad of")
        started(tmp_path, native, server.address)


@contextmanager
def a_process_that_serves(fmu: Path) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """`rovbrush serve`, and its address."""
    command = [sys.executable, "-m", "rovbrush.orchestrator", "serve", str(fmu), "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        found = re.search(r"serving feedthrough2\.fmu .* at (tcp://\S+)", process.stdout.readline())
        assert found
        try:
            yield process, found[1]
        finally:
            process.kill()


@pytest.mark.parametrize(
    ("how", "words"),
    [
        (signal.SIGKILL, r"the connection to tcp://127\.0\.0\.1:\d+ broke"),
        (signal.SIGTERM, r"the server was stopped at tcp://127\.0\.0\.1:\d+"),
    ],
)
def test_a_server_that_ends_in_mid_run_leaves_the_rows_until_then(
    how: signal.Signals, words: str, native: Path, tmp_path: Path
) -> None:
    with a_process_that_serves(native / "feedthrough2.fmu") as (process, address):
        plan = plan_of(tmp_path, native, PARTS, ["a.y -> b.u"], stop="10 ms", of={"b": {"isolation": address}})
        with Stepping(plan) as session:
            session.step("5 ms")
            process.send_signal(how)
            process.wait()
            with pytest.raises(RunError, match=rf"component b: {words}.* in the step to t = 0\.006 s"):
                session.step("5 ms")
            result = session.result()
    assert result["b.y"].values[1:].tolist() == 5 * [1.5]


def test_two_masters_at_once_get_an_instance_each(native: Path, tmp_path: Path) -> None:
    with serving(native / "feedthrough2.fmu") as server:
        of = {"b": {"isolation": str(server.address)}}
        plans = []
        for u in (2.0, 3.0):
            parts = {**PARTS, "a": ("feedthrough2", "1 ms", {"=u": u})}
            plans.append(plan_of(tmp_path, native, parts, ["a.y -> b.u"], stop="9 ms", of=of))
        with Stepping(plans[0]) as one, Stepping(plans[1]) as other:
            for _ in range(9):
                one.step()
                other.step()
            assert (one.get("b.y"), other.get("b.y")) == (2.0, 3.0)


def test_more_instances_than_the_server_is_to_run_are_refused(native: Path, tmp_path: Path) -> None:
    with serving(native / "feedthrough2.fmu", most=1) as server:
        of = {name: {"isolation": str(server.address)} for name in "ab"}
        with pytest.raises(FmuError, match=r"component b: .* refused: it runs 1 instance already; --most allows more"):
            simulate(plan_of(tmp_path, native, PARTS, ["a.y -> b.u"], stop="9 ms", of=of))
        server.says("component a of")  # given back
        started(tmp_path, native, server.address)
