"""The workers of a Dask scheduler, for sweeps that have outgrown one machine."""

from __future__ import annotations

import logging
import socket
import threading
from collections.abc import Sequence
from concurrent.futures import Executor, Future
from typing import Any, Self

from ....errors import InputError, RunError
from .point import Job, Record, load, run_batch
from .workers import AHEAD

ANSWER = 5.0  # s that a scheduler has to answer, and then to have a worker


def _connect(address: str) -> Any:
    """A client of the scheduler at an address. Raises InputError if nothing that understands answers soon."""
    try:
        from distributed import Client
        from distributed.comm.addressing import get_address_host_port
    except ImportError:
        raise InputError("--scheduler needs Dask; install it with: pip install 'rovbrush[sweep]'") from None

    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what matters is reported by `check`

    class Quiet(Client):
        """One that could not connect does not try to say goodbye for another ten seconds."""

        def __del__(self) -> None:
            pass

    made: Future[Any] = Future()

    def connect() -> None:
        try:
            made.set_result(Quiet(address, timeout=ANSWER, set_as_default=False))  # type: ignore[no-untyped-call]
        except Exception as error:
            made.set_exception(error)

    try:
        socket.create_connection(get_address_host_port(address), timeout=ANSWER).close()
        threading.Thread(target=connect, daemon=True).start()  # waits forever for one who accepts and says nothing
        return made.result(timeout=ANSWER + 1.0)
    except Exception as error:  # a stranger at that port can answer anything
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise InputError(
            f"--scheduler {address} does not answer as a Dask scheduler within {ANSWER:g} s ({reason}); start one with "
            "`dask scheduler` and give the address that it prints, for instance tcp://192.168.0.5:8786"
        ) from error


class DaskWorkers:
    """The workers of a running Dask scheduler; each needs rovbrush and the same FMUs."""

    def __init__(self, address: str, job: Job) -> None:
        self.address, self.client = address, _connect(address)
        try:
            self._check_workers(job)
            self.pool: Executor = self.client.get_executor(pure=False)
        except BaseException:
            self.client.close()
            raise

    def _check_workers(self, job: Job) -> None:
        try:
            self.client.wait_for_workers(1, timeout=ANSWER)
        except TimeoutError:
            raise InputError(
                f"--scheduler {self.address} has no workers; start some with "
                f"`dask worker {self.address} --nthreads 1 --nworkers -1`"
            ) from None
        try:
            self.client.run(load, job)
        except Exception as error:
            raise InputError(f"a worker of {self.address} cannot run this system: {error}") from error

    def submit(self, job: Job, batch: Sequence[dict[str, Any]]) -> Future[list[Record]]:
        return self.pool.submit(run_batch, job, batch)

    def room(self) -> int:
        return AHEAD * max(1, len(self.client.nthreads()))  # a worker computes one batch at a time

    def check(self) -> None:
        if self.client.status != "running":
            raise RunError(f"the connection to the scheduler {self.address} is lost")

    def start(self) -> None:
        """Dask replaces the workers that die."""

    def stop(self) -> None:
        self.client.close(timeout=ANSWER)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()
