# SPDX-License-Identifier: MIT
"""The host of all endpoints: one session, one loop, one store of values, one way to write.

In: commands and values of clients, through the endpoints. Out: inputs of the session, values by
name, frames and notices. Requests to the session wait in a separate thread, never in the loop.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Literal, ParamSpec, Protocol, Self, TypeVar

from nctakt.base.failure import Failure
from nctakt.lists.machine.machine import Machine
from nctakt.messages.plcs.hli_table import (
    PATH_HAS_NO_EFFECT,
    TRANSITION_DROPPED,
    UNIT_NOT_ENABLED,
)
from nctakt.run.access.machine_names import names_of_machine
from nctakt.servers.catalogue import Catalogue
from nctakt.servers.clock import MachineClock
from nctakt.servers.log import ServerLog
from nctakt.servers.marked_variables import marked_values
from nctakt.servers.notices import Notices, ServerNotice
from nctakt.servers.store import Scalar, Store
from nctakt.session.listening import Frame, Listener, Notice
from nctakt.session.session import Session
from nctakt.st.program import Program

#: Maximum number of writes waiting for the session; one more is refused.
MAX_WRITES = 10_000

#: Writes that the session takes at once: ticks run between two batches.
MAX_BATCH = 100

#: How long a client waits for its write to be latched at most, in seconds: a session may pause.
LATCHING_S = 1.0

#: The operator's keys: the variable of the HLI that each writes, and the value.
KEYS: Mapping[str, tuple[str, float]] = {
    "start": ("HLI.START", 1.0),
    "reset": ("HLI.RESET", 1.0),
    "hold": ("HLI.FEED_HOLD", 1.0),
    "go_on": ("HLI.FEED_HOLD", 0.0),
}

#: Notices also in the log: no answer tells clients that a write has no effect.
_OF_INTERFACE = (PATH_HAS_NO_EFFECT.id, UNIT_NOT_ENABLED.id, TRANSITION_DROPPED.id)

Key = Literal["start", "reset", "hold", "go_on"]

_P = ParamSpec("_P")
_T = TypeVar("_T")


#: Frames that wait for the loop at most; at 1,000 a second these are four seconds.
MAX_FRAMES = 4096

#: Frames a second: as many as there are slices.
_EACH_SLICE_HZ = 1e6


class Endpoint(Protocol):
    """A server of one protocol in the host's loop; ``max_connections``: how many it takes."""

    max_connections: int

    async def prepare(self) -> None:
        """Do slow preparations before clients can connect; raises ``Failure``."""

    async def open(self) -> str:
        """Serve clients from now on; return the address. Raises ``Failure``."""

    async def close(self) -> None:
        """Inform the clients that it ends, and stop serving."""


class Busy(Exception):
    """Too many writes wait for the session."""


class Host:
    """A session and the data shared by its endpoints; open it in a running loop.

    ``machine``: that of the session. ``catalogue``: its values by name; ``store``: their latest
    values; ``programs``: those of its PLC in Structured Text, ``marked``: variables that these mark
    for clients (``marked_variables``); ``notices``: notices for clients; ``log``: the log about
    clients; ``clock``: the times of ticks.
    """

    def __init__(
        self,
        session: Session,
        machine: Machine,
        log: ServerLog,
        programs: Sequence[Program] = (),
    ) -> None:
        self.session = session
        self.programs = programs
        self.machine = machine
        self.catalogue = Catalogue(names_of_machine(machine))
        self.marked = marked_values(programs)
        self.log = log
        self.notices = Notices(log)
        self.store = Store(self._subscribe, log)
        self.cycle_time_us = session.description.cycle_time_us
        self.clock = MachineClock(self.cycle_time_us)
        self._executor = ThreadPoolExecutor(1, "nctakt servers")
        self._writes: list[tuple[Mapping[str, Scalar], str, asyncio.Future[Exception | int]]] = []
        self._latching: list[tuple[int, asyncio.Future[None]]] = []
        self._writer: asyncio.Task[None] | None = None
        self._feed: Feed | None = None

    async def open(self) -> Self:
        """Listen to the session from now on."""
        self.loop = asyncio.get_running_loop()
        self._feed = feed = Feed(self.loop, self._take_frame, self._take_notice)
        await self.ask(self.session.attach, feed)
        return self

    async def close(self, *, answers: bool = True) -> None:
        """Stop listening; the session stays open. ``answers``: it still answers requests."""
        feed, self._feed = self._feed, None
        if feed is not None and answers:
            await self.ask(self.session.detach, feed)
        self._executor.shutdown(wait=answers, cancel_futures=not answers)

    # --- reports of the session -----------------------------------------------------------------

    def _take_frame(self, frame: Frame) -> None:
        self.store.receive(frame)
        if self._latching:
            waiting, self._latching = self._latching, []
            for tick, latched in waiting:
                if tick >= frame.tick:
                    self._latching.append((tick, latched))
                elif not latched.done():
                    latched.set_result(None)
        for message in frame.messages:
            self.notices.notify(ServerNotice("message", frame.tick, message.text, message=message))
        for found in frame.diagnostics:
            if found.id in _OF_INTERFACE:
                self.log.note("interface", tick=frame.tick, text=found.text("en"))
            self.notices.notify(
                ServerNotice("diagnostic", frame.tick, str(found), diagnostic=found)
            )

    def _take_notice(self, notice: Notice) -> None:
        self.log.note(notice.kind, tick=notice.tick, text=notice.text)
        self.notices.notify(
            ServerNotice(notice.kind, notice.tick, notice.text, text_de=notice.text_de)
        )

    def want_events(self) -> None:
        """Let frames have events from now on."""
        assert self._feed is not None
        self._feed.wants_events = True

    @property
    def missed_frames(self) -> int:
        """The number of frames that the loop was too late for."""
        return 0 if self._feed is None else self._feed.missed

    async def _subscribe(self, names: Sequence[str]) -> None:
        assert self._feed is not None
        await self.ask(self.session.attach, self._feed, names)

    # --- requests of clients --------------------------------------------------------------------

    async def ask(self, method: Callable[_P, _T], *words: _P.args, **keywords: _P.kwargs) -> _T:
        """Return the result of a method of the session, without holding up the loop."""
        return await self.loop.run_in_executor(self._executor, lambda: method(*words, **keywords))

    async def write(self, values: Mapping[str, Scalar], endpoint: str, client: str) -> int:
        """Write values from the next tick on, all of them in the same one; return that tick.

        Raises ``Failure`` for a wrong name or value, ``Busy`` where too many writes wait; then
        nothing is written, and it is logged. On the tape its source is endpoint and client.
        """
        if len(self._writes) >= MAX_WRITES:
            self.log.refuse(endpoint, client, "too many writes wait")
            raise Busy
        answer: asyncio.Future[Exception | int] = self.loop.create_future()
        self._writes.append((dict(values), f"{endpoint} {client}", answer))
        if self._writer is None:
            self._writer = self.loop.create_task(self._write_all())
        answered = await answer
        if isinstance(answered, int):
            return answered
        if isinstance(answered, Failure):
            self.refuse(answered, endpoint, client)
        raise answered

    async def latched(self, tick: int) -> None:
        """Return once all can read the values written for a tick, at once unless it plays."""
        if tick < self.store.tick or not self.session.is_playing:
            return
        latched: asyncio.Future[None] = self.loop.create_future()
        self._latching.append((tick, latched))
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(latched, LATCHING_S)

    async def _write_all(self) -> None:
        """Hand the writes of all clients to the session, together those that wait together."""
        try:
            while self._writes:
                writes = self._writes[:MAX_BATCH]
                del self._writes[:MAX_BATCH]
                requests = [(values, source) for values, source, _ in writes]
                answers: Sequence[Exception | int]
                try:
                    answers = await self.ask(self.session.write_each, requests)
                except Exception as error:  # noqa: BLE001 - whoever waits for an answer gets it
                    answers = [error for _ in writes]
                for (_, _, answer), refused in zip(writes, answers, strict=True):
                    if not answer.done():  # whose client has gone
                        answer.set_result(refused)
        finally:
            self._writer = None

    async def select(self, program: str | Path, channel: int, endpoint: str, client: str) -> None:
        """Select a program file for a channel, counted from 1; raises ``Failure``."""
        await self._command(endpoint, client, self.session.select, program, channel)

    async def press(self, key: Key, channel: int, endpoint: str, client: str) -> None:
        """Press a key of the operator: START, RESET, feed hold, and its end."""
        await self.write(self.key_value(key, channel), endpoint, client)

    def key_value(self, key: Key, channel: int) -> dict[str, Scalar]:
        """Return the value that a key writes in a channel, counted from 1."""
        name, value = KEYS[key]
        count = len(self.machine.channels)
        prefix = f"CH{channel}." if count > 1 or channel > 1 else ""
        return {f"{prefix}{name}": value}

    async def _command(
        self, endpoint: str, client: str, method: Callable[..., None], *words: object
    ) -> None:
        try:
            await self.ask(method, *words, source=f"{endpoint} {client}")
        except Failure as failure:
            self.refuse(failure, endpoint, client)
            raise

    def refuse_later(self, endpoint: str, client: str, reason: str) -> None:
        """Log a refusal of a client, from another thread."""
        with contextlib.suppress(RuntimeError):  # the loop has ended
            self.loop.call_soon_threadsafe(self.log.refuse, endpoint, client, reason)

    def refuse(self, failure: Failure, endpoint: str, client: str) -> None:
        """Log a refusal of a client."""
        for found in failure.diagnostics[:1]:
            self.log.refuse(endpoint, client, f"{found.id}: {found.text('en')}")


class Feed(Listener):
    """Hands frames and notices on into a loop; ``missed``: frames that were left out."""

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        take_frame: Callable[[Frame], None],
        take_notice: Callable[[Notice], None],
    ) -> None:
        super().__init__((), _EACH_SLICE_HZ, wants_events=False)
        self._loop = loop
        self._take_frame = take_frame
        self._take_notice = take_notice
        self._waiting: deque[Frame | Notice] = deque()
        self._is_called = False
        self.missed = 0

    def is_due(self) -> bool:
        """Return that each slice is of interest."""
        return True

    def give(self, frame: Frame) -> None:
        """Hand a frame on."""
        with self._changed:
            if len(self._waiting) >= MAX_FRAMES:
                self.missed += 1
                self._waiting.popleft()
            self._hand_on(frame)

    def notify(self, notice: Notice) -> None:
        """Hand a notice on."""
        with self._changed:
            self._hand_on(notice)

    def _hand_on(self, what: Frame | Notice) -> None:
        self._waiting.append(what)
        if not self._is_called:
            self._is_called = True
            try:
                self._loop.call_soon_threadsafe(self._deliver)
            except RuntimeError:
                self._waiting.clear()  # the loop has ended

    def _deliver(self) -> None:
        with self._changed:
            waiting, self._waiting = self._waiting, deque()
            self._is_called = False
        for what in waiting:
            if isinstance(what, Frame):
                self._take_frame(what)
            else:
                self._take_notice(what)
