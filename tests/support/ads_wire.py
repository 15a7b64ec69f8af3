# SPDX-License-Identifier: MIT
"""Requests of ADS as bytes, and connections without sockets for the tests of the server."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Mapping, Sequence
from struct import pack, unpack_from
from types import SimpleNamespace
from typing import Any, cast

from nctakt.base.failure import Failure
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.run.access.interface_access import InterfaceAccess
from nctakt.run.access.variable_access import is_path
from nctakt.servers.ads.codes import Command, Group
from nctakt.servers.ads.frames import REQUEST, Frame, FrameReader
from nctakt.servers.ads.server import AdsEndpoint, Connection
from nctakt.servers.host import Host
from nctakt.servers.log import ServerLog
from nctakt.session.listening import Frame as SessionFrame
from nctakt.session.listening import Listener
from nctakt.session.session import Session

OWN, CLIENT = bytes((127, 0, 0, 1, 1, 1)), bytes((10, 0, 0, 9, 1, 1))


class StandingSession:
    """A paused session: it takes writes, and shows them with the next ``tick``.

    Its interface is the real one, on values that a test sets.
    """

    def __init__(self, machine: Machine) -> None:
        self.description = SimpleNamespace(cycle_time_us=machine.cycle_time_us)
        self.is_playing = False
        self.tick = 0
        self.written: dict[str, float | bool | str] = {}
        self.sources: list[str] = []
        self.selected: list[tuple[str, int]] = []
        self.waiting: list[tuple[int, Any]] = []
        self.acknowledged: list[Any] = []
        self.locked: dict[int, bool] = {}
        self._reports: list[Any] = []
        self._interface = InterfaceAccess(cast("Any", _Machine(self, machine)), 1)
        self._listener: Listener | None = None
        self._signals: Sequence[str] = ()

    def attach(self, listener: Listener, signals: Sequence[str] = ()) -> None:
        """Give the first frame."""
        self._listener, self._signals = listener, signals
        self._give()

    def detach(self, listener: Listener) -> None:
        """Give no more."""
        self._listener = None

    def advance(self, ticks: int = 1) -> None:
        """Run ticks."""
        self.tick += ticks
        self._give()

    def _give(self) -> None:
        values = dict(zip(self._signals, self.read(*self._signals), strict=True))
        assert self._listener is not None
        self._listener.give(
            SessionFrame(
                *(self.tick, self.tick, 1, 0, "ready", None, None, values, {}, (), 0, ()),
                *(tuple(self._reports), 0),
            )
        )
        self._reports.clear()

    def report(self, found: Any) -> None:
        """Let a diagnostic come with the next frame."""
        self._reports.append(found)

    def write_each(
        self, requests: Sequence[tuple[Mapping[str, float | bool | str], str]]
    ) -> list[Failure | int]:
        """Take writes; those of the interface mean what they mean to a controller."""
        answers: list[Failure | int] = []
        for values, source in requests:
            try:
                for name, value in values.items():
                    if is_path(name):
                        self._interface.check(name, value)
                        self._interface.write(name, value, source)
                    else:
                        self.written[name] = value
            except Failure as failure:
                answers.append(failure)
                continue
            self.sources.append(source)
            answers.append(self.tick)
        if any(is_path(name) for values, _ in requests for name in values):
            self._give()
        return answers

    def select(self, program: str, channel: int, source: str) -> None:
        """Take a program."""
        self.selected.append((str(program), channel))

    def read(self, *names: str) -> list[float | bool | str]:
        """Return values."""
        texts = ("TEXT", "STRING")
        return [
            self._interface.read(name)
            if is_path(name)
            else self.written.get(name, "" if name.endswith(texts) else 0.0)
            for name in names
        ]

    def state_view(self, *names: str) -> Any:
        """Return values, the tick, and a channel whose F is 600 mm/min."""
        channel = SimpleNamespace(programmed_mm_s=10.0, in_force=None)
        values, waiting = self.read(*names), tuple(self.waiting)
        return SimpleNamespace(tick=self.tick, values=values, channels=(channel,), waiting=waiting)

    def decoders(self) -> list[Any]:
        """Return no open program."""
        return []


class _Machine:
    """What the interface needs of a machine, on the values of a paused session."""

    def __init__(self, session: StandingSession, configuration: Machine) -> None:
        self.configuration = configuration
        self.inputs = self
        self.report = session.report
        self.cells = _Cells(session)
        names = tuple(axis.name for axis in configuration.channels[0].axes)
        offsets, places = SimpleNamespace(zero_groups={}), SimpleNamespace(names=names)
        self.assembled = (cast("Any", SimpleNamespace(offsets=offsets, places=places)),)
        self._session = session

    def signals(self) -> Any:
        """Each signal's cell is its name."""
        return _Names()

    def read(self, name: str) -> float | bool | str:
        """Return a value."""
        return self._session.read(name)[0]

    def write(self, name: str, value: float | bool | str, source: str) -> None:
        """Write a value."""
        self._session.written[name] = value

    def waiting_functions(self, channel: int) -> list[tuple[Any, int]]:
        """Return what waits, with its units in the order of its areas."""
        found: list[tuple[Any, int]] = []
        for number, entry in self._session.waiting:
            if number == channel + 1:
                found.append((entry, sum(one.axis == entry.axis for one, _ in found)))
        return found

    def lock_axis(self, index: int, is_locked: bool) -> None:
        """Note whether an axis lacks its releases."""
        self._session.locked[index] = is_locked

    def select(self, channel: int, program: str, source: str) -> None:
        """Take a program."""
        self._session.selected.append((program, channel + 1))

    def acknowledge(self, channel: int, *words: Any) -> None:
        """Take an acknowledgement."""
        found = [one for one in self._session.waiting if one[1].slot == words[1]]
        self._session.waiting.remove(found[0])


class _Names(dict[str, Any]):
    def __missing__(self, name: str) -> Any:
        return SimpleNamespace(cell=name, unit="", is_whole=False)


class _Cells:
    def __init__(self, session: StandingSession) -> None:
        self._session = session

    def __getitem__(self, name: str) -> float:
        return float(self._session.read(name)[0])


class Wire(asyncio.Transport):
    """A transport without a socket: ``sent`` is what the server has sent."""

    def __init__(self) -> None:
        super().__init__()
        self.sent = bytearray()
        self.is_closed = self.is_paused = False
        self.unread = 0

    def get_extra_info(self, name: str, default: Any = None) -> Any:
        return ("10.0.0.9", 1) if name == "peername" else None

    def set_write_buffer_limits(self, high: int | None = None, low: int | None = None) -> None:
        pass

    def get_write_buffer_size(self) -> int:
        return self.unread

    def write(self, data: Any) -> None:
        self.sent += data

    def close(self) -> None:
        self.is_closed = True

    def abort(self) -> None:
        self.is_closed = True

    def pause_reading(self) -> None:
        self.is_paused = True

    def resume_reading(self) -> None:
        self.is_paused = False

    def answers(self) -> list[Frame]:
        """Take the frames that were sent."""
        data, self.sent = bytes(self.sent), bytearray()
        reader = FrameReader()
        return list(reader.feed(data))


class Bench:
    """A server on a paused session, with ``log``, its lines."""

    def __init__(
        self, host: Host, session: StandingSession, endpoint: AdsEndpoint, log: list[str]
    ) -> None:
        self.host = host
        self.session = session
        self.endpoint = endpoint
        self.log = log

    def connect(self) -> tuple[Connection, Wire]:
        """Connect a client."""
        wire, connection = Wire(), Connection(self.endpoint)
        connection.connection_made(wire)
        return connection, wire

    async def ask(self, connection: Connection, wire: Wire, request: bytes) -> Frame:
        """Return the answer to a request."""
        connection.data_received(request)
        for _ in range(2000):
            for answer in wire.answers():
                if answer.command != Command.NOTIFICATION:
                    return answer
            await asyncio.sleep(0.001)
        raise AssertionError("no answer")


@contextlib.asynccontextmanager
async def bench(**words: Any) -> AsyncIterator[Bench]:
    """A server whose clients need no sockets."""
    machine = load_machine()
    session = StandingSession(machine)
    log: list[str] = []
    host = await Host(cast("Session", session), machine, ServerLog(log.append)).open()
    endpoint = AdsEndpoint(host, ("127.0.0.1", 0), OWN, **words)
    await endpoint.prepare()
    await endpoint.open()
    try:
        yield Bench(host, session, endpoint, log)
    finally:
        await endpoint.close()
        await host.close()


def request(
    command: int, data: bytes = b"", *, port: int = 851, invoke: int = 1, source: int = 33000
) -> bytes:
    """A request as bytes."""
    return Frame(OWN, port, CLIENT, source, command, REQUEST, 0, invoke, data).encode()


def read(group: int, offset: int, size: int, **words: int) -> bytes:
    """A read."""
    return request(Command.READ, pack("<III", group, offset, size), **words)


def write(group: int, offset: int, data: bytes, **words: int) -> bytes:
    """A write."""
    return request(Command.WRITE, pack("<III", group, offset, len(data)) + data, **words)


def read_write(group: int, offset: int, size: int, data: bytes, **words: int) -> bytes:
    """A read-write."""
    head = pack("<IIII", group, offset, size, len(data))
    return request(Command.READ_WRITE, head + data, **words)


def by_name(name: str) -> bytes:
    """What opens a handle."""
    return read_write(Group.HANDLE_BY_NAME, 0, 4, name.encode() + b"\0")


def notification(
    group: int, offset: int, size: int, mode: int = 4, cycle: int = 0, **words: int
) -> bytes:
    """What adds a notification."""
    data = pack("<IIIIII16x", group, offset, size, mode, 0, cycle)
    return request(Command.ADD_NOTIFICATION, data, **words)


def result(answer: Frame) -> int:
    """The error of an answer."""
    return int(answer.error or unpack_from("<I", answer.data)[0])


def data_of(answer: Frame) -> bytes:
    """The data of an answer to a read or a read-write."""
    assert result(answer) == 0, hex(result(answer))
    return answer.data[8:]


def number_of(answer: Frame) -> int:
    """The number that a read or a read-write has answered."""
    return int.from_bytes(data_of(answer), "little")
