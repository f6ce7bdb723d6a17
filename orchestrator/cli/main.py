"""The command `rovbrush`. Exit codes: 0 success, 1 a failed check or run, 2 usage."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from contextlib import suppress
from itertools import pairwise
from typing import NoReturn

import typer

from ..errors import RovbrushError
from ..extras import how_to_install
from .guard import guarded
from .options import app

# Importing the commands registers them, in the order of the help.
# isort: off
from .commands.studies import bench
from .commands.installed import cache
from .commands.fmus import check
from .commands.installed import doctor
from .commands.fmus import exchange
from .commands.studies import fit
from .commands.fmus import fmu
from .commands.studies import linear
from .commands import live, look, new
from .commands.studies import optimise
from .commands import paper, run
from .commands.installed import schema
from .commands.studies import sensitivity
from .commands.fmus import serve
from .commands.installed import shipped
from .commands.studies import study
# isort: on

__all__ = [
    "bench",
    "cache",
    "check",
    "doctor",
    "exchange",
    "fit",
    "fmu",
    "linear",
    "live",
    "look",
    "main",
    "new",
    "optimise",
    "paper",
    "program",
    "run",
    "schema",
    "sensitivity",
    "serve",
    "shipped",
    "study",
]


# The commands that load FMUs into their own process.
LOADING = (
    "run",
    "live",
    "plan",
    "converge",
    "calibrate",
    "reproduce",
    "design",
    "strategies",
    "bench",
    "linearise",
    "margins",
    "fit",
)


COMPILE = "ROVBRUSH_COMPILE"  # see fmu/files/compiled.py, which few commands need


def program() -> NoReturn:
    """The command as it is started from a shell: what loads FMUs is guarded against their crashes."""
    if command_of(sys.argv[1:]) in LOADING:
        guarded(main)
    main()


def command_of(arguments: Sequence[str]) -> str:
    """The command: the first word, since the options before it have no values."""
    return next((word for word in arguments if not word.startswith("-")), "")


def with_factor(arguments: list[str]) -> list[str]:
    """`--real-time` stands for `--real-time 1` where no number follows."""
    found: list[str] = []
    for k, word in enumerate(arguments):
        following = arguments[k + 1] if k + 1 < len(arguments) else ""
        alone = word == "--real-time" and not following[:1].isdigit() and not following.startswith(".")
        found.append(f"{word}=1" if alone else word)
    return found


def no_factor(arguments: list[str], message: str) -> str:
    """What to say of the word behind `--real-time` that is no number, where that is what is wrong; else empty."""
    for word, following in pairwise(arguments):
        if word == "--real-time" and not following.startswith("-") and f"({following})" in message:
            return (
                f"--real-time {following}: write how many times faster than the clock, such as --real-time 2, or "
                "nothing behind it for real time"
            )
    return ""


def main() -> NoReturn:
    """Entry point: every error that a user can meet becomes one message on stderr and an exit code."""
    arguments = with_factor([a for a in sys.argv[1:] if a not in ("--debug", "--compile")])
    debug = "--debug" in sys.argv[1:]
    if "--compile" in sys.argv[1:]:
        os.environ[COMPILE] = "1"  # for processes that are started here, too
    try:
        code = app(arguments, prog_name="rovbrush", standalone_mode=False)
    except RovbrushError as error:
        if debug:
            raise
        complain(str(error))
        code = error.exit_code
    except typer.Exit as stop:
        code = stop.exit_code
    except (typer.Abort, KeyboardInterrupt):
        complain("interrupted")
        code = 1
    except Exception as error:
        if hasattr(error, "format_message"):  # a usage error found by the command line's own parser
            if message := error.format_message():  # empty behind the help that the bare command prints
                complain(no_factor(sys.argv[1:], message) or f"{message} (see `rovbrush --help`)")
            code = 2
        elif debug:
            raise
        elif isinstance(error, ModuleNotFoundError) and (how := how_to_install(error)):
            complain(f"this needs {how}")
            code = 2
        else:
            complain(f"unexpected {type(error).__name__}: {error}; run again with --debug for the traceback")
            code = 1
    code = code if isinstance(code, int) else 0
    if lost := unprinted():
        complain(f"not everything could be printed: {lost}")
        code = code or 1
    sys.exit(code)


def complain(message: str) -> None:
    """An error on stderr, if anybody is there."""
    with suppress(OSError):
        print(f"error: {message}", file=sys.stderr, flush=True)


def unprinted() -> str:
    """Why stdout did not take everything, empty if it did; nothing that is left over is printed when Python ends."""
    printer = sys.modules.get(f"{__package__}.console")  # most commands do without it
    lost = str(printer.stdout.lost) if printer else ""
    try:
        sys.stdout.flush()
    except OSError as error:
        lost = lost or error.strerror or str(error)
        sys.stdout = open(os.devnull, "w")  # noqa: SIM115
    return lost
