"""Who may see the page: from elsewhere only who knows the token, and no scripts of other pages."""

from __future__ import annotations

import hmac
from collections.abc import Awaitable, Callable, MutableMapping
from http.cookies import CookieError, SimpleCookie
from typing import Any
from urllib.parse import parse_qs, urlsplit

from ...sockets import is_loopback

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]
COOKIE = "rovbrush_live"
REFUSED = 4403  # code with which a socket is closed


class Guard:
    """In front of everything that is served. Without `token` the page is this machine's alone."""

    def __init__(self, app: App, token: str = "") -> None:
        self.app, self.token = app, token

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        headers = {key.decode("latin-1").lower(): value.decode("latin-1") for key, value in scope["headers"]}
        given = parse_qs(scope.get("query_string", b"").decode("latin-1")).get("token", [""])[0]
        if why := self.refusal(headers, given):
            if scope["type"] == "websocket":
                await send({"type": "websocket.close", "code": REFUSED, "reason": why[:100]})
            else:
                await _answer(send, 403, why)
        elif scope["type"] == "http" and self.token and given:  # from now on by a cookie, and out of the address
            cookie = f"{COOKIE}={self.token}; HttpOnly; SameSite=Strict; Path=/"
            await _answer(send, 303, "", [("location", scope["path"] or "/"), ("set-cookie", cookie)])
        else:
            await self.app(scope, receive, send)

    def refusal(self, headers: MutableMapping[str, str], given: str) -> str:
        """Why a request is refused; empty if it is not. `given`: the token in its address."""
        host = headers.get("host", "")
        origin = headers.get("origin", "")
        if origin and urlsplit(origin).netloc != host:
            return f"refused: a page of {origin[:60]} cannot reach this one"
        if not self.token:
            name = urlsplit(f"//{host}").hostname or ""
            return "" if is_loopback(name) else "refused: this page is for browsers on its own machine"
        try:
            kept = SimpleCookie(headers.get("cookie", "")).get(COOKIE)
        except CookieError:
            kept = None
        for word in (given, kept.value if kept else ""):
            if hmac.compare_digest(word.encode(), self.token.encode()):
                return ""
        what = "is wrong" if given else "is missing"
        return f"the token {what}: open the address that `rovbrush live` printed, with ?token= and all that follows"


async def _answer(send: Send, status: int, text: str, headers: list[tuple[str, str]] | None = None) -> None:
    content = [("content-type", "text/plain; charset=utf-8"), *(headers or [])]
    raw = [(key.encode(), value.encode()) for key, value in content]
    await send({"type": "http.response.start", "status": status, "headers": raw})
    await send({"type": "http.response.body", "body": text.encode()})
