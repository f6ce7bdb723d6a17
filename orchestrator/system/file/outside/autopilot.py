"""A component of a system file that is an autopilot: `ardusub`."""

from __future__ import annotations

from ipaddress import ip_address
from itertools import pairwise
from typing import Any

from ....ardupilot.interface import Options, rate_of
from ....ardupilot.servos import HEAVY, Servo
from ....clock import duration
from ....errors import InputError
from ....fmu.outside.autopilot import autopilot_fmu
from ....fmu.outside.declared import DeclaredFmu
from ....sockets import is_loopback
from ....units import parse_unit
from ...schema.checked import checked
from ...schema.keys.ardusub import ArduSubTable, ServoTable


def autopilot_of(name: str, entry: dict[str, Any], period: object) -> DeclaredFmu:
    """What a table `ardusub` declares. Raises InputError, whose text begins with what is wrong."""
    checked(ArduSubTable, entry, "ardusub")
    servos = [servo_of(one, f"ardusub.servos[{k}]") for k, one in enumerate(entry.get("servos", []), 1)]
    table = checked(ArduSubTable, {**entry, "servos": []}, "ardusub")
    host, peer = _addresses(table)
    timeout = duration(table.timeout, "ardusub: timeout")
    options = Options(
        rate=rate_of(duration(period, "period"), name),
        port=table.port,
        host=host,
        peer=peer,
        timeout=float(timeout),
        origin=(float(table.origin[0]), float(table.origin[1]), float(table.origin[2])),
        rangefinders=table.rangefinders,
        battery=table.battery,
        servos=tuple(servos) or (HEAVY,),
    )
    return autopilot_fmu(name, options)


def _addresses(table: ArduSubTable) -> tuple[str, str]:
    """`host` and `peer`, checked. Raises InputError."""
    host = "127.0.0.1" if table.host == "localhost" else table.host
    for key, stated in (("host", host), ("peer", table.peer or host)):
        try:
            ip_address(stated)
        except ValueError:
            raise InputError(f'ardusub: {key} = {stated!r} is no address; write one such as "127.0.0.1"') from None
    if not is_loopback(host) and not table.peer:
        raise InputError(
            f"ardusub: host = {host!r} can be reached by others, and the protocol knows no token; state the one "
            f'address that is listened to, peer = "192.168.2.2"'
        )
    return host, table.peer


def servo_of(entry: dict[str, Any], label: str) -> Servo:
    """One servo, checked. Raises InputError."""
    found = checked(ServoTable, entry, label)
    pulses, values = tuple(map(float, found.pulses)), tuple(map(float, found.values))
    if len(pulses) != len(values):
        raise InputError(f"{label}: {len(pulses)} pulses and {len(values)} values; each pulse needs one value")
    for low, high in pairwise(pulses):
        if not low < high:
            raise InputError(f"{label}: pulses must rise; {high:g} us stands behind {low:g} us")
    if len(set(found.channels)) < len(found.channels):
        raise InputError(f"{label}: channels = {found.channels} has one of them twice")
    if found.unit:
        parse_unit(found.unit)
    return Servo(
        found.output, tuple(found.channels), pulses, values, float(found.idle), found.unit,
        found.description or f"servo channel{'s' if len(found.channels) > 1 else ''} "
        f"{', '.join(map(str, found.channels))}",
    )  # fmt: skip
