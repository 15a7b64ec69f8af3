# SPDX-License-Identifier: MIT
"""The process that a session's controller lives in; started as ``python -m
nctakt.session.process.worker``.

It has one thread: it takes a request from its connection, executes it, and answers. So it can fork
between two requests: the child is a parked controller, a copy of the whole state at that tick (the
decoder's generators and a scripted PLC included), which takes a few milliseconds and shares its
memory until it runs. A parked controller that is woken forks again, and its copy continues; so it
can be woken any number of times. Files that a PLC in Python only reads are opened again by the
copy, at the same position; all others would be shared by both, and are refused by name.
"""

from __future__ import annotations

import contextlib
import gc
import io
import os
import pickle
import signal
import socket
import stat
import sys
import time
import traceback
from collections.abc import Callable, Collection, Iterator
from multiprocessing.connection import Client, Connection
from pathlib import Path
from typing import Any

from nctakt.base import interrupts
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.connections.session import PLC_HOLDS_OPEN
from nctakt.session.engine import Engine
from nctakt.session.setup import Setup

#: The answer to a request: the result, or the reason why there is none; and how long it took, in
#: seconds.
DONE, REFUSED, BROKEN = "done", "refused", "broken"

#: The length of the secret that a worker and its session share, in bytes.
KEY_SIZE = 32


def can_fork() -> bool:
    """Return whether this system can park controllers as processes."""
    return hasattr(os, "fork") and sys.platform == "linux"


def send(connection: Connection[Any, Any], value: object) -> None:
    """Send a value, from a copy: the library's method leaves a buffer that must not be freed."""
    connection.send_bytes(pickle.dumps(value, pickle.HIGHEST_PROTOCOL))


def receive(connection: Connection[Any, Any]) -> Any:
    """Return the next value."""
    return pickle.loads(connection.recv_bytes())


class Worker:
    """One controller and its connection to the session."""

    def __init__(self, address: str, key: bytes) -> None:
        self._address = address
        self._key = key
        self._connection: Connection[Any, Any] | None = None
        self._engine: Engine | None = None
        self._is_copy = False

    def connect(self, name: str) -> None:
        """Connect to the session as ``name``."""
        self._connection = Client(self._address, authkey=self._key)
        send(self._connection, name)

    def serve(self) -> None:
        """Answer requests until the session closes the connection."""
        while self._connection is not None:
            try:
                request, words = receive(self._connection)
            except (EOFError, OSError):
                return
            begin_s = time.monotonic()
            answer = self._answer(request, words)
            if answer is None:
                continue  # it has been given, or this is the copy
            try:
                send(self._connection, (*answer, time.monotonic() - begin_s))
            except OSError:
                return

    def end(self) -> None:
        """End a copy at once, without Python's cleanup; return in the first process.

        Taking all objects apart would touch, and so copy, all of the shared memory: twenty times
        the work of ending. Cleanup that must be done once (files of a model, functions registered
        by a PLC) is done by the first process.
        """
        if self._is_copy:
            _flush()
            os._exit(0)

    def _answer(self, request: str, words: tuple[Any, ...]) -> tuple[str, Any] | None:
        try:
            if request == "open":
                (setup,) = words
                if not isinstance(setup, Setup):
                    raise TypeError(setup)
                self._engine = Engine(setup)
                return DONE, self._engine.description
            if request == "begin":
                self._begin(*words)
                return DONE, None
            if request == "copy":
                self._copy()
                return None
            method: Callable[..., Any] = getattr(self._engine, request)
            return DONE, method(*words)
        except Failure as failure:
            return REFUSED, failure.diagnostics
        except Exception:  # noqa: BLE001 - the session shows it as an internal error
            return BROKEN, traceback.format_exc()

    def _begin(self, environment: dict[str, str]) -> None:
        """Take over working directory, standard output and error, and environment of a session."""
        assert self._connection is not None
        with socket.fromfd(self._connection.fileno(), socket.AF_UNIX, socket.SOCK_STREAM) as own:
            _, given, *_ = socket.recv_fds(own, 1, 3, socket.MSG_CMSG_CLOEXEC)
        folder, *streams = given
        os.fchdir(folder)
        for number, stream in enumerate(streams, start=1):
            os.dup2(stream, number)
        for descriptor in given:
            os.close(descriptor)
        if isinstance(sys.stdout, io.TextIOWrapper):
            sys.stdout.reconfigure(line_buffering=sys.stdout.isatty())
        os.environ.clear()
        os.environ.update(environment)
        self._is_copy = False  # it is the first process of its controller

    def _copy(self) -> None:
        """Copy this process; the session gets the copy's number and its end of a connection."""
        _flush()  # otherwise each would print what a PLC has printed
        shared = self._shared()
        gc.freeze()  # a search for garbage would touch, and so copy, all of the shared memory
        connection = self._connection
        assert connection is not None
        own, others = socket.socketpair()
        child = os.fork()
        if child:
            own.close()
            with others, contextlib.suppress(OSError):  # the session may have ended meanwhile
                connection.send((DONE, child, 0.0))
                with socket.fromfd(connection.fileno(), own.family, own.type) as carrier:
                    socket.send_fds(carrier, [b"0"], [others.fileno()])
            return
        others.close()
        connection.close()
        open_again(shared)
        self._connection = Connection(own.detach())
        self._is_copy = True

    def _shared(self) -> list[int]:
        """Return which files a copy reopens; raises ``Failure`` (902060) for others."""
        if self._engine is None or not self._engine.has_plc:
            return []
        assert self._connection is not None
        return check_open_files({self._connection.fileno()})


def _flush() -> None:
    """Flush printed output."""
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError, ValueError):
            stream.flush()


def main() -> None:
    """Serve the session whose address is the first word; the key comes by standard input."""
    key = sys.stdin.buffer.read(KEY_SIZE)
    interrupts.ignore()  # they may go to a whole group; the session ends its workers itself
    worker = Worker(sys.argv[1], key)
    if can_fork():
        signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # the copies are not waited for
    with contextlib.suppress(OSError, EOFError):  # the session has ended meanwhile
        worker.connect(sys.argv[2])
        worker.serve()
    worker.end()


# --- open files -----------------------------------------------------------------------------------


_DESCRIPTORS = Path("/proc/self/fd")

#: Standard input, output and error.
_STANDARD = 3

#: Files that are named in the diagnostic at most.
_MAX_NAMED = 3


def check_open_files(own: Collection[int]) -> list[int]:
    """Return the descriptors that a copy must reopen; ``own`` are not the PLC's.

    Raises ``Failure`` (902060) if the PLC holds something open that two processes must not share.
    """
    import fcntl  # noqa: PLC0415 - not on Windows, where nothing is copied

    again: list[int] = []
    held: list[str] = []
    for descriptor, name, mode in _opened(own):
        flags = fcntl.fcntl(descriptor, fcntl.F_GETFL)
        if stat.S_ISREG(mode) and flags & os.O_ACCMODE == os.O_RDONLY:
            again.append(descriptor)
        elif not (stat.S_ISDIR(mode) or stat.S_ISCHR(mode)):
            held.append(name)
    if held:
        shown = ", ".join(held[:_MAX_NAMED]) + (", …" if len(held) > _MAX_NAMED else "")
        raise Failure(diagnostic(PLC_HOLDS_OPEN, names=shown))
    return again


def open_again(descriptors: Collection[int]) -> None:
    """Give this process its own positions in files shared with the process it is a copy of."""
    for descriptor in descriptors:
        position = os.lseek(descriptor, 0, os.SEEK_CUR)
        opened = os.open(_DESCRIPTORS / str(descriptor), os.O_RDONLY | os.O_CLOEXEC)
        os.lseek(opened, position, os.SEEK_SET)
        os.dup2(opened, descriptor, inheritable=False)
        os.close(opened)


def _opened(own: Collection[int]) -> Iterator[tuple[int, str, int]]:
    """Yield the descriptors of the PLC, each with its name and its mode."""
    for path in sorted(_DESCRIPTORS.iterdir(), key=lambda one: int(one.name)):
        descriptor = int(path.name)
        if descriptor < _STANDARD or descriptor in own:
            continue
        try:
            name, mode = str(path.readlink()), os.fstat(descriptor).st_mode
        except OSError:  # it belonged to this list
            continue
        yield descriptor, name, mode


if __name__ == "__main__":
    main()
