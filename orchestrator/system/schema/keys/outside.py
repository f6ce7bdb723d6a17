"""The keys of components that are no FMU."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta, Struct

from .values import Instant, Number, Time, Value


class VariableTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One declared variable."""

    unit: Annotated[str, Meta(description="of a Real variable")] = ""
    start: Annotated[
        bool | int | float | None,
        Meta(description="its value where nothing else is stated; of an output until its first step. Else 0 or false"),
    ] = None
    type: Annotated[
        Literal["Real", "Integer", "Boolean"] | None,
        Meta(description="else Real, or Boolean where the start is true or false"),
    ] = None
    min: Annotated[Number | None, Meta(description="its least value")] = None
    max: Annotated[Number | None, Meta(description="its largest value")] = None
    description: Annotated[str, Meta(description="what it is, in a line")] = ""
    tunable: Annotated[bool, Meta(description="of a parameter: it may be set while the run goes")] = False


Variables = dict[str, Value | VariableTable]


class DeclareTable(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The variables of what is no FMU: `"N"` is a unit, `0.5` a start value, `"0.5 N"` both, a table says all."""

    inputs: Annotated[Variables, Meta(description="what it is given")] = {}
    outputs: Annotated[Variables, Meta(description="what it gives, in the order in which a function returns it")] = {}
    parameters: Annotated[Variables, Meta(description="what is set once")] = {}
    states: Annotated[
        Variables, Meta(description="what a function returns behind its outputs, and is given again at the next step")
    ] = {}


class _Late(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How a peer takes part that is no FMU, in another program or on another machine."""

    mode: Annotated[
        Literal["free", "lockstep"],
        Meta(
            description='"free": each step takes the newest that has come, and waits for nothing; "lockstep": each '
            "step waits for the answer to what it has sent"
        ),
    ] = "free"
    timeout: Annotated[
        Time,
        Meta(
            description="in wall time; free: how old the newest may be; lockstep: how long a step waits for its answer"
        ),
    ] = "1 s"
    first: Annotated[
        Instant, Meta(description="how long the start waits for the peer, in wall time; 0 for not at all")
    ] = 0
    late: Annotated[
        Literal["hold", "default", "stop"],
        Meta(
            description="what the outputs are where it is late: as they were, or their start values; or the run ends "
            "(what was computed is kept)"
        ),
    ] = "hold"


class UdpTable(_Late, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Signals to and from another program as UDP packets, one for each step."""

    listen: Annotated[
        str,
        Meta(
            description="where packets are taken, `host:port`, and sent from; port 0 is one that is free, for peers "
            "that answer. Another host than this machine's own needs `token`"
        ),
    ] = "127.0.0.1:0"
    send: Annotated[
        str, Meta(description="where packets go, `host:port`; else to whom the last one came from that was taken")
    ] = ""
    format: Annotated[
        Literal["json", "binary"], Meta(description="of packets: a line of JSON, or little-endian doubles")
    ] = "json"
    token: Annotated[
        str,
        Meta(description='that every packet must carry; `"env:NAME"` takes it from the environment'),
    ] = ""


class SharedMemoryTable(_Late, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Signals to and from another process on this machine through shared memory."""

    name: Annotated[
        str,
        Meta(
            description="of the memory, as `multiprocessing.shared_memory` knows it (under Linux `/dev/shm/NAME`)",
            pattern=r"^[A-Za-z0-9][A-Za-z0-9_.-]{0,200}$",
            extra={"must": "a name of letters, digits, `_`, `-` and `.`"},
        ),
    ]
