# SPDX-License-Identifier: MIT
"""The thread of a session: it executes commands of others, and between them runs on.

In: methods to call, from any thread; a clock. Out: their results, and slices when the clock says.
"""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future, wait
from contextlib import closing, contextmanager
from typing import ParamSpec, TypeVar

from nctakt.base.failure import Failure
from nctakt.base.notebook_progress import UPDATE_S, notebook_progress
from nctakt.messages import diagnostic
from nctakt.messages.connections.session import INTERRUPTED, SESSION_IS_CLOSED
from nctakt.session.clock import AnyClock

#: Maximum number of commands that wait for the thread; whoever adds one more waits.
MAX_COMMANDS = 1000

#: After how long without a command the thread works for those to come, in seconds.
PREPARING_S = 2.0

#: How long a closing thread may take to finish its work, in seconds.
CLOSING_S = 10.0

_P = ParamSpec("_P")
_T = TypeVar("_T")


class SessionThread:
    """Does commands, and between them the slices that ``clock`` asks for.

    ``run_slice`` runs one; without a clock nothing runs unasked but ``prepare``, which returns
    whether it has more to do. ``interruptions`` counts the calls of ``interrupt``: a command
    requested before the last one shall end. In a notebook whoever waits for a long command sees
    ``how_far`` it is: how much is done, of how much.
    """

    def __init__(
        self,
        run_slice: Callable[[AnyClock], None],
        prepare: Callable[[], bool],
        how_far: Callable[[], tuple[int, int | None]],
    ) -> None:
        self._run_slice = run_slice
        self._prepare = prepare
        self._how_far = how_far
        self.clock: AnyClock | None = None
        self.interruptions = 0
        self._asked_at = 0
        self._together = threading.local()
        self.is_closed = False
        self._commands: queue.Queue[Callable[[], None] | None] = queue.Queue(MAX_COMMANDS)
        self._entry = threading.Lock()
        self._thread = threading.Thread(target=self._live, name="nctakt session", daemon=True)
        self._thread.start()

    def _live(self) -> None:
        is_prepared = True
        while True:
            clock = self.clock
            wait_s = None if is_prepared else PREPARING_S
            if clock is not None:
                wait_s = clock.wait_s(time.monotonic())
            try:
                command = self._commands.get(block=wait_s != 0.0, timeout=wait_s or None)
            except queue.Empty:
                if clock is not None:
                    self._run_slice(clock)
                else:
                    is_prepared = not self._prepare()
                continue
            if command is None:
                return
            command()
            is_prepared = False

    def interrupt(self) -> None:
        """Make everything requested so far end soon."""
        self.interruptions += 1

    @contextmanager
    def together(self) -> Iterator[None]:
        """Count the commands that this thread requests inside as one, requested at the beginning.

        An interruption between two of them ends the second.
        """
        self._together.since = self.interruptions
        try:
            yield
        finally:
            del self._together.since

    @property
    def is_interrupted(self) -> bool:
        """Whether the command that runs shall end."""
        return self.interruptions != self._asked_at

    def poll(self) -> None:
        """Raise ``Failure`` (901474) if the command that runs shall end."""
        if self.is_interrupted:
            raise Failure(diagnostic(INTERRUPTED))

    def poller(self) -> Callable[[], None]:
        """Return a function that does so once ``interrupt`` is called from now on."""
        asked_at = self.interruptions

        def poll() -> None:
            if self.interruptions != asked_at:
                raise Failure(diagnostic(INTERRUPTED))

        return poll

    def ask(self, method: Callable[_P, _T], *words: _P.args, **keywords: _P.kwargs) -> _T:
        """Return the result of a method, called in this thread.

        Raises ``Failure`` (901155) once it is closed.
        """
        if threading.current_thread() is self._thread:
            return method(*words, **keywords)
        answer: Future[_T] = Future()
        asked_at = getattr(self._together, "since", self.interruptions)

        def command() -> None:
            self._asked_at = asked_at
            try:
                answer.set_result(method(*words, **keywords))
            except BaseException as error:  # noqa: BLE001 - whoever has asked gets it
                answer.set_exception(error)

        with self._entry:
            if self.is_closed:
                raise Failure(diagnostic(SESSION_IS_CLOSED))
            self._commands.put(command)
        try:
            self._show_until(answer)
            return answer.result()
        except KeyboardInterrupt:
            self.interrupt()
            answer.exception()  # the run stops between two slices
            raise

    def _show_until(self, answer: Future[_T]) -> None:
        """Show in a notebook how far a command is, until it is done."""
        progress = notebook_progress("Session")
        if progress is not None:
            with closing(progress):
                while not wait((answer,), UPDATE_S).done:
                    progress.show(*self._how_far())

    def close(self, abandon: Callable[[], None] = lambda: None) -> None:
        """Finish the requested commands, then end; ``abandon`` ends one that takes too long."""
        self.interrupt()
        with self._entry:
            self.is_closed = True
        self._commands.put(None)
        self._thread.join(CLOSING_S)
        if self._thread.is_alive():
            abandon()
            self._thread.join(CLOSING_S)
