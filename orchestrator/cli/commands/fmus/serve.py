"""The command that runs FMUs for masters elsewhere."""

from __future__ import annotations

import signal
from pathlib import Path
from typing import Annotated, NoReturn

import typer

from ...console import tell
from ...options import app

PORT = 7400


@app.command()
def serve(
    fmus: Annotated[list[Path], typer.Argument(metavar="FMU...", help="The files to serve.")],
    port: Annotated[int, typer.Option("--port", help="Where to listen; 0: any port that is free.")] = PORT,
    host: Annotated[
        str, typer.Option("--host", help="The address to listen at; one that others reach needs a token.")
    ] = "127.0.0.1",
    token_file: Annotated[
        Path | None, typer.Option("--token-file", metavar="FILE", help="The token that masters must prove to have.")
    ] = None,
    token: Annotated[
        str, typer.Option("--token", help="The token itself, which others on this machine can see; a file hides it.")
    ] = "",
    most: Annotated[int, typer.Option("--most", min=1, help="Instances at once.")] = 16,
) -> None:
    """Run FMUs for systems elsewhere, whose components say isolation = "tcp://HOST:PORT"; until Ctrl-C."""
    from ....errors import InputError
    from ....fmu.fmu import Fmu
    from ....participant.elsewhere.connection import TOKEN, token_of
    from ....participant.elsewhere.server import Server
    from ....sockets import is_loopback

    if token and token_file:
        raise InputError("--token and --token-file: one of them is enough")
    word = token_of(token_file or "", "--token-file", token)
    opened = [Fmu.open(path.absolute()) for path in fmus]
    server = Server(opened, host, port, word, most, tell)
    for fmu in opened:
        tell(f"serving {fmu.path.name} (sha256 {fmu.digest[:12]}) at {server.address}")
    if not word:
        tell(f"without a token: any program on this machine may use it ({TOKEN} or --token-file asks for one)")
    elif not is_loopback(host):
        tell("the token is never sent, but values are, as they are; across a network that is not yours take a tunnel")
    signal.signal(signal.SIGTERM, _stopped)
    try:
        server.serve()
    except KeyboardInterrupt:
        tell("stopped")


def _stopped(_number: int, _frame: object) -> NoReturn:
    raise KeyboardInterrupt
