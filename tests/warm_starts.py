"""Python processes of tests start at once: each is a fork of one that has imported what they would import.

`python -m rovbrush...`, `python -c ...` and what `multiprocessing` spawns are what they are otherwise: children of this
process, with their own environment, folder, session, streams and end. Only their imports, which take most of a short
command's time, were made before. Started in earnest is whatever may see a difference: with other settings of Python, of
its libraries or of the project in its environment, with a terminal, or with code that looks at how modules come.
"""

from __future__ import annotations

import atexit
import ctypes
import gc
import importlib
import importlib.util
import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
import traceback
import types
from contextlib import suppress
from multiprocessing import util
from typing import Any

IMPORTED = (
    "rovbrush.orchestrator.participant.isolated.child", "rovbrush.orchestrator.participant.elsewhere.served",
    "rovbrush.orchestrator.exchange.checks.child", "rovbrush.orchestrator.cli.main",
    "rovbrush.orchestrator.cli.run_system", "rovbrush.orchestrator.studies.sweep.workers.point",
    "xarray", "h5netcdf.legacyapi", "pint", "fmpy.validation", "numba",
)  # fmt: skip
SETTINGS = ("PYTHON", "LD_", "NUMBA", "OMP_", "OPENBLAS", "ROVBRUSH_", "HOME", "XDG_", "MPL", "PATH", "LANG", "LC_")
TELLING = ("sys.modules", "meta_path", "__import__", "sys.path", "importlib", "ru_maxrss", "peak_memory", "VmHWM")
COLD = "ROVBRUSH_TESTS_COLD"  # set: every process is started in earnest, as in `make evidence`
PR_SET_CHILD_SUBREAPER = 36  # <sys/prctl.h>


def start_warm() -> None:
    """From here on `subprocess` starts what it can by a fork; on Linux only."""
    if sys.platform == "linux" and not os.environ.get(COLD) and not issubclass(subprocess.Popen, WarmPopen):
        WarmPopen.usual = dict(os.environ)
        subprocess.Popen = WarmPopen  # type: ignore[misc]
        util.spawnv_passfds = _spawned  # of `multiprocessing`


class WarmPopen(subprocess.Popen):  # type: ignore[type-arg]
    """`subprocess.Popen` that forks where it can."""

    usual: dict[str, str]  # the environment in which the imports are made
    _starter: _Starter | None = None
    _lock = threading.Lock()

    def _execute_child(  # of CPython 3.11 to 3.13, by position
        self, args: Any, executable: Any, preexec_fn: Any, close_fds: Any, pass_fds: Any, cwd: Any, env: Any,
        startupinfo: Any, creationflags: Any, shell: Any, p2cread: int, p2cwrite: int, c2pread: int, c2pwrite: int,
        errread: int, errwrite: int, *more: Any,
    ) -> None:  # fmt: skip
        streams = [p2cread, c2pwrite, errwrite]
        streams = [number if given == -1 else given for number, given in enumerate(streams)]
        session = bool(more[5]) if len(more) == 7 else True
        plain = not (executable or preexec_fn or shell) and close_fds and list(more[1:5]) == [None, None, None, -1]
        if not (plain and len(more) == 7 and more[6] == -1 and self._can(args, env, streams)):
            super()._execute_child(
                args, executable, preexec_fn, close_fds, pass_fds, cwd, env, startupinfo, creationflags, shell,
                p2cread, p2cwrite, c2pread, c2pwrite, errread, errwrite, *more,
            )  # type: ignore[misc]  # fmt: skip
            return
        asked = {
            "words": [os.fsdecode(word) for word in args[1:]], "folder": os.fspath(cwd or os.getcwd()),
            "environment": dict(os.environ if env is None else env), "session": session, "passed": list(pass_fds),
        }  # fmt: skip
        self.pid = self._started(asked, [*streams, *pass_fds])
        self._child_created = True
        self._close_pipe_fds(p2cread, p2cwrite, c2pread, c2pwrite, errread, errwrite)

    @classmethod
    def _started(cls, asked: dict[str, Any], files: list[int]) -> int:
        with cls._lock:
            if WarmPopen._starter is None or WarmPopen._starter.master != os.getpid():
                WarmPopen._starter = _Starter(cls.usual)
            return WarmPopen._starter.start(asked, files)

    @classmethod
    def _can(cls, args: Any, env: Any, streams: list[int]) -> bool:
        if not isinstance(args, (list, tuple)) or len(args) < 3 or os.fspath(args[0]) != sys.executable:
            return False
        kind, what = args[1], args[2]
        if not ((kind == "-m" and str(what).startswith("rovbrush.orchestrator")) or kind == "-c"):
            return False
        if any(word in str(what) for word in TELLING) or any(map(os.isatty, streams)):
            return False
        now, usual = (os.environ if env is None else env), cls.usual
        names = {name for name in {*now, *usual} if name.startswith(SETTINGS)}
        return all(now.get(name) == usual.get(name) for name in names)


_spawn = util.spawnv_passfds


def _spawned(path: Any, args: Any, passed: Any) -> int:
    """A process of `multiprocessing` that is spawned: it, too, has its own beginning and imports that were made."""
    words = [word for word in map(os.fsdecode, args) if word != "-B"]
    passed = sorted(passed)
    if words[3:] != ["--multiprocessing-fork"] or not WarmPopen._can(words, None, [0, 1, 2]):
        return _spawn(path, args, passed)
    asked = {"words": words[1:], "folder": os.getcwd(), "environment": dict(os.environ), "session": False,
             "passed": passed}  # fmt: skip
    return WarmPopen._started(asked, [0, 1, 2, *passed])


class _Starter:
    """The process that has the imports behind it. It ends when this one does."""

    def __init__(self, environment: dict[str, str]) -> None:
        self.master = os.getpid()
        ours, theirs = socket.socketpair()
        with theirs:
            command = [sys.executable, "-P", __file__, str(theirs.fileno())]
            options: dict[str, Any] = {"pass_fds": [theirs.fileno()], "env": environment}
            self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, **options)
        self.socket, self.answer = ours, ours.makefile("r")

    def start(self, asked: dict[str, Any], files: list[int]) -> int:
        """The number of a process, which is a child of this one."""
        asked["blocked"] = [int(number) for number in signal.pthread_sigmask(signal.SIG_BLOCK, [])]
        text = json.dumps(asked).encode()
        prctl = ctypes.CDLL(None).prctl
        prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)  # whose parent ends is ours then
        try:
            socket.send_fds(self.socket, [len(text).to_bytes(4, "big")], files)
            self.socket.sendall(text)
            return int(self.answer.readline())
        finally:
            prctl(PR_SET_CHILD_SUBREAPER, 0, 0, 0, 0)


_loaded: set[str] = set()


def _serve(asking: socket.socket) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for who waits
    for name in IMPORTED:
        with suppress(ImportError):
            importlib.import_module(name)
    for name in [name for name in sys.modules if name.startswith("rovbrush.orchestrator.cli")]:
        del sys.modules[name]  # which looks at the environment
    gc.freeze()
    while True:
        head, files, *_ = socket.recv_fds(asking, 4, 64)
        if not head:
            return
        size, text = int.from_bytes(head, "big"), b""
        while len(text) < size:
            text += asking.recv(size - len(text))
        _load_what_is_compiled()
        reader, writer = os.pipe()
        between = os.fork()
        if between == 0:
            mine = os.getpid()
            child = os.fork()
            if child:
                os.write(writer, str(child).encode())
                os._exit(0)
            while os.getppid() == mine:
                time.sleep(0.0005)
            for number in (reader, writer):
                os.close(number)
            asking.close()
            _end(_code_of(files, json.loads(text)))
        os.close(writer)
        os.waitpid(between, 0)
        with os.fdopen(reader) as answer:
            asking.sendall(f"{answer.read()}\n".encode())
        for file in files:
            os.close(file)


def _load_what_is_compiled() -> None:
    """Functions for Model Exchange that this machine has by now: to load them takes each process a second."""
    from rovbrush.orchestrator.integration import compiled

    for name, (function, _) in compiled.FUNCTIONS.items():
        if name not in _loaded and compiled.Kept(function, compiled._hash(function.__module__)).is_there:
            compiled.address_of(name)
            _loaded.add(name)


def _code_of(files: list[int], asked: dict[str, Any]) -> int:
    """The exit code of the program, as Python finds it."""
    try:
        _become(files, **asked)
    except SystemExit as ending:
        if ending.code is not None and not isinstance(ending.code, int):
            print(ending.code, file=sys.stderr)
            return 1
        return ending.code or 0
    except KeyboardInterrupt:
        traceback.print_exc()
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        os.kill(os.getpid(), signal.SIGINT)
    except BaseException:
        traceback.print_exc()
        return 1
    return 0


def _end(code: int) -> None:
    """What Python does at its end, and then C; the modules are not taken to pieces, which takes a tenth of a second."""
    threading._shutdown()  # type: ignore[attr-defined]
    atexit._run_exitfuncs()
    try:
        sys.stdout.flush()
    except (OSError, ValueError):
        traceback.print_exc()
        code = code or 120
    sys.stderr.flush()
    ctypes.CDLL(None).exit(code)


def _become(
    files: list[int], words: list[str], folder: str, environment: dict[str, str], session: bool, passed: list[int],
    blocked: list[int],
) -> None:  # fmt: skip
    """The program that was asked for; its end is that of this process."""
    high = [_moved(file) for file in files]
    for target, file in zip((0, 1, 2, *passed), high, strict=True):
        os.dup2(file, target)
        os.set_inheritable(target, True)
        os.close(file)
    if session:
        os.setsid()
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.pthread_sigmask(signal.SIG_SETMASK, blocked)
    os.chdir(folder)
    os.environ.clear()
    os.environ.update(environment)
    kind, what, *rest = words
    main = types.ModuleType("__main__")
    sys.modules["__main__"] = main
    if kind == "-c":
        sys.argv, sys.path[:0] = ["-c", *rest], [""]
        exec(compile(what, "<string>", "exec"), main.__dict__)
        return
    spec = importlib.util.find_spec(what)
    if spec is not None and spec.submodule_search_locations is not None:
        spec = importlib.util.find_spec(f"{what}.__main__")
    assert spec is not None and spec.loader is not None and spec.origin is not None
    main.__spec__, main.__package__, main.__file__ = spec, spec.parent, spec.origin
    sys.argv, sys.path[:0] = [spec.origin, *rest], [folder]
    exec(spec.loader.get_code(spec.name), main.__dict__)  # type: ignore[attr-defined]


def _moved(file: int) -> int:
    """The same file under a number that no one asks for."""
    import fcntl

    high = fcntl.fcntl(file, fcntl.F_DUPFD_CLOEXEC, 500)
    os.close(file)
    return high


if __name__ == "__main__":
    _serve(socket.socket(fileno=int(sys.argv[1])))
