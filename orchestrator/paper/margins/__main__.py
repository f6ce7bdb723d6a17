"""Prints the table of the shipped pass; the folder of FMUs may be given."""

from __future__ import annotations

import sys
from pathlib import Path

from ...errors import RovbrushError
from .table import BRUSHES, STRATEGIES, table

if __name__ == "__main__":
    try:
        for line in table("hull_pass", Path(sys.argv[1]) if sys.argv[1:] else None, STRATEGIES, BRUSHES):
            print(line, flush=True)
    except RovbrushError as error:
        print(f"error: {error}", file=sys.stderr)
        sys.exit(error.exit_code)
