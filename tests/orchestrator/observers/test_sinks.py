"""What each kind of observer writes or sends is read back by programs that are not ours."""

from __future__ import annotations

import csv
import json
import socket
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mqtt_broker import Broker
from observed import notes
from rovbrush.orchestrator import Model
from rovbrush.orchestrator.observers.layout import Layout, Rows
from rovbrush.orchestrator.observers.sinks.foxglove_server import FoxgloveServer
from rovbrush.orchestrator.observers.watched import Watching, watched


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
