"""An MQTT broker: a topic for each component, `PREFIX/motor`, with JSON messages of quality 0 (at most once).

Each message has the `time` of its row. While the broker is away messages are dropped and counted; it is asked again.
"""

from __future__ import annotations

import re
import threading
from typing import Any

from ...errors import InputError, RunError
from ..asked import address_of
from ..layout import Layout, Rows
from ..sink import LIVE_PATIENCE, LIVE_ROOM, encoded

PORT, PREFIX = 1883, "rovbrush"
QUEUED = 1000  # messages that the client keeps for the network
ANSWER = 5.0  # s that a broker has to answer


class Mqtt:
    room, patience = LIVE_ROOM, ANSWER + LIVE_PATIENCE

    def __init__(self, host: str, port: int, prefix: str) -> None:
        self.host, self.port, self.prefix = host, port, prefix
        self._client: Any = None
        self._topics: list[list[tuple[str, list[int], list[str]]]] = []

    def open(self, layout: Layout) -> str:
        from paho.mqtt import client
        from paho.mqtt.enums import CallbackAPIVersion

        self._client = made = client.Client(CallbackAPIVersion.VERSION2)
        made.max_queued_messages_set(QUEUED)
        made.connect_timeout = ANSWER
        answered, refused = threading.Event(), list[str]()

        def on_connect(_client: Any, _data: Any, _flags: Any, code: Any, _properties: Any) -> None:
            refused[:] = [str(code)] if code.is_failure else []
            answered.set()

        made.on_connect = on_connect
        try:
            made.connect(self.host, self.port)
        except OSError as error:
            raise RunError(f"no broker at {self.host}:{self.port}: {error.strerror or error}") from None
        made.loop_start()
        if not answered.wait(ANSWER):
            raise RunError(f"the broker at {self.host}:{self.port} did not answer for {ANSWER:g} s")
        if refused:
            raise RunError(f"the broker at {self.host}:{self.port} refused: {refused[0]}")
        self._topics = [
            [
                (f"{self.prefix}/{component}", columns, ["time", *(table.columns[k].variable for k in columns)])
                for component, columns in table.parts().items()
            ]
            for table in layout.tables
        ]
        return f"MQTT topics {self.prefix}/# at {self.host}:{self.port}"

    def write(self, rows: Rows) -> int:
        lost = [False] * len(rows.times)
        for topic, columns, names in self._topics[rows.table]:
            for k, (time, values) in enumerate(zip(rows.times.tolist(), rows.each(columns), strict=True)):
                payload = encoded(dict(zip(names, (time, *values), strict=True)))
                lost[k] |= self._client.publish(topic, payload).rc != 0
        return sum(lost)

    def close(self) -> None:
        if self._client is not None:
            self._client.disconnect()
            self._client.loop_stop()


def sink_of(where: str, label: str) -> Mqtt:
    """`host`, `host:port`, with `/prefix` behind them or not."""
    address, slash, prefix = where.partition("/")
    if slash and not re.fullmatch(r"[^#+\0]+", prefix):
        raise InputError(f"{label}: '{prefix}' is no beginning of topics; write {address}/prefix, without # and +")
    return Mqtt(*address_of(address, label, port=PORT), prefix or PREFIX)
