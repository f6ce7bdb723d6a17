"""Who looks on sees all rows as they come; and whatever becomes of it, the run is the same bit by bit."""

from __future__ import annotations

import os
import re
import socket
import threading
from pathlib import Path
from typing import Any

import pytest
from helpers import Part, rovbrush, system_text
from mqtt_broker import Broker
from observed import bits, notes
from rovbrush.orchestrator import Model, load
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.extras import how_to_install
from rovbrush.orchestrator.observers.layout import Layout, Rows
from rovbrush.orchestrator.observers.watched import Watching, watched


class Raises:
    """An observer with a fault."""

    room, patience = 1_000_000, 1.0

    def __init__(self, where: str) -> None:
        self.where = where

    def open(self, layout: Layout) -> str:
        if self.where == "open":
            raise ValueError("no")
        return ""

    def write(self, rows: Rows) -> int:
        if self.where == "write":
            raise KeyError("no")
        return 0

    def close(self) -> None:
        if self.where == "close":
            raise OSError(28, "No space left on device")


class Slow(Raises):
    """One that takes its rows only when it is allowed to, with room for little."""

    def __init__(self, room: int, patience: float) -> None:
        super().__init__("nowhere")
        self.room, self.patience = room, patience
        self.go = threading.Event()

    def write(self, rows: Rows) -> int:
        self.go.wait()
        return 0


@pytest.mark.parametrize("where", ["open", "write", "close"])
def test_an_observer_that_raises_ends_alone(where: str, model: Model, tmp_path: Path) -> None:
    result = model.run(observe=[Raises(where), f"csv={tmp_path / 'rows.csv'}"])
    assert bits(result) == bits(model.run())
    told = notes(result)
    assert told[0].startswith("warning: observer Raises: ") and told[1].endswith(": 42 rows")
    assert {"open": "ValueError: no", "write": "KeyError: 'no'", "close": "No space left"}[where] in told[0]
    assert ("42 dropped" in told[0]) == (where != "close")


def test_who_is_slow_is_not_waited_for_and_what_it_misses_is_counted(model: Model) -> None:
    slow = Slow(room=200, patience=0.1)
    with model.start() as session:
        with watched(session, Watching((slow,), ("i.x",))):
            while session.time < session.stop:
                session.step()
        slow.go.set()
        result = session.result()
    assert bits(result) == bits(model.run())
    told = notes(result)[0]
    counts = [int(number) for number in re.findall(r"(\d+) (?:rows?|dropped)", told)]
    assert "it has taken nothing for 0.1 s" in told and counts[1] > 0 and sum(counts) <= 31


def test_what_waits_when_the_run_ends_is_still_sent(model: Model) -> None:
    slow = Slow(room=1_000_000, patience=20.0)
    threading.Timer(0.3, slow.go.set).start()
    result = model.run(observe=[slow], signals=["i.x"])
    assert notes(result) == ["observer Slow: 31 rows"]


def test_a_disk_that_is_full_costs_the_file_alone(model: Model) -> None:
    if not os.path.exists("/dev/full"):
        pytest.skip("a device of Linux")
    for kind in ("csv", "mcap"):
        result = model.run(observe=f"{kind}=/dev/full")
        assert bits(result) == bits(model.run())
        assert "No space left on device" in notes(result)[0]


def test_a_port_in_use_and_a_broker_that_is_away_are_told_and_the_run_goes_on(
    path: Path, model: Model, fmus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        options = ["--observe", f"foxglove={port}"]
        code = rovbrush(monkeypatch, "run", path, "--fmus", fmus, "--out", tmp_path / "out", *options)
        said = capsys.readouterr().out
        assert code == 0 and f"warning: observer foxglove={port}: " in said and "in use" in said.lower()
    result = model.run(observe=f"mqtt=127.0.0.1:{port}")
    assert bits(result) == bits(model.run()) and f"no broker at 127.0.0.1:{port}" in notes(result)[0]


def test_a_broker_that_goes_away_loses_messages_and_no_rows(model: Model) -> None:
    with Broker() as broker, model.start() as session:
        with watched(session, Watching((f"mqtt=127.0.0.1:{broker.port}",), ("i.x",))):
            session.step()
            broker.published(1)
            broker.close()
            session.finish()
        result = session.result()
    assert bits(result) == bits(model.run()) and "observer mqtt=" in notes(result)[0]


def test_a_run_that_fails_has_given_its_last_rows_too(tmp_path: Path, fmus: Path) -> None:
    parts: dict[str, Part] = {"w": ("wave", "2 ms", {"c1": 2.0}), "i": ("integrator", "2 ms")}
    failing = load_text(tmp_path, fmus, system_text(parts, ["w.y -> i.u"], stop="60 ms"))
    with failing.start() as session:
        with watched(session, Watching((f"csv={tmp_path / 'rows.csv'}",))):
            session.step("10 ms")
            session.fail("something outside")
        rows = [len(table) for table in session.run().tables]
    assert len((tmp_path / "rows.csv").read_text().splitlines()) - 1 == max(rows) == 6


def load_text(folder: Path, fmus: Path, text: str) -> Model:
    (folder / "other.toml").write_text(text, encoding="utf-8")
    return load(folder / "other.toml", fmus=fmus)


def test_rows_on_standard_output_are_alone_there(
    path: Path, fmus: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    import subprocess
    import sys

    command = [sys.executable, "-m", "rovbrush.orchestrator", "run", str(path), "--fmus", str(fmus)]
    more = ["--out", str(tmp_path / "out"), "--observe", "csv=-", "--observe-signals", "i.x"]
    done = subprocess.run([*command, *more], capture_output=True, text=True, check=True, timeout=300)
    lines = done.stdout.splitlines()
    assert lines[0] == "time,i.x" and len(lines) == 32 and "observer csv=-: 31 rows" in done.stderr


def test_what_components_print_goes_elsewhere_than_the_rows(tmp_path: Path) -> None:
    import subprocess
    import sys

    (tmp_path / "loud.py").write_text(
        'import os\n\ndef step(t, h) -> {"y": float}:\n    print("said", flush=True)\n'
        '    os.write(1, b"written\\n")\n    return t\n'
    )
    (tmp_path / "s.toml").write_text(
        'format = 2\nstop_time = "30 ms"\n[components.a]\npython = "loud.py:step"\nperiod = "10 ms"\n'
    )
    command = [sys.executable, "-m", "rovbrush.orchestrator", "run", str(tmp_path / "s.toml"), "--observe", "csv=-"]
    done = subprocess.run(
        [*command, "--out", str(tmp_path / "out")], capture_output=True, text=True, check=True, timeout=300
    )
    assert done.stdout.splitlines() == ["time,a.y", "0.0,0.0", "0.01,0.0", "0.02,0.01", "0.03,0.02"]
    assert done.stderr.count("said") == done.stderr.count("written") == 3


WRONG: dict[str, tuple[list[str], dict[str, Any], str]] = {
    "kind": (["mcapp=x"], {}, "no observer is called 'mcapp'; did you mean 'mcap'"),
    "where": (["mcap="], {}, "where to[?] Write mcap=run.mcap"),
    "nothing": (["udp"], {}, "where to[?] Write udp=127.0.0.1:9870"),
    "twice": (["udp=1.2.3.4:5", "udp=1.2.3.4:5"], {}, "it is there already"),
    "folder": (["csv=."], {}, "is a folder; give a file in it"),
    "no folder": (["csv=nowhere/rows.csv"], {}, "there is no folder .*nowhere"),
    "port": (["udp=localhost:70000"], {}, "is no address; write host:port"),
    "no port": (["udp=localhost:0"], {}, "to which port"),
    "address": (["rerun=here"], {}, "here is no address"),
    "open to all": (["foxglove=0.0.0.0:8765"], {}, "no password, so that it is served to this machine alone"),
    "topics": (["mqtt=localhost/a#"], {}, "is no beginning of topics"),
    "signals": (["csv=-"], {"signals": ("i.y",)}, "no recorded signal 'i.y'; did you mean"),
    "every": (["csv=-"], {"every": "soon"}, "--observe-every = 'soon' is not a time"),
    "nobody": ([], {"every": "1 ms"}, "go with --observe; say who looks on"),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_cannot_be_meant_is_an_error_before_the_run(case: str, model: Model) -> None:
    given, keys, message = WRONG[case]
    with pytest.raises(InputError, match=message):
        Watching(tuple(given), **keys).check(model.plan)


@pytest.mark.parametrize(
    ("module", "extra"), [("foxglove", "foxglove"), ("rerun", "rerun"), ("paho", "mqtt"), ("mcap", "mcap")]
)
def test_a_package_that_is_missing_is_named_with_its_extra(module: str, extra: str) -> None:
    error = ModuleNotFoundError("", name=module)
    assert how_to_install(error).endswith(f"'rovbrush[{extra}]'")


MESSAGES = {
    "unknown signal": ('"i.x", 0.5', '"i.xx", 0.5', "position: no variable is called 'i.xx'; did you mean 'i.x'"),
    "another's field": ("position =", "force =", "a PoseStamped has position and orientation, and no force"),
    "two numbers": ('"i.x", 0.5, ', '"i.x", ', "position"),
    "type": ("PoseStamped", "Pose", "type"),
    "topic": ("/there/pose", "there pose", "topic"),
}


@pytest.mark.parametrize("case", MESSAGES)
def test_what_is_wrong_in_a_message_is_told_with_its_line(case: str, path: Path, fmus: Path) -> None:
    old, new, words = MESSAGES[case]
    path.write_text(path.read_text().replace(old, new, 1))
    with pytest.raises(InputError, match=rf"{re.escape(words)}.*case.toml, line \d+"):
        load(path, fmus=fmus)


def test_nothing_of_the_packages_is_loaded_without_them(path: Path, fmus: Path, tmp_path: Path) -> None:
    from helpers import python

    code = (
        "import sys\nfrom rovbrush.orchestrator import load\n"
        f"load({str(path)!r}, fmus={str(fmus)!r}).run(observe='csv={tmp_path / 'r.csv'}')\n"
        "print([m for m in ('mcap', 'foxglove', 'rerun', 'paho') if m in sys.modules])"
    )
    assert python(code).stdout.strip().endswith("[]")
