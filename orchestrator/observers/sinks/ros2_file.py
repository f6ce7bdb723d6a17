"""An MCAP file as ROS 2 writes it (`ros2 bag play run.mcap`): a topic for each signal, `/motor/i`, of std_msgs, and
those of `[[messages]]` of the system file, of geometry_msgs. No ROS is needed.
"""

from __future__ import annotations

import re

from ..asked import file_of
from ..layout import Column, Layout, Rows
from ..ros2.cdr import Writer as Cdr
from ..ros2.definitions import OF_KIND, TOGETHER
from ..ros2.together import Message, left_out, messages_of
from .mcap_writer import McapWriter


class Ros2File(McapWriter):
    profile = "ros2"

    def __init__(self, path: str) -> None:
        super().__init__(path)
        self._schemas: dict[str, int] = {}
        self._signals: list[list[tuple[int, int, str]]] = []  # by table: channel, column, code of its number
        self._messages: list[list[tuple[int, Message]]] = []

    def begin(self, layout: Layout) -> str:
        for number, table in enumerate(layout.tables):
            signals = []
            for k, column in enumerate(table.columns):
                kind, definition, code = OF_KIND[column.kind]
                signals.append((self._channel(topic_of(column), kind, definition), k, code))
            self._signals.append(signals)
            together = messages_of(layout, number)
            self._messages.append(
                [(self._channel(m.topic, f"geometry_msgs/msg/{m.kind}", TOGETHER[m.kind]), m) for m in together]
            )
        missing = left_out(layout)
        what = "whose signals are not recorded or chosen, or have rows at several rates"
        return f"without {', '.join(missing)}, {what}" if missing else ""

    def _channel(self, topic: str, kind: str, definition: str) -> int:
        if kind not in self._schemas:
            self._schemas[kind] = self.writer.register_schema(kind, "ros2msg", definition.encode())
        return int(self.writer.register_channel(topic, "cdr", self._schemas[kind]))

    def write(self, rows: Rows) -> int:
        times = self.layout.nanoseconds(rows.times)
        for channel, k, code in self._signals[rows.table]:
            for time, value in zip(times, rows.values[k].tolist(), strict=True):
                cdr = Cdr().number(code, value) if code else Cdr().text(str(value))
                self.writer.add_message(channel, time, cdr.message, time)
        for channel, message in self._messages[rows.table]:
            for time, values in zip(times, rows.each(), strict=True):
                self.writer.add_message(channel, time, message.bytes(time, values), time)
        return 0


def topic_of(column: Column) -> str:
    """`/motor/i`; what no topic of ROS may have becomes `_`."""
    return "/" + "/".join(re.sub(r"\W", "_", part, flags=re.ASCII) for part in (column.component, column.variable))


def sink_of(where: str, label: str) -> Ros2File:
    """A file."""
    return Ros2File(str(file_of(where, label)))
