"""What this process has used so far: time since it began, and its peak memory."""

from __future__ import annotations

import os
import re
import sys
import time
from pathlib import Path

_IMPORTED = time.time()
_first: int | str = "self"  # the process whose start counts


def began_with(pid: int) -> None:
    """Count time from the start of another process, which made this one."""
    global _first
    _first = pid


def seconds_since_start() -> float:
    """Wall time since the process, or the one that made it, began [s].

    Where the system does not tell: since this module was imported.
    """
    stat, uptime = Path(f"/proc/{_first}/stat"), Path("/proc/uptime")
    if stat.is_file() and uptime.is_file():
        started = float(stat.read_text().rsplit(")", 1)[1].split()[19]) / os.sysconf("SC_CLK_TCK")
        return float(uptime.read_text().split()[0]) - started
    return time.time() - _IMPORTED


def peak_memory() -> float:
    """Largest resident size so far [MB]; 0 where the system does not tell."""
    status = Path("/proc/self/status")
    found = re.search(r"VmHWM:\s*(\d+) kB", status.read_text()) if status.is_file() else None
    if found:  # `ru_maxrss` below can be that of the process which started this one
        return int(found[1]) * 1024 / 1e6
    try:
        import resource
    except ImportError:
        return 0.0
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (1e6 if sys.platform == "darwin" else 1e3)
