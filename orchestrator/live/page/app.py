"""The web application: the page for each viewer, the socket for rows, and when it ends."""

from __future__ import annotations

import asyncio
import sys
import threading
import time
from pathlib import Path

from fastapi import WebSocket
from nicegui import app, ui

from ..server import Settings
from ..viewers import Viewers
from .guard import Guard
from .link import Link
from .rows import send_rows
from .view import View

STATIC = Path(__file__).parent / "static"
AWAY = 4.0  # s that a browser may be away before its page is given up
LINGER = 1.5  # s between the end of the run and that of the server, to tell the viewers


def serve(settings: Settings) -> None:
    """Until the run's process is gone, or says so by closing the standard input."""
    link, viewers = Link(), Viewers()
    app.add_static_files("/live", str(STATIC))
    app.add_middleware(Guard, token=settings.token)
    app.on_startup(lambda: asyncio.create_task(_listen(link, settings)))
    app.on_startup(lambda: asyncio.create_task(_look(viewers)))

    @app.websocket("/rows")
    async def rows(socket: WebSocket) -> None:
        await send_rows(socket, link)

    @ui.page("/", reconnect_timeout=AWAY)
    def page() -> None:
        View(link, viewers).build()

    threading.Thread(target=_end_with_input, args=(link,), daemon=True).start()
    ui.run(
        host=settings.host, port=settings.port, reload=False, show=False, title="rovbrush live", dark=None,
        show_welcome_message=False, favicon="\N{WATER WAVE}", uvicorn_logging_level="error",
        binding_refresh_interval=None,
    )  # fmt: skip


async def _listen(link: Link, settings: Settings) -> None:
    while not await _reachable(settings):  # whoever is told of the page finds it
        await asyncio.sleep(0.05)
    await link.listen(settings)
    await asyncio.sleep(LINGER)
    app.shutdown()


async def _reachable(settings: Settings) -> bool:
    host = {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(settings.host, settings.host)
    try:
        _, writer = await asyncio.open_connection(host, settings.port)
    except OSError:
        return False
    writer.close()
    return True


async def _look(viewers: Viewers) -> None:
    while True:
        viewers.look(time.monotonic())
        await asyncio.sleep(0.5)


def _end_with_input(link: Link) -> None:
    """The run's process holds the other end: when it is gone, whatever ended it, so is this one, a little later."""
    while sys.stdin.readline():
        pass
    time.sleep(2.0 * LINGER)
    if not link.gone:
        return
    import os

    os._exit(0)  # a browser that holds on does not keep the server
