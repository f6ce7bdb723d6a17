"""Who looks on sees all rows as they come, by programs that are not ours; and whatever becomes of it, the run is the
same bit by bit."""

from __future__ import annotations

import csv
import json
import os
import re
import socket
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers import Part, rovbrush, system_text
from mqtt_broker import Broker
from rovbrush.orchestrator import Model, load
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.extras import how_to_install
from rovbrush.orchestrator.observers.layout import Layout, Rows
from rovbrush.orchestrator.observers.sinks.foxglove_server import FoxgloveServer
from rovbrush.orchestrator.observers.watched import Watching, watched
from rovbrush.orchestrator.results.result import Result

PARTS: dict[str, Part] = {
    "w": ("wave", "2 ms", {"c1": 2.0}), "i": ("integrator", "2 ms"), "j": ("integrator", "6 ms"),
}  # fmt: skip
WIRES = ["w.y -> i.u", "w.y -> j.u"]
MESSAGE = """
[[messages]]
topic = "/there/pose"
type = "PoseStamped"
frame = "ned"
position = ["i.x", 0.5, "w.y"]
orientation = [0.0, 0.0, "i.x"]
[[messages]]
topic = "/there/wrench"
type = "WrenchStamped"
force = ["j.x", 1, 2]
[[messages]]
topic = "/several/rates"
type = "TwistStamped"
linear = ["j.x", "i.x", 0]
"""


@pytest.fixture
def path(tmp_path: Path, fmus: Path) -> Path:
    found = tmp_path / "case.toml"
    found.write_text(system_text(PARTS, WIRES, stop="60 ms") + MESSAGE, encoding="utf-8")
    return found


@pytest.fixture
def model(path: Path, fmus: Path) -> Model:
    return load(path, fmus=fmus)


def bits(result: Result) -> list[bytes]:
    return [table.tobytes() for table in result.run.tables]


def notes(result: Result) -> list[str]:
    return [note for note in result.run.notes if "observer" in note]


def test_a_csv_stream_has_a_line_for_every_instant(model: Model, tmp_path: Path) -> None:
    result = model.run(observe=f"csv={tmp_path / 'rows.csv'}")
    with (tmp_path / "rows.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["time"]) for row in rows] == result["w.y"].time.values.tolist()
    assert [float(row["w.y"]) for row in rows] == result["w.y"].values.tolist()
    slow = [(float(row["time"]), float(row["j.x"])) for row in rows if row["j.x"]]
    assert slow == list(zip(result["j.x"].time.values.tolist(), result["j.x"].values.tolist(), strict=True))
    assert notes(result) == [f"observer csv={tmp_path / 'rows.csv'}: 42 rows"]


def test_only_some_signals_and_every_so_often(model: Model, tmp_path: Path) -> None:
    result = model.run(observe=f"csv={tmp_path / 'rows.csv'}", signals=["i.*"], every="10 ms")
    with (tmp_path / "rows.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert {"time", "i.u", "i.x"} <= set(rows[0]) and "w.y" not in rows[0] and len(rows) == 7
    assert [float(row["i.x"]) for row in rows] == result["i.x"].values[::5].tolist()


def test_an_mcap_file_is_read_back_with_its_schemas(model: Model, tmp_path: Path) -> None:
    from mcap.reader import make_reader

    result = model.run(observe=f"mcap={tmp_path / 'run.mcap'}")
    with (tmp_path / "run.mcap").open("rb") as file:
        reader = make_reader(file)
        found = [
            (schema, channel.topic, m.log_time, json.loads(m.data)) for schema, channel, m in reader.iter_messages()
        ]
    x = [(time, data["x"]) for _, topic, time, data in found if topic == "/i"]
    assert x == [
        (round(1e9 * t), v) for t, v in zip(result["i.x"].time.values, result["i.x"].values.tolist(), strict=True)
    ]
    assert {topic for _, topic, _, _ in found} == {"/w", "/i", "/j"}
    schema = next(json.loads(schema.data) for schema, topic, _, _ in found if topic == "/i" and schema)
    assert schema["properties"]["x"]["type"] == "number" and schema["title"] == "case.i"
    first = (tmp_path / "run.mcap").read_bytes()
    model.run(observe=f"mcap={tmp_path / 'run.mcap'}")
    assert (tmp_path / "run.mcap").read_bytes() == first, "the same rows are the same file"


def test_an_mcap_file_of_ros_2_is_decoded_by_its_reader(model: Model, tmp_path: Path) -> None:
    from mcap.reader import make_reader
    from mcap_ros2.decoder import DecoderFactory

    result = model.run(observe=f"ros2={tmp_path / 'run.mcap'}")
    with (tmp_path / "run.mcap").open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        found = [(channel.topic, m.log_time, decoded) for _, channel, m, decoded in reader.iter_decoded_messages()]
        assert reader.get_header().profile == "ros2"
    x, y = result["i.x"].values.tolist(), result["w.y"].values.tolist()
    assert [decoded.data for topic, _, decoded in found if topic == "/i/x"] == x
    poses = [(time, decoded) for topic, time, decoded in found if topic == "/there/pose"]
    assert [(p.pose.position.x, p.pose.position.y, p.pose.position.z) for _, p in poses] == [
        (a, 0.5, b) for a, b in zip(x, y, strict=True)
    ]
    last = poses[-1][1]
    assert (last.header.stamp.sec, last.header.stamp.nanosec, last.header.frame_id) == (0, 60_000_000, "ned")
    assert last.pose.orientation.z == pytest.approx(np.sin(x[-1] / 2)) and last.pose.orientation.x == 0.0
    wrenches = [decoded.wrench for topic, _, decoded in found if topic == "/there/wrench"]
    assert [(w.force.x, w.force.y, w.torque.z) for w in wrenches] == [(v, 1.0, 0.0) for v in result["j.x"].values]
    assert not any(topic == "/several/rates" for topic, _, _ in found)


def test_all_types_have_their_messages_in_ros_2(tmp_path: Path) -> None:
    from mcap.reader import make_reader
    from mcap_ros2.decoder import DecoderFactory
    from rovbrush.orchestrator.observers.layout import Column, Table
    from rovbrush.orchestrator.observers.sinks.ros2_file import sink_of

    kinds = {"number": np.array([0.1]), "integer": np.array([-(2**60)]), "boolean": np.array([True]),
             "string": np.array(["märz"], dtype=object)}  # fmt: skip
    columns = tuple(Column("a", f"{kind}[1]", kind, "", "") for kind in kinds)
    sink = sink_of(str(tmp_path / "run.mcap"), "ros2")
    sink.open(Layout("s", "", -1.0, 1.0, (Table("1 s", columns),)))
    sink.write(Rows(0, np.array([-0.5]), tuple(kinds.values())))
    sink.close()
    with (tmp_path / "run.mcap").open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        found = {c.topic: (m.log_time, d.data) for _, c, m, d in reader.iter_decoded_messages()}
    assert found == {f"/a/{kind}_1_": (500_000_000, value[0]) for kind, value in kinds.items()}


def test_rerun_saves_what_its_own_reader_finds(model: Model, tmp_path: Path) -> None:
    from rerun.chunk import RrdReader

    result = model.run(observe=f"rerun={tmp_path / 'run.rrd'}", signals=["i.x"])
    assert notes(result) == [f"observer rerun={tmp_path / 'run.rrd'}: 31 rows"]
    found: list[tuple[int, float]] = []
    for chunk in RrdReader(tmp_path / "run.rrd").stream():
        if chunk.entity_path == "/i/x":
            batch = chunk.to_record_batch()
            times = batch.column("time").cast("int64").to_pylist()
            scalars = batch.column("Scalars:scalars").to_pylist()
            found += [(time, row[0]) for time, row in zip(times, scalars, strict=True)]
    grid = (1e9 * result["i.x"].time.values).round().astype(int).tolist()
    assert sorted(found) == list(zip(grid, result["i.x"].values.tolist(), strict=True))


def test_each_row_is_a_datagram(model: Model) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(10.0)
        result = model.run(observe=f"udp=127.0.0.1:{receiver.getsockname()[1]}", signals=["i.x", "w.y"])
        rows = [json.loads(receiver.recv(65536)) for _ in result["i.x"].values]
    assert [row["time"] for row in rows] == result["i.x"].time.values.tolist()
    assert [row["i.x"] for row in rows] == result["i.x"].values.tolist()


def test_a_client_of_foxglove_is_told_of_every_topic_and_its_rows(model: Model) -> None:
    from websockets.sync.client import connect
    from websockets.typing import Subprotocol

    sink = FoxgloveServer("127.0.0.1", 0)
    with model.start() as session, watched(session, Watching((sink,), ("i.*",))):
        with connect(f"ws://127.0.0.1:{sink.port}", subprotocols=[Subprotocol("foxglove.sdk.v1")]) as client:
            info, channels = None, None
            while channels is None:
                said = json.loads(client.recv(timeout=10))
                info = said if said["op"] == "serverInfo" else info
                channels = said["channels"] if said["op"] == "advertise" else None
            assert info is not None and info["name"] == "case"
            assert [(c["topic"], c["encoding"]) for c in channels] == [("/i", "json")]
            assert json.loads(channels[0]["schema"])["properties"]["x"]["type"] == "number"
            client.send(json.dumps({"op": "subscribe", "subscriptions": [{"id": 7, "channelId": channels[0]["id"]}]}))
            rows: list[tuple[int, float]] = []
            while not rows:  # until the subscription has arrived
                if session.time >= session.stop:
                    pytest.fail("no row has come")
                session.step()
                rows += received(client, 0.2)
            before = session.time
            session.finish()
            while not rows or rows[-1][0] < 60_000_000:
                rows += received(client, 10.0)
        values = dict(
            zip(session.result()["i.x"].time.values.tolist(), session.result()["i.x"].values.tolist(), strict=True)
        )
    assert before < 0.06 and dict(rows) == {round(1e9 * t): values[t] for t in values if round(1e9 * t) >= rows[0][0]}


def received(client: Any, timeout: float) -> list[tuple[int, float]]:
    """Time and i.x of a message, if one comes."""
    try:
        data = client.recv(timeout=timeout)
    except TimeoutError:
        return []
    if isinstance(data, str) or data[0] != 1:
        return []
    return [(int.from_bytes(data[5:13], "little"), json.loads(data[13:])["x"])]


def test_a_broker_gets_a_message_of_each_component(model: Model) -> None:
    with Broker() as broker:
        result = model.run(observe=f"mqtt=127.0.0.1:{broker.port}/rig/one", signals=["i.x"])
        found = broker.published(len(result["i.x"].values))
    assert {topic for topic, _ in found} == {"rig/one/i"}
    assert [json.loads(data)["x"] for _, data in found] == result["i.x"].values.tolist()
    assert [json.loads(data)["time"] for _, data in found] == result["i.x"].time.values.tolist()


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
