# SPDX-License-Identifier: MIT
"""The processes of a session: opens controllers, copies them, speaks with them.

In: a ``Setup``. Out: ``RemoteEngine`` objects, each a controller in its own process.
"""

from __future__ import annotations

import atexit
import contextlib
import os
import secrets
import select
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Iterator, Sequence
from multiprocessing import AuthenticationError
from multiprocessing.connection import Client, Connection, Listener
from typing import Any, cast

from nctakt.base import interrupts
from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.base.python_process import at_start, python_command, python_environment
from nctakt.messages import diagnostic
from nctakt.messages.connections.session import CONTROLLER_LOST
from nctakt.results.run import RecordedRun
from nctakt.results.trace.event_words import SoughtEvents
from nctakt.run.access.inputs import Input
from nctakt.session.engine import Accounted, CycleState, Found, FoundEvents, StepResult
from nctakt.session.process.worker import BROKEN, KEY_SIZE, REFUSED, can_fork, receive, send
from nctakt.session.setup import Description, Setup
from nctakt.session.stops import StopAt
from nctakt.timing.table import TitledTables

#: How long a new process may take to report, in seconds.
START_S = 60.0

#: How long it may take to end, in seconds, once its connection is closed.
END_S = 5.0

#: How often a process that has not reported yet is looked at, in seconds.
_LOOK_S = 0.1

#: The descriptors of standard output and error.
_PRINTED = (1, 2)

#: The name of a connection that only wakes; those of processes are numbers.
_WAKE = "wake"


class RemoteEngine:
    """A controller in another process, with the methods of ``Engine``.

    Raises ``Failure`` as ``Engine`` does, and 901153 when its process is gone. ``tick``: where it
    is; ``process``: the number of its process; ``took_s``: how long the latest request has taken
    there. ``is_apart``: a separate thread uses it, and it must not be abandoned.
    """

    def __init__(
        self, connection: Connection[Any, Any], process: int, pool: ProcessPool, tick: int
    ) -> None:
        self._connection = connection
        self.process = process
        self._pool = pool
        self.tick = tick
        self._listed: Sequence[str] = ()
        self._unread = 0
        self.took_s = 0.0
        self.is_apart = False

    def ask(self, request: str, *words: Any) -> Any:
        """Return the answer to a request; also raises the failure of an earlier request."""
        self._send(request, words)
        self._unread += 1
        answers = self._received()
        for verdict, answer, took_s in answers:
            self.took_s = took_s
            if verdict == REFUSED:
                raise Failure(*answer)
            if verdict == BROKEN:
                raise RuntimeError(answer)
        return answers[-1][1]

    def order(self, request: str, *words: Any) -> None:
        """Make a request without waiting for its answer: no thread has to wake for that alone."""
        self._send(request, words)
        self._unread += 1

    def _send(self, request: str, words: tuple[Any, ...]) -> None:
        with self._watched():
            send(self._connection, (request, words))

    def _received(self) -> list[tuple[str, Any, float]]:
        """Return the answers to all requests so far."""
        with self._watched():
            answers = [receive(self._connection) for _ in range(self._unread)]
        self._unread = 0
        return answers

    @contextlib.contextmanager
    def _watched(self) -> Iterator[None]:
        """Allow the process to be killed during a request; raises ``Failure`` if it is gone."""
        if not self.is_apart:
            self._pool.asked = self
        try:
            yield
        except (EOFError, OSError) as error:
            raise Failure(diagnostic(CONTROLLER_LOST, reason=str(error) or "EOF")) from error
        finally:
            if not self.is_apart:
                self._pool.asked = None

    def copy(self, pool: ProcessPool | None = None) -> RemoteEngine:
        """Return a copy at the same tick, in its own process; it belongs to ``pool``."""
        process = cast("int", self.ask("copy"))
        try:
            with socket.fromfd(
                self._connection.fileno(), socket.AF_UNIX, socket.SOCK_STREAM
            ) as own:
                _, (descriptor,), *_ = socket.recv_fds(own, 1, 1, socket.MSG_CMSG_CLOEXEC)
        except (OSError, ValueError) as error:
            raise Failure(diagnostic(CONTROLLER_LOST, reason=str(error) or "EOF")) from error
        self._pool.copies += 1
        return RemoteEngine(Connection(descriptor), process, pool or self._pool, self.tick)

    def begin(self) -> None:
        """Give a copy of the prototype everything that a new process gets from this one.

        That is: the working directory, where it prints, and the environment.
        """
        self.order("begin", python_environment())
        with self._watched(), contextlib.ExitStack() as ends:
            given = [os.open(".", os.O_PATH | os.O_DIRECTORY)]
            for stream in _PRINTED:
                try:
                    given.append(os.dup(stream))
                except OSError:  # it is closed
                    given.append(os.open(os.devnull, os.O_WRONLY))
            for descriptor in given:
                ends.callback(os.close, descriptor)
            own = socket.fromfd(self._connection.fileno(), socket.AF_UNIX, socket.SOCK_STREAM)
            socket.send_fds(ends.enter_context(own), [b"0"], given)

    def run(
        self,
        end: int,
        stops: Sequence[StopAt] = (),
        *,
        events: bool = True,
        marks: Sequence[int] | None = (),
        rests: bool = False,
        since: int | None = None,
    ) -> StepResult:
        """Run as ``Engine.run``."""
        done = cast("StepResult", self.ask("run", end, stops, events, marks, rests, since))
        self.tick = done.tick
        return done

    def read(self, names: Sequence[str]) -> list[float | bool | str]:
        """Read as ``Engine.read``; names that were asked for last are not sent again."""
        known, self._listed = self._listed, ()
        answer = self.ask("read_listed", None if names == known else names)
        self._listed = names
        return cast("list[float | bool | str]", answer)

    def last_hit(self, end: int, stops: Sequence[StopAt], marks: Sequence[int]) -> Found:
        """Search as ``Engine.last_hit``."""
        found = cast("Found", self.ask("last_hit", end, stops, marks))
        self.tick = found[1]
        return found

    def find_events(
        self, end: int, sought: SoughtEvents, marks: Sequence[int], since: int
    ) -> FoundEvents:
        """Search as ``Engine.find_events``."""
        found = cast("FoundEvents", self.ask("find_events", end, sought, marks, since))
        self.tick = found.end
        return found

    def record(self, signals: Sequence[str] | None) -> None:
        """Prepare as ``Engine.record``."""
        self.ask("record", signals)

    def record_to(self, end: int, marks: Sequence[int]) -> Accounted:
        """Run as ``Engine.record_to``."""
        done = cast("Accounted", self.ask("record_to", end, marks))
        self.tick = done[0]
        return done

    def recorded(self) -> RecordedRun:
        """Return ``Engine.result`` after ``record``."""
        return cast("RecordedRun", self.ask("result"))

    def account(self, end: int, marks: Sequence[int]) -> Accounted:
        """Account for ticks as ``Engine.account``."""
        done = cast("Accounted", self.ask("account", end, marks))
        self.tick = done[0]
        return done

    def time_tables(self, language: Language) -> TitledTables:
        """Return tables as ``Engine.time_tables``."""
        return cast("TitledTables", self.ask("time_tables", language))

    def plan(self, inputs: Sequence[Input]) -> None:
        """Plan as ``Engine.plan``."""
        self.order("plan", inputs)

    def post(self, inputs: Sequence[Input]) -> None:
        """Post as ``Engine.post``."""
        self.ask("post", inputs)

    def cycles(self) -> list[CycleState]:
        """Return the living realtime cycles."""
        return cast("list[CycleState]", self.ask("cycles"))

    def close(self) -> None:
        """Let the process end."""
        self._connection.close()


class ProcessPool:
    """Opens controllers in separate processes; ``close`` ends them all.

    ``asked``: the one with an unanswered request. ``copies``: how many copies have been made.
    """

    def __init__(self) -> None:
        self.copies = 0
        self.asked: RemoteEngine | None = None
        self._key = secrets.token_bytes(KEY_SIZE)
        self._listener = Listener(authkey=self._key)
        self._count = 0
        self._waiting: dict[str, Connection[Any, Any]] = {}
        self._processes: list[subprocess.Popen[bytes]] = []
        self._copies: list[int] = []

    def next_name(self) -> str:
        """Return the name of the next process."""
        self._count += 1
        return str(self._count)

    def open(self, setup: Setup) -> tuple[RemoteEngine, Description]:
        """Return a new controller before its first tick; raises ``Failure`` with its mistakes."""
        engine = self._from_prototype() if self.can_copy else self.start()
        try:
            return engine, cast("Description", engine.ask("open", setup))
        except Failure:
            engine.close()
            raise

    def _from_prototype(self) -> RemoteEngine:
        """Return a process for a controller: one that has already done the imports."""
        engine = _PROTOTYPE.copy(self)
        with contextlib.suppress(OSError):  # it has ended, as the next request will report
            self._copies.append(os.pidfd_open(engine.process))
        return engine

    def start(self) -> RemoteEngine:
        """Return a new process for a controller, which does its imports."""
        name = self.next_name()
        address = self._listener.address
        with interrupts.blocked_for_children():
            process = subprocess.Popen(
                python_command("nctakt.session.process.worker", str(address), name),
                stdin=subprocess.PIPE,
                env=python_environment(),
            )
        self._processes.append(process)
        assert process.stdin is not None
        with contextlib.suppress(OSError):
            process.stdin.write(self._key)
            process.stdin.close()
        return RemoteEngine(self.accept(name, process), process.pid, self, 0)

    def accept(
        self, name: str, process: subprocess.Popen[bytes] | None = None
    ) -> Connection[Any, Any]:
        """Return the connection of the process of this name, once it has reported.

        Raises ``Failure`` (901153) if it ends before, or does not report in time.
        """
        has_reported, is_given_up = threading.Event(), threading.Event()

        def watch() -> None:
            end_s = time.monotonic() + START_S
            while not has_reported.wait(_LOOK_S):
                if time.monotonic() > end_s or (process and process.poll() is not None):
                    is_given_up.set()
                    self._wake()
                    return

        threading.Thread(target=watch, name="nctakt start", daemon=True).start()
        try:
            while name not in self._waiting:
                connection = self._listener.accept()
                self._waiting[receive(connection)] = connection
                if _WAKE in self._waiting:
                    self._waiting.pop(_WAKE).close()
                    if is_given_up.is_set():
                        raise EOFError
        except (EOFError, OSError) as error:
            raise Failure(diagnostic(CONTROLLER_LOST, reason=str(error) or "EOF")) from error
        finally:
            has_reported.set()
        return self._waiting.pop(name)

    def _wake(self) -> None:
        """Wake the thread that waits for a process to report: closing the listener would not."""
        with (
            contextlib.suppress(OSError, EOFError, AuthenticationError),
            Client(self._listener.address, authkey=self._key) as connection,
        ):
            send(connection, _WAKE)

    @property
    def can_copy(self) -> bool:
        """Whether a controller can be copied here."""
        return can_fork()

    def abandon(self) -> None:
        """Kill the process that does not answer: the requester gets 901153."""
        asked = self.asked
        if asked is not None:
            with contextlib.suppress(OSError):  # it has ended just now
                os.kill(asked.process, getattr(signal, "SIGKILL", signal.SIGTERM))

    def kill(self) -> None:
        """Let no more processes in, and kill the first ones."""
        self._listener.close()
        for process in self._processes:
            process.kill()
            process.wait()

    def close(self) -> None:
        """Let no more processes in, and wait for the first ones; the others end unasked.

        One of the first that does not end is killed.
        """
        self._listener.close()
        for connection in self._waiting.values():
            connection.close()
        for process in self._processes:
            try:
                process.wait(timeout=END_S)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        for copy in self._copies:
            waiting = select.poll()
            waiting.register(copy, select.POLLIN)
            if not waiting.poll(END_S * 1000):
                signal.pidfd_send_signal(copy, signal.SIGKILL)
            os.close(copy)
        self._copies.clear()


class Prototype:
    """A process that has imported nctakt and holds no controller: those of sessions are its copies.

    A copy takes milliseconds; to start Python and to import takes half a second of a processor. It
    starts with the first session, and ends with this process.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._engine: RemoteEngine | None = None
        self._pool: ProcessPool | None = None
        self._at_start: tuple[object, ...] = ()
        atexit.register(self.end)
        if can_fork():
            os.register_at_fork(after_in_child=self._leave)

    def copy(self, pool: ProcessPool) -> RemoteEngine:
        """Return a copy that belongs to ``pool``, as a process that is started now would be."""
        with self._lock:
            now = at_start()
            if self._engine is None or now != self._at_start:
                self._engine = self._renewed(now)
            try:
                copy = self._engine.copy(pool)
            except Failure:  # somebody has killed it
                self._engine = self._renewed(now)
                copy = self._engine.copy(pool)
            except BaseException:  # an interrupt: its answer would be taken for that to the next
                self.end()
                raise
        copy.begin()
        return copy

    def _renewed(self, now: tuple[object, ...]) -> RemoteEngine:
        """Return a new process, started as ``now`` says; raises ``Failure`` (901153) if it ends."""
        self.end()
        pool = ProcessPool()
        try:
            engine = pool.start()
        except Failure:
            pool.kill()
            raise
        self._pool, self._at_start = pool, now
        return engine

    def end(self) -> None:
        """Kill it: it has nothing that could be lost."""
        if self._engine is not None and self._pool is not None:
            self._engine.close()
            self._pool.kill()
        self._engine = self._pool = None

    def _leave(self) -> None:
        """Leave it to the process from which this one was copied."""
        self._lock = threading.Lock()
        if self._engine is not None:
            self._engine.close()
        self._engine = None


_PROTOTYPE = Prototype()
