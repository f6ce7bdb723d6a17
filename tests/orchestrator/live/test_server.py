"""Where the page may be, and who may see it."""

from __future__ import annotations

import asyncio
import socket
from typing import Any

import pytest
from rovbrush.orchestrator.errors import InputError
from rovbrush.orchestrator.live.page.guard import COOKIE, Guard
from rovbrush.orchestrator.live.server import checked_place

TOKEN = "anemoneofthereef2026"


def test_a_port_in_use_is_said_with_the_way_out() -> None:
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        with pytest.raises(InputError, match=f"port {port} of 127.0.0.1 is in use.*--port"):
            checked_place("127.0.0.1", port, "")


def test_port_0_is_any_that_is_free() -> None:
    assert checked_place("127.0.0.1", 0, "") > 0


@pytest.mark.parametrize("host", ["0.0.0.0", "192.168.1.2", "::", "a.name"])
def test_a_host_beyond_this_machine_needs_a_token(host: str) -> None:
    with pytest.raises(InputError, match=r"others reach it, and there is no token.*--token WORD"):
        checked_place(host, 0, "")


@pytest.mark.parametrize(
    "token", ["short", "fifteenletters1", "with spaces in it", "ümlautsandmore17", "semi;colonequals1"]
)
def test_a_token_is_letters_and_digits_enough(token: str) -> None:
    with pytest.raises(InputError, match="--token needs at least 16"):
        checked_place("127.0.0.1", 0, token)


@pytest.mark.parametrize("port", [-1, 65536])
def test_a_port_that_is_none_is_refused(port: int) -> None:
    with pytest.raises(InputError, match=f"--port {port}: a port is 1 to 65535"):
        checked_place("127.0.0.1", port, "")


def test_a_host_that_is_not_of_this_machine_is_refused() -> None:
    with pytest.raises(InputError, match=r"cannot listen at tcp://192\.0\.2\.1:0: .*; see --host and --port"):
        checked_place("192.0.2.1", 0, TOKEN)


def asked(token: str, path: str = "/", query: str = "", kind: str = "http", **headers: str) -> list[dict[str, Any]]:
    """What a request gets; 200 from whatever is guarded."""
    sent: list[dict[str, Any]] = []

    async def inside(scope: Any, receive: Any, send: Any) -> None:
        await send({"type": "inside", "status": 200})

    async def send(message: Any) -> None:
        sent.append(message)

    async def receive() -> dict[str, Any]:
        return {"type": "http.request"}

    pairs = [(key.encode(), value.encode()) for key, value in {"host": "127.0.0.1:8080", **headers}.items()]
    scope = {"type": kind, "path": path, "query_string": query.encode(), "headers": pairs}
    asyncio.run(Guard(inside, token)(scope, receive, send))
    return sent


def test_without_a_token_a_browser_here_sees_the_page() -> None:
    assert asked("")[0]["status"] == 200


def test_a_name_that_was_turned_to_this_machine_is_refused() -> None:
    assert asked("", host="evil.example:8080")[0]["status"] == 403


@pytest.mark.parametrize("kind", ["http", "websocket"])
def test_scripts_of_another_page_are_refused(kind: str) -> None:
    answer = asked("", kind=kind, origin="http://evil.example")[0]
    assert answer.get("status") == 403 or answer["code"] == 4403


@pytest.mark.parametrize(("query", "what"), [("", "is missing"), ("token=wrong", "is wrong"), ("token=", "is missing")])
def test_a_token_that_is_wrong_is_refused_in_words(query: str, what: str) -> None:
    answer = asked(TOKEN, query=query)
    assert answer[0]["status"] == 403
    assert f"the token {what}".encode() in answer[1]["body"]


def test_a_socket_without_the_token_is_closed() -> None:
    answer = asked(TOKEN, path="/rows", kind="websocket")[0]
    assert answer["type"] == "websocket.close" and answer["reason"].startswith("the token is missing")


def test_the_right_token_becomes_a_cookie_that_opens_the_page() -> None:
    answer = asked(TOKEN, query=f"token={TOKEN}")
    headers = dict(answer[0]["headers"])
    assert answer[0]["status"] == 303 and headers[b"location"] == b"/"
    cookie = headers[b"set-cookie"].decode().split(";")[0]
    assert cookie == f"{COOKIE}={TOKEN}"
    assert asked(TOKEN, cookie=cookie)[0]["status"] == 200
    assert asked(TOKEN, cookie=f"{COOKIE}=other", kind="websocket")[0]["type"] == "websocket.close"
