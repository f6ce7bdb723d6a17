"""`python -m rovbrush.orchestrator.live.page`, as the run starts it: its settings come on the standard input."""

from __future__ import annotations

import sys

import msgspec

from ..server import Settings
from .app import serve

if __name__ == "__main__":
    serve(msgspec.json.decode(sys.stdin.readline().encode(), type=Settings))
