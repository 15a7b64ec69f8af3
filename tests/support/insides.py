# SPDX-License-Identifier: MIT
"""What tests see of a controller and a session that their users do not: nobody else reaches in."""

from __future__ import annotations

import asyncio
import os
import queue
import signal
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

from nctakt.run.controller import Controller
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.run.tick_loop import TickLoop
from nctakt.session.core import SessionCore
from nctakt.session.session import Session

if TYPE_CHECKING:
    import pytest

    from nctakt.files.output import OutputFile
    from nctakt.nc.fast.templates import Templates
    from nctakt.session.process.thread import SessionThread
    from nctakt.studies.runs.shared_beginning import SharedBeginning


def machine_of(controller: Controller) -> AssembledMachine:
    """The machine that a controller runs."""
    return controller._machine


def loop_of(controller: Controller) -> TickLoop:
    """The loop in which a controller runs ticks."""
    return controller._loop


def core_of(session: Session) -> SessionCore:
    """What turns the commands of a session into effects."""
    return session._core


def lose_controller(session: Session) -> None:
    """Cut the connection to the controller of a session."""
    core_of(session).timeline.live._connection.close()


def process_of(session: Session) -> int:
    """The number of the process in which the controller of a session lives."""
    return core_of(session).timeline.live.process


def kill_controller(session: Session) -> None:
    """Kill the process in which the controller of a session lives."""
    os.kill(process_of(session), signal.SIGKILL)


class Audience:
    """Those who listen to a session."""

    def __init__(self, session: Session) -> None:
        self._session = session

    @property
    def count(self) -> int:
        """How many listen."""
        return len(self._session._subscribers._listeners)

    def report_travel(self) -> None:
        """Report all of them that the session has travelled, in its thread."""
        self._session._thread.ask(self._session._subscribers.notify, "travelled")


def audience_of(session: Session) -> Audience:
    """Those who listen to a session."""
    return Audience(session)


def exchange_queue(thread: SessionThread, other: queue.Queue[Any]) -> queue.Queue[Any]:
    """Give a thread another queue of commands; return the one that it had."""
    first, thread._commands = thread._commands, other
    return first


def living_cycles(controller: Controller) -> Iterable[Any]:
    """The definitions of the cycles that live."""
    return machine_of(controller).registry._living.values()


def remembered(templates: Templates) -> tuple[Sequence[bytes], int]:
    """The shapes that were seen, and how many templates were made of them."""
    return list(templates._seen), len(templates._known)


def let_copy(shared: SharedBeginning) -> None:
    """Let the beginning of a study be copied, whether that pays or not."""
    shared._may_copy = True
    shared._copying_pays = lambda: True  # type: ignore[method-assign]


def break_output(
    patch: pytest.MonkeyPatch, file: OutputFile, broken: Callable[[object], object]
) -> None:
    """Let a file be written by another object, made of its own."""
    patch.setattr(file, "_file", broken(file._file))


def timer_of(deadline: Any) -> asyncio.TimerHandle | None:
    """What ends a connection of the servers that takes too long."""
    timer: asyncio.TimerHandle | None = deadline._timer
    return timer


def handles_of(notifier: Any) -> list[int]:
    """The notifications of the ADS server, the oldest first."""
    return list(notifier._all)


def kept_items(table: Any) -> list[Any]:
    """The ranges that the symbols of the ADS server remember."""
    return list(table._items.values())


def is_writing(host: Any) -> bool:
    """Whether a host of servers writes at this moment."""
    return host._writer is not None


def queue_line(client: Any, line: str) -> None:
    """Let a line wait for an agent of MTConnect, which does not read."""
    client._queue(line)


def send_unasked(protocol: Any, request: object) -> None:
    """Send a request of asyncua whose answer nobody waits for."""
    protocol._send_request(request)


def kill_server(client: Any) -> None:
    """End the language server of a client of pygls at once."""
    client._server.kill()
