"""The first words of a connection: both sides prove that they have the token, and that they mean the same FMU.

The server sends a number that is used once, the master one of its own with HMAC-SHA256 of both by the token, and the
server answers with another: the token itself never crosses the wire, and who hears all of it cannot use it again. What
comes after is not encrypted. A stranger is told nothing of the FMUs.
"""

from __future__ import annotations

import ctypes
import hmac
import secrets
import sys
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any, NamedTuple, NoReturn

from ...errors import FmuError
from ..isolated.channel import Channel, ChannelBrokenError, ChannelClosedError, ChannelSilentError, from_json, to_json

PROTOCOL = 1
LONGEST = 4096  # bytes of a message before both know each other
PATIENCE = 5.0  # s for all of it
SLOWED = 0.5  # s before a wrong proof is answered
MACHINE = f"{sys.byteorder}-endian, {8 * ctypes.sizeof(ctypes.c_void_p)} bit"  # numbers and handles are as in memory
LETTER = b"H"


class RefusedError(Exception):
    """The server does not serve a connection; `why` is for its own screen."""


class Guest(NamedTuple):
    """What a master that is known wants: an FMU by its digest, for a component."""

    digest: str
    component: str


def welcome(channel: Channel, token: str, served: Mapping[str, str], reserve: Callable[[], str]) -> Guest:
    """The server's part; `served`: names of FMUs by digest; `reserve` takes a place for it, or says why there is none.

    Raises RefusedError, when the other side has been told as much as it may know.
    """
    end, nonce = time.monotonic() + PATIENCE, secrets.token_hex(16)
    try:
        _send(channel, {"protocol": PROTOCOL, "machine": MACHINE, "nonce": nonce, "token": bool(token)}, end)
        said = _received(channel, end, ("nonce", "proof", "digest", "component"))
    except ChannelBrokenError:
        raise RefusedError("it is no rovbrush") from None
    except (ChannelClosedError, ChannelSilentError):
        raise RefusedError("it did not say who it is") from None
    if token and not hmac.compare_digest(said["proof"].encode(), proof(token, "master", nonce, said["nonce"]).encode()):
        time.sleep(SLOWED)
        _refuse(channel, "its token is another one" if said["proof"] else "it wants a token", end)
    digest, known = said["digest"], ", ".join(f"{name} ({found[:12]})" for found, name in served.items())
    if digest not in served:
        _refuse(channel, f"it serves {known}", end, fmu=True)
    if why := reserve():
        _refuse(channel, why, end)
    try:
        _send(channel, {"proof": proof(token, "server", nonce, said["nonce"]) if token else ""}, end)
    except (ChannelClosedError, ChannelSilentError):
        raise RefusedError("it went away") from None
    return Guest(digest, "".join(c for c in said["component"][:80] if c.isprintable()))


def greet(channel: Channel, token: str, digest: str, file: str, component: str, where: str) -> None:
    """The master's part. Raises FmuError that says why the server does not serve it, or is none."""
    end, nonce, label = time.monotonic() + PATIENCE, secrets.token_hex(16), f"component {component}: "
    try:
        first = _received(channel, end, ("nonce", "machine"))
        if first.get("protocol") != PROTOCOL:
            raise FmuError(f"{label}the server at {where} is of another version of rovbrush; install the same on both")
        if first["machine"] != MACHINE:
            raise FmuError(f"{label}{where} is a machine of another kind ({first['machine']}; this one: {MACHINE})")
        if first.get("token") and not token:
            raise FmuError(f"{label}the server at {where} wants a token: give it by token_file or ROVBRUSH_TOKEN")
        if token and not first.get("token"):
            raise FmuError(f"{label}the server at {where} has no token; give it this one, or take it away here")
        own = proof(token, "master", first["nonce"], nonce) if token else ""
        _send(channel, {"nonce": nonce, "proof": own, "digest": digest, "component": component[:80]}, end)
        answer = _received(channel, end, ())
    except ChannelBrokenError:
        raise FmuError(f"{label}what listens at {where} is no `rovbrush serve`") from None
    except ChannelClosedError:
        raise FmuError(f"{label}{where} closed the connection; is it `rovbrush serve`?") from None
    except ChannelSilentError:
        raise FmuError(
            f"{label}what listens at {where} did not greet within {PATIENCE:g} s; is it `rovbrush serve`?"
        ) from None
    if why := answer.get("refused"):
        other = f", and the system has {file} ({digest[:12]}); give both the same file" if answer.get("fmu") else ""
        raise FmuError(f"{label}the server at {where} refused: {str(why)[:500]}{other}")
    expected = proof(token, "server", first["nonce"], nonce) if token else ""
    if not hmac.compare_digest(str(answer.get("proof", "")).encode(), expected.encode()):
        raise FmuError(f"{label}what listens at {where} does not have the token; nothing was sent to it")


def proof(token: str, who: str, servers: str, masters: str) -> str:
    """That somebody has the token, for this connection alone."""
    return hmac.digest(token.encode(), f"rovbrush {PROTOCOL} {who} {servers} {masters}".encode(), "sha256").hex()


def _refuse(channel: Channel, why: str, end: float, **more: bool) -> NoReturn:
    with suppress(ChannelClosedError, ChannelSilentError):
        _send(channel, {"refused": why, **more}, end + SLOWED)
    raise RefusedError(why)


def _send(channel: Channel, content: dict[str, Any], end: float) -> None:
    channel.send(LETTER, to_json(content), 0, end)


def _received(channel: Channel, end: float, texts: tuple[str, ...]) -> dict[str, Any]:
    """A message with these texts in it. Raises ChannelBrokenError for anything else."""
    _, letter, body = channel.receive(end)
    try:
        found = from_json(body)
    except (ValueError, TypeError, RecursionError):
        raise ChannelBrokenError from None
    if letter != LETTER or not isinstance(found, dict):
        raise ChannelBrokenError
    for key in texts:
        text = found.get(key)
        if not isinstance(text, str) or not (text.isascii() or key == "component"):
            raise ChannelBrokenError
    return found
