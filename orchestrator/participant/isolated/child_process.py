"""The process of an isolated FMU as the master sees it: started, asked, lost, ended."""

from __future__ import annotations

import os
import subprocess
import sys

from ...errors import FmuError
from ...fmu.files.compiled import ASKED
from ...fmu.fmu import Fmu
from ...processes import end, how_ended, start
from .channel import Channel, ChannelBrokenError, ChannelClosedError, ChannelSilentError
from .memory import Shared

CLOSING = 2.0  # s


class ProcessLostError(FmuError):
    """The process is no more: what befell it."""


class ChildProcess:
    """Starts it; `shared` is the memory that it has too."""

    def __init__(self, fmu: Fmu, name: str) -> None:
        self.shared, memory = Shared.made()
        to_child, out = os.pipe()
        into, from_child = os.pipe()
        ends = (to_child, from_child, memory)
        command = [sys.executable, "-m", f"{__package__}.child", *map(str, ends), str(os.getpid())]
        self.process = start(
            [*command, str(fmu.path), fmu.digest, name],
            pass_fds=ends,
            stdin=subprocess.DEVNULL,
            start_new_session=True,  # Ctrl-C is for the master
            env=os.environ | {ASKED: "1"} if fmu.own.compiled else None,
        )
        os.close(to_child)
        os.close(from_child)
        os.close(memory)
        self.channel = Channel(into, out)

    def ask(self, letter: bytes, body: bytes, limit: float) -> bytes:
        """A message and the body of its answer, within `limit` [s]. Raises ProcessLostError if there is none; the
        process has been ended then."""
        try:
            answered, answer = self.channel.ask(letter, body, limit)
            if answered != letter:
                raise ChannelBrokenError
        except ChannelSilentError:
            raise self._lost(f"its process did not answer within {limit:g} s and was ended") from None
        except ChannelBrokenError:
            raise self._lost(
                "its process sent what is no answer (the FMU writes to files that are not its own) and was ended"
            ) from None
        except ChannelClosedError:
            try:
                fault = f"its process {how_ended(self.process.wait(CLOSING))}"
            except subprocess.TimeoutExpired:
                fault = "its process closed the connection to the master and was ended"
            raise self._lost(fault) from None
        return answer

    def _lost(self, fault: str) -> ProcessLostError:
        self.kill()
        return ProcessLostError(fault)

    def kill(self) -> None:
        """End it at once."""
        self.process.kill()
        self.process.wait()

    def close(self) -> None:
        """End it: it goes when its pipe closes, and is made to if it does not."""
        self.channel.close()
        end(self.process, CLOSING)
        if self.shared.base:
            self.shared.close()

    def fell_down(self) -> str:
        """How it ended when it was closed, where that was not well."""
        code = self.process.returncode
        return f"its process {how_ended(code)} when it was no more needed" if code else ""
