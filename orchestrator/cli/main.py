"""The command `rovbrush`. Exit codes: 0 success, 1 a failed check or run, 2 usage."""

from __future__ import annotations

import sys
from typing import NoReturn

import typer

from ..errors import RovbrushError
from . import bench_commands, exchange_commands, paper_commands, study_commands
from . import run_commands as commands
from .guard import guarded
from .options import app

# Importing the commands registers them.
__all__ = [
    "bench_commands", "commands", "exchange_commands", "main", "paper_commands", "program", "study_commands",
]  # fmt: skip


LOADING = ("run", "plan", "converge")  # commands that load FMUs into their own process


def program() -> NoReturn:
    """The command as it is started from a shell: what loads FMUs is guarded against their crashes."""
    if sys.argv[1:2] and sys.argv[1] in LOADING:
        guarded(main)
    main()


def main() -> NoReturn:
    """Entry point: every error that a user can meet becomes one message on stderr and an exit code."""
    arguments = [a for a in sys.argv[1:] if a != "--debug"]
    debug = len(arguments) < len(sys.argv) - 1
    try:
        code = app(arguments, standalone_mode=False)
    except RovbrushError as error:
        if debug:
            raise
        print(f"error: {error}", file=sys.stderr)
        code = error.exit_code
    except typer.Exit as stop:
        code = stop.exit_code
    except (typer.Abort, KeyboardInterrupt):
        print("error: interrupted", file=sys.stderr)
        code = 1
    except Exception as error:
        if hasattr(error, "format_message"):  # a usage error found by the command line's own parser
            if error.format_message():  # empty behind the help that the bare command prints
                print(f"error: {error.format_message()} (see `rovbrush --help`)", file=sys.stderr)
            code = 2
        elif debug:
            raise
        else:
            print(
                f"error: unexpected {type(error).__name__}: {error}; run again with --debug for the traceback",
                file=sys.stderr,
            )
            code = 1
    sys.stdout.flush()
    sys.exit(code if isinstance(code, int) else 0)
