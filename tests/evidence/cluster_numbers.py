"""`python -m tests.evidence.cluster_numbers [POINTS] [WORKERS]`: what a sweep on a Dask cluster of worker processes
costs: points/s, speed-up, bytes between this process and the scheduler, and the same with a worker killed on the way.

No claim: it prints. The system is that of `rovbrush bench sweeps`; a run through a proxy counts bytes.
"""

from __future__ import annotations

import os
import shutil
import signal
import socket
import sys
import tempfile
import threading
import time
from contextlib import suppress
from pathlib import Path

from rovbrush.orchestrator.studies.bench.fmus.systems import native_folder
from rovbrush.orchestrator.studies.bench.runs.sweeps import SYSTEM
from rovbrush.orchestrator.studies.sweep.options import Options
from rovbrush.orchestrator.studies.sweep.sweep import sweep

POINTS, WORKERS = 2000, 2


class Proxy:
    """A port of this machine that passes all on to another one, and counts bytes each way."""

    def __init__(self, address: str) -> None:
        host, _, port = address.removeprefix("tcp://").rpartition(":")
        self.there, self.sent, self.came = (host, int(port)), 0, 0
        self.server = socket.create_server(("127.0.0.1", 0))
        self.address = f"tcp://127.0.0.1:{self.server.getsockname()[1]}"
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        with suppress(OSError):
            while True:
                here, _ = self.server.accept()
                there = socket.create_connection(self.there)
                for a, b, way in ((here, there, "sent"), (there, here, "came")):
                    threading.Thread(target=self._pass, args=(a, b, way), daemon=True).start()

    def _pass(self, a: socket.socket, b: socket.socket, way: str) -> None:
        with suppress(OSError):
            while data := a.recv(1 << 16):
                setattr(self, way, getattr(self, way) + len(data))
                b.sendall(data)
        for end in (a, b):
            with suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)

    def close(self) -> None:
        self.server.close()


def measured(system: Path, out: Path, points: int, workers: int, kill: bool = False) -> tuple[float, int, int, bytes]:
    """Seconds, bytes sent and come, and the table of a sweep on a cluster of so many processes of this machine."""
    from distributed import LocalCluster

    options = Options(["motor.R=0.06:0.12", "battery.soc_start=0.3:1"], random=points, seed=1, fmus=native_folder(None))
    with LocalCluster(
        n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=60
    ) as cluster:
        proxy = Proxy(cluster.scheduler_address)
        there = Options(**{**vars(options), "scheduler": proxy.address})
        begin, killed = [0.0], [False]

        def progress(done: int, of: int) -> None:
            begin[0] = begin[0] or time.perf_counter()
            if kill and not killed[0] and done > of // 4:
                killed[0] = True
                os.kill(next(iter(cluster.workers.values())).pid, signal.SIGKILL)

        swept = sweep(str(system), out, there, progress=progress)
        seconds = time.perf_counter() - begin[0]
        swept.require_all()
        proxy.close()
    return seconds, proxy.sent, proxy.came, (out / "sweep.csv").read_bytes()


def main(points: int = POINTS, workers: int = WORKERS) -> None:
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        system = folder / "started.toml"
        system.write_text(SYSTEM, encoding="utf-8")
        found = {}
        for label, count, kill in (("1 worker", 1, False), (f"{workers} workers", workers, False),
                                   (f"{workers} workers, one killed", workers, True)):  # fmt: skip
            out = folder / "out"
            shutil.rmtree(out, ignore_errors=True)
            seconds, sent, came, table = measured(system, out, points, count, kill)
            found[label] = table
            print(
                f"{label:<26} {points} points in {seconds:.2f} s: {points / seconds:.0f} points/s; for a point "
                f"{sent / points:.0f} bytes to the scheduler, {came / points:.0f} from it"
            )
        same = len(set(found.values())) == 1
        print("all tables are the same bytes" if same else "THE TABLES DIFFER")
        if not same:
            sys.exit(1)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
