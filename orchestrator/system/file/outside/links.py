"""`udp` and `shared_memory` of a component: addresses, times and tokens, checked before anything is opened."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ....clock import duration, instant
from ....errors import InputError
from ....fmu.outside.declared import Declared, DeclaredFmu, declared_fmu
from ....fmu.outside.links import Host, SharedMemory, Udp, Waiting
from ....sockets import is_loopback
from ....toml.file import TomlFile
from ...schema.checked import checked
from ...schema.keys.outside import SharedMemoryTable, UdpTable

MOST = 1000  # variables of one direction: a packet of JSON stays below 64 KB


def link_component(
    file: TomlFile, name: str, entry: Mapping[str, Any], kind: str, stated: Mapping[str, list[Declared]]
) -> DeclaredFmu:
    """A component whose outputs come from another program, and whose inputs go there. Raises InputError."""
    label, heading = f"component {name}: {kind}", f"components.{name}.{kind}"
    table: UdpTable | SharedMemoryTable
    if kind == "udp":
        table = checked(UdpTable, entry[kind], label, file, heading)
    else:
        table = checked(SharedMemoryTable, entry[kind], label, file, heading)
    for group in ("parameters", "states"):
        if stated[group]:
            raise InputError(f"declare.{group} is for `python`; what comes from outside has inputs and outputs")
    variables = [*stated["inputs"], *stated["outputs"]]
    if not variables:
        raise InputError(
            f"{kind} has neither inputs nor outputs: declare what comes, [components.{name}.declare] outputs = "
            f'{{ force = "N" }}, and what goes, inputs'
        )
    if max(len(stated["inputs"]), len(stated["outputs"])) > MOST:
        raise InputError(f"{kind} has more than {MOST} inputs or outputs; split it into several components")
    waiting = Waiting(
        table.mode, float(duration(table.timeout, f"{kind}: timeout")), float(instant(table.first, f"{kind}: first")),
        table.late,
    )  # fmt: skip
    if waiting.first < 0:
        raise InputError(f"{kind}: first = {table.first!r} is negative; 0 does not wait")
    if isinstance(table, SharedMemoryTable):
        settings: Udp | SharedMemory = SharedMemory(waiting, table.name)
        path, what = Path(table.name), "shared memory"
    else:
        listen, token = _host(table.listen, "listen"), _token(table.token)
        send = _host(table.send, "send") if table.send else None
        for key, host in (("listen", listen), ("send", send)):
            if host is not None and not is_loopback(host[0]) and not token:
                raise InputError(
                    f"{kind}: {key} = {getattr(table, key)!r} is not this machine's own loopback (127.0.0.1), and "
                    f"there is no token; without one only programs on this machine take part"
                )
        if send is not None and send[1] == 0:
            raise InputError(f"{kind}: send = {table.send!r} has port 0, where nothing can be sent")
        settings, path, what = Udp(waiting, listen, send, table.format, token), Path(f"udp {table.listen}"), "UDP peer"
    made: DeclaredFmu = declared_fmu(name, variables, path, what, settings, saves=False)
    return made


def _host(text: str, key: str) -> Host:
    """`host:port`. Raises InputError."""
    host, colon, port = text.rpartition(":")
    host = host.removeprefix("[").removesuffix("]")
    if not colon or not host or not port.isascii() or not port.isdigit() or int(port) > 65535:
        raise InputError(f'{key} = {text!r} must be "host:port" with a port from 0 to 65535, as in "127.0.0.1:9010"')
    return host, int(port)


def _token(text: str) -> str:
    """The token itself, or from the environment. Raises InputError for one that is missing or is no secret."""
    if not text:
        return ""
    token = text
    if text.startswith("env:"):
        token = os.environ.get(text[4:], "")
        if not token:
            raise InputError(f"token = {text!r}: the environment has no {text[4:]}; set it before the run")
    if len(token) < 8:
        raise InputError("token is shorter than 8 characters, which is no secret")
    return token
