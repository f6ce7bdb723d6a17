"""Rows to one viewer by a socket of their own: no more than the viewer takes, so that a slow one is no burden."""

from __future__ import annotations

import asyncio

import msgspec
from fastapi import WebSocket, WebSocketDisconnect

from .link import Box, Link

AHEAD = 3  # messages that a viewer has not answered
PATIENCE = 30.0  # s until a viewer that answers nothing is let go


async def send_rows(socket: WebSocket, link: Link) -> None:
    """All that the page's script needs, from the last while on, until the viewer goes."""
    await socket.accept()
    while link.hello is None:
        await asyncio.sleep(0.05)
    box, answers = Box(), asyncio.Semaphore(AHEAD)
    link.boxes.add(box)
    listening = asyncio.create_task(_answers(socket, answers))
    try:
        hello = link.hello
        about = {"signals": hello.signals, "charts": hello.charts, "scene": hello.scene, "start": hello.start}
        await socket.send_text(msgspec.json.encode(about).decode())
        attempt = link.attempt
        for message in list(link.kept):
            await socket.send_bytes(message)
        while not listening.done():
            async with asyncio.timeout(PATIENCE):
                await answers.acquire()
            while not box.rows and not listening.done():
                box.came.clear()
                try:
                    async with asyncio.timeout(1.0):
                        await box.came.wait()
                except TimeoutError:
                    continue
            if link.attempt != attempt:
                attempt = link.attempt
                await socket.send_text('{"begins": true}')
            if box.rows:
                await socket.send_bytes(box.rows.popleft())
    except (WebSocketDisconnect, RuntimeError, TimeoutError, OSError):
        pass
    finally:
        link.boxes.discard(box)
        listening.cancel()


async def _answers(socket: WebSocket, answers: asyncio.Semaphore) -> None:
    """A viewer says of each message that it was taken."""
    try:
        while True:
            await socket.receive_text()
            answers.release()
    except (WebSocketDisconnect, RuntimeError, KeyError, OSError):
        pass
